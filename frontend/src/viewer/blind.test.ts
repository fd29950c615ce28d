import { describe, expect, it } from "vitest";
import { isDrawn } from "./blind";

describe("the sampling plan of blind second clicks", () => {
  const ids = Array.from({ length: 3000 }, (_, i) => i + 1);

  it("draws the same measurements each time, about one in n, and not every third of a vehicle", () => {
    const drawn = ids.filter((id) => isDrawn(id, 5));
    expect(drawn.length).toBeGreaterThan(500);
    expect(drawn.length).toBeLessThan(700);
    expect(ids.filter((id) => isDrawn(id, 5))).toEqual(drawn);
    for (const rest of [0, 1, 2]) expect(drawn.filter((id) => id % 3 === rest).length).toBeGreaterThan(150);
  });

  it("draws all at one in one and none at zero", () => {
    expect(ids.every((id) => isDrawn(id, 1))).toBe(true);
    expect(ids.some((id) => isDrawn(id, 0))).toBe(false);
  });
});
