/** Names of curves, each written beside its own where it has room; the legend keeps the others. */
import type { Drawn } from "./Reader";
import type { Readable } from "./reading";

interface Point {
  x: number;
  y: number;
}
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
export interface Size {
  width: number;
  height: number;
}

const STEP_PX = 8;
const BESIDE_PX = 5;
/** At least so much nearer to its own curve than to any other. */
const APART_PX = 7;
/** More room than this makes no place better. */
const ENOUGH_PX = 40;
const MARGIN_PX = 3;
/** What a pixel between a word's middle and its curve takes from its room: a word is not to hang on by its end. */
const FROM_MIDDLE = 0.5;

/** The middle of each curve's word (its size in `sizes`); null where it has no free place in the frame. */
export function placesOf(
  curves: readonly (readonly Point[])[],
  sizes: readonly Size[],
  frame: Box,
  taken: readonly Box[] = [],
): (Point | null)[] {
  const full = [...taken];
  return sizes.map((size, i) => {
    const others = curves.filter((_, n) => n !== i);
    const free = (box: Box) => within(box, frame) && !full.some((one) => meet(box, one));
    const best = roomiest(size, curves[i] ?? [], others, free);
    if (best) full.push(boxOf(best, size));
    return best;
  });
}

/** The place beside a curve that is furthest from all others, and nearer to it than to them. */
function roomiest(
  size: Size,
  own: readonly Point[],
  others: readonly (readonly Point[])[],
  free: (box: Box) => boolean,
): Point | null {
  let best: { at: Point; room: number } | null = null;
  for (const at of own.flatMap((point) => around(point, size))) {
    const box = boxOf(at, size);
    if (!free(box)) continue;
    const near = distance(box, own);
    const apart = Math.min(ENOUGH_PX, ...others.map((one) => distance(box, one)));
    if (near < BESIDE_PX - 2 || apart < near + APART_PX) continue;
    const room = apart - FROM_MIDDLE * distance(boxOf(at, { width: 0, height: 0 }), own);
    if (best === null || room > best.room) best = { at, room };
  }
  return best?.at ?? null;
}

function around({ x, y }: Point, { width, height }: Size): Point[] {
  const [aside, up] = [width / 2 + BESIDE_PX, height / 2 + BESIDE_PX];
  return [
    { x, y: y - up },
    { x: x + aside, y },
    { x: x - aside, y },
    { x, y: y + up },
    { x: x + aside, y: y - up },
    { x: x + aside, y: y + up },
    { x: x - aside, y: y - up },
    { x: x - aside, y: y + up },
  ];
}

const boxOf = ({ x, y }: Point, { width, height }: Size): Box => ({
  left: x - width / 2,
  right: x + width / 2,
  top: y - height / 2,
  bottom: y + height / 2,
});

const within = (box: Box, frame: Box) =>
  box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;

const meet = (a: Box, b: Box) =>
  a.left - MARGIN_PX < b.right &&
  b.left - MARGIN_PX < a.right &&
  a.top - MARGIN_PX < b.bottom &&
  b.top - MARGIN_PX < a.bottom;

function distance(box: Box, curve: readonly Point[]): number {
  let least = Number.POSITIVE_INFINITY;
  for (const { x, y } of curve) {
    const [across, up] = [Math.max(box.left - x, x - box.right, 0), Math.max(box.top - y, y - box.bottom, 0)];
    least = Math.min(least, Math.hypot(across, up));
  }
  return least;
}

/** A curve in pixels, with no two neighbours further apart than a step; gaps stay gaps. */
export function pathOf(one: Readable, { x, y }: Pick<Drawn, "x" | "y">): Point[] {
  const path: Point[] = [];
  let before: Point | null = null;
  const goTo = (to: Point) => {
    const far = before ? Math.hypot(to.x - before.x, to.y - before.y) : 0;
    const steps = one.way === "points" ? 1 : Math.max(1, Math.ceil(far / STEP_PX));
    const from = before ?? to;
    for (let n = 1; n <= steps; n++) {
      path.push({ x: from.x + ((to.x - from.x) * n) / steps, y: from.y + ((to.y - from.y) * n) / steps });
    }
    before = to;
  };
  for (const [i, across] of one.x.entries()) {
    const up = one.y[i] ?? null;
    const at = up === null ? null : { x: x.apply(across as never), y: y.apply(up as never) };
    if (at && one.way === "steps" && before) goTo({ x: at.x, y: (before as Point).y });
    if (at) goTo(at);
    else before = null;
  }
  return path;
}

const SVG = "http://www.w3.org/2000/svg";

/** Writes the words of the curves that are lines into a figure just drawn: those written. */
export function writeBeside(figure: Element, drawn: Drawn, words: ReadonlySet<string>): ReadonlySet<string> {
  const named = drawn.curves.filter((one) => one.way !== "points" && words.has(one.word));
  const texts = named.map((one) => textOf(one));
  figure.append(...texts);
  const sizes = texts.map((text) => ({ width: widthOf(text), height: 14 }));
  const frame = frameOf(drawn);
  const rest = drawn.curves.filter((one) => !named.includes(one));
  const places = placesOf(
    [...named, ...rest].map((one) => pathOf(one, drawn)),
    sizes,
    frame,
    writtenIn(figure, texts),
  );
  const written = new Set<string>();
  for (const [i, text] of texts.entries()) {
    const at = places[i];
    if (at) {
      text.setAttribute("x", at.x.toFixed(1));
      text.setAttribute("y", at.y.toFixed(1));
      written.add(text.textContent ?? "");
    } else text.remove();
  }
  return written;
}

function textOf({ word, ink }: Readable): SVGTextElement {
  const text = document.createElementNS(SVG, "text");
  const how = { "text-anchor": "middle", "dominant-baseline": "central", "font-weight": "600" };
  const halo = { stroke: "var(--surface)", "stroke-width": "3", "paint-order": "stroke" };
  for (const [name, value] of Object.entries({ ...how, ...halo, fill: ink ?? "var(--ink)" })) {
    text.setAttribute(name, value);
  }
  text.textContent = word;
  return text;
}

const LETTER_PX = 7;

const widthOf = (text: SVGTextElement) =>
  text.getComputedTextLength?.() || LETTER_PX * (text.textContent ?? "").length;

/** Where other words stand: of standards, and of values at their rules. */
function writtenIn(figure: Element, but: readonly Element[]): Box[] {
  const edge = figure.getBoundingClientRect();
  return [...figure.querySelectorAll("text")]
    .filter((one) => !but.includes(one))
    .map((one) => one.getBoundingClientRect())
    .map(({ left, right, top, bottom }) => ({
      left: left - edge.left,
      right: right - edge.left,
      top: top - edge.top,
      bottom: bottom - edge.top,
    }));
}

function frameOf(drawn: Drawn): Box {
  const [across, up] = [drawn.x.range ?? [], drawn.y.range ?? []].map((of) => [...of].map(Number));
  return {
    left: Math.min(...(across ?? [])),
    right: Math.max(...(across ?? [])) + 12,
    top: Math.min(...(up ?? [])) - 4,
    bottom: Math.max(...(up ?? [])),
  };
}
