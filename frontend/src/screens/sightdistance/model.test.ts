import { expect, it } from "vitest";
import type { Standard } from "../../core/types";
import { ofHeight, ofStandard, standardAt } from "./model";

const standard = (name: string, what: string, height_m: number, percent: number | null = null) =>
  ({ name, what, height_m, percent }) as Standard;
const CAR = standard("A", "eye_car", 1.08, 10);
const OTHER_CAR = standard("B", "eye_car", 1.08);
const TRUCK = standard("T", "eye_truck", 2.3, 5);
const OPTIONS = [CAR, OTHER_CAR, TRUCK];

it("reads a typed height by the rule of cars, unless only a truck's standard has it", () => {
  expect(ofHeight("eye_m", 1.1, OPTIONS)).toMatchObject({ eye_m: 1.1, eye_what: null });
  expect(ofHeight("eye_m", 1.08, OPTIONS)).toMatchObject({ eye_what: null });
  expect(ofHeight("eye_m", 2.3, OPTIONS)).toMatchObject({ eye_what: "eye_truck" });
  expect(ofHeight("object_m", 0.6, OPTIONS)).not.toHaveProperty("eye_what");
});

it("names the standard that was chosen among those of one height, and only of its own eyes", () => {
  const at = (said: Record<string, unknown>) =>
    new URLSearchParams(Object.entries(said).map(([name, value]) => [name, String(value)]));
  expect(standardAt(at(ofStandard("eye_m", OTHER_CAR)), "eye_m", 1.08, OPTIONS)).toBe(OTHER_CAR);
  expect(standardAt(at(ofStandard("eye_m", OTHER_CAR)), "eye_m", 1.1, OPTIONS)).toBeUndefined();
  expect(standardAt(at(ofStandard("eye_m", TRUCK)), "eye_m", 2.3, OPTIONS)).toBe(TRUCK);
  expect(standardAt(at({}), "eye_m", 2.3, OPTIONS)).toBeUndefined();
});
