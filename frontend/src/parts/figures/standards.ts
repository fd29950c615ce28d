/** The words of standards: what each is a height of. */
import { wordsOf } from "../../core/messages";
import type { Standard } from "../../core/types";
import { formatLength } from "../../core/units";

export const STANDARD_OF = wordsOf("statistics-standard-of-");

type Words = Pick<Standard, "name" | "code"> &
  Partial<Pick<Standard, "vehicle_class" | "source" | "cited_by">>;

const PROGRAMS: Readonly<Record<"name" | "vehicle_class" | "source" | "cited_by", Record<string, string>>> = {
  name: wordsOf("standard-name-"),
  vehicle_class: wordsOf("standard-class-"),
  source: wordsOf("standard-source-"),
  cited_by: wordsOf("standard-cited-"),
};

/** A standard with the words that the program brought in the reader's language; what a person wrote stays. */
export function inWords<S extends Words>(one: S): S {
  const { code } = one;
  if (code === null) return one;
  const said = Object.entries(PROGRAMS).flatMap(([field, words]) => {
    const word = field in one && words[code];
    return word ? [[field, word]] : [];
  });
  return { ...one, ...Object.fromEntries(said) };
}

/** The decimals of a standard's height: two, a third only where its metres have one. */
export function limitDigits(height_m: number): number {
  return height_m.toFixed(3).endsWith("0") ? 2 : 3;
}

export function formatLimit(height_m: number): string {
  return formatLength(height_m, limitDigits(height_m));
}

export function standardKey(one: Standard): string {
  return `${one.what}:${one.name}:${one.height_m}`;
}
