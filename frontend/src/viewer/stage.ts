/** What a frame view shares with its loupe, overlay and screen: the viewport, the pointer, and a way in for tests. */
import { signal } from "@preact/signals";
import { type ImagePoint, imagePoint, type ScreenPoint, screenPoint } from "./points";
import { type Size, Viewport } from "./viewport";

const NOTHING: Size = { width: 1, height: 1 };

export class Stage {
  readonly viewport = signal(Viewport.fit({ width: 640, height: 480 }, NOTHING));
  /** Where the pointer (or the keyboard's cursor) stands, in the image; null outside. */
  readonly pointer = signal<ImagePoint | null>(null);
  /** The loupe is switched on, held (Z), or a point is being dragged. */
  readonly loupe = signal(false);
  readonly dragging = signal(false);
  /** Set when Space was held to pan, so that letting it go does not play. */
  panned = false;
  private element: HTMLElement | null = null;
  private known = false;

  attach(element: HTMLElement): () => void {
    this.element = element;
    const watcher = new ResizeObserver(() => this.measure());
    watcher.observe(element);
    this.measure();
    const withdraw = expose(this);
    return () => {
      watcher.disconnect();
      withdraw();
      this.element = null;
    };
  }

  /** The picture's size, once known; another size fits anew. */
  setImage(image: Size): void {
    const now = this.viewport.value;
    if (this.known && now.image.width === image.width && now.image.height === image.height) return;
    this.known = true;
    this.viewport.value = Viewport.fit(image, now.screen);
  }

  fit(): void {
    const { image, screen } = this.viewport.value;
    this.viewport.value = Viewport.fit(image, screen);
  }

  /** Zoom at the pointer if it is over the picture, else at the middle. */
  zoom(factor: number): void {
    const view = this.viewport.value;
    const at = this.pointer.value
      ? view.toScreen(this.pointer.value)
      : screenPoint(view.screen.width / 2, view.screen.height / 2);
    this.viewport.value = view.zoomAt(at, factor);
  }

  /** Position of a mouse event inside the frame view. */
  fromClient(clientX: number, clientY: number): ScreenPoint {
    const box = this.element?.getBoundingClientRect();
    return screenPoint(clientX - (box?.left ?? 0), clientY - (box?.top ?? 0));
  }

  toClient(point: ImagePoint): { x: number; y: number } {
    const box = this.element?.getBoundingClientRect();
    const [x, y] = this.viewport.value.toScreen(point);
    return { x: x + (box?.left ?? 0), y: y + (box?.top ?? 0) };
  }

  centre(): ImagePoint {
    const { screen } = this.viewport.value;
    return this.viewport.value.toImage(screenPoint(screen.width / 2, screen.height / 2));
  }

  focus(): void {
    this.element?.focus({ preventScroll: true });
  }

  private measure(): void {
    if (!this.element) return;
    const screen = { width: this.element.clientWidth, height: this.element.clientHeight };
    if (screen.width > 0) this.viewport.value = this.viewport.value.resized(screen);
  }
}

/**
 * Read-only helper for browser tests: `imageToScreen(x, y)` answers the client coordinates `{x, y}`
 * at which to click to hit an image pixel; null while no frame view is shown.
 */
interface SightlineHelper {
  imageToScreen(x: number, y: number): { x: number; y: number } | null;
}

declare global {
  interface Window {
    __sightline?: SightlineHelper;
  }
}

const stages: Stage[] = [];

function expose(stage: Stage): () => void {
  stages.push(stage);
  window.__sightline = Object.freeze({
    imageToScreen: (x: number, y: number) => stages.at(-1)?.toClient(imagePoint(x, y)) ?? null,
  });
  return () => {
    stages.splice(stages.indexOf(stage), 1);
  };
}
