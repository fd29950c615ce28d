import type { components } from "#schema";
import { wordsOf } from "../../core/messages";
import type { CatalogueRow } from "../../core/types";

type Schemas = components["schemas"];
export type Plan = Schemas["ImportPlan"];
export type ModelIn = Schemas["ModelIn"];
export type Unit = "m" | "cm" | "mm" | "ft" | "in";

export const SIZES = ["height", "length", "width", "wheelbase", "taillight", "headlight"] as const;
export type Size = (typeof SIZES)[number];

export const SIZE_WORDS = wordsOf(
  "catalogue-",
  "height",
  "length",
  "width",
  "wheelbase",
  "taillight",
  "headlight",
);

export const CHANGE_WORDS = wordsOf("catalogue-change-");

export const UNIT_WORDS = wordsOf("catalogue-unit-", "m", "cm", "mm", "ft", "in");

/** Every field that a column of a file can be taken for. */
export const FIELDS: readonly string[] = [
  "make",
  "model",
  "year_from",
  "year_to",
  "category",
  ...SIZES.map((size) => `${size}_m`),
  ...SIZES.map((size) => `u_${size}_m`),
  ...SIZES.map((size) => `${size}_source`),
  "source",
];

export function bodyOf(row: CatalogueRow): ModelIn {
  const { id: _id, version: _version, retired_at: _retired, ...body } = row;
  return body;
}
