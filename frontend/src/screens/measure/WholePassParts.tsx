/** What is seen of a pass that was followed: its points on the frame, its frames on the timeline. */
import { say } from "../../core/messages";
import type { Measurement } from "../../core/types";
import { formatLength } from "../../core/units";
import { PointMark } from "../../viewer/Overlay";
import { fromServer } from "../../viewer/points";
import type { Span } from "../../viewer/spans";
import type { MeasureModel } from "./model";

export function FollowedMarks({ model }: { model: MeasureModel }) {
  return (
    <g data-testid="followed-points">
      {model.whole.here.value.map((one) => (
        <PointMark
          key={one.point}
          stage={model.stage}
          at={fromServer(one.at)}
          kind={one.point === "target" ? "point" : "contact"}
          faint
          text={say("measure-followed-mark", { point: one.point })}
        />
      ))}
    </g>
  );
}

/** Frames of the pass that are used, and those that are not, as spans of the timeline. */
export function followedSpans(model: MeasureModel): Span[] {
  return model.whole.frames.value.map(({ frame, whole }) => ({
    id: `followed-${frame}`,
    first: frame,
    last: frame,
    label: "",
    title: say("measure-followed-frame", { frame: String(frame), used: whole ? "yes" : "no" }),
    kind: whole ? "followed" : "dropped",
  }));
}

export function PassSaid({ m }: { m: Measurement }) {
  if (!m.followed) return null;
  return (
    <p class="height-row__said muted" data-testid="pass-said">
      {say("measure-whole-said", {
        inset: formatLength(m.solved_inset_m, 2),
        u_inset: formatLength(m.u_solved_inset_m, 2),
      })}
    </p>
  );
}
