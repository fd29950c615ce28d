import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { api } from "../core/api";
import type { AxesAnswer } from "../core/types";
import { type AxesWish, Geometry, SLOW_MS } from "./geometry";
import { imagePoint } from "./points";

const ANSWER = { ok: true, axes: null, ladder: [] } as unknown as AxesAnswer;
const wish = (x: number): AxesWish => ({
  recordingId: 1,
  contact: imagePoint(x, 400),
  target: "roof",
  inset: null,
});

let answers: ((answer: AxesAnswer) => void)[] = [];

beforeEach(() => {
  vi.useFakeTimers();
  answers = [];
  vi.spyOn(api, "ask").mockImplementation(
    (() => new Promise((resolve) => answers.push(resolve))) as unknown as typeof api.ask,
  );
});
afterEach(() => vi.useRealTimers());

it("says that axes are awaited when the server takes long, and no more once they are here", async () => {
  const geometry = new Geometry();
  geometry.showAxes(wish(100));
  await vi.advanceTimersByTimeAsync(SLOW_MS - 1);
  expect(geometry.awaited.value).toBeNull();
  await vi.advanceTimersByTimeAsync(1);
  expect(geometry.awaited.value).toEqual(imagePoint(100, 400));
  answers[0]?.(ANSWER);
  await vi.advanceTimersByTimeAsync(0);
  expect(geometry.awaited.value).toBeNull();
  expect(geometry.axes.value).toBe(ANSWER);
});

it("goes on saying so when the answer is of a contact before", async () => {
  const geometry = new Geometry();
  geometry.showAxes(wish(100));
  geometry.showAxes(wish(200));
  await vi.advanceTimersByTimeAsync(SLOW_MS);
  answers[0]?.(ANSWER);
  await vi.advanceTimersByTimeAsync(0);
  expect(geometry.awaited.value).toEqual(imagePoint(200, 400));
  geometry.showAxes(null);
  expect(geometry.awaited.value).toBeNull();
});
