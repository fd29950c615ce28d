/** What a figure's curves say at one place of its axis: for the pointer, the keyboard and a screen reader. */
import { say } from "../../core/messages";
import { fixed } from "../../core/units";

export interface Readable {
  /** As the legend names it; empty where there is one curve only. */
  word: string;
  /** Of the word where it stands beside its curve; ink unless said. */
  ink?: string;
  /** In the units of the axes, ascending in x unless these are points. */
  x: readonly number[];
  y: readonly (number | null)[];
  low?: readonly (number | null)[];
  high?: readonly (number | null)[];
  way: "steps" | "line" | "points";
}

export interface Read {
  word: string;
  x: number;
  y: number;
  low: number | null;
  high: number | null;
}

/** Where a row is drawn, and what it says: as Plot takes it for a mark. */
export interface Channels<R> {
  x: (row: R) => number;
  y: (row: R) => number | null;
  low?: (row: R) => number | null;
  high?: (row: R) => number | null;
}

/** Rows read where a mark with the same channels draws them. */
export function readRows<R>(
  rows: readonly R[],
  { x, y, low, high }: Channels<R>,
  way: Readable["way"],
  word = "",
): Readable {
  return {
    word,
    x: rows.map(x),
    y: rows.map(y),
    low: low && rows.map(low),
    high: high && rows.map(high),
    way,
  };
}

const READABLE = new WeakMap<object, readonly Readable[]>();

/** The mark, which can be read from now on. */
export function readable<T extends object>(mark: T, ...what: readonly Readable[]): T {
  READABLE.set(mark, what);
  return mark;
}

/** What can be read of the marks of a figure, in their order. */
export function readablesOf(marks: readonly unknown[] = []): Readable[] {
  return marks.flat(4).flatMap((mark) => {
    const found = typeof mark === "object" && mark !== null ? READABLE.get(mark) : undefined;
    return found?.filter((one) => one.x.length > 0) ?? [];
  });
}

/** The value at x; null where the curve has none. Of points the nearest one, if it lies within `near`. */
export function readAt(one: Readable, x: number, near: number): Read | null {
  if (one.way === "points") return nearest(one, x, near);
  const after = one.x.findIndex((at) => at > x);
  const i = (after < 0 ? one.x.length : after) - 1;
  if (one.way === "steps") return i < 0 ? { ...NOTHING, word: one.word, x } : at(one, i, x);
  if (i < 0 || (after < 0 && x > (one.x.at(-1) ?? 0))) return null;
  if (after < 0) return at(one, i, x);
  const share = (x - (one.x[i] ?? 0)) / ((one.x[after] ?? 0) - (one.x[i] ?? 0));
  const between = (of: readonly (number | null)[] | undefined) => {
    const [a, b] = [of?.[i] ?? null, of?.[after] ?? null];
    return a === null || b === null ? null : a + share * (b - a);
  };
  const y = between(one.y);
  return y === null ? null : { word: one.word, x, y, low: between(one.low), high: between(one.high) };
}

/** Below the first step a share is 0, and its band is that of none. */
const NOTHING = { y: 0, low: null, high: null };

function at(one: Readable, i: number, x: number): Read | null {
  const y = one.y[i] ?? null;
  return y === null ? null : { word: one.word, x, y, low: one.low?.[i] ?? null, high: one.high?.[i] ?? null };
}

function nearest(one: Readable, x: number, near: number): Read | null {
  let found = -1;
  let apart = near;
  for (const [i, at] of one.x.entries()) {
    if (Math.abs(at - x) > apart || one.y[i] === null) continue;
    apart = Math.abs(at - x);
    found = i;
  }
  return found < 0 ? null : at(one, found, one.x[found] ?? x);
}

/** Decimals that tell apart a thousandth of an axis, or what is as good as that. */
export function digitsOf(low: number, high: number): number {
  const span = Math.abs(high - low);
  return span > 0 ? Math.min(4, Math.max(0, Math.ceil(2.6 - Math.log10(span)))) : 2;
}

/** "80.0", with the band where there is one: "80.0 (44.4 to 97.5)". */
export function valueWords({ y, low, high }: Read, digits: number): string {
  const value = fixed(y, digits);
  if (low === null || high === null) return value;
  return `${value} (${say("interval", { low: fixed(low, digits), high: fixed(high, digits) })})`;
}
