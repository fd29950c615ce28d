/** Vehicles a minute over the last hour; minutes that were not watched whole are hatched. */
import { say } from "../../core/messages";
import { formatClock } from "../../core/times";
import type { LiveStream } from "../../core/types";

type Minutes = LiveStream["flow"];
const LEAST_TOP = 5;

export function Flow({ flow }: { flow: Minutes }) {
  const top = Math.max(LEAST_TOP, ...flow.map((one) => one.vehicles));
  const whole = flow.filter((one) => one.whole).at(-1);
  return (
    <figure class="live-flow" data-testid="live-flow">
      <figcaption class="row row--apart">
        <span>{say("live-flow")}</span>
        <span class="muted">
          {whole
            ? say("live-flow-last", { time: formatTime(whole.begin), vehicles: whole.vehicles })
            : say("live-flow-none")}
        </span>
      </figcaption>
      <div class="live-flow__plot">
        <div class="live-flow__scale" aria-hidden="true">
          <span>{top}</span>
          <span>0</span>
        </div>
        <ol class="live-flow__bars">
          {flow.map((one) => (
            <li key={one.begin} title={minuteWords(one)}>
              <span
                class={one.whole ? "live-flow__bar" : "live-flow__bar live-flow__bar--part"}
                style={{ height: `${(100 * one.vehicles) / top}%` }}
              />
              <span class="visually-hidden">{minuteWords(one)}</span>
            </li>
          ))}
        </ol>
      </div>
      <div class="live-flow__times row row--apart small muted" aria-hidden="true">
        <span>{flow[0] && formatTime(flow[0].begin)}</span>
        <span>{flow.length > 1 && formatTime(flow[flow.length - 1]?.begin ?? "")}</span>
      </div>
    </figure>
  );
}

function minuteWords(one: Minutes[number]): string {
  return say(one.whole ? "live-flow-minute" : "live-flow-part", {
    time: formatTime(one.begin),
    vehicles: one.vehicles,
  });
}

function formatTime(iso: string): string {
  return formatClock(new Date(iso)).replace(/:\d\d$/, "");
}
