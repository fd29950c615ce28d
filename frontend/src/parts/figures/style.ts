/** What all figures share: margins, type, and axes with their name in the middle below and at the top left, without arrows. */
import { numbersIn } from "../../core/units";

type Plot = typeof import("./plot");
export type PlotOptions = Parameters<Plot["plot"]>[0] & object;

const ACROSS = { labelArrow: "none", labelAnchor: "center", labelOffset: 34 } as const;
const UP = { labelArrow: "none", grid: true } as const;

/** A tick that is a number; those of a time stay. */
const NUMBER = /^[−-]?\d[\d,]*(\.\d+)?$/;

/** A figure in the one style, as one picture for those who do not see it; its axes' numbers as the language writes them. */
export function figureOf(plot: Plot, options: PlotOptions, height: number): ReturnType<Plot["plot"]> {
  const drawn = plot.plot(inOneStyle(options, height));
  drawn.setAttribute("role", "img");
  for (const tick of drawn.querySelectorAll('g[aria-label$="axis tick label"] text')) {
    const text = tick.textContent ?? "";
    if (NUMBER.test(text) && tick.childElementCount === 0) tick.textContent = numbersIn(text);
  }
  for (const part of drawn.querySelectorAll("g[aria-label]")) part.removeAttribute("aria-label"); // one picture
  return drawn;
}

/** The options with what all figures share; `height` unless they say their own. */
export function inOneStyle(options: PlotOptions, height: number): PlotOptions {
  return {
    height,
    marginLeft: 48,
    marginBottom: 40,
    marginTop: 24,
    marginRight: 16,
    className: "figure",
    style: { background: "transparent", color: "var(--ink)", fontSize: "12px", fontFamily: "var(--font)" },
    ...options,
    x: { ...ACROSS, ...options.x },
    y: { ...UP, ...options.y },
  };
}
