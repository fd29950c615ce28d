import { describe, expect, it } from "vitest";
import { allOf } from "../../core/messages";
import type { CameraDocument, CameraView } from "../../core/types";
import { formatAway, lengthUnit } from "../../core/units";
import { PLAIN } from "../../parts/boards/markers";
import { inUnit, problemsOf, readBoard } from "./board";
import { readSpan } from "./CalibrateForm";
import { apart, boardInWords, type Halves, halvesInWords, heldOutInWords } from "./checks";
import { angleOfView, coveredShare, figuresOf, worstView } from "./lens";
import { niceFactor } from "./ViewPicture";

const lens: CameraDocument = {
  format: "sightline-camera-1",
  name: "test",
  width_px: 640,
  height_px: 480,
  model: "brown",
  fx_px: 320,
  fy_px: 321,
  cx_px: 319,
  cy_px: 241,
  distortion: [-0.28, 0.02, 0.001, -0.0001, 0.16],
  rms_px: 0.2,
  parameters: ["fx_px", "fy_px", "cx_px", "cy_px", "k1"],
  covariance: [
    [4, 0, 0, 0, 0],
    [0, 9, 0, 0, 0],
    [0, 0, 1, 0, 0],
    [0, 0, 0, 1, 0],
    [0, 0, 0, 0, 0.0001],
  ],
  views: [],
};

describe("the board as typed", () => {
  it("is read in metres", () => {
    expect(readBoard({ ...PLAIN, columns: "9", rows: "6", square: "24,5" })).toEqual({
      columns: 9,
      rows: 6,
      square_m: 0.0245,
    });
  });

  it("is typed in inches where lengths are in feet, and turned with the unit", () => {
    const typed = { ...PLAIN, columns: "9", rows: "6", square: "25" };
    const inches = inUnit(typed, "m", "ft");
    expect(inches.square).toBe("0.98425");
    lengthUnit.value = "ft";
    expect(readBoard({ ...typed, square: "1" })?.square_m).toBeCloseTo(0.0254, 12);
    expect(problemsOf({ ...typed, square: "" }).square).toContain("inches, for example 1.");
    lengthUnit.value = "m";
    expect(inUnit(inches, "ft", "m")).toEqual(typed);
  });

  it("has markers only where it is told so", () => {
    const typed = { columns: "9", rows: "6", square: "25", dictionary: "5X5_100", marker: "20" };
    expect(readBoard({ ...typed, kind: "charuco" })).toMatchObject({
      board_kind: "charuco",
      dictionary: "5X5_100",
      marker_m: 0.02,
    });
    expect(readBoard({ ...typed, kind: "checkerboard" })).not.toHaveProperty("dictionary");
    expect(problemsOf({ ...typed, kind: "charuco", marker: "25" }).marker).toMatch(/smaller/);
    expect(readBoard({ ...typed, kind: "charuco", marker: "" })).toBeNull();
  });

  it.each([
    [{ columns: "9.5", rows: "6", square: "25" }, "columns"],
    [{ columns: "9", rows: "2", square: "25" }, "rows"],
    [{ columns: "9", rows: "6", square: "0" }, "square"],
    [{ columns: "9", rows: "6", square: "" }, "square"],
  ] as const)("%j has something wrong with its %s", (fields, part) => {
    const typed = { ...PLAIN, ...fields };
    expect(problemsOf(typed)[part]).toMatch(/\w/);
    expect(readBoard(typed)).toBeNull();
  });
});

describe("figures", () => {
  it("carry the root of their variance", () => {
    const figures = figuresOf(lens);
    expect(figures.map((figure) => figure.name)).toEqual([
      "fx",
      "fy",
      "cx",
      "cy",
      "k1",
      "k2",
      "p1",
      "p2",
      "k3",
    ]);
    expect(figures[0]).toMatchObject({ value: 320, u: 2 });
    expect(figures[4]?.u).toBeCloseTo(0.01, 12);
    expect(figures[5]?.u).toBeNull();
  });

  it("have no uncertainty without a covariance", () => {
    expect(figuresOf({ ...lens, covariance: null }).every((figure) => figure.u === null)).toBe(true);
  });

  it("tell the angle of view", () => {
    expect(angleOfView(lens)).toBeCloseTo(90, 9);
    expect(angleOfView({ ...lens, model: "fisheye" })).toBeCloseTo(114.59, 2);
  });
});

describe("coverage", () => {
  const even = Array.from({ length: 12 }, () => Array.from({ length: 16 }, () => 5));

  it("tells the share of cells with a corner", () => {
    expect(coveredShare(even)).toBe(1);
    expect(
      coveredShare([
        [1, 0],
        [0, 0],
      ]),
    ).toBe(0.25);
  });

  it("lists words as people do", () => {
    expect(allOf(["a"])).toBe("a");
    expect(allOf(["a", "b", "c"])).toBe("a, b and c");
  });
});

describe("views", () => {
  const view = (file: string, used: boolean, rms_px: number | null): CameraView => ({
    file,
    image_id: null,
    frame: null,
    used,
    reason: null,
    rms_px,
    corners_px: [],
    residuals_px: [],
  });

  it("the worst is the used one with the largest residual", () => {
    expect(worstView([view("a", true, 0.2), view("b", true, 0.4), view("c", false, 9)])?.file).toBe("b");
    expect(worstView([view("c", false, null)])).toBeNull();
  });

  it.each([
    [0.3, 1],
    [7, 5],
    [23, 20],
    [99, 50],
    [100, 100],
  ])("residuals are drawn a round number of times longer: %d gives %d", (value, factor) => {
    expect(niceFactor(value)).toBe(factor);
  });
});

describe("frames to calibrate from", () => {
  it("are all of them unless said otherwise", () => {
    expect(readSpan("", "", "10", 283)).toEqual({ every: 10, first_frame: 0, last_frame: 282 });
  });

  it.each([
    ["5", "4", "1", /before/],
    ["0", "283", "1", /frame 282/],
    ["0", "10", "0", /whole number/],
    ["a", "", "1", /whole numbers/],
  ])("%s to %s by %s is refused in words", (first, last, every, words) => {
    expect(readSpan(first, last, every, 283)).toMatch(words);
  });
});

describe("checks in words", () => {
  const halves: Halves = {
    reason: null,
    views: [8, 7],
    fit_rms_px: 0.16,
    held_out_rms_px: 0.1712,
    height_differences: [
      { distance_m: 2, difference_m: null, expected_m: null },
      { distance_m: 3, difference_m: -0.0002, expected_m: 0.0003 },
      { distance_m: 5, difference_m: 0.0164, expected_m: 0.01 },
    ],
  };

  it("the halves differ by so much in a height, whatever the sign", () => {
    expect(halvesInWords(halves).replaceAll("\u00a0", " ")).toBe(
      "Heights from the two halves differ by 0.2 mm at 3 m and 16 mm at 5 m.",
    );
    expect(heldOutInWords(halves)).toContain("0.171\u00a0px; fitted images: 0.160\u00a0px");
  });

  it("are in feet and inches where lengths are in feet", () => {
    lengthUnit.value = "ft";
    expect(apart(0.00002).replaceAll("\u00a0", " ")).toBe("under 0.01 in");
    expect(apart(-0.016).replaceAll("\u00a0", " ")).toBe("0.63 in");
    expect(formatAway(2).replaceAll("\u00a0", " ")).toBe("6.6 ft");
    lengthUnit.value = "m";
    expect([apart(0.00002), formatAway(2)].join(", ").replaceAll("\u00a0", " ")).toBe("under 0.1 mm, 2 m");
  });

  it("a reason stands where there are no halves", () => {
    const none = {
      ...halves,
      reason: { code: "calibration-halves-few", values: { least: 6, usable: 4, board: "flat" }, message: "" },
      height_differences: [],
    };
    expect(halvesInWords(none)).toMatch(/^Not done\. Two halves need at least 6/);
  });

  it("the board is told to be taken as flat or solved for", () => {
    const shape = {
      solved: false,
      bow_m: 0.0012,
      flat_rms_px: 0.4,
      bent_rms_px: 0.2,
      height_differences: [],
    };
    expect(boardInWords(shape).replaceAll("\u00a0", " ")).toMatch(/^Taken as flat\. .* a bend of 1\.2 mm\./);
    expect(boardInWords({ ...shape, solved: true })).toMatch(/^Board shape modelled: it bends by 1/);
  });
});
