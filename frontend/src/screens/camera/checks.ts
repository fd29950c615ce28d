/** The checks of a calibration in words. Pure; the numbers are the server's. */
import type { Calibration } from "../../core/types";
import { formatSmall, lengthScale, lengthText, smallScale } from "../../core/units";
import { listed } from "./lens";

export type Halves = NonNullable<Calibration["cross_validation"]>;
export type Shape = NonNullable<Calibration["board_shape"]>;

/** A difference as people read it: no sign, and no "0.0 mm" or "0.00 in" for what is merely small. */
export function apart(metres: number | null): string {
  if (metres === null) return "–";
  const size = Math.abs(metres);
  const [factor, unit] = smallScale();
  const least = (unit === "in" ? 0.01 : 0.1) / factor;
  return size < least / 2 ? `under ${formatSmall(least)}` : formatSmall(size);
}

/** How far away a vehicle is, as short as can be: "2 m", "6.6 ft". */
export function away(metres: number): string {
  const [, unit] = lengthScale();
  return `${lengthText(metres, unit, 1)} ${unit}`;
}

const px = (value: number | null): string => (value === null ? "–" : `${value.toFixed(3)} px`);

/** "Two halves of the pictures, calibrated apart, differ by ... in a height", or why that is not known. */
export function halvesInWords(halves: Halves): string {
  if (halves.reason !== null) return `Not done. ${halves.reason}`;
  const told = halves.height_differences.flatMap((d) =>
    d.difference_m === null ? [] : [`${apart(d.difference_m)} at ${away(d.distance_m)}`],
  );
  if (told.length === 0) return "The picture shows too little of such a scene to compare a height.";
  return `Two halves of the pictures, calibrated apart, differ by ${listed(told)} in a height.`;
}

/** The residual of pictures that did not help to find the lens, beside that of those that did. */
export function heldOutInWords(halves: Halves): string {
  return `Residual of pictures that did not help to find the lens: ${px(halves.held_out_rms_px)}; of those that did: ${px(halves.fit_rms_px)}.`;
}

/** How far the board is from flat, and whether that is allowed for. */
export function boardInWords(shape: Shape): string {
  const bow = apart(shape.bow_m);
  const before = `taken as flat the residual is ${px(shape.flat_rms_px)}, with its shape solved for ${px(shape.bent_rms_px)}`;
  return shape.solved
    ? `Solved for: the board bends by ${bow}; ${before}.`
    : `Taken as flat. From the pictures it bends by ${bow}; ${before}.`;
}
