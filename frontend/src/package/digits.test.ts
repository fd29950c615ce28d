import { expect, it } from "vitest";
import { fixed, shown, shownHeight } from "./digits";

it("prints heights to the millimetre, errors and u to a tenth of one", () => {
  const rule = {
    height_m: "1.085593",
    difference_m: "0.005593",
    percent: "10.0",
    standard: "'=1+1",
    n: "92",
  };
  const cells = Object.keys(rule).map((name) => shown("statistics/same_rule.csv", name, rule));
  expect(cells).toEqual(["1.086", "0.0056", "10", "=1+1", "92"]);
  const bias = { figure: "bias_m", value: "0.016100000000000007", low: "", n: "100" };
  expect(shown("statistics/error_table.csv", "value", bias)).toBe("0.0161");
  const square = { figure: "mse_m2", value: "1.2e-5" };
  expect(shown("statistics/error_table.csv", "value", square)).toBe("0.000012");
  expect(shown("statistics/total_uncertainty.csv", "value", { figure: "percentile", value: "1.0865" })).toBe(
    "1.087",
  );
  expect(shown("surveys.csv", "latitude_deg", { latitude_deg: "49.443232" })).toBe("49.44323");
  expect(shown("surveys.csv", "longitude_deg", { longitude_deg: "-1.099971" })).toBe("-1.09997");
  expect(shown("insets.csv", "u_inset_m", { u_inset_m: "0.100000" })).toBe("0.1000");
});

it("rounds halves of a number's fewest digits away from zero, as reports and pages do", () => {
  expect(["1.1475", "1.0005", "1.2345"].map(shownHeight)).toEqual(["1.148", "1.001", "1.235"]);
  const row = { height_m: "1.147500", u_height_m: "0.00525" };
  expect(shown("measurements.csv", "height_m", row)).toBe("1.148");
  expect(shown("measurements.csv", "u_height_m", row)).toBe("0.0053");
  expect([fixed(-1.1475, 3), fixed(-0.0004, 3), fixed(12345.5, 0)]).toEqual(["-1.148", "0.000", "12346"]);
});
