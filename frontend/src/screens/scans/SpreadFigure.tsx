/** The cumulative distribution of one quantity with its band, and the percentiles that are asked for. */
import { apart, say, sentenceOf, withUnit, wordsOf } from "../../core/messages";
import type { ScanSpread } from "../../core/types";
import { fixed, lengthScale, plainPercent, type Scale, speedScale } from "../../core/units";
import { aroundOne, ECDF_COLUMNS, ecdfMarks, ecdfRows, noBandWords } from "../../parts/figures/curves";
import { PlotFigure } from "../../parts/figures/PlotFigure";

const TITLES: Readonly<Record<string, string>> = wordsOf(
  "motion-",
  "speed",
  "length",
  "time_gap",
  "distance_gap",
  "headway",
);
/** On the axis, where the title stands above: in a word or two. */
const SHORT: Readonly<Record<string, string>> = wordsOf({
  speed: "scan-head-speed",
  length: "scan-head-length",
  time_gap: "scan-evidence-time_gap",
  distance_gap: "scan-evidence-distance_gap",
  headway: "scan-head-headway",
});
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
  const percentiles = apart(asked.map((one) => percentileWords(one, by)));
  const notes = [
    percentiles && say("motion-spread-note", { unit, percentiles }),
    there ? (noBandWords(ecdf.n) ?? say("statistics-target-ecdf-note")) : null,
  ];
  return (
    <PlotFigure
      name={`scan-${spread.quantity}`}
      title={title}
      says={say("motion-spread-says", { count: spread.n, percentiles, unit })}
      data={spread}
      reason={there ? null : sentenceOf(ecdf.reason)}
      note={there ? notes.filter(Boolean).join(" ") || undefined : undefined}
      options={(plot) => ({
        height: 240,
        x: {
          label: withUnit(SHORT[spread.quantity] ?? title, unit),
          ...(there ? aroundOne(ecdf.value.map((one) => one * by)) : {}),
        },
        y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
        marks: there
          ? [
              ...ecdfMarks(plot, ecdf, { word: "", band: true }, by),
              plot.ruleX(
                asked.flatMap((one) => (one.percent === 85 && one.value !== null ? [one.value * by] : [])),
                { stroke: "var(--ink-2)", strokeDasharray: "4 3" },
              ),
            ]
          : [],
      })}
      table={() => ({
        columns: [`${spread.quantity}_${spread.unit.replace("/", "p")}`, ...ECDF_COLUMNS],
        rows: there ? ecdfRows("", ecdf).map(([, ...row]) => row) : [],
      })}
    />
  );
}

function percentileWords(one: ScanSpread["percentiles"][number], by: number): string {
  const percent = plainPercent(one.percent);
  if (one.value === null) return sentenceOf(one.reason) ?? "";
  const value = fixed(one.value * by, 2);
  if (one.low === null || one.high === null) return say("motion-percentile", { percent, value });
  const [low, high] = [fixed(one.low * by, 2), fixed(one.high * by, 2)];
  return say("motion-percentile-interval", { percent, value, low, high });
}
