import { expect, it } from "vitest";
import { GROUPS } from "./work";

it("lists at most eleven pages of a survey in four named groups, and two below them", () => {
  const [overview, ...groups] = GROUPS.filter((group) => group.key !== "aside");
  expect(overview?.entries.map((entry) => entry.name)).toEqual(["survey"]);
  expect(groups.map((group) => group.key)).toEqual(["setup", "measure", "quality", "results"]);
  expect(1 + groups.reduce((sum, group) => sum + group.entries.length, 0)).toBeLessThanOrEqual(11);
  expect(GROUPS.find((group) => group.key === "aside")?.entries).toHaveLength(2);
});
