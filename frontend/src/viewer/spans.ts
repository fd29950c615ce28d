/** Spans of frames on the timeline, and what is drawn of them where there are more than have room. */
import { say } from "../core/messages";

export interface Span {
  readonly id: string;
  readonly first: number;
  readonly last: number;
  readonly label: string;
  readonly title: string;
  readonly kind: "todo" | "done" | "current" | "board" | "followed" | "dropped";
}

const LABEL_PX = 24;
/** Nearer than this two bars look like one. */
const GAP_PX = 2;

/**
 * The spans to draw on a strip of `width_px` for `count` frames. While each has room for its label on average they
 * are drawn as they are; a day's thousands are drawn as bars over those of one kind that touch or overlap, for as
 * many elements would slow down every frame that the page draws. What is current is never put together.
 */
export function drawnSpans(spans: readonly Span[], count: number, width_px: number): readonly Span[] {
  if (count < 1 || spans.length * LABEL_PX <= width_px) return spans;
  const gap = (GAP_PX * count) / Math.max(1, width_px);
  const apart = spans.filter((span) => span.kind !== "todo" && span.kind !== "done");
  const todo = together(spans, "todo", gap);
  const done = together(spans, "done", gap);
  return [...done, ...todo, ...apart]; // what is open lies above what is done
}

function together(spans: readonly Span[], kind: Span["kind"], gap: number): Span[] {
  const sorted = spans.filter((span) => span.kind === kind).sort((a, b) => a.first - b.first);
  const bars: { first: Span; last: number; count: number }[] = [];
  for (const span of sorted) {
    const bar = bars.at(-1);
    if (bar && span.first <= bar.last + gap) {
      bar.last = Math.max(bar.last, span.last);
      bar.count += 1;
    } else bars.push({ first: span, last: span.last, count: 1 });
  }
  return bars.map(({ first, last, count }) => (count === 1 ? first : barOf(first, last, count)));
}

function barOf({ id, first, kind }: Span, last: number, count: number): Span {
  const frames = { first_frame: String(first), last_frame: String(last) };
  return {
    id: `bar-${id}`,
    first,
    last,
    label: "",
    title: say("timeline-passes", { count, ...frames }),
    kind,
  };
}
