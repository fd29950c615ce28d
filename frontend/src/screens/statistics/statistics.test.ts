import { afterEach, describe, expect, it } from "vitest";
import { changed } from "../../core/address";
import { address } from "../../core/api";
import type { Standard } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { csvOf } from "../../parts/figures/csv";
import { type Hue, hueOf } from "../../parts/figures/hues";
import { resolved } from "../../parts/figures/svg";
import { narrowed, statisticsQuery } from "./filters";
import { problemOfRow, rowOf, standardOf } from "./StandardsEditor";

describe("the address", () => {
  it("goes to the server without what only the page knows", () => {
    const at = new URLSearchParams(
      "survey=1&survey=3&lighting=daytime&off=driver_eye:France:1&eye_limit_m=1.1&x=2",
    );
    const asked = (query: URLSearchParams) => address("/statistics", statisticsQuery(query));
    expect(asked(at)).toBe("/statistics?survey=1&survey=3&eye_limit_m=1.1&lighting=daytime");
    expect(asked(new URLSearchParams())).toBe("/statistics");
    expect(asked(new URLSearchParams("rounding=cm"))).toBe("/statistics?rounding=cm");
  });

  it("changes one value and keeps the others", () => {
    const at = new URLSearchParams("survey=1&state=all");
    expect(changed(at, { survey: ["1", "2"], state: null }).toString()).toBe("survey=1&survey=2");
    expect(narrowed(at)).toBe(true);
    expect(narrowed(new URLSearchParams("survey=1"))).toBe(false);
  });
});

describe("the table of standards", () => {
  afterEach(() => {
    lengthUnit.value = "m";
  });

  it("keeps to the last digit what nobody typed, in feet too", () => {
    const one = { name: "F", what: "vehicle", height_m: 1.315, year: 1998, percent: 10 } as Standard;
    lengthUnit.value = "ft";
    expect(standardOf(rowOf(one))).toEqual(one);
    expect(standardOf({ ...rowOf(one), height: "3.5" }).height_m).toBeCloseTo(1.0668, 9);
  });
});

it("a standard whose year or percentile is no number is not saved without it", () => {
  const row = rowOf({ name: "F", what: "vehicle", height_m: 1.315, year: 1998, percent: 10 } as Standard);
  expect(problemOfRow(row)).toBeNull();
  expect(problemOfRow({ ...row, year: "", percent: " " })).toBeNull();
  expect(problemOfRow({ ...row, year: "19x8" })).toContain("four digits");
  expect(problemOfRow({ ...row, percent: "ten" })).toContain("Enter a number");
  expect(problemOfRow({ ...row, height: "tall" })).toContain("Enter the height");
});

describe("CSV", () => {
  it("follows RFC 4180 and runs no formula", () => {
    const text = csvOf(
      ["site", "height_m"],
      [
        ['a "b", c', -1.5],
        ["=1+1", null],
      ],
    );
    expect(text).toBe('site,height_m\r\n"a ""b"", c",-1.5\r\n\'=1+1,\r\n');
  });
});

it("an SVG of its own knows none of the page's variables", () => {
  expect(resolved('stroke="var(--ink)" fill="var(--unknown)"')).toBe('stroke="#1a1b18" fill="currentColor"');
});

it("neighbouring curves differ in hue, and no two of six look the same", () => {
  const look = (i: number) => `${hueOf({ hue: (i % 3) as Hue })} ${i < 3}`;
  const six = [0, 1, 2, 3, 4, 5].map(look);
  expect(new Set(six).size).toBe(6);
  expect(hueOf({ hue: 1, faint: true })).toBe(hueOf({ faint: true }));
});
