/** The cumulative distribution of one quantity with its band, and the percentiles that are asked for. */

import type { ScanSpread } from "../../core/types";
import { fixed, lengthScale, type Scale, speedScale } from "../../core/units";
import { ecdfMarks } from "../../parts/figures/curves";
import { PlotFigure } from "../../parts/figures/PlotFigure";

const TITLES: Record<string, string> = {
  speed: "Speed as the front reaches camera 1",
  length: "Length",
  time_gap: "Time gap, rear to front",
  distance_gap: "Distance gap, rear to front",
  headway: "Headway, front to front",
};
/** 85: the speed that limits are set by. */
const ASKED = [15, 50, 85];

/** Factor from the server's unit, and the unit that is shown. */
function shown(unit: string): Scale {
  if (unit === "m/s") return speedScale();
  if (unit === "m") return lengthScale();
  return [1, unit];
}

export function SpreadFigure({ spread }: { spread: ScanSpread }) {
  const { ecdf } = spread;
  const [by, unit] = shown(spread.unit);
  const title = TITLES[spread.quantity] ?? spread.quantity;
  const there = "value" in ecdf;
  const asked = spread.percentiles.filter((one) => ASKED.includes(one.percent));
  const words = asked.map((one) => {
    if (one.reason) return `${one.percent} %: ${one.reason}`;
    const within =
      one.low === null || one.high === null
        ? ""
        : ` (${fixed(one.low * by, 2)} to ${fixed(one.high * by, 2)})`;
    return `${one.percent} %: ${fixed(one.value * by, 2)}${within}`;
  });
  return (
    <PlotFigure
      name={`scan-${spread.quantity}`}
      title={title}
      says={`Cumulative distribution of ${spread.n} vehicles; ${words.join("; ")} ${unit}`}
      data={spread}
      reason={there ? null : ecdf.reason}
      note={
        there && words.length > 0
          ? `Percentiles with their 95 % intervals, ${unit}: ${words.join("; ")}.`
          : undefined
      }
      options={(plot) => ({
        height: 240,
        x: { label: unit, grid: true },
        y: { label: "% of the vehicles", domain: [0, 100], grid: true },
        marks: there
          ? [
              ...ecdfMarks(plot, ecdf, { word: "", band: true }, by),
              plot.ruleX(
                asked.filter((one) => one.percent === 85 && !one.reason).map((one) => one.value * by),
                { stroke: "var(--ink-2)", strokeDasharray: "4 3" },
              ),
            ]
          : [],
      })}
      table={() => ({
        columns: [
          `${spread.quantity}_${spread.unit.replace("/", "p")}`,
          "share",
          "band95_low",
          "band95_high",
        ],
        rows: there
          ? ecdf.value.map((value, n) => [
              value,
              ecdf.share[n] ?? null,
              ecdf.low[n] ?? null,
              ecdf.high[n] ?? null,
            ])
          : [],
      })}
    />
  );
}
