/** Which measurements of a survey are out of date, as the notice on a page last read it. */
import { signal } from "@preact/signals";
import { say } from "../../core/messages";
import type { OutOfDate } from "../../core/types";
import { CAUSES } from "./words";

export const stale = signal<{ surveyId: number; found: OutOfDate } | null>(null);

/** Why a height is out of date, as sentences; none where it is not. */
export function staleWords(measurementId: number | undefined): string[] {
  const causes = measurementId === undefined ? [] : (stale.value?.found.measurements[measurementId] ?? []);
  return CAUSES.filter((cause) => causes.includes(cause)).map((cause) => say(`computing-mark-${cause}`));
}
