import { say } from "../../core/messages";
import type { Curve } from "../../core/types";
import { lengthScale, lengthUnit, smallScale } from "../../core/units";
import { type Dot, PlotFigure } from "../../parts/figures/PlotFigure";
import { readable } from "../../parts/figures/reading";
import { type Plan, wordOf } from "./model";

/** Dashes and symbols tell the targets apart: colours belong to the road's axes. */
const LOOKS: Record<string, { dash: string; dot: Dot }> = {
  roof: { dash: "1 0", dot: "triangle" },
  driver_eye: { dash: "1 0", dot: "circle" },
  driver_eye_far: { dash: "7 4", dot: "diamond" },
  taillight: { dash: "2 3", dot: "square" },
  headlight: { dash: "9 3 2 3", dot: "cross" },
};

export function DistanceFigure({ plan }: { plan: Plan }) {
  return (
    <Figure
      name="plan-distance"
      at="distance_m"
      title={say("planning-figure-distance-title")}
      note={say("planning-figure-distance-note")}
      curves={plan.U95_over_distance}
      words={(unit, small) => ({
        label: say("planning-figure-distance-label", { unit, small }),
        x: say("planning-figure-distance-x", { unit }),
        y: say("planning-figure-distance-y", { unit: small }),
      })}
      marker={plan.site.distance_m}
      fromZero
    />
  );
}

export function BiasFigure({ plan }: { plan: Plan }) {
  return (
    <Figure
      name="plan-bias"
      at="camera_height_m"
      title={say("planning-figure-bias-title")}
      note={say("planning-figure-bias-note")}
      curves={plan.bias_over_camera_height}
      words={(unit, small) => ({
        label: say("planning-figure-bias-label", { unit, small }),
        x: say("planning-figure-bias-x", { unit }),
        y: say("planning-figure-bias-y", { unit: small }),
      })}
      marker={plan.site.camera_height_m}
    />
  );
}

interface FigureProps {
  name: string;
  title: string;
  note: string;
  curves: readonly Curve[];
  /** What the picture shows for those who do not see it, and its axes; `unit` across, `small` up. */
  words: (unit: string, small: string) => { label: string; x: string; y: string };
  at: string;
  marker: number;
  fromZero?: boolean;
}

function Figure({ name, title, note, curves, words, at, marker, fromZero }: FigureProps) {
  const unit = lengthUnit.value;
  const targets = curves.map((curve) => curve.target);
  return (
    <PlotFigure
      name={name}
      title={title}
      says={words(unit, smallScale(unit)[1]).label}
      note={`${note} ${say("planning-figure-bar")}`}
      legend={targets.map((target) => ({ word: wordOf(target), ...LOOKS[target] }))}
      data={curves}
      options={(plot, unit) => {
        const [[perX], [perY, small]] = [lengthScale(unit), smallScale(unit)];
        const { x, y } = words(unit, small);
        const drawn = curves.map(({ target, at_m, value_m }) =>
          at_m.map((one, i) => ({ x: one * perX, y: times(value_m[i], perY), target })),
        );
        const lines = drawn.map((own, i) => {
          const target = targets[i] ?? "";
          const dashed = { stroke: "var(--ink)", strokeWidth: 1.5, strokeDasharray: LOOKS[target]?.dash };
          const [x, y] = [own.map((one) => one.x), own.map((one) => one.y)];
          const line = plot.line(own, { x: "x", y: "y", ...dashed });
          return readable(line, { word: wordOf(target), x, y, way: "line" });
        });
        const hollow = { fill: "var(--surface)", stroke: "var(--ink)", strokeWidth: 1.5 };
        const dots = drawn.flat().filter((_, i) => i % 6 === 3);
        return {
          x: { label: x },
          y: { label: y, zero: fromZero, nice: true },
          symbol: {
            domain: targets,
            range: targets.map((one) => LOOKS[one]?.dot ?? "circle"),
            legend: false,
          },
          marks: [
            plot.ruleX([marker * perX], { stroke: "var(--accent)", strokeWidth: 3 }),
            plot.ruleY([0], { stroke: "var(--line-strong)" }),
            ...lines,
            plot.dot(dots, { x: "x", y: "y", symbol: "target", r: 4, ...hollow }),
          ],
        };
      }}
      table={() => ({
        columns: ["target", at, "value_m"],
        rows: curves.flatMap(({ target, at_m, value_m }) =>
          at_m.map((one, i) => [target, one, value_m[i] ?? null]),
        ),
      })}
    />
  );
}

function times(value: number | null | undefined, factor: number): number | null {
  return value == null ? null : value * factor;
}
