import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import { say, speak } from "../../core/messages";
import type { ErrorsBody, Standard, TargetBody } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { trendWords } from "./ErrorFigures";
import { Percentiles, Shares } from "./TargetSection";

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
  const target = { target: "driver_eye", raw: of, corrected: of, total } as unknown as TargetBody;
  render(<Percentiles target={target} />, document.body);
  expect(document.body.textContent).toContain("the heights are all the same");
});

it("a slope in inches per foot is as fine as one in millimetres per metre", () => {
  const trend = { slope: -0.0043, slope_ci95: { low: -0.0081, high: -0.0005 }, correlation: -0.3 };
  const errors = { trend, absolute_trend: { reason: null } } as unknown as ErrorsBody;
  const said = () => trendWords(errors).replace(/\s/g, " ");
  expect(said()).toContain("−4.3 mm per m (−8.1 to −0.5)");
  lengthUnit.value = "ft";
  expect(said()).toContain("−0.052 in per ft (−0.097 to −0.006)");
});

it("the counts beside a share of true heights are said to be of the measured ones", () => {
  const standard = { name: "F", height_m: 1.1, code: null } as Standard;
  const one = { standard, share: 0.3, low: 0.2, high: 0.4, below: 60, n: 200 };
  const total = { shares: [{ value: 0.25, U95_low: 0.2, U95_high: 0.31 }] };
  const target = { target: "driver_eye", corrected: { shares: [one] }, total } as unknown as TargetBody;
  render(<Shares target={target} standards={[standard]} />, document.body);
  expect(document.body.textContent).toContain("measured heights: 60 of 200");
});

it("a note on groups says how many the table lists", () => {
  const told = say("statistics-groups-note", { count: 6, all: 40, listed: 24 });
  expect(told).toContain("the table lists 24");
});

it("percentiles without an interval are written as the language writes numbers", async () => {
  await speak("fr");
  const reason = { code: "x", values: {}, message: "trop peu" };
  const own = { percent: 2.5, value: 1.2, low: null, high: null, needs: 6, reason };
  const of = { n: 200, percentiles: [own] };
  const target = { target: "driver_eye", raw: of, corrected: of, total: null } as unknown as TargetBody;
  render(<Percentiles target={target} />, document.body);
  const told = document.querySelector("details li")?.textContent;
  await speak("en");
  expect(told).toContain("2,5");
});
