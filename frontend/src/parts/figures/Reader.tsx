import { useState } from "preact/hooks";
import { apart, say } from "../../core/messages";
import { fixed } from "../../core/units";
import { digitsOf, type Read, type Readable, readAt, valueWords } from "./reading";

interface Scale {
  domain?: Iterable<unknown>;
  apply: (value: never) => number;
  invert?: (px: never) => unknown;
  range?: Iterable<unknown>;
}

/** What was drawn, and how it is read. */
export type Drawn = NonNullable<ReturnType<typeof drawnOf>>;

type Figure = (SVGSVGElement | HTMLElement) & { scale(name: "x" | "y"): unknown };

/** Of a figure just drawn; null where nothing of it can be read. */
export function drawnOf(figure: Figure, curves: readonly Readable[], labels: { x: unknown; y: unknown }) {
  const [x, y] = [figure.scale("x") as Scale | undefined, figure.scale("y") as Scale | undefined];
  if (!x?.invert || !y || curves.length === 0) return null;
  const size = { width: Number(figure.getAttribute("width")), height: Number(figure.getAttribute("height")) };
  return { ...size, x, y, curves, xLabel: String(labels.x ?? ""), yLabel: String(labels.y ?? "") };
}

const ends = (of: Iterable<unknown> | undefined): [number, number] => {
  const all = [...(of ?? [0, 1])].map(Number);
  return [Math.min(...all), Math.max(...all)];
};

/** How much of the axis the arrows go, and the pages. */
const STEP = 1 / 100;
const PAGE = 1 / 10;

interface Props {
  title: string;
  drawn: Drawn;
  /** A place of the axis in words, where it is no plain number. */
  place?: (x: number) => string;
}

/** Over a figure: reads its curves where the pointer is, or where the arrow keys have gone. */
export function Reader({ title, drawn, place }: Props) {
  const [x, setX] = useState<number | null>(null);
  const [low, high] = ends(drawn.x.domain);
  const [top, bottom] = ends(drawn.y.range);
  const read = x === null ? [] : drawn.curves.flatMap((one) => readAt(one, x, (high - low) * 0.015) ?? []);
  const words = x === null ? null : wordsOf(drawn, x, read, place);
  const at = x === null ? 0 : drawn.x.apply(x as never);
  const goTo = (to: number) => setX(Math.min(high, Math.max(low, to)));
  const byKey = (event: KeyboardEvent) => {
    const from = x ?? (low + high) / 2;
    const step = KEYS[event.key];
    if (event.key === "Escape" && x !== null) setX(null);
    else if (event.key === "Home") goTo(low);
    else if (event.key === "End") goTo(high);
    else if (step !== undefined) goTo(from + step * (high - low));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const byPointer = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    goTo(Number(drawn.x.invert?.((((event.clientX - box.left) / box.width) * drawn.width) as never)));
  };
  return (
    <div
      class="figure-reader"
      role="slider"
      tabIndex={0}
      aria-label={say("figure-read", { figure: title })}
      aria-valuemin={low}
      aria-valuemax={high}
      aria-valuenow={x ?? (low + high) / 2}
      aria-valuetext={words ? apart([words.place, ...words.values]) : say("figure-read-hint")}
      onKeyDown={byKey}
      onPointerMove={byPointer}
      onPointerDown={byPointer}
      onPointerLeave={(event) => event.pointerType === "mouse" && setX(null)}
      onBlur={() => setX(null)}
    >
      {words && (
        <>
          <svg width={drawn.width} height={drawn.height} aria-hidden="true">
            <line x1={at} x2={at} y1={top} y2={bottom} />
            {read.map((one) => (
              <circle
                key={one.word}
                r="4"
                cx={drawn.x.apply(one.x as never)}
                cy={drawn.y.apply(one.y as never)}
              />
            ))}
          </svg>
          <div
            class="figure-reader__words"
            style={{
              top: `${top + 4}px`,
              ...(at > drawn.width / 2 ? { right: `${drawn.width - at + 8}px` } : { left: `${at + 8}px` }),
            }}
            aria-hidden="true"
          >
            <strong>{words.place}</strong>
            {words.values.map((one) => (
              <span key={one}>{one}</span>
            ))}
          </div>
        </>
      )}
    </div>
  );
}

const KEYS: Readonly<Record<string, number>> = {
  ArrowLeft: -STEP,
  ArrowDown: -STEP,
  ArrowRight: STEP,
  ArrowUp: STEP,
  PageDown: -PAGE,
  PageUp: PAGE,
};

function wordsOf(drawn: Drawn, x: number, read: readonly Read[], place?: (x: number) => string) {
  const [xLow, xHigh] = ends(drawn.x.domain);
  const [yLow, yHigh] = ends(drawn.y.domain);
  const digits = digitsOf(yLow, yHigh);
  const value = place ? place(x) : fixed(x, digitsOf(xLow, xHigh));
  const values = read.map((one) =>
    say("figure-read-value", { what: one.word || drawn.yLabel, value: valueWords(one, digits) }),
  );
  return { place: say("figure-read-value", { what: drawn.xLabel, value }), values };
}
