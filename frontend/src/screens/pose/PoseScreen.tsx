/** Road pose: the board on the frame, its size and its height above the road; the road drawn over the picture. */
import { Button, Empty, Loading } from "../../components";
import { CommandButton } from "../../components/CommandButton";
import { useCommands } from "../../core/commands";
import { say, sentencesOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { canWork } from "../../core/session";
import type { BoardFinding } from "../../core/types";
import { FailedPage } from "../../parts/FailedPage";
import { usePageModel } from "../../parts/pageModel";
import { linesShown } from "../../viewer/display";
import { FrameView } from "../../viewer/FrameView";
import { FoundBoard, RoadOverlay } from "../../viewer/PoseOverlay";
import type { Player } from "../../viewer/player";
import type { Span } from "../../viewer/spans";
import {
  brightSwitch,
  fitCommand,
  frameCommands,
  linesSwitch,
  loupeSwitch,
} from "../../viewer/stageCommands";
import { Timeline } from "../../viewer/Timeline";
import { Transport } from "../../viewer/Transport";
import { PoseModel } from "./model";
import { PoseForm } from "./PoseForm";
import { PoseResult } from "./PoseResult";
import "./pose.css";

export default function PoseScreen({ surveyId }: ScreenProps) {
  const model = usePageModel(() => new PoseModel(surveyId), [surveyId]);
  const player = model.reel.player.value;
  useCommands([
    { id: "passBegin", label: say("pose-mark-first"), run: () => model.mark("first"), enabled: mayMark },
    { id: "passEnd", label: say("pose-mark-last"), run: () => model.mark("last"), enabled: mayMark },
    ...frameCommands(model.stage, player),
  ]);
  if (model.problem.value) return <FailedPage model={model} />;
  if (!model.loaded.value) return <Loading what={say("pose-loading")} />;
  if (!player) {
    return (
      <Empty
        says="pose-no-recording-title"
        why="pose-no-recording"
        actions={
          <Button says="pose-add-recordings" kind="primary" href={`/surveys/${surveyId}/recordings`} />
        }
      />
    );
  }
  return (
    <div class="desk pose">
      <h1 class="visually-hidden">{say("page-pose")}</h1>
      <section class="frame-place" aria-label={say("stage-frame")}>
        <FrameView
          key={player.recordingId}
          player={player}
          stage={model.stage}
          describedBy="pose-hint"
          above={<BoardHint model={model} />}
        >
          {linesShown.value && model.pose.value && (
            <RoadOverlay overlay={model.pose.value.overlay} stage={model.stage} />
          )}
          {model.finding.value?.found && <FoundBoard finding={model.finding.value} stage={model.stage} />}
        </FrameView>
      </section>
      <aside class="desk__side" aria-label={say("pose-side")}>
        <PoseResult model={model} />
        <PoseForm model={model} />
      </aside>
      <section class="desk__time" aria-label={say("stage-timeline")}>
        <div class="row row--near frame-tools">
          <Transport player={player} stage={model.stage} />
          <span class="grow" />
          <CommandButton command={fitCommand(model.stage)}>{say("stage-fit")}</CommandButton>
          <CommandButton command={linesSwitch}>{say("stage-lines")}</CommandButton>
          <CommandButton command={brightSwitch}>{say("stage-bright")}</CommandButton>
          <CommandButton command={loupeSwitch(model.stage)}>{say("stage-loupe")}</CommandButton>
        </div>
        <Timeline player={player} spans={spansOf(model, player)} />
      </section>
    </div>
  );
}

const mayMark = (): boolean => canWork.value;

function spansOf(model: PoseModel, player: Player): Span[] {
  const { first, last } = model.form.value;
  const end = last ?? (first === null ? null : Math.max(first, player.frame.value));
  if (first === null || end === null) return [];
  const title = say("pose-board-span", { first_frame: String(first), last_frame: String(end) });
  return [{ id: "board", first, last: end, label: "", title, kind: "board" }];
}

function foundWords({ ids, columns, rows }: BoardFinding): string {
  return ids ? say("pose-found-part") : say("pose-found", { columns, rows });
}

function BoardHint({ model }: { model: PoseModel }) {
  const finding = model.finding.value;
  const inUse = model.pose.value !== null;
  const advice = say(inUse ? "pose-go-again" : "pose-go");
  const problem = model.findingProblem.value;
  const words = finding?.found
    ? sentencesOf(finding.order_notes)
    : model.looking.value
      ? say("pose-looking")
      : inUse || problem === null
        ? advice
        : problem;
  return (
    <p class="frame-hint" id="pose-hint" role="status">
      {finding?.found && <strong class="nowrap">{foundWords(finding)}</strong>}
      <span>{words}</span>
    </p>
  );
}
