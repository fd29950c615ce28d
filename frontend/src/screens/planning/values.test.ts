import { describe, expect, it } from "vitest";
import type { Camera, Scan } from "../../core/types";
import { completed, completedLines, LINE_NAMES, shown, typed, valuesOf, withCamera } from "./values";

const camera = (id: number, calibration: number | null) =>
  ({ id, current_calibration_id: calibration, calibrations: [] }) as unknown as Camera;

describe("what the address leaves open", () => {
  it("takes the first calibration in use, else a plain camera", () => {
    expect(completed({}, [camera(1, null), camera(2, 7)]).calibration_id).toBe("7");
    const plain = completed({}, []);
    expect(plain.calibration_id).toBeUndefined();
    expect(plain.field_of_view_deg).toBe("65");
  });

  it("changes nothing that the address says", () => {
    const said = valuesOf(
      new URLSearchParams("field_of_view_deg=90&width_px=640&height_px=480&distance_m=4.2&other=9"),
    );
    const values = completed(said, [camera(2, 7)]);
    expect(values).toMatchObject({ ...said, camera_height_m: "1.5" });
    expect(values.calibration_id).toBeUndefined();
    expect(Object.keys(values)).not.toContain("other");
  });

  it("drops the plain camera for a calibration and back", () => {
    expect(withCamera("4")).toEqual({
      calibration_id: "4",
      width_px: null,
      height_px: null,
      field_of_view_deg: null,
    });
    expect(withCamera("plain")).toMatchObject({ calibration_id: null, width_px: "1920" });
  });
});

describe("lengths in the unit shown", () => {
  it("are metres in the address", () => {
    expect(typed("distance_m", "10", "ft")).toBe("3.048");
    expect(shown("distance_m", "3.048", "ft")).toBe("10");
    expect(typed("distance_m", "3,5", "m")).toBe("3.5");
    expect(shown("u_baseline_m", "0.0005", "ft")).toBe("0.00164");
    expect(typed("u_baseline_m", "0.00164", "ft")).toBe("0.0005");
  });

  it("leave angles, pixels and what is no number alone", () => {
    expect(typed("direction_deg", "30", "ft")).toBe("30");
    expect(shown("sigma_px", "1", "ft")).toBe("1");
    expect(shown("distance_m", "x", "ft")).toBe("x");
    expect(typed("distance_m", "three", "m")).toBeNull();
    expect(typed("board_distance_m", " ", "m")).toBe("");
  });
});

describe("the values of a line rate", () => {
  const rig = { baseline_m: 1.2, u_baseline_m: 0.001, line_rate_hz: 5000 } as unknown as Scan["rig"];

  it("come from the survey's newest rig unless the address says otherwise", () => {
    expect(completedLines({}, [{ rig }])).toMatchObject({ baseline_m: "1.2", line_rate_hz: "5000" });
    const said = valuesOf(new URLSearchParams("baseline_m=2&speed_mps=20"), LINE_NAMES);
    const values = completedLines(said, [{ rig }]);
    expect(values).toMatchObject({ baseline_m: "2", speed_mps: "20", error: "0.01" });
    expect(values.line_rate_hz).toBeUndefined();
  });

  it("are shown in km/h or mph and per cent", () => {
    expect(shown("speed_mps", "25", "m")).toBe("90");
    expect(shown("speed_mps", "44.704", "ft")).toBe("100");
    expect(typed("speed_mps", "90", "m")).toBe("25");
    expect(typed("speed_mps", "100", "ft")).toBe("44.704");
    expect(shown("error", "0.013", "m")).toBe("1.3");
    expect(typed("error", "1.3", "m")).toBe("0.013");
  });
});
