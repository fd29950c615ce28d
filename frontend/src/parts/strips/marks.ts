/** The pen on the strips, and marks over camera 1: clicks, what joins them, and words beside them. */
import { type Place, type StripsView, xOf, yOf } from "./view";

export interface Pens {
  readonly pen: CanvasRenderingContext2D;
  readonly view: StripsView;
  readonly ink: string;
  readonly line: string;
  readonly accent: string;
  readonly paper: string;
}

const DARK = "rgb(16 17 16 / 72%)";
const HALF_CROSS_PX = 9;

/** A pen with the colours of the page that is shown. */
export function pensOf(canvas: HTMLCanvasElement, view: StripsView): Pens | null {
  const pen = canvas.getContext("2d");
  const style = getComputedStyle(canvas);
  const colour = (name: string): string => style.getPropertyValue(name);
  const [ink, line] = [colour("--stage-ink"), colour("--stage-line")];
  return pen && { pen, view, ink, line, accent: colour("--accent"), paper: colour("--stage") };
}

/** What is drawn stays within one strip until `pen.restore()`. */
export function keepWithin({ pen, view }: Pens, top: number): void {
  pen.save();
  pen.beginPath();
  pen.rect(0, top, view.width, view.height);
  pen.clip();
}

/** A pen that keeps to camera 1; `pen.restore()` ends it. */
export function penOn(canvas: HTMLCanvasElement, view: StripsView): Pens | null {
  const pens = pensOf(canvas, view);
  if (!pens) return null;
  keepWithin(pens, 0);
  pens.pen.font = "600 12px system-ui, sans-serif";
  pens.pen.textBaseline = "middle";
  return pens;
}

type Path = readonly (readonly [x: number, y: number])[];
type Style = readonly [colour: string, width: number];

/** Lines through points of the canvas; with an edge they are seen on any picture. */
export function stroke(
  { pen }: Pick<Pens, "pen">,
  { style, edge, dash = [] }: { style: Style; edge?: Style; dash?: number[] },
  ...paths: readonly Path[]
): void {
  pen.setLineDash(dash);
  for (const [colour, width] of edge ? [edge, style] : [style]) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.beginPath();
    for (const path of paths)
      for (const [at, [x, y]] of path.entries()) pen[at === 0 ? "moveTo" : "lineTo"](x, y);
    pen.stroke();
  }
  pen.setLineDash([]);
}

/** From the contact up and across to the target: a point at another line stands at the same distance. */
export function joined(pens: Pens, contact: Place, point: Place): void {
  const { view } = pens;
  const [x, y] = [xOf(view, contact.line), yOf(view, point.row)];
  const corner: Path = [
    [x, yOf(view, contact.row)],
    [x, y],
    [xOf(view, point.line), y],
  ];
  stroke(pens, { style: [pens.ink, 1], dash: [3, 3] }, corner);
}

export function cross(pens: Pens, at: Place, colour: string): void {
  const [x, y] = [xOf(pens.view, at.line), yOf(pens.view, at.row)];
  const across: Path = [-HALF_CROSS_PX, HALF_CROSS_PX].map((by) => [x + by, y]);
  const down: Path = [-HALF_CROSS_PX, HALF_CROSS_PX].map((by) => [x, y + by]);
  stroke(pens, { style: [colour, 1.5], edge: [DARK, 4] }, across, down);
}

/** To the right of a place and `up`; elsewhere around it where it would cover one of the `crosses`. */
export function word(
  { pen, view, ink, accent, paper }: Pens,
  at: Place,
  text: string,
  {
    strong = false,
    up = 12,
    crosses = [],
  }: { strong?: boolean; up?: number; crosses?: readonly Place[] } = {},
): void {
  const wide = pen.measureText(text).width + 10;
  const places = [12, -12 - wide].flatMap((right) =>
    [-up, up].map((down) => ({
      x: Math.max(Math.min(xOf(view, at.line) + right, view.width - wide), 0),
      y: Math.max(Math.min(yOf(view, at.row) + down, view.height - 10), 10),
    })),
  );
  const covers = (place: { x: number; y: number }, cross: Place): boolean =>
    Math.abs(xOf(view, cross.line) - place.x - wide / 2) < wide / 2 + HALF_CROSS_PX &&
    Math.abs(yOf(view, cross.row) - place.y) < 9 + HALF_CROSS_PX;
  const free = places.find((place) => !crosses.some((cross) => covers(place, cross)));
  const { x, y } = free ?? (places[0] as { x: number; y: number });
  pen.fillStyle = strong ? accent : DARK;
  pen.fillRect(x, y - 9, wide, 18);
  pen.fillStyle = strong ? paper : ink;
  pen.fillText(text, x + 5, y + 1);
}
