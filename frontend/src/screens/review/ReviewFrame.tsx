/** The picture with the reviewed points, their axes and ladder; the points can be dragged while fixing. */
import { say } from "../../core/messages";
import { TARGET_NOUNS } from "../../core/words";
import { AnswerLines } from "../../viewer/AnswerLines";
import { FrameView } from "../../viewer/FrameView";
import { heightOrReason } from "../../viewer/geometry";
import { InImage, Line, PointMark } from "../../viewer/Overlay";
import type { Player } from "../../viewer/player";
import { fromServer, pair } from "../../viewer/points";
import type { ReviewModel } from "./model";

export function ReviewFrame({ model, player }: { model: ReviewModel; player: Player }) {
  const contact = model.contact.value;
  const point = model.point.value;
  const fix = model.fix.value;
  return (
    <FrameView player={player} stage={model.stage} describedBy="review-hint" above={<Hint model={model} />}>
      {model.onFrame.value && contact && point && (
        <>
          <AnswerLines geometry={model.geometry} stage={model.stage} />
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
            text={model.current.value ? TARGET_NOUNS[model.current.value.measurement.target] : undefined}
          />
        </>
      )}
    </FrameView>
  );
}

/** Where it was clicked again on this frame, and by whom; not while the points are being moved. */
function SecondClicks({ model }: { model: ReviewModel }) {
  const frame = model.ofFrame.value?.frame;
  if (model.fix.value) return null;
  return (
    <g data-testid="second-clicks">
      {(model.repeats.comparisons.value ?? [])
        .filter(({ repeat }) => repeat.frame === frame)
        .map(({ repeat }) => (
          <g key={repeat.id}>
            <PointMark stage={model.stage} at={fromServer(repeat.contact)} kind="contact" faint />
            <PointMark stage={model.stage} at={fromServer(repeat.target_point)} kind="point" faint />
          </g>
        ))}
    </g>
  );
}

function Hint({ model }: { model: ReviewModel }) {
  const live = model.geometry.live.value?.answer;
  const words = model.stage.hint.value ?? (model.onFrame.value ? "" : say("review-other-frame"));
  if (!words) return <p class="visually-hidden" id="review-hint" />;
  return (
    <p class="frame-hint" id="review-hint" role="status">
      {model.fix.value && live && <strong class="nowrap">{heightOrReason(live)}</strong>}
      <span>{words}</span>
    </p>
  );
}
