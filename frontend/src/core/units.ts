/** Lengths as people read them. The server speaks metres; feet are only shown. */
import { stored } from "./stored";

export type LengthUnit = "m" | "ft";
export const METRES_PER_FOOT = 0.3048;

/** Metres by default, feet on request, everywhere. */
export const lengthUnit = stored<LengthUnit>("unit", "m", (v) => v === "m" || v === "ft");

const NBSP = " ";
const THIN = " ";

function convert(metres: number, unit: LengthUnit): number {
  return unit === "ft" ? metres / METRES_PER_FOOT : metres;
}

/** A number with a true minus sign and fixed decimals. */
export function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  if (!text.startsWith("-")) return text;
  return Number(text) === 0 ? text.slice(1) : `−${text.slice(1)}`;
}

/** "1.172 m"; a missing value is an en dash. */
export function formatLength(metres: number | null, digits = 3, unit = lengthUnit.value): string {
  if (metres === null) return "–";
  return `${fixed(convert(metres, unit), digits)}${NBSP}${unit}`;
}

/** "1.172 ± 0.018 m", where the second number is the half-width of the 95 % interval. */
export function formatHeight(
  metres: number | null,
  U95_m: number | null,
  digits = 3,
  unit = lengthUnit.value,
): string {
  if (metres === null) return "–";
  if (U95_m === null) return formatLength(metres, digits, unit);
  const value = fixed(convert(metres, unit), digits);
  return `${value}${NBSP}±${NBSP}${convert(U95_m, unit).toFixed(digits)}${NBSP}${unit}`;
}

/** A small length: "18 mm", or "0.71 in" for those who read feet. */
export function formatSmall(metres: number | null, unit = lengthUnit.value): string {
  if (metres === null) return "–";
  if (unit === "ft") return `${fixed((metres / METRES_PER_FOOT) * 12, 2)}${NBSP}in`;
  const mm = metres * 1000;
  return `${fixed(mm, Math.abs(mm) < 10 ? 1 : 0)}${NBSP}mm`;
}

/** A sentence of the server, which speaks millimetres, with its small lengths in the shown unit. */
export function inUnits(words: string, unit = lengthUnit.value): string {
  if (unit === "m") return words;
  return words.replace(/(\d+(?:\.\d+)?) mm\b/g, (_, mm: string) => formatSmall(Number(mm) / 1000, unit));
}

/** What a person typed as a length in the shown unit, in metres; null when it is no number. Takes a comma for the point. */
export function parseLength(text: string, unit = lengthUnit.value): number | null {
  const value = parseNumber(text);
  return value === null ? null : unit === "ft" ? value * METRES_PER_FOOT : value;
}

/** A typed number, comma or point, blanks allowed; null when it is none. */
export function parseNumber(text: string): number | null {
  const cleaned = text
    .trim()
    .replace(/[\s  ]/g, "")
    .replace("−", "-")
    .replace(",", ".");
  if (!/^-?(\d+\.?\d*|\.\d+)(e-?\d+)?$/i.test(cleaned)) return null;
  return Number(cleaned);
}

/** A count with thin spaces between thousands. */
export function formatCount(value: number): string {
  return String(Math.round(value)).replace(/\B(?=(\d{3})+(?!\d))/g, THIN);
}

/** "3 images", "1 image". */
export function plural(count: number, one: string, many = `${one}s`): string {
  return `${formatCount(count)}${NBSP}${count === 1 ? one : many}`;
}

/** "14.2 MB" (decimal). */
export function formatBytes(bytes: number): string {
  const names = ["B", "kB", "MB", "GB", "TB"];
  let value = bytes;
  let step = 0;
  while (value >= 999.5 && step < names.length - 1) {
    value /= 1000;
    step++;
  }
  return `${value.toFixed(step === 0 || value >= 99.5 ? 0 : 1)}${NBSP}${names[step]}`;
}

/* -- lengths in input fields, as a person would type them -- */

export function lengthText(metres: number | null | undefined, unit = lengthUnit.value, decimals = 4): string {
  if (metres === null || metres === undefined) return "";
  return String(Number((unit === "ft" ? metres / METRES_PER_FOOT : metres).toFixed(decimals)));
}

/** What is wrong with a typed length, or null. Empty is allowed where a value may be unknown. */
export function lengthProblem(text: string, options: { empty: boolean }): string | null {
  if (text.trim() === "") return options.empty ? null : "A length, such as 0.60.";
  const value = parseLength(text);
  return value === null || value > 10 || value < -10 ? "A length, such as 1.624." : null;
}

/* -- speeds and accelerations -- */

const KMH = 3.6;
const MPH = 2.2369362920544;

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
  const [by, unit] = lengthUnit.value === "ft" ? [1 / METRES_PER_FOOT, "ft/s²"] : [1, "m/s²"];
  const value = fixed(mps2 * by, 2);
  return U95_mps2 === null
    ? `${value}${NBSP}${unit}`
    : `${value}${NBSP}±${NBSP}${(U95_mps2 * by).toFixed(2)}${NBSP}${unit}`;
}

/** A number of the table without its unit, which the column's head names. */
export function plainSpeed(mps: number | null): string {
  return mps === null ? "–" : fixed(mps * (lengthUnit.value === "ft" ? MPH : KMH), 1);
}

export function plainAcceleration(mps2: number | null): string {
  return mps2 === null ? "–" : fixed(mps2 * (lengthUnit.value === "ft" ? 1 / METRES_PER_FOOT : 1), 2);
}

export function plainLength(metres: number | null, digits = 2): string {
  return formatLength(metres, digits).split(NBSP)[0] ?? "–";
}

export function heads(): { speed: string; acceleration: string; length: string } {
  return lengthUnit.value === "ft"
    ? { speed: "mph", acceleration: "ft/s²", length: "ft" }
    : { speed: "km/h", acceleration: "m/s²", length: "m" };
}
