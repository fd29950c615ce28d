import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Problem } from "../../components";
import { language, say } from "../../core/messages";
import { theme } from "../../core/theme";
import { type LengthUnit, lengthUnit } from "../../core/units";
import { type Cell, csvOf, download } from "./csv";
import { writeBeside } from "./direct";
import { FileButton } from "./FileButton";
import "./figures.css";
import { type Hue, hueOf } from "./hues";
import { type Drawn, drawnOf, Reader } from "./Reader";
import { readablesOf } from "./reading";
import { figureOf, type PlotOptions } from "./style";
import { svgFile } from "./svg";

export type Plot = typeof import("./plot");
/** The library that draws, fetched once. */
export const loadPlot = (): Promise<Plot> => import("./plot");

interface Table {
  columns: readonly string[];
  rows: readonly (readonly Cell[])[];
}

interface Props {
  name: string;
  title: string;
  /** What the picture shows, in words, for those who do not see it. */
  says: string;
  note?: ComponentChildren;
  /** Names of the curves: written beside them where they have room, else above the figure; those of dots always above. */
  legend?: readonly LegendEntry[];
  data: unknown;
  options: (plot: Plot, unit: LengthUnit) => PlotOptions;
  table: () => Table;
  reason?: string | null;
  /** A place of the axis across in words, where it is no plain number. */
  place?: (x: number) => string;
}

export interface LegendEntry {
  word: string;
  dash?: string;
  faint?: boolean;
  /** Ink, purple or ochre; ink unless said. */
  hue?: Hue;
  dot?: Dot;
}

const HEIGHT = 320;
/** Widths on A4 at 96 pixels an inch, within the margins: drawn anew, so that words keep their size on paper. */
const HALF_A_PAGE = 310;
const A_PAGE = 640;
const HEIGHT_ON_PAPER = 230;

/** Draws for paper before a print, and for the screen after it; at once, for a browser waits for nothing else. */
function useOnPaper(before: () => void, after: () => void): void {
  const latest = useRef({ before, after });
  latest.current = { before, after };
  useEffect(() => {
    const ends = new AbortController();
    window.addEventListener("beforeprint", () => latest.current.before(), { signal: ends.signal });
    window.addEventListener("afterprint", () => latest.current.after(), { signal: ends.signal });
    return () => ends.abort();
  }, []);
}

function inView(box: HTMLElement | null): boolean {
  return !!box && box.getBoundingClientRect().top < window.innerHeight;
}

/** One figure with its legend, its words and its two downloads. */
export function PlotFigure({ name, title, says, note, legend, data, options, table, reason, place }: Props) {
  const [plot, setPlot] = useState<Plot | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const [width, setWidth] = useState(0);
  const [read, setRead] = useState<Drawn | null>(null);
  const [beside, setBeside] = useState<ReadonlySet<string>>(new Set());
  const box = useRef<HTMLDivElement>(null);
  const unit = lengthUnit.value;
  useEffect(() => {
    loadPlot().then(setPlot, setProblem);
  }, []);
  useEffect(() => {
    if (!box.current) return;
    const watch = new ResizeObserver(([entry]) => entry && setWidth(Math.round(entry.contentRect.width)));
    watch.observe(box.current);
    return () => watch.disconnect();
  }, [reason]);
  const draw = (wide: number, height: number) => {
    if (!plot || !box.current || wide < 200) return;
    const chosen = options(plot, unit);
    const drawn = figureOf(plot, { ...chosen, width: wide, ariaLabel: says }, height);
    box.current.replaceChildren(drawn);
    const labels = { x: chosen.x?.label, y: chosen.y?.label };
    const reads = drawnOf(drawn, readablesOf(chosen.marks), labels);
    setRead(reads);
    const words = new Set(legend?.map((one) => one.word));
    setBeside(reads ? writeBeside(drawn, reads, words) : new Set());
  };
  useEffect(() => {
    if (inView(box.current)) return draw(width, HEIGHT);
    const later = setTimeout(() => draw(width, HEIGHT)); // what is in view is drawn and shown first
    return () => clearTimeout(later);
  }, [plot, width, data, unit, theme.value, language.value, reason]);
  useOnPaper(
    () => draw(box.current?.closest(".stat-figures, .scan-figures") ? HALF_A_PAGE : A_PAGE, HEIGHT_ON_PAPER),
    () => draw(width, HEIGHT),
  );
  const saveSvg = () => {
    const drawn = box.current?.querySelector("svg");
    if (drawn) download(`sightline-${name}.svg`, "image/svg+xml", svgFile(drawn, title));
  };
  const saveCsv = () => {
    const { columns, rows } = table();
    download(`sightline-${name}.csv`, "text/csv;charset=utf-8", csvOf(columns, rows));
  };
  return (
    <figure class="panel stack stack--tight stat-figure">
      <header class="row row--apart stat-figure__head">
        <h3>{title}</h3>
        {!reason && (
          <div class="row stat-noprint">
            <FileButton as="svg" save={saveSvg} title={say("figure-as-svg", { figure: title })} />
            <FileButton as="csv" save={saveCsv} title={say("figure-as-csv", { figure: title })} />
          </div>
        )}
      </header>
      {reason ? (
        <p class="muted">{reason}</p>
      ) : (
        <>
          {legend && <Legend entries={legend.filter((one) => !beside.has(one.word))} />}
          <Problem error={problem} />
          <div class="figure-read">
            <div ref={box} class="stat-figure__box" data-testid={`figure-${name}`} />
            {read && <Reader title={title} drawn={read} place={place} />}
          </div>
        </>
      )}
      {note && <figcaption class="field__hint">{note}</figcaption>}
    </figure>
  );
}

export type Dot = keyof typeof DOTS;

const DOTS = {
  cross: "M-4.5,-1.5H-1.5V-4.5H1.5V-1.5H4.5V1.5H1.5V4.5H-1.5V1.5H-4.5Z",
  diamond: "M0,-5L3,0L0,5L-3,0Z",
  circle: "M4,0A4,4,0,1,1,-4,0A4,4,0,1,1,4,0Z",
  triangle: "M0,-5L4.4,2.6L-4.4,2.6Z",
  square: "M-3.5,-3.5H3.5V3.5H-3.5Z",
};

function Legend({ entries }: { entries: readonly LegendEntry[] }) {
  if (entries.length === 0) return null;
  return (
    <ul class="row row--wrap row--far small">
      {entries.map((one) => (
        <li key={one.word} class="row">
          <svg width="30" height="12" viewBox="-15 -6 30 12" aria-hidden="true">
            {(one.dash || !one.dot) && (
              <path d="M-15 0H15" stroke={hueOf(one)} stroke-width="2" stroke-dasharray={one.dash} />
            )}
            {one.dot && (
              <path d={DOTS[one.dot]} fill="var(--surface)" stroke="currentColor" stroke-width="1.5" />
            )}
          </svg>
          {one.word}
        </li>
      ))}
    </ul>
  );
}
