/**
 * How two strips lie on the screen: time and height have scales of their own. Immutable; every change returns a new view.
 * Line n's centre is at n, so a strip begins at line -0.5; rows likewise.
 */
import { clamp } from "../../viewer/view";

/** The pictures: lines along the time, rows along the height, both strips alike. */
export interface Strips {
  readonly lines: number;
  readonly rows: number;
}

export interface View {
  readonly strips: Strips;
  /** Screen pixels of one strip's window. */
  readonly width: number;
  readonly height: number;
  /** Line at the window's left edge, lines per screen pixel. */
  readonly line0: number;
  readonly perPx: number;
  /** Row at the window's top edge, screen pixels per row. */
  readonly row0: number;
  readonly rowPx: number;
}

const FINEST_PER_PX = 1 / 24;
const MAX_ROW_PX = 24;

export function fitAll(strips: Strips, width: number, height: number): View {
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

export function xOf(view: View, line: number): number {
  return (line - view.line0) / view.perPx;
}

export function lineAt(view: View, x: number): number {
  return view.line0 + x * view.perPx;
}

export function yOf(view: View, row: number): number {
  return (row - view.row0) * view.rowPx;
}

export function rowAt(view: View, y: number): number {
  return view.row0 + y / view.rowPx;
}

/** Time stretched by a factor; the line under x stays there. */
export function zoomTime(view: View, x: number, factor: number): View {
  const most = view.strips.lines / Math.max(view.width, 1);
  const perPx = clamp(view.perPx / factor, Math.min(FINEST_PER_PX, most), most);
  return placed({ ...view, perPx, line0: lineAt(view, x) - x * perPx });
}

/** Height stretched by a factor; the row under y stays there. */
export function zoomHeight(view: View, y: number, factor: number): View {
  const least = view.height / view.strips.rows;
  const rowPx = clamp(view.rowPx * factor, least, Math.max(MAX_ROW_PX, least));
  return placed({ ...view, rowPx, row0: view.row0 + y / view.rowPx - y / rowPx });
}

export function panBy(view: View, dx: number, dy: number): View {
  return placed({ ...view, line0: view.line0 - dx * view.perPx, row0: view.row0 - dy / view.rowPx });
}

/** Shows the lines from `first` to `last` with some road before and behind. */
export function showLines(view: View, first: number, last: number, share = 0.25): View {
  const span = Math.max(last - first, 8);
  const wanted = (span * (1 + 2 * share)) / Math.max(view.width, 1);
  const most = view.strips.lines / Math.max(view.width, 1);
  const perPx = clamp(wanted, Math.min(FINEST_PER_PX, most), most);
  return placed({ ...view, perPx, line0: (first + last) / 2 - (view.width * perPx) / 2 });
}

/** Moves just enough that the lines are seen; where they are too many, the scale gives way. */
export function revealLines(view: View, first: number, last: number): View {
  const margin = 0.05 * view.width * view.perPx;
  if (last - first > view.width * view.perPx - 2 * margin) return showLines(view, first, last);
  const low = view.line0 + margin;
  const high = view.line0 + view.width * view.perPx - margin;
  if (first >= low && last <= high) return view;
  return placed({ ...view, line0: (first + last) / 2 - (view.width * view.perPx) / 2 });
}

/** The window has another size: the scale along the time stays where something was zoomed. */
export function resized(view: View, width: number, height: number): View {
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
export function tilesIn(view: View, step: number, tileLines: number, tiles: number): [number, number] {
  const per = step * tileLines;
  const first = Math.floor((view.line0 + 0.5) / per);
  const last = Math.floor((lineAt(view, view.width) + 0.5) / per);
  return [clamp(first, 0, tiles - 1), clamp(last, 0, tiles - 1)];
}

function placed(view: View): View {
  const most = view.strips.lines / Math.max(view.width, 1);
  const perPx = Math.min(view.perPx, most);
  const rowPx = Math.max(view.rowPx, view.height / view.strips.rows);
  return {
    ...view,
    perPx,
    rowPx,
    line0: clamp(view.line0, -0.5, Math.max(-0.5, view.strips.lines - 0.5 - view.width * perPx)),
    row0: clamp(view.row0, -0.5, Math.max(-0.5, view.strips.rows - 0.5 - view.height / rowPx)),
  };
}
