import { describe, expect, it } from "vitest";
import type { Recording } from "../core/types";
import { around, standIn, worthHaving } from "./ahead";

const of = (width_px: number, height_px: number): Recording =>
  ({
    frame_count: 1000,
    width_px,
    height_px,
    thumbs: [0, 100, 200].map((frame) => ({ frame, url: "" })),
  }) as unknown as Recording;

describe("worthHaving", () => {
  it("puts neighbours in the direction of travel first, then what is expected", () => {
    const wanted = worthHaving(500, -1, of(640, 480), around(700), 256e6);
    expect(wanted).toEqual([499, 498, 497, 496, 495, 494, 493, 492, 501, 502, 700, 701, 699, 702, 698]);
  });

  it("never asks for more than the cache holds", () => {
    const large = worthHaving(500, 1, of(3840, 2160), around(700), 256e6);
    expect(large).toEqual([501, 502, 503, 504, 505]);
    expect(worthHaving(500, 1, of(16384, 6000), around(700), 256e6)).toEqual([501, 502]);
  });
});

describe("standIn", () => {
  it("stands in for a jump and not for a step, and only if it is nearer than what is shown", () => {
    expect(standIn(of(640, 480), 190, 20)?.frame).toBe(200);
    expect(standIn(of(640, 480), 30, 20)).toBeUndefined();
    expect(standIn(of(640, 480), 150, 130)).toBeUndefined();
    expect(standIn(of(640, 480), 90, null)?.frame).toBe(100);
    expect(standIn(null, 90, null)).toBeUndefined();
  });
});
