import { expect, test } from "vitest";
import { digitsOf, type Readable, readAt, readable, readablesOf, valueWords } from "./reading";

const STEPS: Readable = {
  word: "daytime",
  x: [1, 2, 4],
  y: [25, 50, 100],
  low: [0, 10, 60],
  high: [60, 90, 100],
  way: "steps",
};

test("a step holds until the next one", () => {
  expect(readAt(STEPS, 0.5, 0)).toMatchObject({ y: 0, low: null });
  expect(readAt(STEPS, 1, 0)).toMatchObject({ y: 25, low: 0, high: 60 });
  expect(readAt(STEPS, 3.9, 0)).toMatchObject({ y: 50, low: 10, high: 90 });
  expect(readAt(STEPS, 9, 0)).toMatchObject({ y: 100 });
});

test("a line is read between its points, and nowhere else", () => {
  const line: Readable = { word: "K", x: [30, 40], y: [2, 4], low: [1, null], way: "line" };
  expect(readAt(line, 35, 0)).toMatchObject({ y: 3, low: null });
  expect(readAt(line, 40, 0)).toMatchObject({ y: 4 });
  expect(readAt(line, 29, 0)).toBeNull();
  expect(readAt(line, 41, 0)).toBeNull();
});

test("of points the nearest is read, if there is one near", () => {
  const points: Readable = { word: "roof", x: [3, 1, 2], y: [30, 10, 20], way: "points" };
  expect(readAt(points, 1.9, 0.2)).toMatchObject({ x: 2, y: 20 });
  expect(readAt(points, 1.5, 0.2)).toBeNull();
});

test("marks keep what is read of them, at any depth", () => {
  const [mark, other] = [{}, {}];
  expect(readablesOf([[readable(mark, STEPS)], other, null])).toEqual([STEPS]);
});

test("values have the decimals of their axis, and their band", () => {
  expect([digitsOf(0, 120), digitsOf(1, 2.1), digitsOf(0, 100)]).toEqual([1, 3, 1]);
  const read = readAt(STEPS, 2, 0);
  expect(read && valueWords(read, 1)).toBe("50.0 (10.0 to 90.0)");
});
