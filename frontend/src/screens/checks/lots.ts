import { allOf, say, wordsOf } from "../../core/messages";
import type { PlannedLot, ShownLot } from "../../core/types";
import { LIGHTING_NOUNS, TARGET_NOUNS } from "../../core/words";

export const LOT_STATES: Readonly<Record<ShownLot["state"], string>> = wordsOf("lots-state-");

const LEFT: Readonly<Record<string, (count: number) => string>> = {
  measured_again: (count) => say("lots-left-measured_again", { count }),
  withdrawn: (count) => say("lots-left-withdrawn", { count }),
  vehicle_deleted: (count) => say("lots-left-vehicle_deleted", { count }),
  verdict_of_its_own: (count) => say("lots-left-verdict_of_its_own", { count }),
};

export function commonInWords({ target, lighting, operator, day }: PlannedLot["common"]): string {
  const parts = [target && TARGET_NOUNS[target], lighting && LIGHTING_NOUNS[lighting], operator?.name, day];
  return parts.filter(Boolean).join(", ") || say("lots-everything");
}

/** Why heights left a lot, each reason with its count; empty where none did. */
export function leftInWords({ progress }: ShownLot): string {
  const counts = Object.entries(progress.left);
  return allOf(counts.map(([why, count]) => LEFT[why]?.(count ?? 0) ?? why));
}
