import { expect, it } from "vitest";
import { shown } from "./digits";

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
