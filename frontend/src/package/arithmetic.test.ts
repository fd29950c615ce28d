import { createHash } from "node:crypto";
import { describe, expect, it } from "vitest";
import { canonical } from "./canonical";
import { cellsOf, rowsOf, unsafe } from "./csv";
import { poseOf } from "./documents";
import { heightOfFrames } from "./frames";
import { heightOf } from "./height";
import { direction, distorted } from "./lens";
import { sha256 } from "./sha256";
import { condition, solved } from "./solving";

describe("hashes and texts", () => {
  it("are those of others, whatever the length", () => {
    for (const length of [0, 1, 55, 56, 63, 64, 65, 119, 120, 1000]) {
      const text = "é".repeat(length >> 1) + "x".repeat(length % 2);
      expect(sha256(text)).toBe(createHash("sha256").update(text).digest("hex"));
    }
  });

  it("canonical JSON is RFC 8785's own example", () => {
    const value = {
      numbers: [333333333.3333333, 1e30, 4.5, 2e-3, 1e-27],
      "\u20ac": "€",
      "\r": 1,
      literals: [null, true],
    };
    expect(canonical(value)).toBe(
      '{"\\r":1,"literals":[null,true],"numbers":[333333333.3333333,1e+30,4.5,0.002,1e-27],"€":"€"}',
    );
  });

  it("reads quoted cells, empty ones, and the apostrophe before a formula", () => {
    expect(cellsOf('a,b\n"x ""y"", z",\n,"two\nlines"\n')).toEqual([
      ["a", "b"],
      ['x "y", z', ""],
      ["", "two\nlines"],
    ]);
    expect(() => rowsOf("a,b\n1\n")).toThrow();
    expect([unsafe("'=1+1"), unsafe("'tis"), unsafe("-")]).toEqual(["=1+1", "'tis", "-"]);
  });
});

const CAMERA = {
  model: "brown",
  width_px: 1920,
  height_px: 1080,
  fx_px: 1000,
  fy_px: 1010,
  cx_px: 950,
  cy_px: 530,
  distortion: [-0.2, 0.05, 1e-3, -5e-4, 0.01],
} as const;
const LEVEL = poseOf({
  camera: CAMERA,
  cam_from_road: {
    rotation: [
      [1, 0, 0],
      [0, 0, -1],
      [0, 1, 0],
    ],
    translation_m: [0, 1.5, 4],
  },
});

/** The pixel of a point of the road frame, for the level camera at (0, -4, 1.5). */
function seen(x: number, y: number, z: number): readonly [number, number] {
  const d = distorted(CAMERA, x / (y + 4), (1.5 - z) / (y + 4));
  return [CAMERA.fx_px * d.x + CAMERA.cx_px, CAMERA.fy_px * d.y + CAMERA.cy_px];
}

describe("heights", () => {
  it("come back from points that were projected", () => {
    const found = heightOf(LEVEL, seen(0.5, 0.2, 0), seen(1.1, 0.65, 1.16), 0.45);
    expect(found?.height_m).toBeCloseTo(1.16, 12);
    expect([found?.x_m, found?.y_m]).toEqual([expect.closeTo(0.5, 12), expect.closeTo(0.2, 12)]);
  });

  it("and from several frames with the inset that nobody told", () => {
    const frames = [-0.6, 0, 0.7].map((x) => ({
      contact: seen(x, 0.2, 0),
      target: seen(x + 0.3, 0.65, 1.16),
    }));
    const found = heightOfFrames(LEVEL, frames, 1);
    expect(found?.height_m).toBeCloseTo(1.16, 10);
    expect(found?.solved_inset_m).toBeCloseTo(0.45, 9);
  });

  it("there is none above the horizon, outside the picture, or where the vehicle stood", () => {
    expect(heightOf(LEVEL, seen(0, 0, 1.6), seen(0, 0, 1), 0)).toBeNull();
    expect(heightOf(LEVEL, [-1, 900], seen(0, 0, 1), 0)).toBeNull();
    expect(heightOf(LEVEL, seen(0, 0, 0), seen(0, 0, 0), 0)).toBeNull();
    const still = { contact: seen(0, 0, 0), target: seen(0.3, 0.4, 1.2) };
    expect(heightOfFrames(LEVEL, [still, still], 1)).toBeNull();
  });

  it("no direction lies beyond where the lens folds", () => {
    const folds = { ...CAMERA, fx_px: 300, fy_px: 300, distortion: [-0.5, 0, 0, 0, 0] };
    expect(direction(folds, [20, 20])).toBeNull();
    expect(direction(folds, [950, 530])).toEqual([expect.closeTo(0, 15), expect.closeTo(0, 15)]);
  });
});

it("small systems are solved, singular ones are not", () => {
  expect(
    solved(
      [
        [0, 2],
        [3, 1],
      ],
      [4, 5],
    ),
  ).toEqual([1, 2]);
  expect(
    solved(
      [
        [1, 2],
        [2, 4],
      ],
      [1, 1],
    ),
  ).toBeNull();
  expect(
    condition([
      [2, 1],
      [1, 2],
    ]),
  ).toBeCloseTo(3, 12);
});
