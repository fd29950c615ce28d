/** How a stream is, in figures: what came, what was lost, the light, the clock, the memory. */
import { say } from "../../core/messages";
import { formatDuration } from "../../core/times";
import type { LiveStream } from "../../core/types";
import { fixed, formatCount } from "../../core/units";

const MOST_DN = 255;

export function Health({ stream }: { stream: LiveStream }) {
  const { health } = stream;
  if (!health) return null;
  return (
    <dl class="live__health" data-testid="live-health">
      <Figure name={say("live-time")} value={formatDuration(health.lines / stream.line_rate_hz)} />
      <Figure name={say("live-lines")} value={formatCount(health.lines)} />
      <Figure name={say("live-lost")} value={bothOf(health.lost_lines, formatCount)} />
      <Figure name={say("live-light")} value={bothOf(health.light_dn, lightOf)} />
      <Figure name={say("live-saturated")} value={bothOf(health.saturated, percentOf)} />
      <Figure name={say("live-clock")} value={`${fixed(health.clock_offset_s, 1)} s`} />
      <Figure name={say("live-waiting")} value={`${fixed(health.waiting_mib, 0)} MiB`} />
      <Figure name={say("live-memory")} value={`${fixed(health.memory_mib, 0)} MiB`} />
    </dl>
  );
}

function Figure({ name, value }: { name: string; value: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}

/** "0 / 32": camera 1, camera 2. */
function bothOf<T>(pair: readonly [T, T], word: (value: T) => string): string {
  return pair.map(word).join(" / ");
}

function lightOf(dn: number | null): string {
  return dn === null ? "–" : percentOf(dn / MOST_DN);
}

function percentOf(share: number): string {
  return `${fixed(100 * share, 0)} %`;
}
