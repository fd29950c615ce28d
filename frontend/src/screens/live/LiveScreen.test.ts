import { afterEach, expect, it } from "vitest";
import { survey } from "../../core/survey";
import type { Survey } from "../../core/types";
import { clockThere, momentThere } from "./LiveScreen";

afterEach(() => {
  survey.value = null;
});

it.each([
  ["Asia/Tokyo", "02:30:05", "4 May 2026, 02:30:05"],
  ["America/Lima", "12:30:05", "3 May 2026, 12:30:05"],
])("tells the time of day by the clocks of the place: %s", (time_zone, told, moment) => {
  survey.value = { place: { time_zone } } as unknown as Survey;
  expect(clockThere("2026-05-03T17:30:05Z")).toBe(told);
  expect(momentThere("2026-05-03T17:30:05Z")).toBe(moment);
});
