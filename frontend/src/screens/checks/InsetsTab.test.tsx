import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import type { InsetCheck } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { Explanation, insetWithU } from "./InsetsTab";

afterEach(() => {
  render(null, document.body);
  lengthUnit.value = "m";
});

it("an inset that many vehicles tell is not said to be exact", () => {
  expect(insetWithU({ inset_m: 0.2314, u_inset_m: 0.0041 })).toMatch(/^0\.231\sm \(u\s=\s0\.004\sm\)$/);
});

it("what a missing inset does is said of the distance that it was computed for, in feet too", () => {
  const cases = [
    { target: "driver_eye", place: null, height_m: 1.16, inset_m: 0.45, bias_m: [0.062, 0.044] },
  ];
  const check = { camera_height_m: 1.5, cases_at_m: [2, 3], cases } as unknown as InsetCheck;
  const heads = (unit: "m" | "ft") => {
    lengthUnit.value = unit;
    render(null, document.body);
    render(<Explanation check={check} />, document.body);
    return [...document.querySelectorAll("thead th")].map((one) => one.textContent ?? "").join("|");
  };
  expect(heads("m")).toMatch(/2\sm\|.*3\sm/);
  expect(heads("ft")).toMatch(/6\.6\sft\|.*9\.8\sft/);
});
