import { say, sentenceOf } from "../../core/messages";
import { lengthScale, smallScale } from "../../core/units";
import { NONE, range, scaled } from "../../parts/figures/numbers";
import { type LegendEntry, PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";
import { type Errors, GROUP_WORDS, isThere, type Trend } from "./model";

const SYMBOLS = { daytime: "circle", low_light: "triangle", unknown: "square" } as const;
type Lit = keyof typeof SYMBOLS;
const LIT = Object.keys(SYMBOLS) as Lit[];
type Row = { height: number; error: number; lighting: Lit };

/** Signed error over the true height, points told apart by shape, the regression with its band. */
export function TrendFigure({ errors }: { errors: Errors }) {
  const { points } = errors;
  const rows: Row[] = points.reference_m.map((height, i) => ({
    height,
    error: points.error_m[i] as number,
    lighting: points.lighting[i] as Lit,
  }));
  const line = isThere<Trend>(errors.trend) ? errors.trend : null;
  const present = LIT.filter((one) => rows.some((row) => row.lighting === one));
  const legend: LegendEntry[] = present.map((one) => ({ word: GROUP_WORDS[one] ?? one, dot: SYMBOLS[one] }));
  if (line) legend.push({ word: say("statistics-trend-legend") });
  return (
    <PlotFigure
      name="error-against-height"
      title={say("statistics-trend-title")}
      says={`${say("statistics-trend-says", { count: rows.length })} ${trendWords(errors)}`}
      note={trendWords(errors)}
      legend={legend}
      reason={rows.length === 0 ? say("statistics-trend-nothing") : null}
      data={errors}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        const [perY, small] = smallScale(unit);
        const fit = {
          x: (i: number) => (line?.at[i] ?? 0) * perX,
          y: (i: number) => (line?.value[i] ?? 0) * perY,
          low: (i: number) => (line?.low[i] ?? 0) * perY,
          high: (i: number) => (line?.high[i] ?? 0) * perY,
        };
        const along = line ? [...line.at.keys()] : [];
        const where = { x: (row: Row) => row.height * perX, y: (row: Row) => row.error * perY };
        return {
          x: { label: say("statistics-trend-x", { unit: long }), nice: true, inset: 4 },
          y: { label: say("statistics-signed-error", { unit: small }), nice: true, inset: 4 },
          symbol: { domain: LIT, range: Object.values(SYMBOLS), legend: false },
          marks: [
            plot.ruleY([0], { stroke: "var(--line-strong)" }),
            plot.areaY(along, { x: fit.x, y1: fit.low, y2: fit.high, fill: "var(--ink)", fillOpacity: 0.09 }),
            readable(
              plot.line(along, { x: fit.x, y: fit.y, stroke: "var(--ink)", strokeWidth: 2 }),
              readRows(along, fit, "line", say("statistics-trend-legend")),
            ),
            readable(
              plot.dot(rows, {
                ...where,
                symbol: "lighting",
                r: rows.length > 300 ? 2.5 : 4,
                fill: "var(--surface)",
                fillOpacity: rows.length > 300 ? 0 : 1,
                stroke: "var(--ink)",
                strokeOpacity: rows.length > 300 ? 0.6 : 1,
                strokeWidth: 1.25,
              }),
              ...present.map((lighting) => {
                const y = (row: Row) => (row.lighting === lighting ? where.y(row) : null);
                return readRows(rows, { ...where, y }, "points", GROUP_WORDS[lighting]);
              }),
            ),
          ],
        };
      }}
      table={() => ({
        columns: [
          "part",
          "lighting",
          "reference_height_m",
          "signed_error_m",
          "band95_low_m",
          "band95_high_m",
        ],
        rows: [
          ...rows.map((row) => ["vehicle", row.lighting, row.height, row.error, null, null]),
          ...(line?.at.map((at, i) => ["regression", null, at, line.value[i], line.low[i], line.high[i]]) ??
            []),
        ],
      })}
    />
  );
}

/** "−12 mm per m (−20 to −4), r = −0.31 (…)." */
export function trendWords({ trend, absolute_trend }: Errors): string {
  if (!isThere<Trend>(trend)) return sentenceOf(trend.reason);
  const [factor, small] = smallScale();
  const [toLong, long] = lengthScale();
  const per = factor / toLong;
  const digits = long === "ft" ? 3 : 1; // 0.1 mm per m are 0.0012 in per ft
  const signed = say("statistics-trend", {
    slope: scaled(trend.slope, per, digits),
    small,
    unit: long,
    slope_interval: range(trend.slope_ci95, per, digits) ?? NONE,
    ...correlationWords(trend),
  });
  if (!isThere<Trend>(absolute_trend)) return signed;
  return `${signed} ${say("statistics-trend-absolute", correlationWords(absolute_trend))}`;
}

function correlationWords({ correlation }: Trend) {
  return { correlation: scaled(correlation, 1, 2) };
}
