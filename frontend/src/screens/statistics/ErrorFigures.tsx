import { say, sentenceOf } from "../../core/messages";
import type { Density, Ecdf, ErrorsBody, ReasonBody, TrendBody } from "../../core/types";
import { lengthScale, smallScale } from "../../core/units";
import {
  type Curve,
  DENSITY_COLUMNS,
  densityMarks,
  densityRows,
  ECDF_COLUMNS,
  ecdfMarks,
  ecdfRows,
  shareStep,
} from "../../parts/figures/curves";
import { fixedRange, NONE, range, scaled } from "../../parts/figures/numbers";
import { type LegendEntry, PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";
import { GROUP_WORDS, isThere } from "./model";

const CURVES: Record<string, Omit<Curve, "word">> = {
  daytime: { band: true },
  low_light: { dash: "7 4", hue: 1, band: true },
  overall: { dash: "2 3", faint: true },
};
const GROUPS = Object.keys(CURVES);

interface Drawn<T> {
  group: string;
  part: T;
  curve: Curve;
}

/** The groups that have something to draw; one that equals "overall" is drawn once. */
function drawn<T extends { n: number }>(parts: Record<string, T | ReasonBody>): Drawn<T>[] {
  const there = GROUPS.flatMap((group) => {
    const part = parts[group];
    return part && isThere<T>(part as T | ReasonBody)
      ? [{ group, part: part as T, curve: { ...CURVES[group], word: GROUP_WORDS[group] ?? group } }]
      : [];
  });
  const all = there.find((one) => one.group === "overall");
  const alone = there.some((one) => one !== all && one.part.n === all?.part.n);
  const list = there.filter((one) => one !== all || !alone);
  return list.length > 1
    ? list
    : list.map((one) => ({ ...one, curve: { word: one.curve.word, band: true } }));
}

function reasonOf(parts: Record<string, { n: number } | ReasonBody>): string | null {
  if (drawn(parts as Record<string, { n: number } | ReasonBody>).length > 0) return null;
  const overall = parts["overall"];
  return overall && "reason" in overall
    ? say("statistics-nothing-because", { reason: sentenceOf(overall.reason) })
    : say("statistics-nothing");
}

/** The figures of the error: its size, its share of the height, its density, and how it goes with the height. */
export function ErrorFigures({ errors }: { errors: ErrorsBody }) {
  return (
    <div class="stat-figures">
      <ShareFigure errors={errors} of="absolute" />
      <ShareFigure errors={errors} of="relative" />
      <DensityFigure errors={errors} />
      <TrendFigure errors={errors} />
    </div>
  );
}

function counts(list: readonly Drawn<{ n: number }>[]): string {
  return list
    .map(({ group, part }) => say("statistics-group-n", { group: GROUP_WORDS[group] ?? group, n: part.n }))
    .join(", ");
}

/** Which share of the errors is no larger, by size or by their part of the height. */
function ShareFigure({ errors, of }: { errors: ErrorsBody; of: "absolute" | "relative" }) {
  const list = drawn<Ecdf>(errors[of]);
  const groups = counts(list);
  return (
    <PlotFigure
      name={`${of}-error-ecdf`}
      title={say(`statistics-${of}-title`)}
      says={say(`statistics-${of}-says`, { groups })}
      note={say(`statistics-${of}-note`, { groups })}
      legend={list.map(({ curve }) => curve)}
      reason={reasonOf(errors[of])}
      data={errors}
      options={(plot, unit) => {
        const [perX, small] = smallScale(unit);
        const [factor, label] =
          of === "absolute"
            ? [perX, say("statistics-absolute-x", { unit: small })]
            : [100, say("statistics-relative-x")];
        return {
          x: { label, zero: true, nice: true },
          y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
          marks: list.flatMap((one) => ecdfMarks(plot, one.part, one.curve, factor)),
        };
      }}
      table={() => ({
        columns: ["lighting", of === "absolute" ? "absolute_error_m" : "relative_error", ...ECDF_COLUMNS],
        rows: list.flatMap((one) => ecdfRows(one.group, one.part)),
      })}
    />
  );
}

const ROUNDING_M = 0.01;

/** How the density is made. A kernel narrower than half of the rounding would draw it as a comb. */
function densityNote(list: readonly Drawn<Density>[], rounded: boolean): string | undefined {
  if (list.length === 0) return undefined;
  const bandwidths = list.map((one) => fixedRange(one.part.bandwidth)).join(", ");
  const groups = counts(list);
  return rounded
    ? say("statistics-density-note-rounded", { bandwidths, groups, rounding: fixedRange(ROUNDING_M) })
    : say("statistics-density-note", { bandwidths, groups });
}

function DensityFigure({ errors }: { errors: ErrorsBody }) {
  const list = drawn<Density>(errors.density);
  return (
    <PlotFigure
      name="signed-error-density"
      title={say("statistics-density-title")}
      says={say("statistics-density-says", { groups: counts(list) })}
      note={densityNote(list, errors.rounding === "cm")}
      legend={list.map(({ curve }) => curve)}
      reason={reasonOf(errors.density)}
      data={errors}
      options={(plot, unit) => {
        const [perX, small] = smallScale(unit);
        return {
          x: { label: say("statistics-signed-error", { unit: small }) },
          y: {
            label: say("statistics-density-y", { unit: shareStep(unit, true).name }),
            zero: true,
            nice: true,
          },
          marks: [
            plot.ruleX([0], { stroke: "var(--line-strong)" }),
            ...list.flatMap((one) => densityMarks(plot, one.part, one.curve, perX, shareStep(unit, true).m)),
          ],
        };
      }}
      table={() => ({
        columns: ["lighting", "signed_error_m", ...DENSITY_COLUMNS],
        rows: list.flatMap((one) => densityRows(one.group, one.part)),
      })}
    />
  );
}

const SYMBOLS = { daytime: "circle", low_light: "triangle", unknown: "square" } as const;
type Lit = keyof typeof SYMBOLS;
const LIT = Object.keys(SYMBOLS) as Lit[];
type Row = { height: number; error: number; lighting: Lit };

/** Signed error over the true height, points told apart by shape, the regression with its band. */
function TrendFigure({ errors }: { errors: ErrorsBody }) {
  const { points } = errors;
  const rows: Row[] = points.reference_m.map((height, i) => ({
    height,
    error: points.error_m[i] as number,
    lighting: points.lighting[i] as Lit,
  }));
  const line = isThere<TrendBody>(errors.trend) ? errors.trend : null;
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
export function trendWords({ trend, absolute_trend }: ErrorsBody): string {
  if (!isThere<TrendBody>(trend)) return sentenceOf(trend.reason);
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
  if (!isThere<TrendBody>(absolute_trend)) return signed;
  return `${signed} ${say("statistics-trend-absolute", correlationWords(absolute_trend))}`;
}

function correlationWords({ correlation }: TrendBody) {
  return { correlation: scaled(correlation, 1, 2) };
}
