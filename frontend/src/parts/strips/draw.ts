/** Draws the two strips, the vehicles' spans and the boundaries of the chosen one on a canvas. */
import { say } from "../../core/messages";
import type { Scan, ScanVehicle } from "../../core/types";
import { fixed } from "../../core/units";
import { keepWithin, type Pens, pensOf, stroke } from "./marks";
import type { Tiles } from "./tiles";
import { AXIS_PX, levelFor, type StripsView, stripTop, tilesIn, xOf, yOf } from "./view";

export const EDGES = ["front_line_1", "rear_line_1", "front_line_2", "rear_line_2"] as const;
export type Edge = (typeof EDGES)[number];
export type Crossings = Record<Edge, number>;

export interface Drawing {
  readonly scan: Scan;
  readonly view: StripsView;
  readonly tiles: Tiles;
  readonly vehicles: readonly ScanVehicle[];
  readonly chosen: number | null;
  readonly crossings: Crossings | null;
  readonly edge: Edge | null;
  readonly wheels: readonly (number | null)[];
  /** Every wheel's hub, of which axles are counted. */
  readonly axles: readonly number[];
}

export function draw(canvas: HTMLCanvasElement, what: Drawing): void {
  const { view } = what;
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(view.width * ratio);
  const height = Math.round((2 * view.height + AXIS_PX) * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const pens = pensOf(canvas, view);
  if (!pens) return;
  const { pen, paper } = pens;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.fillStyle = paper;
  pen.fillRect(0, 0, view.width, 2 * view.height + AXIS_PX);
  for (const camera of [1, 2] as const) {
    keepWithin(pens, stripTop(view, camera));
    strip(pen, what, camera, ratio);
    shadowZone(pens, what, camera);
    if (camera === 1) lanes(pens, what);
    spans(pens, what, camera);
    if (what.crossings) boundaries(pens, what, what.crossings, camera);
    pen.restore();
  }
  timeAxis(pens, what);
}

function strip(pen: CanvasRenderingContext2D, what: Drawing, camera: 1 | 2, ratio: number): void {
  const { view, scan } = what;
  const finest = levelFor(view.perPx, scan.levels.length, ratio);
  pen.imageSmoothingEnabled = view.perPx > 0.4 && view.rowPx < 3;
  // coarse first, so that what is finer covers it once it is here
  for (let level = scan.levels.length - 1; level >= finest; level--) {
    const about = scan.levels[level];
    if (!about) continue;
    const [first, last] = tilesIn(view, about.step, scan.tile_lines, about.tiles);
    for (let index = first; index <= last; index++) {
      const bitmap = what.tiles.get({ camera, level, index });
      if (!bitmap) continue;
      const left = xOf(view, index * scan.tile_lines * about.step - 0.5);
      const top = stripTop(view, camera) + yOf(view, -0.5);
      const wide = (bitmap.width * about.step) / view.perPx;
      pen.drawImage(bitmap, left, top, wide, view.strips.rows * view.rowPx);
    }
  }
}

/** The share of the rows that the chosen vehicle's lane has as its shadow zone, or the rig. */
function shadowShare({ scan, vehicles, chosen }: Drawing): number {
  const lane = vehicles.find((one) => one.id === chosen)?.measurement?.lane;
  return scan.rig.lanes.find((one) => one.name === lane)?.shadow_share ?? scan.rig.shadow_share;
}

/** The rows in which shadows fall and no vehicle is looked for: their upper edge, and a veil over them. */
function shadowZone(pens: Pens, what: Drawing, camera: 1 | 2): void {
  const { pen, view } = pens;
  const share = shadowShare(what);
  if (share <= 0) return;
  const top = stripTop(view, camera);
  const rows = view.strips.rows;
  const edge = top + yOf(view, rows * (1 - share) - 0.5);
  const bottom = top + yOf(view, rows - 0.5);
  pen.fillStyle = "rgb(16 17 16 / 28%)";
  pen.fillRect(0, edge, view.width, bottom - edge);
  const above = [0, view.width].map((x) => [x, edge] as const);
  stroke(pens, { style: [pens.line, 1], dash: [2, 6] }, above);
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "top";
  pen.fillStyle = pens.ink;
  const word = say("scan-shadow-zone");
  if (bottom - edge > 14) pen.fillText(word, view.width - pen.measureText(word).width - 8, edge + 3);
}

/** Of each lane the rows of strip 1 between which its tyres meet the road, at the window's left edge. */
function lanes(pens: Pens, { scan }: Drawing): void {
  const { pen, view } = pens;
  const top = stripTop(view, 1);
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  for (const { name, tyres_from_px, tyres_to_px } of scan.rig.lanes) {
    if (tyres_from_px === null || tyres_to_px === null) continue;
    const from = top + yOf(view, tyres_from_px - 0.5);
    const to = top + yOf(view, tyres_to_px - 0.5);
    upright(pens, 3, from + 2, to - 2, { style: [pens.accent, 3] });
    const wide = pen.measureText(name).width;
    pen.fillStyle = "rgb(16 17 16 / 70%)";
    pen.fillRect(8, (from + to) / 2 - 8, wide + 8, 16);
    pen.fillStyle = pens.ink;
    pen.fillText(name, 12, (from + to) / 2);
  }
}

function spans(pens: Pens, what: Drawing, camera: 1 | 2): void {
  pens.pen.font = "600 12px system-ui, sans-serif";
  pens.pen.textBaseline = "top";
  for (const vehicle of what.vehicles) span(pens, what, vehicle, camera);
}

/** A line below the vehicle from its front to its rear, with its number where there is room. */
function span(pens: Pens, what: Drawing, vehicle: ScanVehicle, camera: 1 | 2): void {
  const measured = vehicle.measurement;
  if (!measured) return;
  const { pen, view } = pens;
  const here = vehicle.id === what.chosen;
  const lines = here && what.crossings ? what.crossings : measured;
  const from = xOf(view, camera === 1 ? lines.front_line_1 : lines.front_line_2);
  const to = xOf(view, camera === 1 ? lines.rear_line_1 : lines.rear_line_2);
  if (to < 0 || from > view.width) return;
  const bottom = stripTop(view, camera) + view.height;
  const below = [from, Math.max(to, from + 2)].map((x) => [x, bottom - 2] as const);
  const dash = measured.status === "ok" ? [] : [3, 3];
  stroke(pens, { style: here ? [pens.accent, 3] : [pens.ink, 2], dash }, below);
  if (to - from < 14 && !here) return;
  const word = String(vehicle.number);
  const wide = pen.measureText(word).width + 8;
  const at = Math.max(Math.min((from + to) / 2 - wide / 2, view.width - wide), 0);
  pen.fillStyle = here ? pens.accent : "rgb(16 17 16 / 70%)";
  pen.fillRect(at, bottom - 20, wide, 16);
  pen.fillStyle = here ? pens.paper : pens.ink;
  pen.fillText(word, at + 4, bottom - 18);
}

function boundaries(pens: Pens, what: Drawing, crossings: Crossings, camera: 1 | 2): void {
  const { pen, view, ink, accent } = pens;
  const top = stripTop(view, camera);
  for (const edge of EDGES) {
    if (!edge.endsWith(String(camera))) continue;
    const x = xOf(view, crossings[edge]);
    const [colour, width] = edge === what.edge ? ([accent, 3] as const) : ([ink, 1.5] as const);
    upright(pens, x, top, top + view.height, edged(colour, width));
    pen.fillStyle = colour;
    const outward = edge.startsWith("front") ? -1 : 1;
    pen.beginPath();
    pen.moveTo(x, top + 2);
    pen.lineTo(x - outward * 9, top + 8);
    pen.lineTo(x, top + 14);
    pen.fill();
  }
  if (camera === 1) hubs(pens, what);
}

/** Both wheels that were clicked, over the whole strip; every axle from where bodies end downwards. */
function hubs(pens: Pens, { axles, wheels }: Drawing): void {
  const { view, accent } = pens;
  const top = stripTop(view, 1);
  const bottom = top + view.height;
  for (const line of axles)
    upright(pens, xOf(view, line), top + 0.78 * view.height, bottom, edged(accent, 2));
  for (const line of wheels)
    if (line !== null) upright(pens, xOf(view, line), top, bottom, { ...edged(accent, 1.5), dash: [5, 4] });
}

type Stroke = Parameters<typeof stroke>[1];

function edged(colour: string, width: number): Stroke {
  return { style: [colour, width], edge: ["rgb(16 17 16 / 65%)", width + 2] };
}

function upright(pens: Pens, x: number, top: number, bottom: number, how: Stroke): void {
  const path = [top, bottom].map((y) => [x, y] as const);
  stroke(pens, how, path);
}

const STEPS_S = [
  0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600,
];

function timeAxis(pens: Pens, { scan }: Drawing): void {
  const { pen, view, ink, line, paper } = pens;
  const rate = scan.rig.line_rate_hz;
  const top = view.height;
  pen.fillStyle = paper;
  pen.fillRect(0, top, view.width, AXIS_PX);
  const perPxS = view.perPx / rate;
  const step = STEPS_S.find((one) => one / perPxS > 90) ?? 7200;
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  pen.font = "12px system-ui, sans-serif";
  pen.textBaseline = "middle";
  pen.fillStyle = ink;
  for (let n = Math.ceil(view.line0 / rate / step); ; n++) {
    const x = xOf(view, n * step * rate);
    if (x > view.width) break;
    upright(pens, Math.round(x) + 0.5, top, top + AXIS_PX, { style: [line, 1] });
    pen.fillText(say("value-s", { value: fixed(n * step, digits) }), x + 4, top + AXIS_PX / 2 + 1);
  }
}
