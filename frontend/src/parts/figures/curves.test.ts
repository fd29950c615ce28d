import { describe, expect, it } from "vitest";
import { speak } from "../../core/messages";
import type { Density, Ecdf, Standard } from "../../core/types";
import {
  aroundOne,
  densityMarks,
  ecdfMarks,
  noBandWords,
  shareStep,
  standardAxes,
  standardMarks,
  standardTiers,
} from "./curves";
import type { Plot } from "./PlotFigure";
import * as library from "./plot";
import { figureOf, inOneStyle } from "./style";

const standard = (name: string, height_m: number) => ({ name, height_m, what: "eye_car" }) as Standard;
const FOUR = [
  standard("A", 1.08),
  standard("B", 1.0),
  standard("C", 1.1),
  standard("D", 1.1),
  standard("E", 1.55),
];

/** What is drawn, in place of drawing it. */
const drawn: { kind: string; data: unknown; options: Record<string, unknown> }[] = [];
const plot = new Proxy({} as Plot, {
  get: (_, kind: string) => (data: unknown, options: Record<string, unknown>) => {
    drawn.push({ kind, data, options });
    return {};
  },
});

describe("the names of standards", () => {
  it("have a line for each height, and no rule crosses a name on its side", () => {
    const tiers = standardTiers(FOUR, 1, "m", 1.3);
    expect(tiers.map((one) => one.x)).toEqual([1.0, 1.08, 1.1, 1.55]);
    expect(tiers.map((one) => one.way)).toEqual(["start", "start", "start", "end"]);
    drawn.length = 0;
    standardMarks(plot, tiers);
    const tops = drawn.filter((one) => one.kind === "text").map((one) => one.options["dy"] as number);
    const rules = drawn.filter((one) => one.kind === "ruleX").map((one) => one.options["insetTop"] as number);
    expect(new Set(tops).size).toBe(4);
    expect(rules).toEqual(tops); // each rule goes up to its own name
    expect([...tops].sort((a, b) => a - b)).toEqual(tops); // and those to its right end below it
    expect(standardAxes(tiers, "m").marginTop).toBeGreaterThan(-Math.min(...tops));
  });

  it("have the third decimal that their metres have", () => {
    const words = standardTiers([standard("A", 1.08), standard("F", 1.315)], 1, "m", 1.3);
    expect(words.map((one) => one.word.split(/\s/)[1])).toEqual(["1.08", "1.315"]);
  });
});

describe("curves", () => {
  it("say a density in per cent of the vehicles a step that an engineer reads", () => {
    const density = { value: [1, 1.01], density: [4, 4], low: [3, 3], high: [5, 5], n: 9, bandwidth: 1 };
    drawn.length = 0;
    densityMarks(plot, density as Density, { word: "" }, 1, shareStep("m").m);
    const [first] = (drawn[0]?.data ?? []) as { y: number }[];
    expect(first?.y).toBeCloseTo(4); // 4 a metre: 4 % in each centimetre
    expect(shareStep("ft")).toEqual({ m: 0.0254, name: "in" });
  });

  it("has an axis of some width about one value alone", () => {
    expect(aroundOne([63.4, Number.NaN, 63.4])).toEqual({ domain: [50, 70] });
    expect(aroundOne([4.66])).toEqual({ domain: [4, 6] });
    expect(aroundOne([0])).toEqual({ domain: [0, 1] });
    expect(aroundOne([-0.31])).toEqual({ domain: [expect.closeTo(-0.4), expect.closeTo(-0.2)] });
    expect(aroundOne([63.4, 63.5])).toEqual({});
  });

  it("have no band where there are too few for one", () => {
    expect([noBandWords(29), noBandWords(30)]).toEqual([expect.stringContaining("29"), null]);
    const ecdf = (n: number) => ({ value: [1], share: [1], low: [0], high: [1], n }) as Ecdf;
    for (const [n, kinds] of [
      [29, ["line"]],
      [30, ["areaY", "line"]],
    ] as const) {
      drawn.length = 0;
      ecdfMarks(plot, ecdf(n), { word: "", band: true }, 1);
      expect(drawn.map((one) => one.kind)).toEqual(kinds);
    }
  });
});

describe("all figures", () => {
  it("have their axes in one style, whatever they say of them", () => {
    const styled = inOneStyle({ x: { label: "speed (km/h)", nice: true }, marks: [] }, 300);
    expect(styled.x).toMatchObject({ label: "speed (km/h)", labelArrow: "none", labelAnchor: "center" });
    expect(styled.y).toMatchObject({ labelArrow: "none", grid: true });
    expect(styled.height).toBe(300);
  });

  it("have the numbers of their axes as the language writes them", async () => {
    await speak("fr");
    const options = { document, x: { domain: [0, 1] }, y: { domain: [0, 1] }, marks: [] };
    const drawn = figureOf(library, options, 300);
    const times = { domain: [new Date("2025-05-14T08:09:05Z"), new Date("2025-05-14T08:09:25Z")] };
    const timed = figureOf(library, { document, x: times, marks: [] }, 300);
    await speak("en");
    const ticks = [...drawn.querySelectorAll("text")].map((one) => one.textContent);
    expect(ticks).toContain("0,2");
    expect(ticks.join()).not.toContain(".");
    expect([...timed.querySelectorAll("text")].some((one) => one.textContent?.includes(":"))).toBe(true);
    expect(timed.querySelectorAll("tspan").length).toBeGreaterThan(0);
  });
});
