/** A pass that is followed: what comes of it, and what to do with it. */
import { Button, Facts } from "../../components";
import { type Said, say, sentenceOf } from "../../core/messages";
import { formatHeight, formatLength, formatSpeed } from "../../core/units";
import { heightOrReason } from "../../viewer/geometry";
import type { MeasureModel } from "./model";

const MOST_REASONS = 3;

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
      <Facts
        small
        of={[
          [say("measure-whole-height"), height && heightOrReason(height)],
          height?.single && [
            say("measure-one-frame"),
            formatHeight(height.single.height_m, height.single.U95_height_m),
          ],
          [
            say("measure-whole-frames"),
            say("measure-whole-frames-used", { used: height?.frames ?? 0, all: whole.frames.value.length }),
          ],
          height?.solved_inset_m != null && [
            say("measure-inset"),
            formatHeight(height.solved_inset_m, 1.96 * (height.u_solved_inset_m ?? 0)),
          ],
          height?.speed_mps != null && [
            say("measure-whole-speed"),
            formatSpeed(Math.abs(height.speed_mps), null, 1),
          ],
          height?.wheelbase_m != null && [say("measure-whole-wheelbase"), formatLength(height.wheelbase_m)],
        ]}
      />
      <ul class="small muted">
        {reasonsOf(dropped)
          .slice(0, MOST_REASONS)
          .map(([reason, count]) => (
            <li key={reason}>{say("measure-whole-dropped", { reason, count })}</li>
          ))}
      </ul>
      <p class="small muted">{say("measure-whole-look", { count: points.length })}</p>
      <Button says="measure-whole-keep" small kind="primary" disabled={!ok} onClick={() => whole.keep()} />{" "}
      <Button says="measure-whole-leave" small onClick={() => whole.forget()} />
    </section>
  );
}

function reasonsOf(dropped: readonly { readonly reason: Said }[]): [string, number][] {
  const counts = new Map<string, number>();
  for (const reason of dropped.map((one) => sentenceOf(one.reason)))
    counts.set(reason, (counts.get(reason) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}
