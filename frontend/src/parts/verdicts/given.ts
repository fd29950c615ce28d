/** Verdicts as values that can be put back: in the place of one's own, on what was looked at when it was given. */
import { ApiError } from "../../core/api";
import { type Ledger, StepOvertaken } from "../../core/history";
import { say } from "../../core/messages";
import { sameValue } from "../../core/same";
import { me } from "../../core/session";
import type { Review, Stands, Verdict } from "./kind";

/** As it stands, with what it was given on and by whom: only one's own is taken back or given again. */
type Given<W extends Verdict> = Pick<W, "verdict" | "reason"> & {
  readonly of?: Stands["of"] | null;
  readonly by?: number | null;
};

interface Judged<W extends Verdict> {
  /** The review that stands; what is kept here stands as one's own. */
  stands(id: number): Stands | null;
  /** Answers the review that stands then; null where nothing is there to be judged. */
  give(id: number, want: Pick<W, "verdict" | "reason">): Promise<Review | null>;
  /** Another's verdict, or another measurement, came before: nothing is left to send, and what stands is shown. */
  overtaken(id: number): Promise<void>;
}

/** What waits for a verdict is written as reopened, by nobody. */
export function verdictLedger<W extends Verdict>(judged: Judged<W>): Ledger<number, Given<W>> {
  const read = (id: number): Given<W> => {
    const { of = null, review } = judged.stands(id) ?? {};
    if (!review || isWaiting({ review })) return { verdict: "reopened", reason: null, of, by: null };
    const { verdict, reason, reviewer } = review;
    return { verdict: verdict as W["verdict"], reason, of, by: reviewer?.id ?? null };
  };
  return {
    read,
    async write(id, value, left) {
      const { verdict, reason } = value;
      const giving = () => judged.give(id, { verdict, reason });
      if (!left) return void (await giving());
      const stands = judged.stands(id);
      if (!stands || isOthers(stands.review) || !sameValue(read(id), left))
        throw new StepOvertaken(say("review-step-overtaken"));
      if (verdict !== "reopened" && (verdict === "fixed" || value.by !== me.value?.person.id))
        throw new StepOvertaken(say("review-step-not-again"));
      const given = await giving().catch((error: unknown) => {
        if (error instanceof ApiError && error.status === 409) return null;
        throw error;
      });
      if (given && !isOthers(given)) return;
      await judged.overtaken(id);
      throw new StepOvertaken(say("review-step-overtaken"));
    },
  };
}

/** One's own verdict, as it stands once it is stored. */
export function ownReview({ verdict, reason }: Verdict): Review {
  const reviewer = me.value ? { id: me.value.person.id, name: me.value.person.name } : null;
  return { verdict, reason, reviewer, at: null, lot_id: null };
}

/** True while nobody has said anything of what stands; what was reopened waits again. */
export function isWaiting({ review }: { review: Review }): boolean {
  return review.verdict === "to_review" || review.verdict === "reopened";
}

function isOthers({ reviewer }: Review): boolean {
  return reviewer !== null && reviewer.id !== me.value?.person.id;
}
