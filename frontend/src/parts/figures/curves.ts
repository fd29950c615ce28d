/**
 * Marks of the figures. Three hues that are not the road's axes', dashes and words tell lines apart, never a hue alone.
 */
import { say } from "../../core/messages";
import { fixed } from "../../core/units";
import type { Cell } from "./csv";
import { type Hue, hueOf } from "./hues";
import type { Plot } from "./PlotFigure";
import type { Density, Ecdf, Standard } from "./types";

export interface Curve {
  word: string;
  dash?: string;
  faint?: boolean;
  /** Ink, purple or ochre; ink unless said. */
  hue?: Hue;
  /** Where along the curve its word stands: at this share. */
  wordAt?: number;
  band?: boolean;
}

type Mark = ReturnType<Plot["line"]>;
const HALO = { stroke: "var(--surface)", strokeWidth: 5, fill: "var(--ink)" } as const;

const lineStyle = (curve: Curve) => ({
  stroke: hueOf(curve),
  strokeWidth: curve.faint ? 1.5 : 2,
  strokeDasharray: curve.dash,
});

/** A cumulative distribution as steps, with its band and its word. */
export function ecdfMarks(plot: Plot, ecdf: Ecdf, curve: Curve, perX: number): Mark[] {
  const first = ecdf.value[0] ?? 0;
  const steps = [
    { x: first * perX, y: 0 },
    ...ecdf.value.map((value, i) => ({ x: value * perX, y: 100 * (ecdf.share[i] ?? 0) })),
  ];
  const marks: Mark[] = [];
  if (curve.band) {
    const band = ecdf.value.map((value, i) => ({
      x: value * perX,
      low: 100 * (ecdf.low[i] ?? 0),
      high: 100 * (ecdf.high[i] ?? 0),
    }));
    marks.push(
      plot.areaY(band, {
        x: "x",
        y1: "low",
        y2: "high",
        curve: "step-after",
        fill: hueOf(curve),
        fillOpacity: 0.09,
      }),
    );
  }
  marks.push(plot.line(steps, { x: "x", y: "y", curve: "step-after", ...lineStyle(curve) }));
  return marks;
}

/** The word of a curve, written on it: right of it, unless `left`, or where the figure (ending at `end`) has no room. */
export function ecdfWord(
  plot: Plot,
  ecdf: Ecdf,
  curve: Curve,
  perX: number,
  end: number,
  left = false,
): Mark {
  const share = curve.wordAt ?? 0.5;
  const value = valueAt(ecdf, share);
  const turned = left || value > 0.75 * end;
  return plot.text([{ x: value * perX, y: 100 * share, word: curve.word }], {
    x: "x",
    y: "y",
    text: "word",
    textAnchor: turned ? "end" : "start",
    dx: turned ? -8 : 8,
    ...HALO,
  });
}

/** Where a curve passes a share. */
export function valueAt(ecdf: Ecdf, share: number): number {
  const at = ecdf.share.findIndex((one) => one >= share);
  return ecdf.value[Math.max(0, at)] ?? 0;
}

/** The largest value of several curves. */
export function endOf(ecdfs: readonly Ecdf[]): number {
  return Math.max(...ecdfs.map((one) => one.value.at(-1) ?? 0));
}

/** A density with its band and its word at the top. */
export function densityMarks(plot: Plot, density: Density, curve: Curve, perX: number): Mark[] {
  const rows = density.value.map((value, i) => ({
    x: value * perX,
    y: (density.density[i] ?? 0) / perX,
    low: (density.low[i] ?? 0) / perX,
    high: (density.high[i] ?? 0) / perX,
  }));
  const marks: Mark[] = [];
  if (curve.band) {
    marks.push(plot.areaY(rows, { x: "x", y1: "low", y2: "high", fill: "var(--ink)", fillOpacity: 0.09 }));
  }
  marks.push(plot.line(rows, { x: "x", y: "y", ...lineStyle(curve) }));
  return marks;
}

/** Standards as upright rules with their names on them; those of one height share a rule. */
export function standardMarks(
  plot: Plot,
  standards: readonly Standard[],
  perX: number,
  unit: string,
): Mark[] {
  const byHeight = new Map<number, string[]>();
  for (const one of standards) byHeight.set(one.height_m, [...(byHeight.get(one.height_m) ?? []), one.name]);
  const rows = [...byHeight].map(([height, names]) => ({
    x: height * perX,
    word: say("figure-standard", { standards: names.join(", "), height: fixed(height * perX, 2), unit }),
  }));
  return [
    plot.text(rows, {
      x: "x",
      text: "word",
      frameAnchor: "top",
      rotate: -90,
      lineAnchor: "middle",
      textAnchor: "end",
      dx: -9,
      fill: "var(--accent-text)",
      stroke: "var(--surface)",
      strokeWidth: 3,
    }),
    plot.ruleX(rows, { x: "x", stroke: "var(--accent-text)", strokeWidth: 1.5 }),
  ];
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

export const ECDF_COLUMNS = ["share", "band95_low", "band95_high", "n"] as const;

/** Rows of a cumulative distribution for its CSV: group, value, share, band, n. */
export function ecdfRows(word: string, ecdf: Ecdf): Cell[][] {
  return ecdf.value.map((value, i) => [word, value, ecdf.share[i], ecdf.low[i], ecdf.high[i], ecdf.n]);
}

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
