import { expect, test } from "vitest";
import { pathOf, placesOf } from "./direct";

const FRAME = { left: 0, right: 400, top: 0, bottom: 300 };
const WORD = { width: 60, height: 14 };
const level = (y: number) => Array.from({ length: 51 }, (_, n) => ({ x: 8 * n, y }));

test("each word stands at its own curve, nearer to it than to any other", () => {
  const places = placesOf([level(80), level(200)], [WORD, WORD], FRAME);
  const [first, second] = places;
  expect(Math.abs((first?.y ?? 0) - 80)).toBeLessThan(15);
  expect(Math.abs((second?.y ?? 0) - 200)).toBeLessThan(15);
});

test("a curve between two near ones has no room for its word, and a word wider than the frame none", () => {
  const [first, between, last] = placesOf([level(80), level(88), level(96)], [WORD, WORD, WORD], FRAME);
  expect(first?.y).toBeLessThan(80);
  expect(between).toBeNull();
  expect(last?.y).toBeGreaterThan(96);
  expect(placesOf([level(80)], [{ width: 500, height: 14 }], FRAME)).toEqual([null]);
});

test("a word goes where no other word stands, and outside of no frame", () => {
  const taken = { left: 0, right: 330, top: 0, bottom: 300 };
  const [only] = placesOf([level(150)], [WORD], FRAME, [taken]);
  expect((only?.x ?? 0) - 30).toBeGreaterThan(330);
  expect((only?.x ?? 0) + 30).toBeLessThanOrEqual(400);
});

test("a path has no long gaps of its own and keeps those of its curve", () => {
  const scale = { apply: (value: never) => Number(value) };
  const scales = { x: scale, y: scale };
  const steps = pathOf({ word: "", x: [0, 100], y: [0, 50], way: "steps" }, scales);
  expect(steps).toContainEqual({ x: 100, y: 0 });
  expect(steps.at(-1)).toEqual({ x: 100, y: 50 });
  expect(steps.length).toBeGreaterThan(18);
  const broken = pathOf({ word: "", x: [0, 50, 100], y: [0, null, 50], way: "line" }, scales);
  expect(broken).toEqual([
    { x: 0, y: 0 },
    { x: 100, y: 50 },
  ]);
});
