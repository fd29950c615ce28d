/** Lengths and speeds as people read and type them. The server speaks metres and seconds; feet and miles are only shown. */
import { APART, region, say, writeNumber, writeSmallLengths } from "./messages";
import { stored } from "./stored";

export type LengthUnit = "m" | "ft";
const METRES_PER_FOOT = 0.3048;
const METRES_PER_MILE = 5280 * METRES_PER_FOOT;
const SECONDS_PER_HOUR = 3600;

/** Metres by default, feet on request, everywhere. */
export const lengthUnit = stored<LengthUnit>("unit", "m", (v) => v === "m" || v === "ft");

const NBSP = "\u00a0";

/** What a number of the server is multiplied by to be shown, and the name of the unit it then has. */
export type Scale<Unit extends string = string> = readonly [factor: number, unit: Unit];

export function lengthScale(unit: LengthUnit = lengthUnit.value): Scale<LengthUnit> {
  return unit === "ft" ? [1 / METRES_PER_FOOT, "ft"] : [1, "m"];
}

/** For uncertainties, differences, and the squares of a board. */
export function smallScale(unit: LengthUnit = lengthUnit.value): Scale {
  return unit === "ft" ? [12 / METRES_PER_FOOT, "in"] : [1000, "mm"];
}

export function speedScale(unit: LengthUnit = lengthUnit.value): Scale {
  return unit === "ft" ? [SECONDS_PER_HOUR / METRES_PER_MILE, "mph"] : [SECONDS_PER_HOUR / 1000, "km/h"];
}

function accelerationScale(unit: LengthUnit = lengthUnit.value): Scale {
  return unit === "ft" ? [1 / METRES_PER_FOOT, "ft/s²"] : [1, "m/s²"];
}

function convert(metres: number, unit: LengthUnit): number {
  return metres * lengthScale(unit)[0];
}

const formats = new Map<string, Intl.NumberFormat>();

/** How the chosen language writes numbers of so many decimals. */
function numbers(
  digits: number,
  grouping: Intl.NumberFormatOptions = { useGrouping: false },
): Intl.NumberFormat {
  const key = `${region.value} ${digits} ${grouping.useGrouping}`;
  const options = { minimumFractionDigits: digits, maximumFractionDigits: digits, ...grouping };
  const found = formats.get(key) ?? new Intl.NumberFormat(region.value, options);
  formats.set(key, found);
  return found;
}

/** A number with a true minus sign and fixed decimals, as the chosen language writes it. */
export function fixed(value: number, digits: number): string {
  const size = numbers(digits).format(Math.abs(value));
  return value < 0 && Number(value.toFixed(digits)) !== 0 ? `−${size}` : size;
}

/** With how many digits a height is printed, wherever it stands; of reports `export/report/units.py` says it. */
const HEIGHT_DIGITS = 3;

/** "1.172 m"; a missing value is an en dash. */
export function formatLength(metres: number | null, digits = HEIGHT_DIGITS, unit = lengthUnit.value): string {
  if (metres === null) return "–";
  return `${fixed(convert(metres, unit), digits)}${NBSP}${unit}`;
}

/** A distance that was chosen, as short as it is right: "2 m", "6.6 ft". */
export function formatAway(metres: number): string {
  const tenths = Math.round(convert(metres, lengthUnit.value) * 10);
  return `${fixed(tenths / 10, tenths % 10 === 0 ? 0 : 1)}${NBSP}${lengthUnit.value}`;
}

/** The height at which a line is drawn, with the digits that it has: "0.5 m", "0.02 m", "1.64 ft". */
export function formatRung(metres: number): string {
  const digits = lengthUnit.value === "m" && Math.abs(metres * 10 - Math.round(metres * 10)) < 1e-6 ? 1 : 2;
  return formatLength(metres, digits);
}

/** "1.172 ± 0.018 m", where the second number is the half-width of the 95 % interval. */
export function formatHeight(
  metres: number | null,
  U95_m: number | null,
  digits = HEIGHT_DIGITS,
  unit = lengthUnit.value,
): string {
  return withInterval(metres, U95_m, lengthScale(unit), digits);
}

/** A small length: "18 mm", or "0.71 in" for those who read feet. */
export function formatSmall(metres: number | null, unit = lengthUnit.value, ofMillimetres?: number): string {
  return metres === null ? "–" : `${smallNumber(metres, unit, ofMillimetres)}${NBSP}${smallScale(unit)[1]}`;
}

/** Its number alone, for a sentence that names the unit later: "18". */
export function smallNumber(metres: number | null, unit = lengthUnit.value, ofMillimetres?: number): string {
  if (metres === null) return "–";
  const value = metres * smallScale(unit)[0];
  return fixed(value, unit === "ft" ? 2 : (ofMillimetres ?? (Math.abs(value) < 10 ? 1 : 0)));
}
writeSmallLengths(
  (metres, digits) => formatSmall(metres, lengthUnit.value, digits),
  () => lengthUnit.value === "m",
);

/** A small uncertainty to two digits that count, as the chosen language writes it: "0.0021". */
export function significant(value: number): string {
  return new Intl.NumberFormat(region.value, { maximumSignificantDigits: 2 }).format(value);
}

/** "10", "2.5", "2,5": a percentage of a rule with the digits that it has, as the chosen language writes it. */
export function plainPercent(value: number | null): string {
  if (value === null) return "";
  return new Intl.NumberFormat(region.value, { maximumFractionDigits: 3 }).format(value);
}

/** The numbers of a text that was written with points, each with its digits, as the chosen language writes them. */
export function numbersIn(text: string): string {
  return text.replace(/\d[\d,]*(?:\.\d+)?/g, (number) => {
    const digits = number.split(".")[1]?.length ?? 0;
    const grouping = number.includes(",") ? APART : undefined;
    return writeNumber(numbers(digits, grouping), Number(number.replaceAll(",", "")));
  });
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

/** A number of a field as the chosen language writes it; `parseNumber` reads it in any. What is none stays as it is. */
export function localNumber(text: string): string {
  return /^[-−]?\d*\.\d*$/.test(text) ? text.replace(".", fixed(0.5, 1).charAt(1)) : text;
}

/** A count, as sentences have it too. */
export function formatCount(value: number): string {
  return writeNumber(numbers(0, APART), Math.round(value));
}

/** "14.2 MB" (decimal). */
export function formatBytes(bytes: number): string {
  const prefixes = ["", "k", "M", "G", "T"];
  let value = bytes;
  let step = 0;
  while (value >= 999.5 && step < prefixes.length - 1) {
    value /= 1000;
    step++;
  }
  return `${fixed(value, step === 0 || value >= 99.5 ? 0 : 1)}${NBSP}${prefixes[step]}${say("unit-byte")}`;
}

export function lengthText(metres: number | null | undefined, unit = lengthUnit.value, decimals = 4): string {
  return metres === null || metres === undefined ? "" : typedNumber(convert(metres, unit), decimals);
}

export function smallText(metres: number | null | undefined, unit = lengthUnit.value, decimals = 3): string {
  return metres === null || metres === undefined ? "" : typedNumber(metres * smallScale(unit)[0], decimals);
}

/** What a person typed as a small length in the shown unit, in metres; null when it is no number. */
export function parseSmall(text: string, unit = lengthUnit.value): number | null {
  const value = parseNumber(text);
  return value === null ? null : unit === "ft" ? (value * METRES_PER_FOOT) / 12 : value / 1000;
}

/** What was typed; a value that was left as it was shown is not rounded by having been shown. */
export function kept(
  text: string,
  shown: string,
  before: number | null | undefined,
  parse: (text: string) => number | null,
): number | null {
  return before != null && text === shown ? before : parse(text);
}

export function keptLength(text: string, before: number | null | undefined): number | null {
  return kept(text, lengthText(before), before, parseLength);
}

export function keptSmall(text: string, before: number | null | undefined): number | null {
  return kept(text, smallText(before), before, parseSmall);
}

function typedNumber(value: number, decimals: number): string {
  return String(Number(value.toFixed(decimals)));
}

/** What is wrong with a typed length, or null. Empty is allowed where a value may be unknown. */
export function lengthProblem(text: string, options: { empty: boolean }): string | null {
  if (text.trim() === "")
    return options.empty ? null : say("length-problem", { example: localNumber("0.60") });
  const value = parseLength(text);
  return value === null || value > 10 || value < -10
    ? say("length-problem", { example: localNumber("1.624") })
    : null;
}

/** "63.3 ± 0.1 km/h", or mph for those who read feet; a missing value is an en dash. */
export function formatSpeed(mps: number | null, U95_mps: number | null = null, digits = 1): string {
  return withInterval(mps, U95_mps, speedScale(), digits);
}

/** "−1.40 ± 0.10 m/s²" */
export function formatAcceleration(mps2: number | null, U95_mps2: number | null = null, digits = 2): string {
  return withInterval(mps2, U95_mps2, accelerationScale(), digits);
}

/** "1.650 ± 0.004 s" */
export function formatSeconds(seconds: number | null, U95_s: number | null = null, digits = 2): string {
  return withInterval(seconds, U95_s, [1, "s"], digits);
}

function withInterval(
  value: number | null,
  U95: number | null,
  [factor, unit]: Scale,
  digits: number,
): string {
  if (value === null) return "–";
  const least = U95 ? 10 ** -digits : 0; // what is not known exactly never reads ± 0
  const half = U95 === null ? "" : `${NBSP}±${NBSP}${fixed(Math.max(U95 * factor, least), digits)}`;
  return `${fixed(value * factor, digits)}${half}${NBSP}${unit}`;
}

export function plainSpeed(mps: number | null): string {
  return plain(mps, speedScale(), 1);
}

export function plainAcceleration(mps2: number | null): string {
  return plain(mps2, accelerationScale(), 2);
}

export function plainHeight(metres: number | null): string {
  return plain(metres, lengthScale(), HEIGHT_DIGITS);
}

/** An error or a difference of a table, with its sign where it is asked for: "+5.6". */
export function plainSmall(metres: number | null, options: { signed: boolean } = { signed: false }): string {
  const scale = smallScale();
  const digits = scale[1] === "in" ? 2 : 1;
  const isMore = options.signed && metres !== null && Number((metres * scale[0]).toFixed(digits)) > 0;
  return `${isMore ? "+" : ""}${plain(metres, scale, digits)}`;
}

export function plainLength(metres: number | null, digits = 2): string {
  return plain(metres, lengthScale(), digits);
}

function plain(value: number | null, [factor]: Scale, digits: number): string {
  return value === null ? "–" : fixed(value * factor, digits);
}

export function heads(): { speed: string; acceleration: string; length: string } {
  return { speed: speedScale()[1], acceleration: accelerationScale()[1], length: lengthScale()[1] };
}
