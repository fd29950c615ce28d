import { describe, expect, it } from "vitest";
import type { Pose } from "../types";
import { EMPTY_FORM, fromPose, problemsOf, requestOf } from "./form";

const filled = {
  ...EMPTY_FORM,
  calibrationId: 3,
  square: "0,1",
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
        },
      },
    } as unknown as Pose;
    expect(fromPose(pose, true)).toMatchObject({
      columns: 7,
      square: "0.12",
      reference: "top",
      referenceHeight: "1.1",
      first: 5,
    });
    expect(fromPose(pose, false)).not.toHaveProperty("first");
  });
});
