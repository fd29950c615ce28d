/** Each repeat's difference from what it repeats, with the bar that the clicks' uncertainty lets one expect. */
import { say } from "../../core/messages";
import type { RepeatDifference, Target } from "../../core/types";
import { type LengthUnit, lengthScale, lengthUnit, smallScale } from "../../core/units";
import { TARGET_WORDS, TARGETS } from "../../core/words";
import { type Dot, type Plot, PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";
import type { PlotOptions } from "../../parts/figures/style";

/** Symbols tell the targets apart: colours belong to the road's axes. */
const SYMBOLS: readonly Dot[] = ["triangle", "circle", "square", "cross", "diamond"];

export function DifferenceFigure({ differences }: { differences: readonly RepeatDifference[] }) {
  const unit = lengthUnit.value;
  const shown = TARGETS.filter((target) => differences.some((one) => one.target === target));
  return (
    <PlotFigure
      name="repeats"
      title={say("repeats-differences-title")}
      says={say("repeats-differences-label", { small: smallScale(unit)[1], unit, count: differences.length })}
      note={say("repeats-differences-note")}
      legend={shown.map((target) => ({ word: TARGET_WORDS[target], dot: symbolOf(target) }))}
      data={differences}
      options={(plot, unit) => drawn(plot, differences, unit)}
      table={() => ({
        columns: ["target", "mean_m", "difference_m", "expected_m"],
        rows: differences.map((one) => [one.target, one.mean_m, one.difference_m, one.expected_m]),
      })}
    />
  );
}

function symbolOf(target: Target): Dot {
  return SYMBOLS[TARGETS.indexOf(target) % SYMBOLS.length] ?? "circle";
}

function drawn(plot: Plot, differences: readonly RepeatDifference[], unit: LengthUnit): PlotOptions {
  const [[perX], [perY, small]] = [lengthScale(unit), smallScale(unit)];
  const at = {
    x: (one: RepeatDifference) => one.mean_m * perX,
    y: (one: RepeatDifference) => one.difference_m * perY,
    low: (one: RepeatDifference) => (one.difference_m - one.expected_m) * perY,
    high: (one: RepeatDifference) => (one.difference_m + one.expected_m) * perY,
  };
  const marks = TARGETS.map((target) => {
    const points = differences.filter((one) => one.target === target);
    const dots = plot.dot(points, {
      x: at.x,
      y: at.y,
      symbol: symbolOf(target),
      r: 4,
      fill: "var(--surface)",
      stroke: "var(--ink)",
      strokeWidth: 1.5,
    });
    return [
      plot.ruleX(points, { x: at.x, y1: at.low, y2: at.high, stroke: "var(--line-strong)" }),
      readable(dots, readRows(points, at, "points", TARGET_WORDS[target])),
    ];
  });
  return {
    x: { label: say("repeats-differences-x", { unit }), nice: true },
    y: { label: say("repeats-differences-y", { unit: small }), nice: true },
    marks: [plot.ruleY([0], { stroke: "var(--line-strong)" }), ...marks.flat()],
  };
}
