/** A verdict on its way to the server: on a height, or on the motion of a vehicle in a line scan. */
import { say } from "../../core/messages";
import type { Kind, Sending, Wish } from "../../core/outbox";
import type { LineHeight } from "../../core/types";
import { STATE_WORDS } from "../../core/words";

export type Review = LineHeight["review"];

/** The review of what stands, and the name of what it was given on: another one was judged by nobody yet. */
export interface Stands {
  readonly of: string | number;
  readonly review: Review;
}

export interface Verdict {
  readonly verdict: "accepted" | "rejected" | "fixed" | "reopened";
  readonly reason: string | null;
}

interface By {
  readonly by: number;
}

/** What is sent: the verdict, and the one that was seen, with its time: another of the same word is not that one. */
interface VerdictBody<W extends Verdict> {
  verdict: W["verdict"];
  seen?: Review["verdict"];
  seen_at?: string;
  reason?: string;
}

interface Judged<S, W extends Verdict, A> extends Pick<Kind<S, W, A>, "read" | "isSaved"> {
  send(wish: Wish<S, W, A>, body: VerdictBody<W>, sending: Sending): Promise<S>;
  review(saved: S): Stands | null;
  /** Whether a review stands on what this verdict is about. */
  isOn(saved: S, wish: Wish<S, W, A>): boolean;
}

export function verdictKind<S, W extends Verdict, A extends By>(judged: Judged<S, W, A>): Kind<S, W, A> {
  const reviewOf = (saved: S | null) => saved && judged.review(saved);
  return {
    once: true,
    read: judged.read,
    isSaved: judged.isSaved,
    send(wish, sending) {
      const { verdict, reason } = wish.want;
      const { verdict: seen, at } = reviewOf(wish.saved)?.review ?? {};
      const inPlace = { ...(seen && { seen }), ...(at && { seen_at: at }) };
      return judged.send(wish, { verdict, ...inPlace, ...(reason && { reason }) }, sending);
    },
    done(wish) {
      const review = reviewOf(wish.saved)?.review;
      return !!review && isGiven(review, wish.want, wish.about.by) && judged.isOn(wish.saved as S, wish);
    },
    version(saved) {
      const now = reviewOf(saved);
      return now ? `${now.of} ${now.review.verdict} ${now.review.at}` : "";
    },
    words(saved) {
      const review = reviewOf(saved)?.review;
      if (!review?.reviewer) return say("review-verdict-none");
      return say("review-verdict-by", { verdict: verdictWord(review), person: review.reviewer.name });
    },
  };
}

/** By this person; what waits for a verdict need not be reopened, whoever left it so. */
function isGiven({ verdict, reason, reviewer }: Review, want: Verdict, by: number): boolean {
  if (want.verdict === "reopened") return verdict === "reopened" || verdict === "to_review";
  return verdict === want.verdict && (reason ?? null) === want.reason && reviewer?.id === by;
}

/** What was wanted, as it reads beside what another gave meanwhile. */
export function verdictWords(want: Verdict): string {
  const verdict = verdictWord(want);
  return want.reason ? say("review-verdict-reason", { verdict, reason: want.reason }) : verdict;
}

function verdictWord({ verdict }: Pick<Review, "verdict">): string {
  return STATE_WORDS[verdict as keyof typeof STATE_WORDS];
}
