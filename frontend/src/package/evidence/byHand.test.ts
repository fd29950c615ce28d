import { expect, it } from "vitest";
import { plainOf, spanOf, speedOf } from "./byHand";

const LINES = { front_line_1: 1000, rear_line_1: 2200, front_line_2: 1150, rear_line_2: 2350 };

it("is baseline over time at front and rear, and their mean times the passing", () => {
  const found = plainOf(LINES, 0.6, 5000);
  expect(found?.front_mps).toBeCloseTo(20, 12);
  expect(found?.rear_mps).toBeCloseTo(20, 12);
  expect(found?.length_m).toBeCloseTo(4.8, 12);
  const braking = plainOf({ ...LINES, rear_line_2: 2500 }, 0.6, 5000);
  expect([braking?.front_mps, braking?.rear_mps]).toEqual([20, 10]);
  expect(braking?.length_m).toBeCloseTo(3.6, 12);
});

it("takes a vehicle that reaches camera 2 first", () => {
  const lines = { front_line_1: 1150, rear_line_1: 2350, front_line_2: 1000, rear_line_2: 2200 };
  const found = plainOf(lines, 0.6, 5000);
  expect(found?.front_mps).toBeCloseTo(20, 12);
  expect(found?.length_m).toBeCloseTo(4.8, 12);
});

it("there is none where lines are no passing", () => {
  expect(plainOf({ ...LINES, front_line_2: 1000 }, 0.6, 5000)).toBeNull();
  expect(plainOf({ ...LINES, rear_line_2: 2200 }, 0.6, 5000)).toBeNull();
  expect(plainOf({ ...LINES, rear_line_1: 900, rear_line_2: 1100 }, 0.6, 5000)).toBeNull();
  expect(plainOf({ ...LINES, rear_line_2: null }, 0.6, 5000)).toBeNull();
  expect(speedOf(-3, 0.6, 5000)).toBeNull();
});

it("a line lies in the middle of its column, also where only every third is kept", () => {
  const picture = {
    name: "a",
    camera: 1,
    sha256: "",
    first_line: 90,
    columns: 10,
    step_lines: 3,
    rows_px: 4,
  };
  expect(spanOf(picture)).toEqual({ start: 88.5, width: 30 });
});
