/** What an operator may say of a vehicle, and where two people said different things. */
import type { Vehicle, VehicleFields } from "../../core/types";

const FIELDS = [
  "first_frame",
  "best_frame",
  "last_frame",
  "make",
  "model",
  "year",
  "category",
  "manufacturer_height_m",
  "u_manufacturer_height_m",
  "height_source",
  "lighting",
  "notes",
] as const satisfies readonly (keyof VehicleFields)[];
export type Field = (typeof FIELDS)[number];
export type Changes = Partial<VehicleFields>;

export const FIELD_WORDS: Record<Field, string> = {
  first_frame: "First frame",
  best_frame: "Best frame",
  last_frame: "Last frame",
  make: "Make",
  model: "Model",
  year: "Year",
  category: "Category",
  manufacturer_height_m: "Manufacturer height",
  u_manufacturer_height_m: "± of the manufacturer height",
  height_source: "Source of the height",
  lighting: "Lighting",
  notes: "Notes",
};

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
