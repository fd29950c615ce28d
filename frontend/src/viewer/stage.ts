/** What a frame view shares with its loupe, overlay and screen: the viewport and the pointer. */
import { signal } from "@preact/signals";
import { type ImagePoint, type ScreenPoint, screenPoint } from "./points";
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
  /** The box of the transport in which a frame's number is typed, while it is shown. */
  frameBox: HTMLInputElement | null = null;
  private element: HTMLElement | null = null;
  private known = false;

  attach(element: HTMLElement): () => void {
    this.element = element;
    const watcher = new ResizeObserver(() => this.measure());
    watcher.observe(element);
    this.measure();
    return () => {
      watcher.disconnect();
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
