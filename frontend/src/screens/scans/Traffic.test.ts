import { expect, it } from "vitest";
import { beganWords } from "./Traffic";

it("an interval after midnight is told with its day, under the day of the first", () => {
  const first = "2026-05-03T23:55:00.000+02:00";
  expect(beganWords(first, first)).toBe("23:55:00");
  expect(beganWords("2026-05-04T00:00:00.000+02:00", first)).toMatch(/4 May 2026.*00:00:00/);
});
