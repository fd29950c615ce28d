/** Both strips on one time axis: drag to pan, wheel to zoom the time, with Shift the height; boundaries are dragged. */
import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { canWork } from "../../core/session";
import { theme } from "../../core/theme";
import { toast } from "../../core/toasts";
import { Asked } from "./Asked";
import { AXIS_PX, draw, EDGES, type Edge, stripTop } from "./draw";
import { drawHeights } from "./drawHeights";
import type { Place } from "./heights";
import type { ScanModel } from "./model";
import type { TileKey } from "./tiles";
import {
  levelFor,
  lineAt,
  panBy,
  resized,
  rowAt,
  tilesIn,
  type View,
  xOf,
  zoomHeight,
  zoomTime,
} from "./view";

const PICK_PX = 8;
const DRAG_PX = 3;

interface Press {
  readonly x: number;
  readonly y: number;
  lastX: number;
  lastY: number;
  readonly edge: Edge | null;
  moved: boolean;
}

export function StripView({ model }: { model: ScanModel }) {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const press = useRef<Press | null>(null);

  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const watch = new ResizeObserver(() => {
      const width = element.clientWidth;
      const height = Math.max((element.clientHeight - AXIS_PX) / 2, 40);
      if (width > 0) model.measured(width, height, (view) => resized(view, width, height));
    });
    watch.observe(element);
    return () => watch.disconnect();
  }, [model]);

  useSignalEffect(() => {
    const view = model.view.value;
    const scan = model.scan.value;
    if (!view || !scan || !canvas.current) return;
    void [model.tiles.arrived.value, theme.value]; // drawn again for these too
    model.tiles.want(wanted(model, view));
    draw(canvas.current, {
      scan,
      view,
      tiles: model.tiles,
      vehicles: model.vehicles.value,
      chosen: model.chosenId.value,
      crossings: model.crossings.value,
      edge: model.edge.value,
      wheels: model.wheels.value,
    });
    drawHeights(canvas.current, model, view);
  });

  const place = (event: MouseEvent): { x: number; y: number } => {
    const box = host.current?.getBoundingClientRect();
    return { x: event.clientX - (box?.left ?? 0), y: event.clientY - (box?.top ?? 0) };
  };

  const down = (event: PointerEvent): void => {
    const view = model.view.value;
    if (!view || event.button > 1) return;
    const { x, y } = place(event);
    const edge =
      event.button === 0 && model.mode.value === "look" && canWork.value ? edgeNear(model, view, x, y) : null;
    press.current = { x, y, lastX: x, lastY: y, edge, moved: false };
    if (edge) {
      model.edge.value = edge;
      model.heights.selected.value = null;
    }
    host.current?.setPointerCapture(event.pointerId);
  };

  const pointAt = (view: View, x: number, y: number): void => {
    if (model.mode.value === "height") model.heights.point(placeAt(view, x, y));
    const near = canWork.value && model.mode.value === "look" && edgeNear(model, view, x, y) !== null;
    host.current?.classList.toggle("strips--edge", near);
  };

  const drag = (view: View, held: Press, x: number, y: number): void => {
    if (Math.hypot(x - held.x, y - held.y) > DRAG_PX) held.moved = true;
    if (held.moved && held.edge) model.moveEdge(held.edge, lineAt(view, x));
    else if (held.moved) model.view.value = panBy(view, x - held.lastX, y - held.lastY);
    held.lastX = x;
    held.lastY = y;
  };

  const move = (event: PointerEvent): void => {
    const view = model.view.value;
    if (!view) return;
    const { x, y } = place(event);
    if (press.current) drag(view, press.current, x, y);
    else pointAt(view, x, y);
  };

  /** A click that dragged nothing: a point that is asked for, or the choice of a vehicle. */
  const click = (view: View, x: number, y: number): void => {
    if (model.mode.value === "look") {
      const id = vehicleAt(model, view, x, y);
      if (id !== model.chosenId.value) model.choose(id);
      return;
    }
    const at = placeAt(view, x, y);
    if (at) void model.click(at.line, at.row);
    else toast("Click on camera 1, the upper strip.");
  };

  const up = (): void => {
    const view = model.view.value;
    const now = press.current;
    press.current = null;
    if (!view || !now) return;
    if (now.moved && now.edge) void model.storeDraft();
    if (!now.moved && !now.edge) click(view, now.x, now.y);
  };

  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const view = model.view.value;
    if (!view) return;
    const { x, y } = place(event);
    const turn = Math.abs(event.deltaY) > Math.abs(event.deltaX) ? event.deltaY : event.deltaX;
    const factor = Math.exp(-turn * (event.deltaMode === 1 ? 0.05 : 0.0016));
    const inStrip = y < view.height ? y : Math.max(y - stripTop(view, 2), 0);
    model.view.value = event.shiftKey ? zoomHeight(view, inStrip, factor) : zoomTime(view, x, factor);
  };

  useEffect(() => {
    const element = host.current;
    element?.addEventListener("wheel", wheel, { passive: false });
    return () => element?.removeEventListener("wheel", wheel);
  }, [model]);

  return (
    <div
      ref={host}
      class={`strips${model.mode.value === "look" ? "" : " strips--placing"}`}
      data-testid="strips"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: role "application" takes the keys and clicks itself
      tabIndex={0}
      role="application"
      aria-roledescription="line-scan strips"
      aria-label="Camera 1 above, camera 2 below, time to the right"
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={up}
      onPointerLeave={() => model.heights.point(null)}
      onPointerCancel={() => {
        press.current = null;
        model.draft.value = null;
      }}
      onDblClick={() => model.show("fit")}
    >
      <canvas ref={canvas} />
      <span class="strips__name">camera 1</span>
      <span class="strips__name strips__name--second">camera 2</span>
      <Asked model={model} />
      {model.tiles.failed.value && (
        <div class="strips__problem" role="alert">
          Some of the picture could not be fetched.{" "}
          <button type="button" class="btn btn--small" onClick={() => model.tiles.retry()}>
            Try again
          </button>
        </div>
      )}
    </div>
  );
}

/** Tiles of the level that fits, and of the coarsest, which stands in until they are here. */
function wanted(model: ScanModel, view: View): TileKey[] {
  const scan = model.scan.value;
  if (!scan || scan.levels.length === 0) return [];
  const finest = levelFor(view.perPx, scan.levels.length, window.devicePixelRatio || 1);
  const keys: TileKey[] = [];
  for (const level of new Set([finest, scan.levels.length - 1])) {
    const about = scan.levels[level];
    if (!about) continue;
    const [first, last] = tilesIn(view, about.step, scan.tile_lines, about.tiles);
    for (let index = first; index <= last; index++)
      for (const camera of [1, 2] as const) keys.push({ camera, level, index });
  }
  return keys;
}

/** A place on camera 1's picture, null beside it. */
function placeAt(view: View, x: number, y: number): Place | null {
  const row = rowAt(view, y);
  if (y < 0 || y >= view.height || row > view.strips.rows - 0.5) return null;
  return { line: lineAt(view, x), row };
}

function edgeNear(model: ScanModel, view: View, x: number, y: number): Edge | null {
  const lines = model.crossings.value;
  if (!lines) return null;
  const camera = y < view.height + AXIS_PX / 2 ? "1" : "2";
  let best: Edge | null = null;
  let nearest = PICK_PX;
  for (const edge of EDGES) {
    const distance = Math.abs(xOf(view, lines[edge]) - x);
    if (!edge.endsWith(camera) || distance > nearest) continue;
    best = edge;
    nearest = distance;
  }
  return best;
}

function vehicleAt(model: ScanModel, view: View, x: number, y: number): number | null {
  const line = lineAt(view, x);
  const second = y >= view.height + AXIS_PX / 2;
  const found = model.vehicles.value.find(({ measurement: one }) => {
    if (!one) return false;
    const [from, to] = second ? [one.front_line_2, one.rear_line_2] : [one.front_line_1, one.rear_line_1];
    return line >= from && line <= to;
  });
  return found?.id ?? null;
}
