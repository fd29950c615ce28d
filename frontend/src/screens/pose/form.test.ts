import { describe, expect, it } from "vitest";
import type { Pose } from "../../core/types";
import { boardOf, EMPTY_FORM, fromPose, problemsOf, requestOf } from "./form";

const filled = {
  ...EMPTY_FORM,
  calibrationId: 3,
  square: "100,0",
  referenceHeight: "0.45",
  first: 20,
  last: 80,
};

describe("the board form", () => {
  it("asks for everything that has no safe default", () => {
    const problems = problemsOf(EMPTY_FORM);
    expect(problems.calibration).not.toBeNull();
    expect(problems.square).not.toBeNull();
    expect(problems.referenceHeight).not.toBeNull();
    expect(problems.span).not.toBeNull();
    expect(problems.uncertainty).toBeNull();
    expect(requestOf(EMPTY_FORM)).toBeNull();
  });

  it("sends metres and radians, and takes a comma for the point", () => {
    expect(requestOf(filled)).toMatchObject({
      calibration_id: 3,
      columns: 9,
      rows: 6,
      square_m: 0.1,
      reference: "bottom",
      reference_height_m: 0.45,
      u_reference_height_m: 0.003,
      first_frame: 20,
      last_frame: 80,
    });
    expect(requestOf(filled)?.["u_lean_rad"]).toBeCloseTo(0.005236, 6);
  });

  it("tells the markers of a ChArUco board, and looks for it only when all is told", () => {
    const charuco = { ...filled, kind: "charuco", dictionary: "4X4_50", marker: "75" } as const;
    const told = { board_kind: "charuco", dictionary: "4X4_50", marker_m: 0.075 };
    expect(requestOf(charuco)).toMatchObject(told);
    expect(boardOf(charuco)).toEqual({ columns: 9, rows: 6, square_m: 0.1, ...told });
    expect(boardOf({ ...charuco, marker: "200" })).toBeNull();
    expect(requestOf({ ...charuco, marker: "" })).toBeNull();
    expect(boardOf(filled)).toEqual({ columns: 9, rows: 6 });
  });

  it("leaves the uncertainties that nobody gave to the estimates", () => {
    expect(requestOf(filled)).toMatchObject({ u_bow_m: 0.0005 });
    expect(requestOf(filled)).not.toHaveProperty("u_square_m");
    expect(requestOf({ ...filled, uSquare: "0.02", uBow: "2,0" })).toMatchObject({
      u_square_m: 0.00002,
      u_bow_m: 0.002,
    });
    expect(problemsOf({ ...filled, uBow: "-1" }).uncertainty).not.toBeNull();
    expect(problemsOf({ ...filled, uSquare: "thin" }).uncertainty).not.toBeNull();
  });

  it("fills itself from an earlier pose, with the span only of its own recording", () => {
    const pose = {
      first_frame: 5,
      last_frame: 9,
      calibration_id: 2,
      document: {
        board: {
          columns: 7,
          rows: 5,
          square_m: 0.12,
          reference: "top",
          reference_height_m: 1.1,
          u_lean_rad: 0.005,
          u_square_m: 0.000025,
        },
      },
    } as unknown as Pose;
    expect(fromPose(pose, true)).toMatchObject({
      columns: 7,
      square: "120",
      reference: "top",
      referenceHeight: "1.1",
      uSquare: "0.025",
      uBow: "",
      first: 5,
    });
    expect(fromPose(pose, false)).not.toHaveProperty("first");
    expect(fromPose(pose, false)).toMatchObject({ square: "120", referenceHeight: "", uReferenceHeight: "" });
  });
});
