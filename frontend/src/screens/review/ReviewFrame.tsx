/** The picture with the reviewed points, their axes and ladder; the points can be dragged while fixing. */

import { formatHeight, formatLength } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { linesShown } from "../../viewer/display";
import { FrameView } from "../../viewer/FrameView";
import { AxesLayer, InImage, LadderLayer, Line, PointMark } from "../../viewer/Overlay";
import type { Player } from "../../viewer/player";
import { fromServer, pair } from "../../viewer/points";
import type { ReviewModel } from "./model";

export function ReviewFrame({ model, player }: { model: ReviewModel; player: Player }) {
  const contact = model.contact.value;
  const point = model.point.value;
  const fix = model.fix.value;
  const handles = fix
    ? [
        { id: "point", at: fix.point },
        { id: "contact", at: fix.contact },
      ]
    : [];
  return (
    <FrameView
      player={player}
      stage={model.stage}
      label={`Frame ${player.frame.value}`}
      describedBy="review-hint"
      handles={handles}
      onPick={(id) => {
        if (fix) model.fix.value = { ...fix, selected: id as "contact" | "point" };
      }}
      onDrag={(id, at, phase) => {
        if (fix && phase !== "cancel") model.move(id as "contact" | "point", at);
      }}
      above={<Hint model={model} />}
    >
      {model.onFrame.value && contact && point && (
        <>
          <Lines model={model} />
          <InImage stage={model.stage}>
            <Line points={[pair(contact), pair(point)]} kind="guide" />
          </InImage>
          <SecondClicks model={model} />
          <PointMark stage={model.stage} at={contact} kind="contact" selected={fix?.selected === "contact"} />
          <PointMark
            stage={model.stage}
            at={point}
            kind="point"
            selected={fix?.selected === "point"}
            text={
              model.current.value
                ? TARGET_WORDS[model.current.value.measurement.target].toLowerCase()
                : undefined
            }
          />
        </>
      )}
    </FrameView>
  );
}

/** Where it was clicked again on this frame, and by whom; not while the points are being moved. */
function SecondClicks({ model }: { model: ReviewModel }) {
  const frame = model.current.value?.measurement.frame;
  if (model.fix.value) return null;
  return (
    <g data-testid="second-clicks">
      {(model.comparisons.value ?? [])
        .filter(({ repeat }) => repeat.frame === frame)
        .map(({ repeat }) => (
          <g key={repeat.id}>
            <PointMark stage={model.stage} at={fromServer(repeat.contact)} kind="contact" faint />
            <PointMark stage={model.stage} at={fromServer(repeat.point)} kind="point" faint />
          </g>
        ))}
    </g>
  );
}

function Lines({ model }: { model: ReviewModel }) {
  const answer = model.geometry.axes.value;
  if (!linesShown.value || !answer?.axes) return null;
  const rungs = answer.ladder.map((rung) => ({ ...rung, words: formatLength(rung.height_m, 1) }));
  return (
    <>
      <LadderLayer rungs={rungs} stage={model.stage} />
      <AxesLayer axes={answer.axes} stage={model.stage} />
    </>
  );
}

function Hint({ model }: { model: ReviewModel }) {
  const live = model.geometry.live.value?.answer;
  const words = model.fix.value
    ? "Drag the points, or choose one with S and nudge it; Enter saves the fix, Esc leaves it."
    : model.onFrame.value
      ? ""
      : "Another frame than the one that was clicked.";
  if (!words) return <p class="visually-hidden" id="review-hint" />;
  return (
    <p class="frame-hint" id="review-hint" role="status">
      {model.fix.value && live && (
        <strong class="nowrap">
          {live.status === "ok" ? formatHeight(live.height_m, live.U95_height_m) : live.reason}
        </strong>
      )}
      <span>{words}</span>
    </p>
  );
}
