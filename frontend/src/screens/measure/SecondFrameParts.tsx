/** What is seen of measuring on several frames: expected spots, and what stands under a measurement. */
import { say } from "../../core/messages";
import type { Measurement } from "../../core/types";
import { formatLength, formatSpeed, speedScale } from "../../core/units";
import { PointMark } from "../../viewer/Overlay";
import { fromServer, type ImagePoint } from "../../viewer/points";
import type { FrameStage } from "../../viewer/stage";
import type { MeasureModel } from "./model";

/** Where the points are expected, and the contact that is clicked already. */
export function SecondMarks({ model }: { model: MeasureModel }) {
  const { second, stage } = model;
  if (!second.now.value) return null;
  const wanted = second.awaiting.value;
  const contact = second.contact.value;
  return (
    <g data-testid="second-frame-spots">
      {second.spots.value.map((spot) => {
        const word =
          spot.assumed_kmh === null
            ? say("measure-second-expected")
            : say("measure-second-expected-at", {
                speed: formatSpeed(spot.assumed_kmh / speedScale("m")[0], null, 0),
              });
        const key = `${spot.assumed_kmh} ${spot.travel_m}`;
        return (
          <g key={key}>
            {wanted === "contact" && <Expected stage={stage} at={fromServer(spot.contact)} text={word} />}
            {wanted !== null && (
              <Expected
                stage={stage}
                at={fromServer(spot.target_point)}
                text={wanted === "point" ? word : undefined}
              />
            )}
          </g>
        );
      })}
      {contact && wanted === "point" && <PointMark stage={stage} at={contact} kind="contact" />}
    </g>
  );
}

/** A place to look at, not a point: a dashed ring that leaves its middle free. */
function Expected({ stage, at, text }: { stage: FrameStage; at: ImagePoint; text?: string | undefined }) {
  const [x, y] = stage.view.value.toScreen(at);
  return (
    <g class="point-mark point-mark--expected" transform={`translate(${x} ${y})`}>
      <circle class="point-mark__halo" r="15" />
      <circle class="point-mark__line" r="15" />
      {text && (
        <text class="overlay-word" x={20} y={4}>
          {text}
        </text>
      )}
    </g>
  );
}

export function FramesSaid({ m }: { m: Measurement }) {
  if (m.more_frames.length === 0) return null;
  const count = m.more_frames.length + 1;
  const inset = formatLength(m.solved_inset_m, 2);
  const u_inset = formatLength(m.u_solved_inset_m, 2);
  return (
    <p class="height-row__said muted" data-testid="frames-said">
      {m.solved_inset_m === null
        ? say("measure-frames-said", { count })
        : say("measure-frames-said-inset", { count, inset, u_inset })}
    </p>
  );
}
