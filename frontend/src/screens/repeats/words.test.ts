import { describe, expect, it } from "vitest";
import { claimVerdict, pixelWords, shiftWords, spreadWords } from "./words";

const few = {
  sd: null,
  low: null,
  high: null,
  freedom: 2,
  reason: { code: "told", values: {}, message: "Too few repeats." },
};

describe("figures of repeats in words", () => {
  it("says a spread with its interval, and nothing where there is none", () => {
    const spread = { sd: 0.0041, low: 0.0032, high: 0.0156, freedom: 22, reason: null };
    expect(spreadWords(spread)).toEqual({ value: "4.1\u00a0mm", interval: "3.2 to 16\u00a0mm" });
    expect(spreadWords(few)).toBeNull();
    expect(pixelWords({ ...spread, sd: 0.62, low: 0.54, high: 0.72 })?.interval).toBe("0.54 to 0.72\u00a0px");
  });

  it("says a shift with its interval, and nothing where too few vehicles tell", () => {
    const shift = { shown: 90, free: 10, shown_m: 0.001, free_m: 0.0021, reason: null };
    expect(shiftWords({ ...shift, shift_m: -0.0011, U95_shift_m: 0.0024 })).toBe(
      "−1.1\u00a0±\u00a02.4\u00a0mm",
    );
    expect(shiftWords({ ...shift, shift_m: 0.0084, U95_shift_m: 0.0124 })).toBe("8\u00a0±\u00a012\u00a0mm");
    expect(shiftWords({ ...shift, shift_m: null, U95_shift_m: null })).toBeNull();
  });

  it("judges a claim by its interval, not by its value", () => {
    const claim = { claimed: 0.005, observed: 0.006, freedom: 24, reason: null };
    expect(claimVerdict({ ...claim, ratio: 1.2, low: 0.9, high: 1.6 })).toBe("as stated");
    expect(claimVerdict({ ...claim, ratio: 1.5, low: 1.1, high: 2.0 })).toBe("more than stated");
    expect(claimVerdict({ ...claim, ratio: 0.5, low: 0.4, high: 0.7 })).toBe("less than stated");
    const none = { ratio: null, low: null, high: null, claimed: null, observed: null, freedom: 1 };
    expect(claimVerdict({ ...none, reason: { code: "told", values: {}, message: "Too few." } })).toBe(
      "Too few.",
    );
  });
});
