/** What all figures share: margins, type, and axes with their name in the middle below and at the top left, without arrows. */
type Plot = typeof import("./plot");
export type PlotOptions = Parameters<Plot["plot"]>[0] & object;

const ACROSS = { labelArrow: "none", labelAnchor: "center", labelOffset: 34 } as const;
const UP = { labelArrow: "none", grid: true } as const;

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
