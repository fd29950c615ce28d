/** Lengths in input fields: as a person would type them, in the shown unit. */
import { lengthUnit, METRES_PER_FOOT, parseLength } from "../units";

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
