/** Verdicts on their way to the server, each a value of its measurement that can be put back. */
import { ApiError } from "../../core/api";
import { type Ledger, StepOvertaken } from "../../core/history";
import { say } from "../../core/messages";
import { outbox, type Wanted } from "../../core/outbox";
import { sameValue } from "../../core/same";
import { me } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { ReviewItem } from "../../core/types";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { type Verdict, verdictWords } from "../../parts/verdicts/kind";
import { type GivenVerdict, type Height, VERDICT, type VerdictAbout } from "./kinds";
import { isWaiting, type ReviewQueue } from "./queue";

export class Verdicts {
  /** As each height was left by the last verdict on it, whether a list shows it or not. */
  private readonly last = new Map<number, Height>();

  constructor(
    private readonly queue: ReviewQueue,
    private readonly lane: string,
  ) {}

  /** Hears also of what was kept without a connection, once the server has it; ends with `close`. */
  readonly close = outbox.listen<Height, GivenVerdict, VerdictAbout>(VERDICT, ({ state, saved }) => {
    if (state === "saved" && saved) this.note(saved);
  });

  /** The verdict that stands on a revision; what waits is written as reopened. Only one's own is taken back. */
  readonly given: Ledger<number, Verdict & { revision: number; by: number | null }> = {
    read: (id) => {
      const m = this.queue.find(id)?.measurement ?? this.last.get(id);
      if (!m || isWaiting(m))
        return { verdict: "reopened", reason: null, revision: m?.revision ?? 0, by: null };
      const { verdict, reason, reviewer } = m.review;
      return {
        verdict: verdict as Verdict["verdict"],
        reason,
        revision: m.revision,
        by: reviewer?.id ?? null,
      };
    },
    write: async (id, value, left) => {
      const item = this.queue.find(id);
      const { verdict, reason } = value;
      if (!item || (left && !(isOwn(item.measurement) && sameValue(this.given.read(id), left))))
        throw new StepOvertaken(say("review-step-overtaken"));
      if (left && verdict !== "reopened" && (verdict === "fixed" || value.by !== me.value?.person.id))
        throw new StepOvertaken(say("review-step-not-again"));
      const giving = this.give(item, { verdict, reason, points: null });
      await (left ? this.orOvertaken(item, giving) : giving);
    },
  };

  /** A step back that another's verdict or points came before: nothing is left to send, and what stands is shown. */
  private async orOvertaken(item: ReviewItem, giving: Promise<Height>): Promise<void> {
    const stands = await giving.catch((error: unknown) => {
      if (!(error instanceof ApiError && error.status === 409)) throw error;
      this.forget(item);
      return null;
    });
    if (stands && (isOwn(stands) || !stands.review.reviewer)) return;
    await this.queue.refresh(item.measurement.id);
    throw new StepOvertaken(say("review-step-overtaken"));
  }

  /** Resolves once the verdict is stored, or kept where there is no connection; it stands in the queue from then on. */
  async give(item: ReviewItem, want: GivenVerdict): Promise<Height> {
    const stored = await outbox.store(this.verdictOn(item, want));
    if (stored?.saved) return stored.saved;
    toast(say("review-verdict-kept"));
    return this.note(expected(item.measurement, want));
  }

  private note(now: Height): Height {
    this.last.set(now.id, now);
    this.queue.replace(now);
    void refreshSurvey();
    void this.queue.readWork();
    return now;
  }

  /** A verdict that was refused is not sent again. */
  forget(item: ReviewItem): void {
    outbox.discard(keyOf(item));
  }

  private verdictOn(item: ReviewItem, want: GivenVerdict): Wanted<Height, GivenVerdict, VerdictAbout> {
    const m = item.measurement;
    return {
      key: keyOf(item),
      kind: VERDICT,
      lane: this.lane,
      about: { id: m.id, revision: m.revision, by: me.value?.person.id ?? 0 },
      what: say("review-verdict-of", {
        target: TARGET_WORDS[m.target],
        vehicle: vehicleName(item.vehicle.number),
      }),
      mine: verdictWords(want),
      page: `/surveys/${this.queue.surveyId}/review?measurement=${m.id}`,
      saved: m,
      want,
    };
  }
}

function isOwn({ review }: Height): boolean {
  return review.reviewer?.id === me.value?.person.id;
}

/** A height as it will be once the verdict is stored. */
function expected(m: Height, { verdict, reason, points }: GivenVerdict): Height {
  const reviewer = me.value ? { id: me.value.person.id, name: me.value.person.name } : null;
  return { ...m, ...points, review: { verdict, reason, reviewer, at: null, lot_id: null } };
}

function keyOf({ measurement }: ReviewItem): string {
  return `verdict.${measurement.id}`;
}
