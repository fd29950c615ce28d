/** What an operator may say of a vehicle, and where two people said different things. */
import { wordsOf } from "../../core/messages";
import type { Vehicle, VehicleFields } from "../../core/types";

const FIELDS = [
  "first_frame",
  "best_frame",
  "last_frame",
  "make",
  "model",
  "year",
  "model_chosen_by",
  "model_sizes",
  "category",
  "manufacturer_height_m",
  "u_manufacturer_height_m",
  "height_source",
  "known_driver_eye_m",
  "u_known_driver_eye_m",
  "known_driver_eye_source",
  "known_taillight_m",
  "u_known_taillight_m",
  "known_taillight_source",
  "known_headlight_m",
  "u_known_headlight_m",
  "known_headlight_source",
  "known_other_m",
  "u_known_other_m",
  "known_other_source",
  "check_target",
  "lighting",
  "direction",
  "driver_side",
  "roof_not_visible",
  "driver_eye_not_visible",
  "taillight_not_visible",
  "headlight_not_visible",
  "discarded",
  "notes",
] as const satisfies readonly (keyof VehicleFields)[];
export type Field = (typeof FIELDS)[number];
export type Changes = Partial<VehicleFields>;

export const FIELD_WORDS: Readonly<Record<Field, string>> = wordsOf({
  first_frame: "measure-field-first_frame",
  best_frame: "measure-field-best_frame",
  last_frame: "measure-field-last_frame",
  make: "measure-field-make",
  model: "measure-field-model",
  year: "measure-field-year",
  model_chosen_by: "measure-field-model_chosen_by",
  model_sizes: "measure-field-model_sizes",
  category: "measure-field-category",
  manufacturer_height_m: "measure-field-manufacturer_height_m",
  u_manufacturer_height_m: "measure-field-u_manufacturer_height_m",
  height_source: "measure-field-height_source",
  known_driver_eye_m: "measure-field-known_driver_eye_m",
  u_known_driver_eye_m: "measure-field-u_known_driver_eye_m",
  known_driver_eye_source: "measure-field-known_driver_eye_source",
  known_taillight_m: "measure-field-known_taillight_m",
  u_known_taillight_m: "measure-field-u_known_taillight_m",
  known_taillight_source: "measure-field-known_taillight_source",
  known_headlight_m: "measure-field-known_headlight_m",
  u_known_headlight_m: "measure-field-u_known_headlight_m",
  known_headlight_source: "measure-field-known_headlight_source",
  known_other_m: "measure-field-known_other_m",
  u_known_other_m: "measure-field-u_known_other_m",
  known_other_source: "measure-field-known_other_source",
  check_target: "measure-field-check_target",
  lighting: "measure-field-lighting",
  direction: "measure-field-direction",
  driver_side: "measure-field-driver_side",
  roof_not_visible: "measure-field-roof_not_visible",
  driver_eye_not_visible: "measure-field-driver_eye_not_visible",
  taillight_not_visible: "measure-field-taillight_not_visible",
  headlight_not_visible: "measure-field-headlight_not_visible",
  discarded: "measure-field-discarded",
  notes: "field-notes",
});

/** Fields that both sides changed from the base, to different values. */
export function disputedFields(base: Vehicle, mine: Changes, theirs: Vehicle): Field[] {
  return FIELDS.filter(
    (field) =>
      field in mine &&
      mine[field] !== base[field] &&
      theirs[field] !== base[field] &&
      theirs[field] !== mine[field],
  );
}
