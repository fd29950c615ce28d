/** One picture and what is done on it: how it lies in its window, the pointer, the keyboard's cursor and the tools. */
import { computed, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { KeyboardCursor } from "./cursor";
import { type ImagePoint, imagePoint, type ScreenPoint, screenDistance, screenPoint } from "./points";
import type { Handle, Tool } from "./tool";
import type { Size, View } from "./view";
import { Viewport } from "./viewport";

export interface Grabbed<P> {
  readonly tool: Tool<P>;
  readonly handle: Handle<P>;
}

export class PictureStage<P, V extends View<P, V>> {
  readonly view: Signal<V>;
  /** Where the pointer (or the keyboard's cursor) stands in the picture; null outside. */
  readonly pointer = signal<P | null>(null);
  readonly keyboard: KeyboardCursor<P, V> = new KeyboardCursor<P, V>(this);
  readonly cursor: ReadonlySignal<P | null> = this.keyboard.at;
  /** The loupe is switched on, or held (Z). */
  readonly loupe = signal(false);
  readonly dragging = signal(false);
  /** From the top: who is asked first. */
  readonly tools: ReadonlySignal<readonly Tool<P>[]>;
  readonly hint = computed(() => this.first((tool) => tool.hint?.value ?? null));
  readonly placing = computed(() => this.tools.value.some((tool) => tool.placing?.value === true));
  /** Shift was held at the last press: what is placed stays exactly there. */
  exact = false;
  /** Set when Space was held to pan, so that letting it go does not play. */
  panned = false;
  /** Ends the drag under way without its doing anything; set by who follows the pointer. */
  letGo: (() => void) | null = null;
  private element: HTMLElement | null = null;
  private pressed = false;

  /** `tools` is asked again whenever a signal in it changes; `stage.keyboard` belongs into it where points are placed. */
  constructor(view: V, tools: () => readonly Tool<P>[] = () => []) {
    this.view = signal(view);
    this.tools = computed(tools);
  }

  place(at: P): boolean {
    return this.tools.value.some((tool) => tool.place?.(at));
  }

  hover(at: P | null): void {
    this.pointer.value = at;
    this.tools.value.some((tool) => tool.hover?.(at));
  }

  nudge(dx: number, dy: number): boolean {
    return this.tools.value.some((tool) => tool.nudge?.(dx, dy));
  }

  confirm(): boolean {
    return this.tools.value.some((tool) => tool.confirm?.());
  }

  back(): boolean {
    return this.tools.value.some((tool) => tool.back?.());
  }

  cancel(): boolean {
    if (this.dragging.value && this.letGo) {
      this.letGo();
      return true;
    }
    return this.tools.value.some((tool) => tool.cancel?.());
  }

  /** The handle nearest to a place of the window, within so many screen pixels. */
  grab(at: ScreenPoint, reach: number): Grabbed<P> | null {
    let best: Grabbed<P> | null = null;
    let nearest = reach;
    for (const tool of this.tools.value)
      for (const handle of tool.handles?.value ?? []) {
        const distance = handle.distance?.(at) ?? screenDistance(this.view.value.toScreen(handle.at), at);
        if (distance > nearest) continue;
        best = { tool, handle };
        nearest = distance;
      }
    return best;
  }

  /** Zoom at the pointer if it is over the picture, else at the middle. */
  zoom(factor: number, across = false): void {
    const view = this.view.value;
    const at = this.pointer.value
      ? view.toScreen(this.pointer.value)
      : screenPoint(view.screen.width / 2, view.screen.height / 2);
    this.view.value = view.zoom(at, factor, across);
  }

  fit(): void {
    this.view.value = this.view.value.fit();
  }

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

  /** While a button is down the picture keeps its place: what changes the layout meanwhile counts when it is up. */
  hold(pressed: boolean): void {
    this.pressed = pressed;
    if (!pressed) this.measure();
  }

  fromClient(clientX: number, clientY: number): ScreenPoint {
    const box = this.element?.getBoundingClientRect();
    return screenPoint(clientX - (box?.left ?? 0), clientY - (box?.top ?? 0));
  }

  fromWindow(x: number, y: number): P {
    return this.view.value.toPicture(screenPoint(x, y));
  }

  focus(): void {
    this.element?.focus({ preventScroll: true });
  }

  protected resize(screen: Size): void {
    this.view.value = this.view.value.resized(screen);
  }

  private first<T>(ask: (tool: Tool<P>) => T | null): T | null {
    for (const tool of this.tools.value) {
      const answer = ask(tool);
      if (answer !== null) return answer;
    }
    return null;
  }

  private measure(): void {
    if (!this.element || this.pressed) return;
    const screen = { width: this.element.clientWidth, height: this.element.clientHeight };
    const now = this.view.value.screen;
    const same = now.width === screen.width && now.height === screen.height;
    if (screen.width > 0 && !same) this.resize(screen);
  }
}

/** More than so many times the whole picture shows no surroundings any more. */
const MOST_AIM = 4;

const NOTHING: Size = { width: 1, height: 1 };

export class FrameStage extends PictureStage<ImagePoint, Viewport> {
  /** The box of the transport in which a frame's number is typed, while it is shown. */
  frameBox: HTMLInputElement | null = null;
  private known = false;
  private aimed: readonly [ImagePoint, ImagePoint] | null = null;

  constructor(tools?: () => readonly Tool<ImagePoint>[]) {
    super(Viewport.fit({ width: 640, height: 480 }, NOTHING), tools);
  }

  /** The picture's size, once known; another size fits anew. */
  setImage(image: Size): void {
    const now = this.view.value;
    if (this.known && now.image.width === image.width && now.image.height === image.height) return;
    this.known = true;
    this.view.value = Viewport.fit(image, now.screen);
    if (this.aimed) this.aim(...this.aimed);
  }

  /** Shows the surroundings of two points, so that they lie a third of the window apart; at once, or as soon as there is a picture. */
  aim(one: ImagePoint, other: ImagePoint): void {
    this.aimed = [one, other];
    const fitted = this.view.value.fit();
    const { width, height } = fitted.screen;
    const apart = screenDistance(fitted.toScreen(one), fitted.toScreen(other));
    const factor = Math.min(MOST_AIM, height / 3 / Math.max(apart, 1));
    const middle = imagePoint((one[0] + other[0]) / 2, (one[1] + other[1]) / 2);
    const zoomed = factor > 1 ? fitted.zoom(fitted.toScreen(middle), factor) : fitted;
    const [x, y] = zoomed.toScreen(middle);
    this.view.value = factor > 1 ? zoomed.pan(width / 2 - x, height / 2 - y) : fitted;
  }

  whole(): void {
    this.aimed = null;
    this.fit();
  }
}
