import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import { lengthUnit } from "../../core/units";
import { trendWords } from "./ErrorFigures";
import type { Errors, OfTarget } from "./model";
import { Percentiles } from "./TargetSection";

afterEach(() => {
  render(null, document.body);
  lengthUnit.value = "m";
});

it("why a percentile has no interval is said of the one that is shown", () => {
  const reason = { code: "stat-true-heights-alike", values: {}, message: "the heights are all the same" };
  const known = { percent: 50, value: 1.2, low: 1.2, high: 1.2, needs: 6, reason: null };
  const own = { percent: 50, value: 1.2, raw: 1.2, U95_low: null, U95_high: null, needs: 6, reason };
  const of = { n: 200, percentiles: [known] };
  const total = {
    n: 200,
    percentiles: [own],
    words: { code: "stat-holds", values: {}, message: "sampling" },
  };
  const target = { target: "driver_eye", raw: of, corrected: of, total } as unknown as OfTarget;
  render(<Percentiles target={target} />, document.body);
  expect(document.body.textContent).toContain("the heights are all the same");
});

it("a slope in inches per foot is as fine as one in millimetres per metre", () => {
  const trend = { slope: -0.0043, slope_ci95: { low: -0.0081, high: -0.0005 }, correlation: -0.3 };
  const errors = { trend, absolute_trend: { reason: null } } as unknown as Errors;
  const said = () => trendWords(errors).replace(/\s/g, " ");
  expect(said()).toContain("−4.3 mm per m (−8.1 to −0.5)");
  lengthUnit.value = "ft";
  expect(said()).toContain("−0.052 in per ft (−0.097 to −0.006)");
});
