import { say } from "../../core/messages";
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

const OF = {
  distance: (plan: Plan) => ({ at: "distance_m", curves: plan.U95_over_distance }) as const,
  bias: (plan: Plan) => ({ at: "camera_height_m", curves: plan.bias_over_camera_height }) as const,
};

/** What a height will be worth over the distance, or what an ignored inset costs over the camera's height. */
export function PlanFigure({ plan, of }: { plan: Plan; of: keyof typeof OF }) {
  const unit = lengthUnit.value;
  const { at, curves } = OF[of](plan);
  const targets = curves.map((curve) => curve.target);
  return (
    <PlotFigure
      name={`plan-${of}`}
      title={say(`planning-figure-${of}-title`)}
      says={say(`planning-figure-${of}-label`, { unit, small: smallScale(unit)[1] })}
      note={`${say(`planning-figure-${of}-note`)} ${say("planning-figure-bar")}`}
      legend={targets.map((target) => ({ word: wordOf(target), ...LOOKS[target] }))}
      data={curves}
      options={(plot, unit) => {
        const [[perX], [perY, small]] = [lengthScale(unit), smallScale(unit)];
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
          x: { label: say(`planning-figure-${of}-x`, { unit }) },
          y: { label: say(`planning-figure-${of}-y`, { unit: small }), zero: of === "distance", nice: true },
          symbol: {
            domain: targets,
            range: targets.map((one) => LOOKS[one]?.dot ?? "circle"),
            legend: false,
          },
          marks: [
            plot.ruleX([plan.site[at] * perX], { stroke: "var(--accent)", strokeWidth: 3 }),
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
