import { expect, it } from "vitest";
import type { ScanVehicle } from "../../core/types";
import { gapFacts } from "./VehiclePanel";

it("tells a known headway where the time gap is missing, and why that is", () => {
  const reason = { code: "rear-unknown", values: {}, message: "the rear is not known" };
  const gap = { time_gap_s: null, distance_gap_m: null, headway_s: 2.4561, reason };
  const told = (one: object) =>
    gapFacts(one as ScanVehicle["gap"])
      .filter(Boolean)
      .map(String);
  const [first, second] = told(gap);
  expect(first).toContain("the rear is not known");
  expect(second).toMatch(/headway.*2\.456/);
  expect(told({ ...gap, headway_s: null })).toHaveLength(1);
});
