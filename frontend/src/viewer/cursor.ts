/** The keyboard's cursor on a picture: stays on it, is kept in sight, and previews what the pointer would. */
import { computed, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import type { DragPhase, Handle, Tool } from "./tool";
import type { View } from "./view";

interface Surface<P, V> {
  readonly view: Signal<V>;
  readonly pointer: ReadonlySignal<P | null>;
  readonly tools: ReadonlySignal<readonly Tool<P>[]>;
  place(at: P): boolean;
  hover(at: P | null): void;
  fromWindow(x: number, y: number): P;
  focus(): void;
}

/** A tool among the others, so that its place in the list says who has the arrows, Enter and Esc first. */
export class KeyboardCursor<P, V extends View<P, V>> implements Tool<P> {
  readonly at = signal<P | null>(null);
  /** A finger put it there: it can be dragged to its place, and a button confirms it. */
  readonly byFinger = signal(false);
  readonly handles = computed<readonly Handle<P>[]>(() =>
    this.at.value !== null && this.byFinger.value ? [{ id: "cursor", at: this.at.value }] : [],
  );

  constructor(private readonly stage: Surface<P, V>) {}

  /** Off, or on where the pointer is. False where no tool places anything. */
  toggle(): boolean {
    if (this.cancel()) return true;
    const { tools, pointer, view } = this.stage;
    if (!tools.value.some((tool) => tool.place)) return false;
    const { width, height } = view.value.screen;
    const start = tools.value.map((tool) => tool.cursorStart?.() ?? null).find((at) => at !== null);
    this.moveTo(pointer.value ?? start ?? this.stage.fromWindow(width / 2, height / 2));
    this.stage.focus();
    return true;
  }

  /** A tap: not a click yet, but a place to be adjusted and confirmed. */
  begin(at: P): void {
    this.byFinger.value = true;
    this.moveTo(at);
  }

  drag(_handle: string, at: P, phase: DragPhase): void {
    if (phase !== "cancel") this.moveTo(at);
  }

  off(): void {
    this.at.value = null;
    this.byFinger.value = false;
  }

  nudge(dx: number, dy: number): boolean {
    const at = this.at.value;
    if (at === null) return false;
    this.moveTo(this.stage.view.value.shifted(at, dx, dy));
    return true;
  }

  confirm(): boolean {
    const at = this.at.value;
    const byFinger = this.byFinger.value;
    if (at === null) return false;
    // the next tap chooses the next place; by keyboard the cursor stays where it is
    if (byFinger) this.off();
    return this.stage.place(at);
  }

  cancel(): boolean {
    if (this.at.value === null) return false;
    this.off();
    this.stage.hover(null);
    return true;
  }

  private moveTo(to: P): void {
    const { view } = this.stage;
    const at = view.value.nearest(to);
    this.at.value = at;
    view.value = view.value.reveal(at);
    this.stage.hover(at);
  }
}
