/** What heights were, or have to be, computed again for. */
import { allOf, say } from "../../core/messages";
import type { OutOfDate } from "../../core/types";

export const CAUSES = ["pose", "inset", "side", "program"] as const;

/** "12 by another inset and 3 by another road pose" */
export function causesInWords(causes: OutOfDate["causes"]): string {
  const there = CAUSES.filter((cause) => causes[cause]);
  return allOf(there.map((cause) => say(`computing-cause-${cause}`, { count: causes[cause] ?? 0 })));
}
