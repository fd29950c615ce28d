import { describe, expect, it } from "vitest";
import { formatAgo, formatDuration, formatFrameTime, formatPlaceTime, secondDigits } from "./times";

describe("times", () => {
  it("shows a position in a recording to the millisecond", () => {
    expect(formatFrameTime(42.8)).toBe("42.800 s");
    expect(formatFrameTime(182.8)).toBe("3:02.800");
    expect([59.9996, 119.9996].map(formatFrameTime)).toEqual(["1:00.000", "2:00.000"]);
  });

  it("shows lengths of time in words", () => {
    expect(formatDuration(4.26)).toBe("4.3 s");
    expect(formatDuration(200)).toBe("3 min 20 s");
    expect(formatDuration(3840)).toBe("1 h 04 min");
  });

  it("gives a time of day the decimals of its uncertainty", () => {
    expect([null, 0.0004, 0.0021, 0.021, 0.2, 3, 30].map(secondDigits)).toEqual([0, 3, 3, 3, 2, 1, 0]);
    expect(formatPlaceTime("2025-05-14T09:29:27.564+02:00", 3)).toBe("09:29:27.564");
    expect(formatPlaceTime("2025-05-14T09:29:27.564+02:00", 1)).toBe("09:29:27.6");
    expect(formatPlaceTime("2025-05-14T09:29:27+02:00", 0)).toBe("09:29:27");
  });

  it("says how long ago in short, then when", () => {
    const now = new Date("2026-11-21T12:00:00Z");
    expect(formatAgo("2026-11-21T11:59:30Z", now)).toBe("just now");
    expect(formatAgo("2026-11-21T11:56:00Z", now)).toBe("4 min ago");
    expect(formatAgo("2026-11-01T11:56:00Z", now)).toMatch(/1 Nov 2026/);
  });
});
