import { expect, test } from "vitest";
import type { CatalogueRow, Vehicle } from "../../core/types";
import { fromCatalogue } from "./fromCatalogue";

const ROW = {
  make: "Aldara",
  model: "Pico",
  category: "hatchback",
  year_from: 2018,
  year_to: 2022,
  height_m: 1.47,
  u_height_m: 0.005,
  height_source: null,
  taillight_m: 0.81,
  u_taillight_m: 0.003,
  taillight_source: "tape",
  headlight_m: null,
  u_headlight_m: null,
  headlight_source: null,
  source: "data sheet",
} as unknown as CatalogueRow;

const CAR = { make: "Haldmann", model: "T75", check_target: false } as unknown as Vehicle;

test("heights come with their u and source; what is not known of the model is taken away", () => {
  expect(fromCatalogue(ROW, CAR)).toEqual({
    make: "Aldara",
    model: "Pico",
    category: "hatchback",
    model_chosen_by: null,
    model_sizes: null,
    manufacturer_height_m: 1.47,
    u_manufacturer_height_m: 0.005,
    height_source: "data sheet",
    known_taillight_m: 0.81,
    u_known_taillight_m: 0.003,
    known_taillight_source: "tape",
    known_headlight_m: null,
    u_known_headlight_m: null,
    known_headlight_source: null,
  });
});

test("a model chosen by its sizes says so, and naming it once more does not unsay it", () => {
  const chosen = fromCatalogue(ROW, CAR, ["height", "wheelbase"]);
  expect(chosen).toMatchObject({ model_chosen_by: "size", model_sizes: "height wheelbase" });
  expect(fromCatalogue(ROW, { ...CAR, ...chosen } as Vehicle)).not.toHaveProperty("model_chosen_by");
  expect(fromCatalogue({ ...ROW, model: "Sol" }, { ...CAR, ...chosen } as Vehicle)).toMatchObject({
    model_chosen_by: null,
    model_sizes: null,
  });
});

test("of the same model, or of a check target, nothing is taken away", () => {
  const same = { ...CAR, make: "Aldara", model: "Pico" } as Vehicle;
  for (const car of [same, { ...CAR, check_target: true } as Vehicle]) {
    expect(fromCatalogue(ROW, car)).not.toHaveProperty("known_headlight_m");
    expect(fromCatalogue(ROW, car)).toHaveProperty("known_taillight_m", 0.81);
  }
});
