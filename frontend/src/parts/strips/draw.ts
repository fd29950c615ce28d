/** Draws the two strips, the vehicles' spans and the boundaries of the chosen one on a canvas. */
import { say } from "../../core/messages";
import type { Scan, ScanVehicle } from "../../core/types";
import { fixed } from "../../core/units";
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

interface Colours {
  ink: string;
  line: string;
  accent: string;
  paper: string;
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
  const pen = canvas.getContext("2d");
  if (!pen) return;
  const style = getComputedStyle(canvas);
  const colours: Colours = {
    ink: style.getPropertyValue("--stage-ink"),
    line: style.getPropertyValue("--stage-line"),
    accent: style.getPropertyValue("--accent"),
    paper: style.getPropertyValue("--stage"),
  };
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.fillStyle = colours.paper;
  pen.fillRect(0, 0, view.width, 2 * view.height + AXIS_PX);
  for (const camera of [1, 2] as const) {
    pen.save();
    pen.beginPath();
    pen.rect(0, stripTop(view, camera), view.width, view.height);
    pen.clip();
    strip(pen, what, camera, ratio);
    shadowZone(pen, what, camera, colours);
    if (camera === 1) lanes(pen, what, colours);
    spans(pen, what, camera, colours);
    if (what.crossings) boundaries(pen, what, what.crossings, camera, colours);
    pen.restore();
  }
  timeAxis(pen, what, colours);
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
function shadowZone(pen: CanvasRenderingContext2D, what: Drawing, camera: 1 | 2, colours: Colours): void {
  const { view } = what;
  const share = shadowShare(what);
  if (share <= 0) return;
  const top = stripTop(view, camera);
  const rows = view.strips.rows;
  const edge = top + yOf(view, rows * (1 - share) - 0.5);
  const bottom = top + yOf(view, rows - 0.5);
  pen.fillStyle = "rgb(16 17 16 / 28%)";
  pen.fillRect(0, edge, view.width, bottom - edge);
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1;
  pen.setLineDash([2, 6]);
  pen.beginPath();
  pen.moveTo(0, edge);
  pen.lineTo(view.width, edge);
  pen.stroke();
  pen.setLineDash([]);
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "top";
  pen.fillStyle = colours.ink;
  const word = say("scan-shadow-zone");
  if (bottom - edge > 14) pen.fillText(word, view.width - pen.measureText(word).width - 8, edge + 3);
}

/** Of each lane the rows of strip 1 between which its tyres meet the road, at the window's left edge. */
function lanes(pen: CanvasRenderingContext2D, what: Drawing, colours: Colours): void {
  const { view, scan } = what;
  const top = stripTop(view, 1);
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  for (const { name, tyres_from_px, tyres_to_px } of scan.rig.lanes) {
    if (tyres_from_px === null || tyres_to_px === null) continue;
    const from = top + yOf(view, tyres_from_px - 0.5);
    const to = top + yOf(view, tyres_to_px - 0.5);
    pen.strokeStyle = colours.accent;
    pen.lineWidth = 3;
    pen.beginPath();
    pen.moveTo(3, from + 2);
    pen.lineTo(3, to - 2);
    pen.stroke();
    const wide = pen.measureText(name).width;
    pen.fillStyle = "rgb(16 17 16 / 70%)";
    pen.fillRect(8, (from + to) / 2 - 8, wide + 8, 16);
    pen.fillStyle = colours.ink;
    pen.fillText(name, 12, (from + to) / 2);
  }
}

function spans(pen: CanvasRenderingContext2D, what: Drawing, camera: 1 | 2, colours: Colours): void {
  pen.font = "600 12px system-ui, sans-serif";
  pen.textBaseline = "top";
  for (const vehicle of what.vehicles) span(pen, what, vehicle, camera, colours);
}

/** A line below the vehicle from its front to its rear, with its number where there is room. */
function span(
  pen: CanvasRenderingContext2D,
  what: Drawing,
  vehicle: ScanVehicle,
  camera: 1 | 2,
  colours: Colours,
): void {
  const measured = vehicle.measurement;
  if (!measured) return;
  const { view } = what;
  const here = vehicle.id === what.chosen;
  const lines = here && what.crossings ? what.crossings : measured;
  const from = xOf(view, camera === 1 ? lines.front_line_1 : lines.front_line_2);
  const to = xOf(view, camera === 1 ? lines.rear_line_1 : lines.rear_line_2);
  if (to < 0 || from > view.width) return;
  const bottom = stripTop(view, camera) + view.height;
  pen.strokeStyle = here ? colours.accent : colours.ink;
  pen.lineWidth = here ? 3 : 2;
  pen.setLineDash(measured.status === "ok" ? [] : [3, 3]);
  pen.beginPath();
  pen.moveTo(from, bottom - 2);
  pen.lineTo(Math.max(to, from + 2), bottom - 2);
  pen.stroke();
  pen.setLineDash([]);
  if (to - from < 14 && !here) return;
  const word = String(vehicle.number);
  const wide = pen.measureText(word).width + 8;
  const at = Math.max(Math.min((from + to) / 2 - wide / 2, view.width - wide), 0);
  pen.fillStyle = here ? colours.accent : "rgb(16 17 16 / 70%)";
  pen.fillRect(at, bottom - 20, wide, 16);
  pen.fillStyle = here ? colours.paper : colours.ink;
  pen.fillText(word, at + 4, bottom - 18);
}

function boundaries(
  pen: CanvasRenderingContext2D,
  what: Drawing,
  crossings: Crossings,
  camera: 1 | 2,
  colours: Colours,
): void {
  const { view } = what;
  const top = stripTop(view, camera);
  for (const edge of EDGES) {
    if (!edge.endsWith(String(camera))) continue;
    const x = xOf(view, crossings[edge]);
    upright(
      pen,
      x,
      top,
      view.height,
      edge === what.edge ? colours.accent : colours.ink,
      edge === what.edge ? 3 : 1.5,
    );
    pen.fillStyle = edge === what.edge ? colours.accent : colours.ink;
    const outward = edge.startsWith("front") ? -1 : 1;
    pen.beginPath();
    pen.moveTo(x, top + 2);
    pen.lineTo(x - outward * 9, top + 8);
    pen.lineTo(x, top + 14);
    pen.fill();
  }
  if (camera === 1) hubs(pen, what, colours);
}

/** Both wheels that were clicked, over the whole strip; every axle from where bodies end downwards. */
function hubs(pen: CanvasRenderingContext2D, what: Drawing, colours: Colours): void {
  const { view } = what;
  const top = stripTop(view, 1);
  for (const line of what.axles)
    upright(pen, xOf(view, line), top + 0.78 * view.height, 0.22 * view.height, colours.accent, 2);
  pen.setLineDash([5, 4]);
  for (const line of what.wheels)
    if (line !== null) upright(pen, xOf(view, line), top, view.height, colours.accent, 1.5);
  pen.setLineDash([]);
}

function upright(
  pen: CanvasRenderingContext2D,
  x: number,
  top: number,
  height: number,
  colour: string,
  wide: number,
): void {
  for (const [style, width] of [
    ["rgb(16 17 16 / 65%)", wide + 2],
    [colour, wide],
  ] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(x, top);
    pen.lineTo(x, top + height);
    pen.stroke();
  }
}

const STEPS_S = [
  0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600,
];

function timeAxis(pen: CanvasRenderingContext2D, what: Drawing, colours: Colours): void {
  const { view, scan } = what;
  const rate = scan.rig.line_rate_hz;
  const top = view.height;
  pen.fillStyle = colours.paper;
  pen.fillRect(0, top, view.width, AXIS_PX);
  const perPxS = view.perPx / rate;
  const step = STEPS_S.find((one) => one / perPxS > 90) ?? 7200;
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  pen.font = "12px system-ui, sans-serif";
  pen.textBaseline = "middle";
  pen.fillStyle = colours.ink;
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1;
  for (let n = Math.ceil(view.line0 / rate / step); ; n++) {
    const x = xOf(view, n * step * rate);
    if (x > view.width) break;
    pen.beginPath();
    pen.moveTo(Math.round(x) + 0.5, top);
    pen.lineTo(Math.round(x) + 0.5, top + AXIS_PX);
    pen.stroke();
    pen.fillText(say("value-s", { value: fixed(n * step, digits) }), x + 4, top + AXIS_PX / 2 + 1);
  }
}
