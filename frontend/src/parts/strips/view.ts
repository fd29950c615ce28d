/**
 * How two strips lie on the screen: time and height have scales of their own. Immutable; every change returns a new view.
 * Line n's centre is at n, so a strip begins at line -0.5; rows likewise.
 */
import { type ScreenPoint, screenPoint } from "../../viewer/points";
import { clamp, type Size, type View } from "../../viewer/view";

/** The pictures: lines along the time, rows along the height, both strips alike. */
export interface Strips {
  readonly lines: number;
  readonly rows: number;
}

export interface Place {
  readonly line: number;
  readonly row: number;
}

export interface StripPoint extends Place {
  readonly camera: 1 | 2;
}

export function placeOf([line, row]: readonly [number, number]): Place {
  return { line, row };
}

/** Height of the band between the strips, which carries the time. */
export const AXIS_PX = 24;
const LEAST_HEIGHT_PX = 40;
/** What is revealed lies at least so far inside the window. */
const MARGIN_PX = 40;

interface Scales {
  readonly strips: Strips;
  readonly width: number;
  readonly height: number;
  /** Line at the window's left edge, lines per screen pixel. */
  readonly line0: number;
  readonly perPx: number;
  /** Row at the window's top edge, screen pixels per row. */
  readonly row0: number;
  readonly rowPx: number;
}

export interface StripsView extends Scales {}

/** Both strips in one window, camera 1 above camera 2, on one time axis. */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor takes each of `Scales` over
export class StripsView implements View<StripPoint, StripsView> {
  constructor(scales: Scales) {
    Object.assign(this, scales);
  }

  get screen(): Size {
    return { width: this.width, height: 2 * this.height + AXIS_PX };
  }

  toScreen({ camera, line, row }: StripPoint): ScreenPoint {
    return screenPoint(xOf(this, line), stripTop(this, camera) + yOf(this, row));
  }

  toPicture(at: ScreenPoint): StripPoint {
    const camera = at[1] < this.height + AXIS_PX / 2 ? 1 : 2;
    return { camera, line: lineAt(this, at[0]), row: rowAt(this, at[1] - stripTop(this, camera)) };
  }

  /** Along the time only: a vehicle is chosen anywhere above or below it. */
  contains({ line }: StripPoint): boolean {
    return line >= -0.5 && line <= this.strips.lines - 0.5;
  }

  nearest({ camera, line, row }: StripPoint): StripPoint {
    const { lines, rows } = this.strips;
    return { camera, line: clamp(line, 0, lines - 1), row: clamp(row, 0, rows - 1) };
  }

  shifted(at: StripPoint, dx: number, dy: number): StripPoint {
    return { ...at, line: at.line + dx, row: at.row + dy };
  }

  pan(dx: number, dy: number): StripsView {
    return panBy(this, dx, dy);
  }

  zoom(at: ScreenPoint, factor: number, across = false): StripsView {
    if (!across) return zoomTime(this, at[0], factor);
    const { camera } = this.toPicture(at);
    return zoomHeight(this, clamp(at[1] - stripTop(this, camera), 0, this.height), factor);
  }

  reveal(at: StripPoint): StripsView {
    const [x, y] = [xOf(this, at.line), yOf(this, at.row)];
    const dx = x - clamp(x, MARGIN_PX, Math.max(MARGIN_PX, this.width - MARGIN_PX));
    const dy = y - clamp(y, 0, this.height);
    return dx === 0 && dy === 0 ? this : panBy(this, -dx, -dy);
  }

  fit(): StripsView {
    return zoomTime(this, 0, 0);
  }

  resized(screen: Size): StripsView {
    return resized(this, screen.width, Math.max((screen.height - AXIS_PX) / 2, LEAST_HEIGHT_PX));
  }
}

export function stripTop(view: Scales, camera: 1 | 2): number {
  return camera === 1 ? 0 : view.height + AXIS_PX;
}

const FINEST_PER_PX = 1 / 24;
const MAX_ROW_PX = 24;

export function fitAll(strips: Strips, width: number, height: number): StripsView {
  return placed({
    strips,
    width,
    height,
    line0: -0.5,
    perPx: strips.lines / Math.max(width, 1),
    row0: -0.5,
    rowPx: height / strips.rows,
  });
}

export function xOf(view: Scales, line: number): number {
  return (line - view.line0) / view.perPx;
}

export function lineAt(view: Scales, x: number): number {
  return view.line0 + x * view.perPx;
}

export function yOf(view: Scales, row: number): number {
  return (row - view.row0) * view.rowPx;
}

function rowAt(view: Scales, y: number): number {
  return view.row0 + y / view.rowPx;
}

/** Time stretched by a factor; the line under x stays there. */
export function zoomTime(view: Scales, x: number, factor: number): StripsView {
  const most = view.strips.lines / Math.max(view.width, 1);
  const perPx = clamp(view.perPx / factor, Math.min(FINEST_PER_PX, most), most);
  return placed({ ...view, perPx, line0: lineAt(view, x) - x * perPx });
}

/** Height stretched by a factor; the row under y stays there. */
export function zoomHeight(view: Scales, y: number, factor: number): StripsView {
  const least = view.height / view.strips.rows;
  const rowPx = clamp(view.rowPx * factor, least, Math.max(MAX_ROW_PX, least));
  return placed({ ...view, rowPx, row0: view.row0 + y / view.rowPx - y / rowPx });
}

export function panBy(view: Scales, dx: number, dy: number): StripsView {
  return placed({ ...view, line0: view.line0 - dx * view.perPx, row0: view.row0 - dy / view.rowPx });
}

/** Shows the lines from `first` to `last` with some road before and behind. */
export function showLines(view: Scales, first: number, last: number, share = 0.25): StripsView {
  const span = Math.max(last - first, 8);
  const wanted = (span * (1 + 2 * share)) / Math.max(view.width, 1);
  const most = view.strips.lines / Math.max(view.width, 1);
  const perPx = clamp(wanted, Math.min(FINEST_PER_PX, most), most);
  return placed({ ...view, perPx, line0: (first + last) / 2 - (view.width * perPx) / 2 });
}

/** Moves just enough that the lines are seen; where they are too many, the scale gives way. */
export function revealLines(view: StripsView, first: number, last: number): StripsView {
  const margin = 0.05 * view.width * view.perPx;
  if (last - first > view.width * view.perPx - 2 * margin) return showLines(view, first, last);
  const low = view.line0 + margin;
  const high = view.line0 + view.width * view.perPx - margin;
  if (first >= low && last <= high) return view;
  return placed({ ...view, line0: (first + last) / 2 - (view.width * view.perPx) / 2 });
}

/** The window has another size: the scale along the time stays where something was zoomed. */
export function resized(view: Scales, width: number, height: number): StripsView {
  const all = fitAll(view.strips, width, height);
  const fitted = view.perPx >= view.strips.lines / Math.max(view.width, 1) - 1e-9;
  if (fitted) return all;
  const full = view.rowPx <= view.height / view.strips.rows + 1e-9;
  const rows = full ? { row0: all.row0, rowPx: all.rowPx } : { row0: view.row0, rowPx: view.rowPx };
  return placed({ ...view, ...rows, width, height });
}

/** The coarsest level (a step of 4 each) that still has a line for every pixel of the screen. */
export function levelFor(perPx: number, levels: number, ratio = 1): number {
  const wanted = Math.floor(Math.log(Math.max(perPx / ratio, 1)) / Math.log(4) + 1e-9);
  return clamp(wanted, 0, Math.max(levels - 1, 0));
}

/** First and last tile of a level (of so many lines each) that the window shows. */
export function tilesIn(view: Scales, step: number, tileLines: number, tiles: number): [number, number] {
  const per = step * tileLines;
  const first = Math.floor((view.line0 + 0.5) / per);
  const last = Math.floor((lineAt(view, view.width) + 0.5) / per);
  return [clamp(first, 0, tiles - 1), clamp(last, 0, tiles - 1)];
}

function placed(view: Scales): StripsView {
  const most = view.strips.lines / Math.max(view.width, 1);
  const perPx = Math.min(view.perPx, most);
  const rowPx = Math.max(view.rowPx, view.height / view.strips.rows);
  return new StripsView({
    ...view,
    perPx,
    rowPx,
    line0: clamp(view.line0, -0.5, Math.max(-0.5, view.strips.lines - 0.5 - view.width * perPx)),
    row0: clamp(view.row0, -0.5, Math.max(-0.5, view.strips.rows - 0.5 - view.height / rowPx)),
  });
}
