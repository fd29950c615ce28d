/** What a person does on a picture: one gesture, whole. A stage asks its tools from the top; the first that answers true has it. */
import type { ReadonlySignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { ScreenPoint } from "./points";

export interface Handle<P> {
  readonly id: string;
  readonly at: P;
  /** Screen pixels from the pointer, where it is not the distance to `at`: of an upright line, only sideways. */
  distance?(pointer: ScreenPoint): number;
}

export type DragPhase = "move" | "end" | "cancel";

export interface Tool<P> {
  /** What the next click does; null while this tool has nothing to say. */
  readonly hint?: ReadonlySignal<string | null>;
  /** True while a click places something: the cross-hair, and picking only by dragging. */
  readonly placing?: ReadonlySignal<boolean>;
  readonly handles?: ReadonlySignal<readonly Handle<P>[]>;
  layers?(): ComponentChildren;
  /** A click, or Enter at the keyboard's cursor. */
  place?(at: P): boolean;
  /** The pointer or the keyboard's cursor moves; null: it has left the picture. */
  hover?(at: P | null): boolean;
  /** By keyboard, in picture pixels. */
  nudge?(dx: number, dy: number): boolean;
  /** Enter, before it places at the keyboard's cursor. */
  confirm?(): boolean;
  /** A click on a handle while nothing is placed. */
  pick?(handle: string): void;
  /** "cancel" puts the point back where it was: as if nothing had been dragged. */
  drag?(handle: string, at: P, phase: DragPhase): void;
  /** Ctrl+Z before anything is stored. */
  back?(): boolean;
  /** Esc: one thing at a time. */
  cancel?(): boolean;
  /** Where the keyboard's cursor begins when the pointer is not over the picture. */
  cursorStart?(): P | null;
}
