/** With how many digits the page prints the numbers of a package's tables: as its report does. */
import { type Row, unsafe } from "./csv";
import { decimal, language } from "./language";

const HEIGHT_DIGITS = 3;
const SMALL_DIGITS = 4;
const SQUARE_DIGITS = 6;
/** Of degrees of latitude and longitude: a metre on the ground. */
const PLACE_DIGITS = 5;
/** Tables whose values are errors, and named so by `figure`. */
const OF_ERRORS = /(?:^|\/)(?:error_table|agreement)\.csv$/;

/** A cell as it is read: fewer digits than the file holds, so that a figure reads alike everywhere. */
export function shown(path: string, name: string, row: Row): string {
  const text = row[name] ?? "";
  if (!/^-?\d+\.\d+(?:e-?\d+)?$/.test(text)) return unsafe(text);
  if (name === "percent") return decimal(String(Number(text)));
  return fixed(Number(text), digits(path, name, row));
}

export function shownHeight(metres: string | number): string {
  return fixed(Number(metres), HEIGHT_DIGITS);
}

const formats = new Map<string, Intl.NumberFormat>();

/** Fixed decimals, halves of a number's fewest digits away from zero; `toFixed` rounds what it is in binary. */
export function fixed(value: number, decimals: number): string {
  const key = `${language.value} ${decimals}`;
  const sizes = { minimumFractionDigits: decimals, maximumFractionDigits: decimals };
  const format =
    formats.get(key) ??
    new Intl.NumberFormat(language.value, { ...sizes, useGrouping: false, signDisplay: "negative" });
  formats.set(key, format);
  return format.format(value);
}

function digits(path: string, name: string, row: Row): number {
  if (OF_ERRORS.test(path)) return row["figure"]?.endsWith("_m2") ? SQUARE_DIGITS : SMALL_DIGITS;
  if (name === "latitude_deg" || name === "longitude_deg") return PLACE_DIGITS;
  return name.startsWith("u_") || name === "difference_m" ? SMALL_DIGITS : HEIGHT_DIGITS;
}
