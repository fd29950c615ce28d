import { smallScale } from "../../core/units";
import {
  type Curve,
  densityMarks,
  densityRows,
  ECDF_COLUMNS,
  ecdfMarks,
  ecdfRows,
  ecdfWord,
  endOf,
} from "../../parts/figures/curves";
import { fixedRange } from "../../parts/figures/numbers";
import { type LegendEntry, PlotFigure } from "../../parts/figures/PlotFigure";
import type { Density, Ecdf } from "../../parts/figures/types";
import { type Errors, GROUP_WORDS, isThere, type Reason } from "./model";
import { TrendFigure } from "./TrendFigure";

const CURVES: Record<string, Curve> = {
  daytime: { word: "daytime", wordAt: 0.72, band: true },
  low_light: { word: "low light", dash: "7 4", wordAt: 0.5, band: true },
  overall: { word: "overall", dash: "2 3", faint: true, wordAt: 0.28 },
};
const GROUPS = Object.keys(CURVES);

function legendOf(list: readonly Drawn<unknown>[]): LegendEntry[] {
  return list.map(({ curve }) => ({ word: curve.word, dash: curve.dash, faint: curve.faint }));
}

interface Drawn<T> {
  group: string;
  part: T;
  curve: Curve;
}

/** The groups that have something to draw; one that equals "overall" is drawn once. */
function drawn<T extends { n: number }>(parts: Record<string, T | Reason>): Drawn<T>[] {
  const there = GROUPS.flatMap((group) => {
    const part = parts[group];
    return part && isThere<T>(part as T | Reason)
      ? [{ group, part: part as T, curve: CURVES[group] as Curve }]
      : [];
  });
  const all = there.find((one) => one.group === "overall");
  const alone = there.some((one) => one !== all && one.part.n === all?.part.n);
  const list = there.filter((one) => one !== all || !alone);
  return list.length > 1
    ? list
    : list.map((one) => ({ ...one, curve: { word: one.curve.word, band: true } }));
}

function reasonOf(parts: Record<string, { n: number } | Reason>): string | null {
  if (drawn(parts as Record<string, { n: number } | Reason>).length > 0) return null;
  const overall = parts["overall"];
  return overall && "reason" in overall ? `Nothing to draw: ${overall.reason}` : "Nothing to draw.";
}

/** The figures of the error: its size, its share of the height, its density, and how it goes with the height. */
export function ErrorFigures({ errors }: { errors: Errors }) {
  return (
    <div class="stat-figures">
      <AbsoluteFigure errors={errors} />
      <RelativeFigure errors={errors} />
      <DensityFigure errors={errors} />
      <TrendFigure errors={errors} />
    </div>
  );
}

function counts(list: readonly Drawn<{ n: number }>[]): string {
  return list.map((one) => `${GROUP_WORDS[one.group]} n = ${one.part.n}`).join(", ");
}

function AbsoluteFigure({ errors }: { errors: Errors }) {
  const list = drawn<Ecdf>(errors.absolute);
  return (
    <PlotFigure
      name="absolute-error-ecdf"
      title="Absolute error, cumulative"
      says={`Share of vehicles with an absolute error of at most so much; ${counts(list)}`}
      note={`Bands at 95 % hold everywhere at once. ${counts(list)}.`}
      legend={legendOf(list)}
      reason={reasonOf(errors.absolute)}
      data={errors}
      options={(plot, unit) => {
        const [perX, small] = smallScale(unit);
        return {
          x: {
            label: `absolute error (${small})`,
            labelArrow: "none",
            labelAnchor: "center",
            labelOffset: 34,
            zero: true,
            nice: true,
          },
          y: { label: "share of vehicles (%)", labelArrow: "none", grid: true, domain: [0, 100] },
          marks: [
            ...list.flatMap((one) => ecdfMarks(plot, one.part, one.curve, perX)),
            ...list.map((one) =>
              ecdfWord(plot, one.part, one.curve, perX, endOf(list.map((other) => other.part))),
            ),
          ],
        };
      }}
      table={() => ({
        columns: ["lighting", "absolute_error_m", ...ECDF_COLUMNS],
        rows: list.flatMap((one) => ecdfRows(one.group, one.part)),
      })}
    />
  );
}

function RelativeFigure({ errors }: { errors: Errors }) {
  const list = drawn<Ecdf>(errors.relative);
  return (
    <PlotFigure
      name="relative-error-ecdf"
      title="Relative error, cumulative"
      says={`Share of vehicles with an error of at most so many per cent of their height; ${counts(list)}`}
      note={`Absolute error over the reference height. ${counts(list)}.`}
      legend={legendOf(list)}
      reason={reasonOf(errors.relative)}
      data={errors}
      options={(plot) => ({
        x: {
          label: "relative error (%)",
          labelArrow: "none",
          labelAnchor: "center",
          labelOffset: 34,
          zero: true,
          nice: true,
        },
        y: { label: "share of vehicles (%)", labelArrow: "none", grid: true, domain: [0, 100] },
        marks: [
          ...list.flatMap((one) => ecdfMarks(plot, one.part, one.curve, 100)),
          ...list.map((one) =>
            ecdfWord(plot, one.part, one.curve, 100, endOf(list.map((other) => other.part))),
          ),
        ],
      })}
      table={() => ({
        columns: ["lighting", "relative_error", ...ECDF_COLUMNS],
        rows: list.flatMap((one) => ecdfRows(one.group, one.part)),
      })}
    />
  );
}

/** Narrower kernels would draw the rounding as a comb. */
function least(errors: Errors): string {
  return errors.rounding === "cm" ? `, at least half of the ${fixedRange(0.01)} of rounding` : "";
}

function DensityFigure({ errors }: { errors: Errors }) {
  const list = drawn<Density>(errors.density);
  return (
    <PlotFigure
      name="signed-error-density"
      title="Signed error, density"
      says={`Density of the signed error; ${counts(list)}`}
      note={
        list.length > 0
          ? `Gaussian kernel, bandwidth ${list.map((one) => fixedRange(one.part.bandwidth)).join(", ")}${least(errors)}; pointwise 95 % band. ${counts(list)}.`
          : undefined
      }
      legend={legendOf(list)}
      reason={reasonOf(errors.density)}
      data={errors}
      options={(plot, unit) => {
        const [perX, small] = smallScale(unit);
        return {
          x: { label: `signed error (${small})`, labelArrow: "none", labelAnchor: "center", labelOffset: 34 },
          y: { label: `density (per ${small})`, labelArrow: "none", grid: true, zero: true, nice: true },
          marks: [
            plot.ruleX([0], { stroke: "var(--line-strong)" }),
            ...list.flatMap((one) => densityMarks(plot, one.part, one.curve, perX)),
          ],
        };
      }}
      table={() => ({
        columns: [
          "lighting",
          "signed_error_m",
          "density_per_m",
          "band95_low_per_m",
          "band95_high_per_m",
          "n",
        ],
        rows: list.flatMap((one) => densityRows(one.group, one.part)),
      })}
    />
  );
}
