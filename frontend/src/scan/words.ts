/** Figures of a line scan in words and units; every number is the server's. */

import type { StateName } from "../components";
import type { ScanMotion, ScanVehicle } from "../types";
import { fixed, formatHeight, formatLength, lengthUnit } from "../units";

const NBSP = " ";
const KMH = 3.6;
const MPH = 2.2369362920544;
const FEET = 1 / 0.3048;

/** "63.3 ± 0.1 km/h", or mph for those who read feet; a missing value is an en dash. */
export function formatSpeed(mps: number | null, U95_mps: number | null = null, digits = 1): string {
  if (mps === null) return "–";
  const [by, unit] = lengthUnit.value === "ft" ? [MPH, "mph"] : [KMH, "km/h"];
  const value = fixed(mps * by, digits);
  if (U95_mps === null) return `${value}${NBSP}${unit}`;
  return `${value}${NBSP}±${NBSP}${(U95_mps * by).toFixed(digits)}${NBSP}${unit}`;
}

/** "−1.40 ± 0.10 m/s²" */
export function formatAcceleration(mps2: number | null, U95_mps2: number | null = null): string {
  if (mps2 === null) return "–";
  const [by, unit] = lengthUnit.value === "ft" ? [FEET, "ft/s²"] : [1, "m/s²"];
  const value = fixed(mps2 * by, 2);
  return U95_mps2 === null
    ? `${value}${NBSP}${unit}`
    : `${value}${NBSP}±${NBSP}${(U95_mps2 * by).toFixed(2)}${NBSP}${unit}`;
}

/** "1.284 s" */
export function formatSeconds(seconds: number | null, digits = 2): string {
  return seconds === null ? "–" : `${fixed(seconds, digits)}${NBSP}s`;
}

/** "4.660 ± 0.008 m"; of an uncertain length no more decimals than its uncertainty has to say. */
export function formatMeasured(metres: number | null, U95_m: number | null): string {
  const coarse = U95_m ?? 0;
  return formatHeight(metres, U95_m, coarse >= 1 ? 1 : coarse >= 0.1 ? 2 : 3);
}

/** A number of the table without its unit, which the column's head names. */
export function plainSpeed(mps: number | null): string {
  return mps === null ? "–" : fixed(mps * (lengthUnit.value === "ft" ? MPH : KMH), 1);
}

export function plainAcceleration(mps2: number | null): string {
  return mps2 === null ? "–" : fixed(mps2 * (lengthUnit.value === "ft" ? FEET : 1), 2);
}

export function plainLength(metres: number | null, digits = 2): string {
  return formatLength(metres, digits).split(NBSP)[0] ?? "–";
}

export function heads(): { speed: string; acceleration: string; length: string } {
  return lengthUnit.value === "ft"
    ? { speed: "mph", acceleration: "ft/s²", length: "ft" }
    : { speed: "km/h", acceleration: "m/s²", length: "m" };
}

export function stateOf(vehicle: ScanVehicle): StateName {
  const measured = vehicle.measurement;
  if (!measured) return "to_do";
  if (measured.status !== "ok") return "not_measurable";
  return measured.review.verdict;
}

/** How the current numbers came about. */
export function causeWords(one: ScanMotion): string {
  const method = one.method === "paper" ? "the paper's method" : "direct registration";
  return one.placed_by_person ? `${method}, boundaries placed by hand` : method;
}
