import { describe, expect, it } from "vitest";
import { cropAround } from "./Loupe";
import { imagePoint } from "./points";

const size = { width: 640, height: 480 };

describe("the loupe's crop", () => {
  it("holds all that the loupe shows around a point, in whole pixels of the picture", () => {
    for (const [x, y] of [
      [0, 0],
      [79.4, 80.6],
      [320.5, 240.25],
      [639, 479],
      [639, 0],
    ] as const) {
      const crop = cropAround(imagePoint(x, y), size);
      expect(Object.values(crop).every(Number.isInteger)).toBe(true);
      expect(crop.x + crop.w).toBeLessThanOrEqual(640);
      expect(crop.y + crop.h).toBeLessThanOrEqual(480);
      expect(crop.x).toBeLessThanOrEqual(Math.max(0, x - 14.5));
      expect(crop.y).toBeLessThanOrEqual(Math.max(0, y - 14.5));
      expect(crop.x + crop.w).toBeGreaterThanOrEqual(Math.min(640, x + 15.5));
      expect(crop.y + crop.h).toBeGreaterThanOrEqual(Math.min(480, y + 15.5));
    }
  });

  it("stays the same while the pointer moves a little", () => {
    expect(cropAround(imagePoint(330, 250), size)).toEqual(cropAround(imagePoint(331.7, 249.2), size));
  });
});
