/**
 * Marks of the figures. Three hues that are not the road's axes', dashes and words tell lines apart, never a hue alone.
 */
import { say } from "../../core/messages";
import type { Density, Ecdf, Standard } from "../../core/types";
import { fixed, type LengthUnit } from "../../core/units";
import type { Cell } from "./csv";
import { hueOf, inkOf } from "./hues";
import type { LegendEntry, Plot } from "./PlotFigure";
import { readable } from "./reading";
import { inWords, limitDigits } from "./standards";

export interface Curve extends Omit<LegendEntry, "dot"> {
  band?: boolean;
}

type Mark = ReturnType<Plot["line"]>;

/** A simultaneous band of fewer covers more than half of the axis and hides the curves; it is read all the same. */
const LEAST_FOR_A_BAND = 30;

/** One value alone spans no axis: units of its first digit about it do, 50 to 70 about 63. Numbers that are none (NaN)
 *  count for nothing. */
export function aroundOne(values: readonly number[]): { domain?: [number, number] } {
  const there = values.filter(Number.isFinite);
  const [least, most] = [Math.min(...there), Math.max(...there)];
  if (least !== most) return {};
  const unit = least === 0 ? 1 : 10 ** Math.floor(Math.log10(Math.abs(least)));
  const low = unit * (Math.round(least / unit) - 1);
  return { domain: [least < 0 ? low : Math.max(0, low), low + 2 * unit] };
}

interface CurvePoint {
  x: number;
  y: number;
  low: number | null;
  high: number | null;
}

/** A curve as it is drawn and read, with its band where that is asked for and stands on enough; `from`: where the line
 *  begins before its first point. */
function curveMarks(
  plot: Plot,
  points: readonly CurvePoint[],
  { n, way, from = [] }: { n: number; way: "steps" | "line"; from?: readonly { x: number; y: number }[] },
  curve: Curve,
): Mark[] {
  const bent = way === "steps" ? ({ curve: "step-after" } as const) : {};
  const marks: Mark[] = [];
  if (curve.band && n >= LEAST_FOR_A_BAND) {
    const within = { y1: (one: CurvePoint) => one.low ?? 0, y2: (one: CurvePoint) => one.high ?? 0 };
    marks.push(plot.areaY(points, { x: "x", ...within, ...bent, fill: hueOf(curve), fillOpacity: 0.09 }));
  }
  const line = plot.line([...from, ...points], {
    x: "x",
    y: "y",
    ...bent,
    stroke: hueOf(curve),
    strokeWidth: curve.faint ? 1.5 : 2,
    strokeDasharray: curve.dash,
  });
  const { word } = curve;
  const banded = curve.band ? { low: points.map((one) => one.low), high: points.map((one) => one.high) } : {};
  const [x, y] = [points.map((one) => one.x), points.map((one) => one.y)];
  marks.push(readable(line, { word, ink: inkOf(curve), x, y, ...banded, way }));
  return marks;
}

export function ecdfMarks(plot: Plot, ecdf: Ecdf, curve: Curve, perX: number): Mark[] {
  const percent = (of: number | null | undefined) => (of == null ? null : 100 * of);
  const points = ecdf.value.map((value, i) => ({
    x: value * perX,
    y: percent(ecdf.share[i]) ?? 0,
    low: percent(ecdf.low[i]),
    high: percent(ecdf.high[i]),
  }));
  const from = [{ x: (ecdf.value[0] ?? 0) * perX, y: 0 }];
  return curveMarks(plot, points, { n: ecdf.n, way: "steps", from }, curve);
}

/** Steps of a density's axis: a share is read "per centimetre" or "per inch", not "per metre"; of errors in finer ones. */
export function shareStep(unit: LengthUnit, fine = false): { m: number; name: string } {
  if (unit === "ft") return fine ? { m: 0.00254, name: "0.1 in" } : { m: 0.0254, name: "in" };
  return fine ? { m: 0.001, name: "mm" } : { m: 0.01, name: "cm" };
}

/** A density with its band: per cent of the vehicles in each `stepM` of the axis. */
export function densityMarks(
  plot: Plot,
  density: Density,
  curve: Curve,
  perX: number,
  stepM: number,
): Mark[] {
  const perY = 100 * stepM;
  const points = density.value.map((value, i) => ({
    x: value * perX,
    y: (density.density[i] ?? 0) * perY,
    low: (density.low[i] ?? 0) * perY,
    high: (density.high[i] ?? 0) * perY,
  }));
  return curveMarks(plot, points, { n: density.n, way: "line" }, curve);
}

const TIER_PX = 16;
/** Above the frame: room for the name of the upward axis. */
const TOP_PX = 24;

/** The names of one height's standards, on a line of their own above the frame. */
interface Tier {
  x: number;
  word: string;
  /** Which way the word runs from its rule. */
  way: "start" | "end";
}

/** A line of names for each height, the highest first, so that no two meet however close their heights lie. */
export function standardTiers(
  standards: readonly Standard[],
  perX: number,
  unit: string,
  middle_m: number,
): Tier[] {
  const byHeight = new Map<number, string[]>();
  for (const one of standards)
    byHeight.set(one.height_m, [...(byHeight.get(one.height_m) ?? []), inWords(one).name]);
  const tiers = [...byHeight].map(
    ([height, names]): Tier => ({
      x: height * perX,
      word: say("figure-standard", {
        standards: names.join(", "),
        height: fixed(height * perX, limitDigits(height)),
        unit,
      }),
      way: height > middle_m ? "end" : "start",
    }),
  );
  // a word runs over the rules on its side, which therefore end below it
  const left = tiers.filter((one) => one.way === "start").sort((a, b) => a.x - b.x);
  const right = tiers.filter((one) => one.way === "end").sort((a, b) => b.x - a.x);
  return [...left, ...right];
}

export function noBandWords(n: number): string | null {
  return n < LEAST_FOR_A_BAND ? say("figure-no-band", { n, least: LEAST_FOR_A_BAND }) : null;
}

/** Shares of vehicles over their heights, below the names of the standards. */
export function standardAxes(tiers: readonly Tier[], unit: string) {
  const marginTop = tiers.length * TIER_PX + TOP_PX;
  return {
    marginTop,
    height: 296 + marginTop,
    x: { label: say("statistics-height-x", { unit }), nice: true, inset: 16 },
    y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
  };
}

/** Standards as upright rules, each up to its names. */
export function standardMarks(plot: Plot, tiers: readonly Tier[]): Mark[] {
  return tiers.flatMap((tier, i) => {
    const up = TIER_PX * (tiers.length - i);
    return [
      plot.ruleX([tier], { x: "x", stroke: "var(--accent-text)", strokeWidth: 1.5, insetTop: 2 - up }),
      plot.text([tier], {
        x: "x",
        text: "word",
        frameAnchor: "top",
        textAnchor: tier.way,
        lineAnchor: "top",
        dx: tier.way === "start" ? 5 : -5,
        dy: 2 - up,
        fill: "var(--accent-text)",
        stroke: "var(--surface)",
        strokeWidth: 3,
      }),
    ];
  });
}

/** The standards that lie in or near the values shown; others would squeeze the curves. */
export function nearby(standards: readonly Standard[], ecdfs: readonly Ecdf[]): Standard[] {
  const values = ecdfs.flatMap((one) => [one.value[0], one.value.at(-1)]).filter((v) => v !== undefined);
  if (values.length === 0) return [];
  const low = Math.min(...values);
  const high = Math.max(...values);
  const reach = Math.max(0.1, 0.4 * (high - low));
  return standards.filter((one) => one.height_m >= low - reach && one.height_m <= high + reach);
}

export function middleOf(ecdfs: readonly Ecdf[]): number {
  const ends = ecdfs.flatMap((one) => [one.value[0] ?? 0, one.value.at(-1) ?? 0]);
  return (Math.min(...ends) + Math.max(...ends)) / 2;
}

export const ECDF_COLUMNS = ["share", "band95_low", "band95_high", "n"] as const;

/** Rows of a cumulative distribution for its CSV: group, value, share, band, n. */
export function ecdfRows(word: string, ecdf: Ecdf): Cell[][] {
  return ecdf.value.map((value, i) => [word, value, ecdf.share[i], ecdf.low[i], ecdf.high[i], ecdf.n]);
}

export const DENSITY_COLUMNS = ["density_per_m", "band95_low_per_m", "band95_high_per_m", "n"] as const;

export function densityRows(word: string, density: Density): Cell[][] {
  return density.value.map((value, i) => [
    word,
    value,
    density.density[i],
    density.low[i],
    density.high[i],
    density.n,
  ]);
}
