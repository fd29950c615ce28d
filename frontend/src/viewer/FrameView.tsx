/** The frame: a canvas for the picture, an SVG in image coordinates above it, and the pointer. */
import { useSignalEffect } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { BRIGHT_WORDS, bright } from "./display";
import { Loupe } from "./Loupe";
import type { Player } from "./player";
import { type ImagePoint, type ScreenPoint, screenDistance } from "./points";
import type { Stage } from "./stage";
import "./timeline.css";
import "./viewer.css";
import "./notes.css";

/** A point that can be picked and dragged. */
export interface Handle {
  readonly id: string;
  readonly at: ImagePoint;
}

export interface FrameViewProps {
  player: Player;
  stage: Stage;
  /** Shapes above the picture; see Overlay. */
  children?: ComponentChildren;
  /** Plain elements above everything, placed by the caller. */
  above?: ComponentChildren;
  label: string;
  describedBy?: string;
  handles?: readonly Handle[];
  /** True when a click places a point: the cross-hair, and picking only by dragging. */
  placing?: boolean;
  onPlace?(point: ImagePoint): void;
  onHover?(point: ImagePoint | null): void;
  onPick?(id: string): void;
  onDrag?(id: string, point: ImagePoint, phase: "move" | "end" | "cancel"): void;
}

const PICK_PX = 11;
const DRAG_PX = 3;

interface Press {
  readonly start: ScreenPoint;
  last: ScreenPoint;
  readonly handle: Handle | null;
  /** Where in the handle it was gripped, so that it does not jump under the pointer. */
  readonly grip: readonly [number, number];
  readonly pan: boolean;
  moved: boolean;
}

export function FrameView(props: FrameViewProps) {
  const { player, stage } = props;
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const press = useRef<Press | null>(null);
  const space = useRef(false);
  const latest = useRef(props);
  latest.current = props;

  useEffect(() => (host.current ? stage.attach(host.current) : undefined), [stage]);
  useSpaceHeld(space);

  useSignalEffect(() => {
    const shown = player.shown.value;
    const facts = player.recording.value;
    if (shown) stage.setImage(shown.picture);
    else if (player.preview.value && facts?.width_px && facts.height_px)
      stage.setImage({ width: facts.width_px, height: facts.height_px });
    const seen = shown ?? player.preview.value;
    if (canvas.current) draw(canvas.current, seen?.picture ?? null, stage);
  });

  const position = (event: PointerEvent): ScreenPoint => stage.fromClient(event.clientX, event.clientY);

  const hover = (at: ScreenPoint | null): void => {
    const view = stage.viewport.value;
    const point = at ? view.toImage(at) : null;
    const inside = point && view.contains(point) ? point : null;
    stage.pointer.value = inside;
    latest.current.onHover?.(inside);
  };

  const down = (event: PointerEvent): void => {
    if (event.button > 1) return;
    const at = position(event);
    const pan = event.button === 1 || space.current;
    const handle = pan ? null : nearest(latest.current.handles ?? [], at, stage);
    const centre = handle ? stage.viewport.value.toScreen(handle.at) : at;
    const grip = [centre[0] - at[0], centre[1] - at[1]] as const;
    press.current = { start: at, last: at, handle, grip, pan, moved: false };
    host.current?.setPointerCapture(event.pointerId);
  };

  const move = (event: PointerEvent): void => {
    const at = position(event);
    const now = press.current;
    if (now && screenDistance(at, now.start) > DRAG_PX) now.moved = true;
    if (now?.moved && now.pan) {
      stage.panned = true;
      stage.viewport.value = stage.viewport.value.panBy(at[0] - now.last[0], at[1] - now.last[1]);
    } else if (now?.moved && now.handle && latest.current.onDrag && !player.preview.value) {
      stage.dragging.value = true;
      dragTo(now, at, "move");
    }
    if (now) now.last = at;
    if (!stage.dragging.value) hover(at);
  };

  const dragTo = (now: Press, at: ScreenPoint, phase: "move" | "end"): void => {
    if (!now.handle) return;
    const view = stage.viewport.value;
    const centre = [at[0] + now.grip[0], at[1] + now.grip[1]] as unknown as ScreenPoint;
    const point = view.toImage(centre);
    stage.pointer.value = point;
    latest.current.onDrag?.(now.handle.id, point, phase);
  };

  const up = (event: PointerEvent): void => {
    const now = press.current;
    press.current = null;
    stage.dragging.value = false;
    if (!now || now.pan || player.preview.value) return;
    const at = position(event);
    if (now.moved) dragTo(now, at, "end");
    else if (now.handle && !latest.current.placing) latest.current.onPick?.(now.handle.id);
    else {
      const point = stage.viewport.value.toImage(now.start);
      if (stage.viewport.value.contains(point)) latest.current.onPlace?.(point);
    }
  };

  const cancel = (): void => {
    const now = press.current;
    press.current = null;
    stage.dragging.value = false;
    if (now?.moved && now.handle) latest.current.onDrag?.(now.handle.id, now.handle.at, "cancel");
  };

  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const at = stage.fromClient(event.clientX, event.clientY);
    const factor = Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016));
    stage.viewport.value = stage.viewport.value.zoomAt(at, factor);
    hover(at);
  };

  useEffect(() => {
    const element = host.current;
    element?.addEventListener("wheel", wheel, { passive: false });
    return () => element?.removeEventListener("wheel", wheel);
  }, [stage]);

  return (
    <div
      ref={host}
      class={`frame-view${props.placing ? " frame-view--placing" : ""}`}
      data-testid="frame-view"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: role "application" takes the keys and clicks itself
      tabIndex={0}
      role="application"
      aria-roledescription="frame"
      aria-label={props.label}
      aria-describedby={props.describedBy}
      onMouseDown={(event) => event.button === 1 && event.preventDefault()}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={up}
      onPointerCancel={cancel}
      onPointerLeave={() => press.current === null && hover(null)}
      onContextMenu={(event) => event.preventDefault()}
    >
      <canvas ref={canvas} />
      <svg class="frame-overlay" aria-hidden="true">
        <title>Axes and points over the frame</title>
        {props.children}
      </svg>
      {props.above}
      {bright.value && (
        <p class="frame-display" data-testid="display-only">
          {BRIGHT_WORDS}
        </p>
      )}
      <Loupe player={player} stage={stage} />
      <FrameState player={player} />
    </div>
  );
}

function FrameState({ player }: { player: Player }) {
  const problem = player.problem.value;
  if (problem) {
    return (
      <div class="frame-problem" role="alert">
        <p>{problem}</p>
        <button type="button" class="btn" onClick={() => player.retry()}>
          Try again
        </button>
      </div>
    );
  }
  const waiting = player.loading.value;
  const preview = player.preview.value;
  if (preview)
    return (
      <div class="frame-loading frame-loading--on" role="status" data-testid="stand-in">
        <span class="spinner" /> thumbnail of frame {preview.frame}; frame {player.frame.value} is coming
      </div>
    );
  return (
    <div class={`frame-loading${waiting ? " frame-loading--on" : ""}`} aria-hidden={!waiting}>
      <span class="spinner" /> frame {player.frame.value}
    </div>
  );
}

function nearest(handles: readonly Handle[], at: ScreenPoint, stage: Stage): Handle | null {
  let best: Handle | null = null;
  let bestDistance = PICK_PX;
  for (const handle of handles) {
    const distance = screenDistance(stage.viewport.value.toScreen(handle.at), at);
    if (distance > bestDistance) continue;
    best = handle;
    bestDistance = distance;
  }
  return best;
}

function draw(canvas: HTMLCanvasElement, picture: ImageBitmap | null, stage: Stage): void {
  const { screen, image, left, top, scale } = stage.viewport.value;
  // where the picture lies, for who reads the page from outside, as the browser tests do
  canvas.dataset["picture"] = `${left} ${top} ${scale}`;
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(screen.width * ratio);
  const height = Math.round(screen.height * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  if (!context) return;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, width, height);
  if (!picture || picture.width === 0) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  // single pixels are what is clicked on: past 3x show them as they are
  context.imageSmoothingEnabled = scale < 3;
  context.imageSmoothingQuality = "high";
  context.drawImage(picture, left, top, image.width * scale, image.height * scale);
}

function useSpaceHeld(held: { current: boolean }): void {
  useEffect(() => {
    const set = (event: KeyboardEvent): void => {
      if (event.code === "Space") held.current = event.type === "keydown";
    };
    window.addEventListener("keydown", set, true);
    window.addEventListener("keyup", set, true);
    return () => {
      window.removeEventListener("keydown", set, true);
      window.removeEventListener("keyup", set, true);
    };
  }, [held]);
}
