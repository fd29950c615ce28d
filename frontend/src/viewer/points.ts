/**
 * Two kinds of points that must never be mixed.
 * Image: pixels of the recording, (0, 0) is the CENTRE of the top-left pixel (OpenCV's rule).
 * Screen: CSS pixels from the top-left corner of the frame view.
 */
declare const kind: unique symbol;

export type ImagePoint = readonly [number, number] & { readonly [kind]: "image" };
export type ScreenPoint = readonly [number, number] & { readonly [kind]: "screen" };

export function imagePoint(x: number, y: number): ImagePoint {
  return [x, y] as unknown as ImagePoint;
}

export function screenPoint(x: number, y: number): ScreenPoint {
  return [x, y] as unknown as ScreenPoint;
}

/** A pair from the server (always image pixels) as a branded point. */
export function fromServer(pair: readonly number[]): ImagePoint {
  return imagePoint(pair[0] ?? 0, pair[1] ?? 0);
}

/** An image point as the plain pair that the server and polylines speak. */
export function pair(point: ImagePoint): [number, number] {
  return [point[0], point[1]];
}

export function samePoint(a: readonly number[] | null, b: readonly number[] | null): boolean {
  return a !== null && b !== null && a[0] === b[0] && a[1] === b[1];
}

/** Pixel distance on the screen, for picking points; never a measured quantity. */
export function screenDistance(a: ScreenPoint, b: ScreenPoint): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
