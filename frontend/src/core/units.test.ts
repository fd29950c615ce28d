import { beforeEach, describe, expect, it, vi } from "vitest";
import { apart, sayCode, speak } from "./messages";
import {
  fixed,
  formatAcceleration,
  formatBytes,
  formatCount,
  formatHeight,
  formatLength,
  formatRung,
  formatSeconds,
  formatSmall,
  formatSpeed,
  heads,
  lengthUnit,
  localNumber,
  numbersIn,
  parseLength,
  parseNumber,
  parseSmall,
  plainAcceleration,
  plainLength,
  plainPercent,
  plainSpeed,
  smallText,
} from "./units";

beforeEach(() => {
  lengthUnit.value = "m";
});

describe("heights", () => {
  it("a drawn line is named with all digits of its height", () => {
    const said = () => [0.5, 1, 0.02].map((metres) => formatRung(metres).replace("\u00a0", " "));
    expect(said()).toEqual(["0.5 m", "1.0 m", "0.02 m"]);
    lengthUnit.value = "ft";
    expect(said()).toEqual(["1.64 ft", "3.28 ft", "0.07 ft"]);
  });

  it("reads as value ± U95 in metres", () => {
    expect(formatHeight(1.1718, 0.0179)).toBe("1.172\u00a0±\u00a00.018\u00a0m");
  });

  it("converts value and uncertainty to feet", () => {
    expect(formatHeight(0.3048, 0.03048, 3, "ft")).toBe("1.000\u00a0±\u00a00.100\u00a0ft");
  });

  it("follows the chosen unit", () => {
    lengthUnit.value = "ft";
    expect(formatLength(3.048)).toBe("10.000\u00a0ft");
  });

  it("never shows a missing value as a number", () => {
    expect(formatHeight(null, 0.01)).toBe("–");
    expect(formatLength(null)).toBe("–");
    expect(formatSmall(null)).toBe("–");
  });

  it("leaves the uncertainty out where it is unknown", () => {
    expect(formatHeight(1.5, null)).toBe("1.500\u00a0m");
  });

  it("never rounds an uncertainty to none", () => {
    expect(formatSeconds(1.65, 0.0003, 3)).toBe("1.650\u00a0±\u00a00.001\u00a0s");
    expect(formatHeight(1.5, 0)).toBe("1.500\u00a0±\u00a00.000\u00a0m");
  });
});

describe("numbers", () => {
  it("uses a true minus, and none for what rounds to zero", () => {
    expect(fixed(-0.12, 2)).toBe("−0.12");
    expect(fixed(-0.0004, 2)).toBe("0.00");
    // as reports print them (tests/export/report/test_figures.py), though 1.1475 in binary lies below the half
    expect([1.1475, 1.0005, 1.2345].map((value) => fixed(value, 3))).toEqual(["1.148", "1.001", "1.235"]);
    expect([2.15, 0.35].map((value) => fixed(value, 1))).toEqual(["2.2", "0.4"]);
  });

  it.each([
    ["1,5", 1.5],
    [" 1 000.25 ", 1000.25],
    ["−3", -3],
    [".5", 0.5],
    ["1e-3", 0.001],
  ])("reads %s", (text, value) => {
    expect(parseNumber(text)).toBe(value);
  });

  it.each(["", "abc", "1.2.3", "1,2,3", "--1", "0x10", "NaN", "Infinity"])("refuses %j", (text) => {
    expect(parseNumber(text)).toBeNull();
  });

  it("reads feet as metres when feet are shown", () => {
    lengthUnit.value = "ft";
    expect(parseLength("10")).toBeCloseTo(3.048, 12);
  });

  it("sets thousands apart from 10,000 on", () => {
    expect([1234, 9999, 1234567].map(formatCount)).toEqual(["1234", "9999", "1\u202f234\u202f567"]);
  });

  it("writes the small lengths of a server's sentence in the unit that is shown", async () => {
    const moved = { code: "height-flag-camera-moved-by", values: { moved_px: 2.5, error_m: 0.0254 } };
    await vi.waitFor(() => expect(sayCode(moved)).toContain("error up to 25\u00a0mm on the"));
    lengthUnit.value = "ft";
    expect(sayCode(moved)).toContain("error up to 1.00\u00a0in on the");
  });

  it("rounds bytes into the next unit rather than 1000 of the last", () => {
    expect(formatBytes(999)).toBe("999\u00a0B");
    expect(formatBytes(999_999)).toBe("1.0\u00a0MB");
    expect(formatBytes(14_200_000)).toBe("14.2\u00a0MB");
  });

  it("shows small lengths in millimetres or inches", () => {
    expect(formatSmall(0.018)).toBe("18\u00a0mm");
    expect(formatSmall(0.0042)).toBe("4.2\u00a0mm");
    expect(formatSmall(0.0254, "ft")).toBe("1.00\u00a0in");
  });
});

describe("speeds and accelerations", () => {
  it("are read in km/h and m/s², or in mph and ft/s²", () => {
    expect(formatSpeed(17.6, 0.05)).toBe("63.4\u00a0±\u00a00.2\u00a0km/h");
    expect(formatAcceleration(-1.4)).toBe("−1.40\u00a0m/s²");
    lengthUnit.value = "ft";
    expect(formatSpeed(17.6)).toBe("39.4\u00a0mph");
    expect(formatAcceleration(-1.4, 0.1)).toBe("−4.59\u00a0±\u00a00.33\u00a0ft/s²");
    expect([plainSpeed(17.6), plainLength(4.66), plainAcceleration(null)]).toEqual(["39.4", "15.29", "–"]);
    expect(heads()).toEqual({ speed: "mph", acceleration: "ft/s²", length: "ft" });
  });
});

describe("small lengths in fields", () => {
  it("are typed in millimetres, or in inches", () => {
    expect(smallText(0.0173)).toBe("17.3");
    expect(parseSmall("17,3")).toBeCloseTo(0.0173, 12);
    lengthUnit.value = "ft";
    expect(smallText(0.0254)).toBe("1");
    expect(parseSmall("0.5")).toBeCloseTo(0.0127, 12);
    expect(parseSmall("wide")).toBeNull();
    expect(smallText(null)).toBe("");
  });
});

describe("numbers and lists in another language", () => {
  it("have the language's decimal sign and the digits that they were written with", async () => {
    expect(numbersIn("−1.50")).toBe("−1.50");
    expect(apart(["a", "b", "c"])).toBe("a; b; c");
    await speak("fr");
    expect(numbersIn("0.278 V t + 0.039 V² / a")).toBe("0,278 V t + 0,039 V² / a");
    expect(numbersIn("−6,600.0 to 12,500.0")).toBe("−6600,0 to 12\u202f500,0");
    expect(plainPercent(2.5)).toBe("2,5");
    expect(formatBytes(14_200_000)).toBe("14,2\u00a0Mo");
    expect(apart(["a", "b", "c"])).toBe("a\u202f; b\u202f; c");
    await speak("en");
  });

  it("stand in a field with the language's sign, and are read with either", async () => {
    expect(localNumber("-0.5")).toBe("-0.5");
    await speak("fr");
    expect(localNumber("-0.5")).toBe("-0,5");
    expect(["0,5", "0.5"].map(parseNumber)).toEqual([0.5, 0.5]);
    expect(["12", "2026.11.28", "1.5 m", ""].map(localNumber)).toEqual(["12", "2026.11.28", "1.5 m", ""]);
    await speak("en");
  });
});
