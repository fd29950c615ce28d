import { render } from "preact";
import { expect, it } from "vitest";
import { Facts } from "../../components";
import type { ScanMotion, ScanVehicle } from "../../core/types";
import { byWords, gapFacts, misalignmentWords } from "./VehiclePanel";

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

it("shows both gaps with half their 95 % interval", () => {
  const gap = { time_gap_s: 1.65, U95_time_gap_s: 0.0041, distance_gap_m: 22.331, U95_distance_gap_m: 0.048 };
  const facts = gapFacts({ ...gap, headway_s: null, paper_distance_gap_m: null } as ScanVehicle["gap"]);
  render(<Facts of={facts} />, document.body);
  expect(document.body.textContent).toContain("1.650\u00a0±\u00a00.004\u00a0s");
  expect(document.body.textContent).toContain("22.33\u00a0±\u00a00.05\u00a0m");
});

it("tells a small uncertainty of the misalignment, which is not nought", () => {
  expect(misalignmentWords(0.6, 0.0012)).toMatch(/0\.60\spx.*u\s=\s0\.0012\spx/);
});

it("tells a small standard deviation of the blocks, which is not nought", () => {
  const motion = { method: "direct", placed_by_person: false, fit_error_percent: 0.0034 };
  expect(byWords(motion as unknown as ScanMotion)).toMatch(/blocks 0\.0034\s%/);
});
