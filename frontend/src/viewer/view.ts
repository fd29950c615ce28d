/** How a picture lies in its window: frames and strips alike. Immutable; every change returns a new view. */
import type { ScreenPoint } from "./points";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** `P` is a point of the picture, `Self` the view itself. */
export interface View<P, Self> {
  readonly screen: Size;
  toScreen(at: P): ScreenPoint;
  toPicture(at: ScreenPoint): P;
  contains(at: P): boolean;
  /** The nearest place on a pixel of the picture. */
  nearest(at: P): P;
  /** So many picture pixels to the right and down. */
  shifted(at: P, dx: number, dy: number): P;
  /** By screen pixels. */
  pan(dx: number, dy: number): Self;
  /** The point under `at` stays under it. `across`: the other scale, where a view has two. */
  zoom(at: ScreenPoint, factor: number, across?: boolean): Self;
  /** Moves just enough that a point is seen. */
  reveal(at: P): Self;
  fit(): Self;
  resized(screen: Size): Self;
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}
