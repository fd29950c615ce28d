/** The frame with axes, ladder, points and the height under the pointer. */
import { useSignal, useSignalEffect } from "@preact/signals";
import { commandName, hint } from "../../core/commands";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import type { HeightAnswer } from "../../core/types";
import { TARGET_NOUNS, TARGET_WORDS, vehicleName } from "../../core/words";
import { AnswerLines } from "../../viewer/AnswerLines";
import { FrameView } from "../../viewer/FrameView";
import { heightOrReason } from "../../viewer/geometry";
import { loupeBelow } from "../../viewer/Loupe";
import { InImage, Line, PointMark } from "../../viewer/Overlay";
import type { Player } from "../../viewer/player";
import { pair, samePoint } from "../../viewer/points";
import { AssistLayer, AssistNote } from "./assist/AssistLayer";
import { DriftLine } from "./assist/DriftLine";
import { SnapLayer } from "./assist/SnapLayer";
import type { Selection } from "./flow";
import type { MeasureModel } from "./model";
import { ProposalLayer } from "./proposals/ProposalLayer";
import { SecondMarks } from "./SecondFrameParts";
import { idOf } from "./standing";
import { FollowedMarks } from "./WholePassParts";

export function FramePanel({ model, player }: { model: MeasureModel; player: Player }) {
  const { stage, standing, assist } = model;
  return (
    <section class="frame-place" aria-label={say("stage-frame")}>
      <FrameView
        player={player}
        stage={stage}
        describedBy="measure-hint"
        above={
          <>
            <Hint model={model} />
            <LiveHeight model={model} />
            <Refused model={model} />
            <DriftLine
              surveyId={model.surveyId}
              recordingId={player.recordingId}
              frame={model.seenFrame.value}
            />
            <AssistNote assist={assist} />
          </>
        }
      >
        <AnswerLines geometry={model.geometry} stage={stage} />
        <Marks model={model} selections={standing.selectable()} />
        <SnapLayer snapping={model.snapping} stage={stage} />
        <AssistLayer assist={assist} stage={stage} />
        <ProposalLayer proposals={model.proposals} stage={stage} />
      </FrameView>
      <Spoken model={model} />
    </section>
  );
}

function Marks({ model, selections }: { model: MeasureModel; selections: readonly Selection[] }) {
  const { stage, standing } = model;
  const selected = model.flow.value.selection;
  const here = standing.entriesHere();
  const renew = model.flow.value.renew;
  const isSelected = (one: Selection): boolean => {
    if (!selected || selected.role !== one.role) return false;
    return selected.key === one.key || samePoint(standing.positionOf(selected), standing.positionOf(one));
  };
  return (
    <>
      {selected && (
        <InImage stage={stage}>
          {here
            .filter(({ key }) => key === selected.key)
            .map((entry) => {
              const { contact, point } = standing.here(entry);
              return <Line key={entry.key} points={[pair(contact), pair(point)]} kind="guide" />;
            })}
        </InImage>
      )}
      {selections.map((one) => {
        const at = standing.positionOf(one);
        const entry = here.find((candidate) => candidate.key === one.key);
        return (
          at && (
            <PointMark
              key={idOf(one)}
              stage={stage}
              at={at}
              kind={one.role}
              selected={isSelected(one)}
              faint={one.role === "contact" && renew}
              text={one.role === "point" && entry ? TARGET_NOUNS[entry.values.target] : undefined}
            />
          )
        );
      })}
      <SecondMarks model={model} />
      <FollowedMarks model={model} />
    </>
  );
}

/** One line at the top of the frame: what the next click does. */
function Hint({ model }: { model: MeasureModel }) {
  const vehicle = model.vehicle.value;
  const target = model.second.now.value?.target ?? model.flow.value.target;
  return (
    <p class="frame-hint" id="measure-hint">
      {vehicle && <strong>{vehicleName(vehicle.number)}</strong>}
      {target && model.hasPose.value && <strong>{TARGET_WORDS[target]}</strong>}
      {target === "driver_eye" && vehicle && model.hasPose.value && <Driver model={model} />}
      <span role="status">{hintWords(model)}</span>
      {!target && vehicle && canWork.value && model.standing.missing().length === 0 && (
        <InHint
          name="next-pass"
          title={commandName("confirmNext") + hint("confirmNext")}
          words={say("measure-next-pass")}
          onClick={() => model.confirmNext()}
        />
      )}
      {vehicle && model.proposals.late.value === vehicle.id && (
        <InHint
          name="late-proposals"
          title={say("measure-proposals-late-title")}
          words={say("measure-proposals-late")}
          onClick={() => model.proposals.showLate()}
        />
      )}
      {!model.hasPose.value && (
        <a href={`/surveys/${model.surveyId}/pose?recording=${model.reel.player.value?.recordingId ?? ""}`}>
          {say("measure-find-pose")}
        </a>
      )}
    </p>
  );
}

/** Near or far, where the eye is clicked: it makes 4 to 9 cm of its height. */
function Driver({ model }: { model: MeasureModel }) {
  const words = say("measure-driver", { side: model.insets.side.value ?? "unknown" });
  if (!canWork.value) return <em>{words}</em>;
  return (
    <InHint
      name="driver-side"
      title={commandName("driverSide") + hint("driverSide")}
      words={words}
      onClick={() => {
        model.insets.turnSide();
        model.stage.focus();
      }}
    />
  );
}

/** A button over the picture: what is pressed there is no click on a frame. */
function InHint(props: { name: string; title: string; words: string; onClick: () => void }) {
  return (
    <button
      type="button"
      class="frame-hint__turn"
      data-testid={props.name}
      title={props.title}
      onPointerDown={(event) => event.stopPropagation()}
      onClick={props.onClick}
    >
      {props.words}
    </button>
  );
}

function hintWords(model: MeasureModel): string {
  const { target } = model.flow.value;
  const said = model.stage.hint.value;
  if (said) return said;
  if (!model.hasPose.value) return say("measure-no-pose");
  if (model.vehicleId.value === null) return say("measure-choose-pass");
  if (!canWork.value) return say("measure-look-only");
  if (model.geometry.problem.value) return model.geometry.problem.value;
  if (target === null) {
    const done = model.standing.missing().length === 0;
    return done ? say("measure-vehicle-done") : say("measure-choose-target");
  }
  if (model.awaiting.value === "contact") return say("blind-contact");
  return say("blind-target", { target });
}

/** Why a contact cannot stand where it was clicked (the sky, outside the lens), said there. */
function Refused({ model }: { model: MeasureModel }) {
  const problem = model.geometry.problem.value;
  const at = model.contact.value;
  if (!problem || !at) return null;
  const view = model.stage.view.value;
  const [x, y] = view.toScreen(at);
  const flip = x > view.screen.width / 2;
  return (
    <p
      class={`live-height live-height--refused${flip ? " live-height--left" : ""}`}
      data-testid="contact-refused"
      aria-hidden="true"
      style={{ left: `${x + (flip ? -16 : 16)}px`, top: `${y + 14}px` }}
    >
      {problem}
    </p>
  );
}

function LiveHeight({ model }: { model: MeasureModel }) {
  const live = model.geometry.live.value;
  const at = model.stage.pointer.value;
  if (!live || !at || model.awaiting.value !== "point") return null;
  const view = model.stage.view.value;
  const [x, y] = view.toScreen(at);
  const refused = live.answer?.status !== "ok"; // a sentence: several lines
  const { width, height } = view.screen;
  const flip = x > width - (refused ? 350 : 190);
  const above = y > height - (refused ? 130 : 60) || loupeBelow(model.stage, at);
  const classes = ["live-height", flip && "live-height--left", refused && "live-height--refused"];
  return (
    <output
      class={classes.filter(Boolean).join(" ")}
      data-testid="live-height"
      aria-hidden="true"
      style={{
        left: `${x + (flip ? -16 : 16)}px`,
        ...(above ? { bottom: `${height - y + 14}px` } : { top: `${y + 14}px` }),
      }}
    >
      {words(live.answer, live.problem)}
    </output>
  );
}

/** A dash where no such target is: on the grass or the sky a height would be a number of nothing. */
function words(answer: HeightAnswer | null, problem: string | null): string {
  if (!answer) return problem ?? "";
  if (answer.of_class === false) return "–";
  return heightOrReason(answer);
}

/** The same for screen readers: said once the pointer rests, not at every pixel. */
function Spoken({ model }: { model: MeasureModel }) {
  const text = useSignal("");
  useSignalEffect(() => {
    const live = model.geometry.live.value;
    const timer = setTimeout(() => {
      text.value = live ? words(live.answer, live.problem) : "";
    }, 450);
    return () => clearTimeout(timer);
  });
  return (
    <p class="visually-hidden" role="status" data-testid="live-height-spoken">
      {text}
    </p>
  );
}
