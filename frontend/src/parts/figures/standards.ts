/** The words of standards: what each is a height of. */
import { wordsOf } from "../../core/messages";
import { formatLength } from "../../core/units";
import type { Standard } from "./types";

/** What a standard speaks of. */
export const STANDARD_OF = wordsOf("statistics-standard-of-");

/** The height of a standard: "1.08 m", with a third decimal only where its metres have one. */
export function formatLimit(height_m: number): string {
  return formatLength(height_m, height_m.toFixed(3).endsWith("0") ? 2 : 3);
}

/** A standard's own address in the link: what and name. */
export function standardKey(one: Standard): string {
  return `${one.what}:${one.name}:${one.height_m}`;
}
