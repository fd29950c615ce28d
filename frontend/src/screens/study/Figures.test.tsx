import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import type { StudyResult } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { Figures, Percentiles } from "./Figures";

afterEach(() => render(null, document.body));

it("a percentile without a value takes none of the others away", () => {
  const values = { percent: 2.5, needed: 146, count: 50 };
  const few = { code: "stat-percentile-needs", values, message: "P2.5 needs 146; there are 50" };
  const row = { target: "driver_eye", n: 50, low_m: null, high_m: null };
  const figures = [
    { ...row, figure: "percentile", percent: 2.5, value_m: null, reason: few },
    { ...row, figure: "percentile", percent: 50, value_m: 1.172, reason: null },
    { ...row, figure: "mean", percent: null, value_m: 1.181, reason: null },
    { ...row, target: "roof", n: 1, figure: "mean", value_m: null, reason: few },
  ];
  const found = { figures } as unknown as StudyResult["found"];
  render(<Percentiles found={found} targets={["driver_eye", "roof"]} />, document.body);
  const [eyes, roofs] = [...document.querySelectorAll("tbody tr")].map((one) => one.textContent);
  expect(eyes).toMatch(/–.*1\.172.*1\.181/);
  expect(eyes).not.toContain("needs 146");
  expect(roofs).toContain("needs 146");
});

it("counts the sites that the heights are of, whatever the study joins now", () => {
  const packages = [{ site: "Rouen" }, { site: "Rouen" }, { site: "Caen" }];
  const none = { figures: [], rules: [], years: [], curves: [], errors: [], classes: [], plan: [] };
  const found = { ...none, consequence: null, packages, heights: 30, vehicles: 20 };
  render(<Figures found={found as unknown as StudyResult["found"]} />, document.body);
  const counted = document.querySelector("[data-testid=study-counted]")?.textContent;
  expect(counted).toBe("30 accepted heights of 20 vehicles at 2 sites.");
});

it("says what heights change on the road in the reader's unit", () => {
  const none = { figures: [], rules: [], years: [], curves: [], errors: [], classes: [], plan: [] };
  const packages = [{ site: "Rouen" }];
  const consequence = { m: "eye 1.080 m", ft: "eye 3.543 ft" };
  const told = (said: object) => {
    const found = { ...none, consequence: said, packages, heights: 30, vehicles: 20 };
    render(<Figures found={found as unknown as StudyResult["found"]} />, document.body);
    return document.querySelector("[data-testid=study-consequence]")?.textContent;
  };
  lengthUnit.value = "ft";
  expect(told(consequence)).toBe("eye 3.543 ft");
  expect(told({ m: "eye 1.080 m" })).toBe("eye 1.080 m"); // a result of an earlier version
  lengthUnit.value = "m";
  expect(told(consequence)).toBe("eye 1.080 m");
});
