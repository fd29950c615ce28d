import { apart, say } from "../../core/messages";
import type { ScanStatistics } from "../../core/types";

/** Why a vehicle that was found is in no figure, in the order in which it is said. */
const LEFT_OUT = {
  to_review: (count: number) => say("motion-left-to_review", { count }),
  rejected: (count: number) => say("motion-left-rejected", { count }),
  not_measurable: (count: number) => say("motion-left-not_measurable", { count }),
};

/** "7 of 9 vehicles in 2 line scans; 2 wait for review.": how the figures agree with those of the Overview. */
export function countedWords(
  found: Pick<ScanStatistics, "counted" | "scans">,
  acceptedOnly: boolean,
): string {
  const { used = 0, vehicles: all = used } = found.counted;
  if (used === all) return say("motion-counted", { vehicles: used, scans: found.scans });
  const reasons = Object.entries(LEFT_OUT).flatMap(([state, words]) => {
    const count = state === "to_review" && !acceptedOnly ? 0 : (found.counted[state] ?? 0);
    return count > 0 ? [words(count)] : [];
  });
  return say("motion-counted-of", { vehicles: used, all, scans: found.scans, left: apart(reasons) });
}
