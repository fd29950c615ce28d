/** What the catalogue's page shows and sends. */
import type { components } from "#schema";
import { wordsOf } from "../../core/messages";
import type { CatalogueRow } from "../../core/types";

type Schemas = components["schemas"];
export type Plan = Schemas["ImportPlan"];
export type ModelIn = Schemas["ModelIn"];
export type Unit = "m" | "cm" | "mm" | "ft" | "in";

export const SIZES = ["height", "length", "width", "wheelbase", "taillight", "headlight"] as const;
export type Size = (typeof SIZES)[number];

export const SIZE_WORDS = wordsOf({
  height: "catalogue-height",
  length: "catalogue-length",
  width: "catalogue-width",
  wheelbase: "catalogue-wheelbase",
  taillight: "catalogue-taillight",
  headlight: "catalogue-headlight",
});

export const CHANGE_WORDS = wordsOf({
  new: "catalogue-change-new",
  update: "catalogue-change-update",
  same: "catalogue-change-same",
  conflict: "catalogue-change-conflict",
  duplicate: "catalogue-change-duplicate",
  refused: "catalogue-change-refused",
});

export const UNIT_WORDS = wordsOf({
  m: "catalogue-unit-m",
  cm: "catalogue-unit-cm",
  mm: "catalogue-unit-mm",
  ft: "catalogue-unit-ft",
  in: "catalogue-unit-in",
});

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

/** What the server takes of a row, as it stands. */
export function bodyOf(row: CatalogueRow): ModelIn {
  const { id: _id, version: _version, retired_at: _retired, ...body } = row;
  return body;
}
