/** The hues of curves: apart for every eye, and none of the road's axes'. */
export type Hue = 0 | 1 | 2;
const HUES = ["var(--ink)", "var(--curve-2)", "var(--curve-3)"] as const;

export function hueOf({ faint, hue = 0 }: { faint?: boolean; hue?: Hue }): string {
  return faint ? "var(--ink-3)" : HUES[hue];
}

/** Of a curve's word: as the curve, but never fainter than text may be. */
export function inkOf(curve: { faint?: boolean; hue?: Hue }): string {
  return curve.faint ? "var(--ink-2)" : hueOf(curve);
}
