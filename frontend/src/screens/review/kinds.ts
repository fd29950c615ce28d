/** How the outbox brings a verdict on a measurement to the server. */
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { type Kind, outbox } from "../../core/outbox";
import { shapeOf } from "../../core/shape";
import type { LineHeight, Measurement, ReviewItem, Verdict } from "../../core/types";
import { STATE_WORDS } from "../../core/words";

export const VERDICT = "verdict";

/** A height of a frame, or of a line of a line scan. */
export type Height = ReviewItem["measurement"];

export function isOfFrame(m: Height): m is Measurement {
  return "recording_id" in m;
}

export function isOfLine(m: Height): m is LineHeight {
  return !isOfFrame(m);
}

const isHeight = shapeOf<Height>({
  id: "number",
  revision: "number",
  target: "string",
  contact: "list",
  target_point: "list",
  review: "object",
});

export interface GivenVerdict {
  readonly verdict: "accepted" | "rejected" | "fixed" | "reopened";
  readonly reason: string | null;
  /** Where a fix puts the points. */
  readonly points: {
    readonly contact: [number, number];
    readonly target_point: [number, number];
    readonly frame: number;
  } | null;
}

export interface VerdictAbout {
  readonly id: number;
  /** The revision that was seen: a verdict never holds for points that nobody has looked at. */
  readonly revision: number;
  /** Who gives it. */
  readonly by: number;
}

const verdictKind: Kind<Height, GivenVerdict, VerdictAbout> = {
  once: true,
  send({ about, saved, want: { verdict, reason, points } }, sending) {
    const seen = saved ? { seen: saved.review.verdict } : {};
    const body = { revision: about.revision, verdict, ...seen, ...(reason ? { reason } : {}), ...points };
    return api.write(
      "POST /measurements/{measurement_id}/reviews",
      { measurement_id: about.id },
      { body, ...sending },
    );
  },
  read: ({ about: { id } }, _error, signal) => readHeight(id, signal),
  isSaved: isHeight,
  done({ about, saved, want }) {
    const review = saved?.review;
    // what waits needs no reopening: a verdict that was taken back before it was sent
    if (want.verdict === "reopened" && review?.verdict === "to_review") return true;
    if (review?.verdict !== want.verdict || review.reviewer?.id !== about.by) return false;
    return (review.reason ?? null) === want.reason && (!want.points || fits(saved as Height, want.points));
  },
  version: (saved) => (saved ? `${saved.revision} ${saved.review.verdict} ${saved.review.at}` : ""),
  words: (saved) =>
    saved?.review.reviewer
      ? say("review-verdict-by", {
          verdict: STATE_WORDS[saved.review.verdict as Verdict],
          person: saved.review.reviewer.name,
        })
      : say("review-verdict-none"),
};

/** The newest revision. */
export async function readHeight(measurement_id: number, signal?: AbortSignal): Promise<Height | null> {
  const route = "GET /measurements/{measurement_id}/history";
  const { revisions } = await api.ask(route, { measurement_id }, signal ? { signal } : {});
  return revisions.at(-1) ?? null;
}

function fits(saved: Height, points: NonNullable<GivenVerdict["points"]>): boolean {
  const { contact, target_point } = points;
  return `${saved.contact} ${saved.target_point}` === `${contact} ${target_point}`;
}

outbox.register(VERDICT, verdictKind);
