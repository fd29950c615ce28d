/** What a model of the catalogue says of a vehicle. */
import type { CatalogueRow, ModelSize, Vehicle } from "../../core/types";
import type { Changes } from "./fields";

/** A height of the catalogue, metres, with its u and where it comes from. */
type Known = readonly [height_m: number | null, u_m: number | null, source: string | null];

/**
 * Heights come with their u and source. What the catalogue does not know is taken away from a vehicle that was
 * another model before: it was the other model's. A check target keeps what was taped.
 *
 * `sizes`: those that the model was chosen by; left out: it was chosen by name. Naming the same model once more does
 * not unsay how it was chosen.
 */
export function fromCatalogue(row: CatalogueRow, vehicle: Vehicle, sizes?: readonly ModelSize[]): Changes {
  const other = row.make !== vehicle.make || row.model !== vehicle.model;
  const clears = other && !vehicle.check_target;
  return {
    make: row.make,
    model: row.model,
    ...howChosen(other, sizes),
    ...(row.category ? { category: row.category } : {}),
    ...(row.year_from !== null && row.year_from === row.year_to ? { year: row.year_from } : {}),
    ...taken(roof, [row.height_m, row.u_height_m, row.height_source || row.source], clears),
    ...taken(
      lamp("taillight"),
      [row.taillight_m, row.u_taillight_m, row.taillight_source || row.source],
      clears,
    ),
    ...taken(
      lamp("headlight"),
      [row.headlight_m, row.u_headlight_m, row.headlight_source || row.source],
      clears,
    ),
  };
}

function howChosen(other: boolean, sizes?: readonly ModelSize[]): Changes {
  if (sizes) return { model_chosen_by: "size", model_sizes: sizes.join(" ") };
  return other ? { model_chosen_by: null, model_sizes: null } : {};
}

function taken(into: (known: Known) => Changes, known: Known, clears: boolean): Changes {
  if (known[0] !== null) return into(known);
  return clears ? into([null, null, null]) : {};
}

const roof = ([height_m, u_m, source]: Known): Changes => ({
  manufacturer_height_m: height_m,
  u_manufacturer_height_m: u_m,
  height_source: source,
});

const lamp =
  (name: "taillight" | "headlight") =>
  ([height_m, u_m, source]: Known): Changes => ({
    [`known_${name}_m`]: height_m,
    [`u_known_${name}_m`]: u_m,
    [`known_${name}_source`]: source,
  });
