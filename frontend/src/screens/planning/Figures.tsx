import { useEffect, useRef, useState } from "preact/hooks";
import { Problem } from "../../components";
import { say } from "../../core/messages";
import { theme } from "../../core/theme";
import { lengthScale, lengthUnit, smallScale } from "../../core/units";
import { writeBeside } from "../../parts/figures/direct";
import { type Drawn, drawnOf, Reader } from "../../parts/figures/Reader";
import { readable, readablesOf } from "../../parts/figures/reading";
import { figureOf } from "../../parts/figures/style";
import { type Curve, type Plan, wordOf } from "./model";

type Plot = typeof import("../../parts/figures/plot");

/** Dashes and symbols tell the targets apart: colours belong to the road's axes. */
const DASHES: Record<string, string> = {
  roof: "1 0",
  driver_eye: "1 0",
  driver_eye_far: "7 4",
  taillight: "2 3",
  headlight: "9 3 2 3",
};
const SYMBOLS: Record<string, string> = {
  roof: "triangle",
  driver_eye: "circle",
  driver_eye_far: "diamond",
  taillight: "square",
  headlight: "cross",
};

/** U95 on vehicles at other distances. */
export function DistanceFigure({ plan }: { plan: Plan }) {
  return (
    <Figure
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

/** What an ignored inset costs, over the camera's height. */
export function BiasFigure({ plan }: { plan: Plan }) {
  return (
    <Figure
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
  title: string;
  note: string;
  curves: readonly Curve[];
  /** What the picture shows for those who do not see it, and its axes; `unit` across, `small` up. */
  words: (unit: string, small: string) => { label: string; x: string; y: string };
  /** The planned place. */
  marker: number;
  fromZero?: boolean;
}

interface Point {
  x: number;
  y: number | null;
  target: string;
}

function Figure({ title, note, curves, words, marker, fromZero }: FigureProps) {
  const [plot, setPlot] = useState<Plot | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  const [read, setRead] = useState<Drawn | null>(null);
  const [beside, setBeside] = useState<ReadonlySet<string>>(new Set());
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
    const [perX] = lengthScale(unit);
    const [perY, small] = smallScale(unit);
    const points: Point[] = curves.flatMap((curve) =>
      curve.at_m.map((x, i) => {
        const y = curve.value_m[i] ?? null;
        return { x: x * perX, y: y === null ? null : y * perY, target: curve.target };
      }),
    );
    const targets = curves.map((curve) => curve.target);
    const { label, x, y } = words(unit, small);
    const marks = [
      plot.ruleX([marker * perX], { stroke: "var(--accent)", strokeWidth: 3 }),
      plot.ruleY([0], { stroke: "var(--line-strong)" }),
      ...targets.map((target) => {
        const own = points.filter((point) => point.target === target);
        return readable(
          plot.line(own, {
            x: "x",
            y: "y",
            stroke: "var(--ink)",
            strokeWidth: 1.5,
            strokeDasharray: DASHES[target],
          }),
          { word: wordOf(target), x: own.map((one) => one.x), y: own.map((one) => one.y), way: "line" },
        );
      }),
      plot.dot(
        points.filter((_, i) => i % 6 === 3),
        {
          x: "x",
          y: "y",
          symbol: "target",
          r: 4,
          fill: "var(--surface)",
          stroke: "var(--ink)",
          strokeWidth: 1.5,
        },
      ),
    ];
    const drawn = figureOf(
      plot,
      {
        width,
        ariaLabel: label,
        x: { label: x },
        y: { label: y, zero: fromZero, nice: true },
        symbol: { domain: targets, range: targets.map((one) => SYMBOLS[one] ?? "circle"), legend: false },
        marks,
      },
      300,
    );
    box.current.replaceChildren(drawn);
    const reads = drawnOf(drawn, readablesOf(marks), { x, y });
    setRead(reads);
    setBeside(reads ? writeBeside(drawn, reads, new Set(targets.map(wordOf))) : new Set());
  }, [plot, width, curves, marker, unit, theme.value]);
  return (
    <figure class="panel plan-figure">
      <h2>{title}</h2>
      <Legend targets={curves.map((curve) => curve.target).filter((one) => !beside.has(wordOf(one)))} />
      <Problem error={problem} />
      <div class="figure-read">
        <div ref={box} class="plan-figure__box" data-testid="plan-figure" />
        {read && <Reader title={title} drawn={read} />}
      </div>
      <figcaption class="field__hint">
        {note} {say("planning-figure-bar")}
      </figcaption>
    </figure>
  );
}

/** Symbol paths on an 8 px radius, as Plot draws them. */
const MARKS: Record<string, string> = {
  roof: "M0,-5L4.4,2.6L-4.4,2.6Z",
  driver_eye: "M4,0A4,4,0,1,1,-4,0A4,4,0,1,1,4,0Z",
  driver_eye_far: "M0,-5L3,0L0,5L-3,0Z",
  taillight: "M-3.5,-3.5H3.5V3.5H-3.5Z",
  headlight: "M-4.5,-1.5H-1.5V-4.5H1.5V-1.5H4.5V1.5H1.5V4.5H-1.5V1.5H-4.5Z",
};

function Legend({ targets }: { targets: readonly string[] }) {
  if (targets.length === 0) return null;
  return (
    <ul class="plan-legend">
      {targets.map((target) => (
        <li key={target}>
          <svg width="36" height="14" viewBox="-18 -7 36 14" aria-hidden="true">
            <path d="M-18 0H18" stroke="currentColor" stroke-width="1.5" stroke-dasharray={DASHES[target]} />
            <path d={MARKS[target]} fill="var(--surface)" stroke="currentColor" stroke-width="1.5" />
          </svg>
          {wordOf(target)}
        </li>
      ))}
    </ul>
  );
}
