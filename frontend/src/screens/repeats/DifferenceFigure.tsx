/** Each repeat's difference from what it repeats, with the bar that the clicks' uncertainty lets one expect. */

import { useEffect, useRef, useState } from "preact/hooks";
import { Problem } from "../../components";
import { say } from "../../core/messages";
import { theme } from "../../core/theme";
import type { RepeatDifference, Target } from "../../core/types";
import { lengthScale, lengthUnit, smallScale } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { type Drawn, drawnOf, Reader } from "../../parts/figures/Reader";
import type { Readable } from "../../parts/figures/reading";
import { figureOf } from "../../parts/figures/style";

type Plot = typeof import("../../parts/figures/plot");

/** Symbols tell the targets apart: colours belong to the road's axes. */
const SYMBOLS: Record<Target, string> = {
  roof: "triangle",
  driver_eye: "circle",
  taillight: "square",
  headlight: "cross",
  other: "diamond",
};

export function DifferenceFigure({ differences }: { differences: readonly RepeatDifference[] }) {
  const [plot, setPlot] = useState<Plot | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const [width, setWidth] = useState(0);
  const [read, setRead] = useState<Drawn | null>(null);
  const box = useRef<HTMLDivElement>(null);
  const unit = lengthUnit.value;
  useEffect(() => {
    import("../../parts/figures/plot").then(setPlot, setProblem);
  }, []);
  useEffect(() => {
    if (!box.current) return;
    const watch = new ResizeObserver(([entry]) => entry && setWidth(Math.round(entry.contentRect.width)));
    watch.observe(box.current);
    return () => watch.disconnect();
  }, []);
  useEffect(() => {
    if (!plot || !box.current || width < 200) return;
    const drawn = draw(plot, differences, width, unit);
    box.current.replaceChildren(drawn);
    const labels = {
      x: say("repeats-differences-x", { unit }),
      y: say("repeats-differences-y", { unit: smallScale(unit)[1] }),
    };
    setRead(drawnOf(drawn, readables(differences, unit), labels));
  }, [plot, width, differences, unit, theme.value]);
  const targets = [...new Set(differences.map((one) => one.target))];
  return (
    <figure class="panel panel__body repeats-figure">
      <h2>{say("repeats-differences-title")}</h2>
      <ul class="repeats-legend small">
        {targets.map((target) => (
          <li key={target}>
            <span aria-hidden="true">{GLYPHS[target]}</span> {TARGET_WORDS[target]}
          </li>
        ))}
      </ul>
      <Problem error={problem} />
      <div class="figure-read">
        <div ref={box} class="repeats-figure__box" data-testid="repeats-figure" />
        {read && <Reader title={say("repeats-differences-title")} drawn={read} />}
      </div>
      <figcaption class="field__hint">{say("repeats-differences-note")}</figcaption>
    </figure>
  );
}

const GLYPHS: Record<Target, string> = {
  roof: "△",
  driver_eye: "○",
  taillight: "□",
  headlight: "✚",
  other: "◇",
};

/** One for each target: the difference with its bar. */
function readables(differences: readonly RepeatDifference[], unit: "m" | "ft"): Readable[] {
  const [[perX], [perY]] = [lengthScale(unit), smallScale(unit)];
  return [...new Set(differences.map((one) => one.target))].map((target) => {
    const of = differences.filter((one) => one.target === target);
    return {
      word: TARGET_WORDS[target],
      x: of.map((one) => one.mean_m * perX),
      y: of.map((one) => one.difference_m * perY),
      low: of.map((one) => (one.difference_m - one.expected_m) * perY),
      high: of.map((one) => (one.difference_m + one.expected_m) * perY),
      way: "points",
    };
  });
}

function draw(plot: Plot, differences: readonly RepeatDifference[], width: number, unit: "m" | "ft") {
  const [perX] = lengthScale(unit);
  const [perY, small] = smallScale(unit);
  const points = differences.map((one) => ({
    x: one.mean_m * perX,
    y: one.difference_m * perY,
    low: (one.difference_m - one.expected_m) * perY,
    high: (one.difference_m + one.expected_m) * perY,
    target: one.target,
  }));
  const targets = Object.keys(SYMBOLS) as Target[];
  return figureOf(
    plot,
    {
      width,
      ariaLabel: say("repeats-differences-label", { small, unit, count: points.length }),
      x: { label: say("repeats-differences-x", { unit }), nice: true },
      y: { label: say("repeats-differences-y", { unit: small }), nice: true },
      symbol: { domain: targets, range: targets.map((one) => SYMBOLS[one]), legend: false },
      marks: [
        plot.ruleY([0], { stroke: "var(--line-strong)" }),
        plot.ruleX(points, { x: "x", y1: "low", y2: "high", stroke: "var(--line-strong)" }),
        plot.dot(points, {
          x: "x",
          y: "y",
          symbol: "target",
          r: 4,
          fill: "var(--surface)",
          stroke: "var(--ink)",
          strokeWidth: 1.5,
        }),
      ],
    },
    300,
  );
}
