/** What a pass's frames may be; the server checks the end of the recording. */
import { say } from "../../core/messages";
import type { Vehicle } from "../../core/types";

export type SpanEnd = "first_frame" | "best_frame" | "last_frame";
export type Span = Pick<Vehicle, SpanEnd>;

/** What is wrong with a frame number for one end of a span, in a sentence, or null. */
export function spanProblem(span: Span, end: SpanEnd, text: string): string | null {
  if (text === "" && end === "best_frame") return null;
  if (!/^\d{1,9}$/.test(text)) return say("measure-span-frame-problem");
  const changed = { ...span, [end]: Number(text) };
  const { first_frame: first, best_frame: best, last_frame: last } = changed;
  const ends = { first_frame: String(first), last_frame: String(last) };
  if (first > last) return say("measure-span-order", ends);
  if (best === null || (best >= first && best <= last)) return null;
  return end === "best_frame"
    ? say("measure-span-choose", ends)
    : say("measure-span-move-best", { best_frame: String(best) });
}
