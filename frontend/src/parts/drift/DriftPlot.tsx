/** How far the picture moved over the recording's time: a dot a look, the floor as a band, moved parts shaded. */
import { say, sentenceOf } from "../../core/messages";
import type { DriftCheck } from "../../core/types";
import { fixed, formatLength, formatSmall } from "../../core/units";

const WIDTH = 420;
const HEIGHT = 92;
const LEFT = 44;
const RIGHT = 8;
const TOP = 8;
const BOTTOM = 18;

export function DriftPlot({ check }: { check: DriftCheck }) {
  const told = check.looks.filter((look) => look.moved_px !== null);
  const end = Math.max(...check.looks.map((look) => look.time_s), 0.1);
  const floor = check.floor_px ?? 0;
  const top = Math.max(...told.map((look) => look.moved_px ?? 0), 2 * floor, 0.1) * 1.1;
  const x = (time_s: number): number => LEFT + (time_s / end) * (WIDTH - LEFT - RIGHT);
  const y = (px: number): number => HEIGHT - BOTTOM - (px / top) * (HEIGHT - TOP - BOTTOM);
  const worst = told.reduce((most, look) => Math.max(most, Math.abs(look.change_m ?? 0)), 0);
  return (
    <figure class="drift__figure">
      <svg
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-label={check.words.map(sentenceOf).join(" ")}
        class="drift__plot"
      >
        <rect
          class="drift__floor"
          x={LEFT}
          y={y(floor)}
          width={WIDTH - LEFT - RIGHT}
          height={y(0) - y(floor)}
        />
        {check.bumps.map((bump) => (
          <line
            key={bump.frame}
            class="drift__bump"
            x1={x(bump.time_s)}
            x2={x(bump.time_s)}
            y1={TOP}
            y2={y(0)}
          />
        ))}
        <path class="drift__axis" d={`M${LEFT} ${TOP}V${y(0)}H${WIDTH - RIGHT}`} />
        {told.map((look) => (
          <circle key={look.frame} class="drift__dot" cx={x(look.time_s)} cy={y(look.moved_px ?? 0)} r={2.2}>
            <title>{lookWords(look)}</title>
          </circle>
        ))}
        <text class="drift__word" x={LEFT - 5} y={TOP + 6} text-anchor="end">
          {say("value-px", { value: fixed(top, top < 1 ? 2 : 1) })}
        </text>
        <text class="drift__word" x={LEFT - 5} y={y(0)} text-anchor="end">
          0
        </text>
        <text class="drift__word" x={LEFT} y={HEIGHT - 4}>
          {say("value-s", { value: "0" })}
        </text>
        <text class="drift__word" x={WIDTH - RIGHT} y={HEIGHT - 4} text-anchor="end">
          {say("value-s", { value: fixed(end, 0) })}
        </text>
      </svg>
      <figcaption class="small muted">
        {say("drift-figure", {
          count: told.length,
          untold: check.looks.length - told.length,
          worst: formatSmall(worst),
          target: formatLength(check.target_m, 2),
          distance: formatLength(check.distance_m, 1),
        })}
      </figcaption>
    </figure>
  );
}

function lookWords({ frame, moved_px, change_m }: DriftCheck["looks"][number]): string {
  const change = formatSmall(change_m ?? null);
  return say("drift-look", { frame: String(frame), moved_px: fixed(moved_px ?? 0, 2), change });
}
