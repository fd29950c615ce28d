import { describe, expect, it } from "vitest";
import type { Scan } from "../../core/types";
import { besideOf, saidOf } from "./RigCalibration";
import { isValues, NEW_RIG, type RigValues, sentOf, typedOf, valuesOf, withoutCorrelation } from "./rig";

const RIG: RigValues = {
  baseline_m: 0.593,
  u_baseline_m: 0.0003,
  line_rate_hz: 4882.8,
  u_line_rate_ratio: 20e-6,
  divergence_rad: 0.0005,
  u_divergence_rad: 0.0002,
  distance_m: 3.5,
  misalignment_px: -0.6,
  u_misalignment_px: 0.01,
  shadow_share: 0.22,
  baseline_correlation: -0.91,
  u_distance_m: 0.25,
};

describe("the rig as it is typed", () => {
  it("comes back as it was", () => {
    const back = valuesOf(typedOf({ rig: RIG }));
    expect(isValues(back)).toBe(true);
    for (const [name, value] of Object.entries(RIG))
      expect(back[name as keyof typeof back]).toBeCloseTo(value as number, 9);
  });

  it("leaves the misalignment to the traffic where nothing is typed", () => {
    const least = valuesOf({ ...NEW_RIG, baseline: "0,6", rate: "2000" });
    expect(least).toMatchObject({
      baseline_m: 0.6,
      misalignment_px: null,
      distance_m: null,
      divergence_rad: 0,
      shadow_share: 0.15,
    });
  });

  it("keeps the correlation beside the values that it is of, and no longer", () => {
    expect(withoutCorrelation({ baseline: "0.6" })).toEqual({ baseline: "0.6", correlation: "" });
    expect(withoutCorrelation({ distance: "4" })).toEqual({ distance: "4" });
    expect(sentOf(RIG, ["baseline_m"])).toEqual({ baseline_m: 0.593, baseline_correlation: -0.91 });
    expect(sentOf(RIG, ["distance_m"])).toEqual({ distance_m: 3.5 });
    const wrong = valuesOf({ ...NEW_RIG, baseline: "1", rate: "9", correlation: "1,1" });
    expect(Object.keys(wrong)).toEqual(["correlation"]);
  });

  it("says what is wrong at the field", () => {
    const wrong = valuesOf({ ...NEW_RIG, baseline: "0.6", rate: "x", divergence: "1", uMisalignment: "0.1" });
    expect(isValues(wrong)).toBe(false);
    expect(Object.keys(wrong).sort()).toEqual(["distance", "misalignment", "rate"]);
    const steep = valuesOf({ ...NEW_RIG, baseline: "0.6", rate: "9", divergence: "300", distance: "3" });
    expect(Object.keys(steep)).toEqual(["divergence"]);
    expect(Object.keys(valuesOf({ ...NEW_RIG, baseline: "1", rate: "9", shadow: "61" }))).toEqual(["shadow"]);
  });
});

it("a calibration stores the distance that stands, not the digits that are shown of it", () => {
  const scan = { rig: { ...RIG, distance_m: 3.514, u_distance_m: 0.01234567, lanes: [] } } as unknown as Scan;
  const shown = besideOf(scan);
  expect(shown).toMatchObject({ distance: "3.51", uDistance: "0.0123" });
  expect(saidOf(shown, scan)).toMatchObject({ distance_m: 3.514, u_distance_m: 0.01234567 });
  expect(saidOf({ ...shown, distance: "3.6" }, scan)).toMatchObject({ distance_m: 3.6 });
  expect(saidOf({ ...shown, uDistance: "" }, scan)).toMatchObject({ u_distance_m: 0 });
  const lane = { distance_m: 7.218, u_distance_m: 0 };
  const laned = { rig: { ...RIG, distance_m: null, lanes: [lane] } } as unknown as Scan;
  expect(saidOf(besideOf(laned), laned)).toMatchObject(lane);
});
