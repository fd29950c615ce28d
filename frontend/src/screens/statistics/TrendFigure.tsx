import { say, sentenceOf } from "../../core/messages";
import { lengthScale, smallScale } from "../../core/units";
import { NONE, range, scaled } from "../../parts/figures/numbers";
import { type LegendEntry, PlotFigure } from "../../parts/figures/PlotFigure";
import { readable } from "../../parts/figures/reading";
import { type Errors, GROUP_WORDS, isThere, type Trend } from "./model";

const SYMBOLS = { daytime: "circle", low_light: "triangle", unknown: "square" } as const;

/** Signed error over the true height, points told apart by shape, the regression with its band. */
export function TrendFigure({ errors }: { errors: Errors }) {
  const { points } = errors;
  const rows = points.reference_m.map((height, i) => ({
    height,
    error: points.error_m[i] as number,
    lighting: points.lighting[i] as keyof typeof SYMBOLS,
  }));
  const line = isThere<Trend>(errors.trend) ? errors.trend : null;
  const present = (Object.keys(SYMBOLS) as (keyof typeof SYMBOLS)[]).filter((one) =>
    rows.some((row) => row.lighting === one),
  );
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
        const fit = line?.at.map((at, i) => ({
          x: at * perX,
          y: (line.value[i] ?? 0) * perY,
          low: (line.low[i] ?? 0) * perY,
          high: (line.high[i] ?? 0) * perY,
        }));
        return {
          x: { label: say("statistics-trend-x", { unit: long }), nice: true, inset: 4 },
          y: { label: say("statistics-signed-error", { unit: small }), nice: true, inset: 4 },
          symbol: { domain: Object.keys(SYMBOLS), range: Object.values(SYMBOLS), legend: false },
          marks: [
            plot.ruleY([0], { stroke: "var(--line-strong)" }),
            ...(fit
              ? [
                  plot.areaY(fit, { x: "x", y1: "low", y2: "high", fill: "var(--ink)", fillOpacity: 0.09 }),
                  readable(plot.line(fit, { x: "x", y: "y", stroke: "var(--ink)", strokeWidth: 2 }), {
                    word: say("statistics-trend-legend"),
                    x: fit.map((one) => one.x),
                    y: fit.map((one) => one.y),
                    low: fit.map((one) => one.low),
                    high: fit.map((one) => one.high),
                    way: "line",
                  }),
                ]
              : []),
            readable(
              plot.dot(rows, {
                x: (row: (typeof rows)[number]) => row.height * perX,
                y: (row: (typeof rows)[number]) => row.error * perY,
                symbol: "lighting",
                r: rows.length > 300 ? 2.5 : 4,
                fill: "var(--surface)",
                fillOpacity: rows.length > 300 ? 0 : 1,
                stroke: "var(--ink)",
                strokeOpacity: rows.length > 300 ? 0.6 : 1,
                strokeWidth: 1.25,
              }),
              ...present.map((lighting) => ({
                word: GROUP_WORDS[lighting] ?? lighting,
                x: rows.map((row) => row.height * perX),
                y: rows.map((row) => (row.lighting === lighting ? row.error * perY : null)),
                way: "points" as const,
              })),
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
function trendWords({ trend, absolute_trend }: Errors): string {
  if (!isThere<Trend>(trend)) return sentenceOf(trend.reason);
  const [factor, small] = smallScale();
  const [toLong, long] = lengthScale();
  const per = factor / toLong;
  const signed = say("statistics-trend", {
    slope: scaled(trend.slope, per, 1),
    small,
    unit: long,
    slope_interval: range(trend.slope_ci95, per, 1) ?? NONE,
    ...correlationWords(trend),
  });
  if (!isThere<Trend>(absolute_trend)) return signed;
  return `${signed} ${say("statistics-trend-absolute", correlationWords(absolute_trend))}`;
}

function correlationWords({ correlation }: Trend) {
  return { correlation: scaled(correlation, 1, 2) };
}
