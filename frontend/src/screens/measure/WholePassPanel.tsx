/** A pass that is followed: what comes of it, and what to do with it. */
import { Button } from "../../components";
import { type Said, say, sentenceOf } from "../../core/messages";
import { formatHeight, formatLength, formatSpeed } from "../../core/units";
import { heightOrReason } from "../../viewer/geometry";
import type { MeasureModel } from "./model";

const MOST_REASONS = 3;

/** The height of the whole pass beside the way to keep it. */
export function WholePassPanel({ model }: { model: MeasureModel }) {
  const { whole } = model;
  const now = whole.now.value;
  if (whole.looking.value) return <p class="small muted">{say("measure-whole-looking")}</p>;
  if (!now) return null;
  const { height, points, dropped } = now.answer;
  const ok = height?.status === "ok";
  return (
    <section class="whole-pass" data-testid="whole-pass">
      <h3 class="small">{say("measure-whole-heading")}</h3>
      <dl class="facts small">
        <dt>{say("measure-whole-height")}</dt>
        <dd>{height && heightOrReason(height)}</dd>
        {height?.single && (
          <>
            <dt>{say("measure-one-frame")}</dt>
            <dd>{formatHeight(height.single.height_m, height.single.U95_height_m)}</dd>
          </>
        )}
        <dt>{say("measure-whole-frames")}</dt>
        <dd>
          {say("measure-whole-frames-used", { used: height?.frames ?? 0, all: whole.frames.value.length })}
        </dd>
        {height?.solved_inset_m != null && (
          <>
            <dt>{say("measure-inset")}</dt>
            <dd>{formatHeight(height.solved_inset_m, 1.96 * (height.u_solved_inset_m ?? 0))}</dd>
          </>
        )}
        {height?.speed_mps != null && (
          <>
            <dt>{say("measure-whole-speed")}</dt>
            <dd>{formatSpeed(Math.abs(height.speed_mps), null, 1)}</dd>
          </>
        )}
        {height?.wheelbase_m != null && (
          <>
            <dt>{say("measure-whole-wheelbase")}</dt>
            <dd>{formatLength(height.wheelbase_m)}</dd>
          </>
        )}
      </dl>
      <ul class="small muted">
        {reasonsOf(dropped)
          .slice(0, MOST_REASONS)
          .map(([reason, count]) => (
            <li key={reason}>{say("measure-whole-dropped", { reason, count })}</li>
          ))}
      </ul>
      <p class="small muted">{say("measure-whole-look", { count: points.length })}</p>
      <Button small kind="primary" disabled={!ok} onClick={() => whole.keep()}>
        {say("measure-whole-keep")}
      </Button>{" "}
      <Button small onClick={() => whole.forget()}>
        {say("measure-whole-leave")}
      </Button>
    </section>
  );
}

function reasonsOf(dropped: readonly { readonly reason: Said }[]): [string, number][] {
  const counts = new Map<string, number>();
  for (const reason of dropped.map((one) => sentenceOf(one.reason)))
    counts.set(reason, (counts.get(reason) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}
