import { describe, expect, it } from "vitest";
import {
  fitAll,
  levelFor,
  lineAt,
  panBy,
  resized,
  revealLines,
  showLines,
  tilesIn,
  xOf,
  yOf,
  zoomHeight,
  zoomTime,
} from "./view";

const strips = { lines: 1_000_000, rows: 256 };
const all = fitAll(strips, 1000, 200);

describe("the view of the strips", () => {
  it("shows everything, and line centres half a line in", () => {
    expect(lineAt(all, 0)).toBe(-0.5);
    expect(lineAt(all, 1000)).toBeCloseTo(999_999.5);
    expect(yOf(all, -0.5)).toBe(0);
    expect(yOf(all, 255.5)).toBeCloseTo(200);
  });

  it("zooms the time at the pointer and leaves the height", () => {
    const near = zoomTime(all, 250, 100);
    expect(lineAt(near, 250)).toBeCloseTo(lineAt(all, 250));
    expect(near.perPx).toBeCloseTo(10);
    expect(near.rowPx).toBe(all.rowPx);
  });

  it("zooms the height at the pointer and leaves the time", () => {
    const tall = zoomHeight(all, 100, 4);
    expect(tall.rowPx).toBeCloseTo(4 * all.rowPx);
    expect(tall.row0 + 100 / tall.rowPx).toBeCloseTo(all.row0 + 100 / all.rowPx);
    expect(tall.perPx).toBe(all.perPx);
  });

  it("never leaves the strips", () => {
    expect(panBy(all, 500, 50)).toEqual(all);
    const near = zoomTime(all, 500, 1e9);
    expect(near.perPx).toBeCloseTo(1 / 24);
    expect(lineAt(panBy(near, 1e12, 0), 0)).toBe(-0.5);
    expect(zoomTime(near, 0, 1e-12).perPx).toBeCloseTo(all.perPx);
  });

  it("brings a vehicle into sight with road around it", () => {
    const seen = showLines(all, 500_000, 501_000);
    expect(xOf(seen, 500_000)).toBeGreaterThan(100);
    expect(xOf(seen, 501_000)).toBeLessThan(900);
    const there = revealLines(seen, 500_100, 500_900);
    expect(there).toBe(seen);
    expect(xOf(revealLines(seen, 700_000, 700_500), 700_250)).toBeCloseTo(500);
  });

  it("keeps the scale of what was zoomed when the window changes, and fits what was fitted", () => {
    expect(resized(all, 500, 100).perPx).toBeCloseTo(2000);
    expect(resized(zoomTime(all, 0, 1000), 500, 100).perPx).toBeCloseTo(1);
  });

  it("asks for the level that fits the screen, and its tiles", () => {
    expect(levelFor(0.2, 6)).toBe(0);
    expect(levelFor(4, 6)).toBe(1);
    expect(levelFor(4, 6, 2)).toBe(0);
    expect(levelFor(1000, 6)).toBe(4);
    expect(levelFor(1e9, 6)).toBe(5);
    expect(tilesIn(all, 256, 1024, 4)).toEqual([0, 3]);
    expect(tilesIn(zoomTime(all, 0, 1000), 1, 1024, 977)).toEqual([0, 0]);
  });
});
