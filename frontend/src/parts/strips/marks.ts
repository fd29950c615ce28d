/** Marks over camera 1: clicks, what joins them, and words beside them. */
import { type Place, type StripsView, xOf, yOf } from "./view";

export interface Pens {
  readonly pen: CanvasRenderingContext2D;
  readonly view: StripsView;
  readonly ink: string;
  readonly accent: string;
  readonly paper: string;
}

const DARK = "rgb(16 17 16 / 72%)";
const HALF_CROSS_PX = 9;

/** A pen that keeps to camera 1; `pen.restore()` ends it. */
export function penOn(canvas: HTMLCanvasElement, view: StripsView): Pens | null {
  const pen = canvas.getContext("2d");
  if (!pen) return null;
  const style = getComputedStyle(canvas);
  const pens: Pens = {
    pen,
    view,
    ink: style.getPropertyValue("--stage-ink"),
    accent: style.getPropertyValue("--accent"),
    paper: style.getPropertyValue("--stage"),
  };
  pen.save();
  pen.beginPath();
  pen.rect(0, 0, view.width, view.height);
  pen.clip();
  pen.font = "600 12px system-ui, sans-serif";
  pen.textBaseline = "middle";
  return pens;
}

/** From the contact up and across to the target: a point at another line stands at the same distance. */
export function joined({ pen, view, ink }: Pens, contact: Place, point: Place): void {
  pen.strokeStyle = ink;
  pen.lineWidth = 1;
  pen.setLineDash([3, 3]);
  pen.beginPath();
  pen.moveTo(xOf(view, contact.line), yOf(view, contact.row));
  pen.lineTo(xOf(view, contact.line), yOf(view, point.row));
  pen.lineTo(xOf(view, point.line), yOf(view, point.row));
  pen.stroke();
  pen.setLineDash([]);
}

export function cross({ pen, view }: Pens, at: Place, colour: string): void {
  const x = xOf(view, at.line);
  const y = yOf(view, at.row);
  for (const [style, width] of [
    [DARK, 4],
    [colour, 1.5],
  ] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(x - HALF_CROSS_PX, y);
    pen.lineTo(x + HALF_CROSS_PX, y);
    pen.moveTo(x, y - HALF_CROSS_PX);
    pen.lineTo(x, y + HALF_CROSS_PX);
    pen.stroke();
  }
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
