/** What a pass's frames may be; the server checks the end of the recording. */
import type { Vehicle } from "../../core/types";

export type SpanEnd = "first_frame" | "best_frame" | "last_frame";
export type Span = Pick<Vehicle, SpanEnd>;

/** What is wrong with a frame number for one end of a span, in a sentence, or null. */
export function spanProblem(span: Span, end: SpanEnd, text: string): string | null {
  if (text === "" && end === "best_frame") return null;
  if (!/^\d{1,9}$/.test(text)) return "Give a frame number.";
  const changed = { ...span, [end]: Number(text) };
  const { first_frame: first, best_frame: best, last_frame: last } = changed;
  if (first > last) return `${first} is after ${last}.`;
  if (best === null || (best >= first && best <= last)) return null;
  return end === "best_frame" ? `Choose ${first} to ${last}.` : `Move best (${best}) first.`;
}
