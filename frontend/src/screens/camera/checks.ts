/** The checks of a calibration in words. Pure; the numbers are the server's. */
import { allOf, say, sentenceOf } from "../../core/messages";
import type { Calibration } from "../../core/types";
import { fixed, formatAway, formatSmall, smallScale } from "../../core/units";

export type Halves = NonNullable<Calibration["cross_validation"]>;
export type Shape = NonNullable<Calibration["board_shape"]>;

/** A difference as people read it: no sign, and no "0.0 mm" or "0.00 in" for what is merely small. */
export function apart(metres: number | null): string {
  if (metres === null) return "–";
  const size = Math.abs(metres);
  const [factor, unit] = smallScale();
  const least = (unit === "in" ? 0.01 : 0.1) / factor;
  return size < least / 2 ? say("camera-under", { length: formatSmall(least) }) : formatSmall(size);
}

export function px(value: number | null): string {
  return value === null ? "–" : say("value-px", { value: fixed(value, 3) });
}

/** "Two halves of the pictures, calibrated separately, differ by ... in a height", or why that is not known. */
export function halvesInWords(halves: Halves): string {
  if (halves.reason !== null) return say("camera-halves-not-done", { reason: sentenceOf(halves.reason) });
  const told = halves.height_differences.flatMap((d) =>
    d.difference_m === null ? [] : [differenceAt(d.difference_m, d.distance_m)],
  );
  if (told.length === 0) return say("camera-halves-nothing");
  return say("camera-halves-differ", { differences: allOf(told) });
}

function differenceAt(difference_m: number, distance_m: number): string {
  return say("camera-difference-at", { difference: apart(difference_m), distance: formatAway(distance_m) });
}

/** The residual of pictures that did not help to find the lens, beside that of those that did. */
export function heldOutInWords(halves: Halves): string {
  return say("camera-held-out", { held_out: px(halves.held_out_rms_px), fit: px(halves.fit_rms_px) });
}

/** How far the board is from flat, and whether that is allowed for. */
export function boardInWords(shape: Shape): string {
  const values = { bow: apart(shape.bow_m), flat: px(shape.flat_rms_px), bent: px(shape.bent_rms_px) };
  return shape.solved ? say("camera-board-solved", values) : say("camera-board-taken-flat", values);
}
