/** Verdicts on their way to the server, each a value of its measurement that can be put back. */
import { type Ledger, StepOvertaken } from "../../core/history";
import { say } from "../../core/messages";
import { outbox, type Wanted } from "../../core/outbox";
import { sameValue } from "../../core/same";
import { me } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { ReviewItem } from "../../core/types";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { verdictWords } from "../../parts/verdicts/kind";
import { type GivenVerdict, type Height, VERDICT, type VerdictAbout } from "./kinds";
import { isWaiting, type ReviewQueue } from "./queue";

export class Verdicts {
  /** As each height was left by the last verdict on it, whether a list shows it or not. */
  private readonly last = new Map<number, Height>();

  constructor(
    private readonly queue: ReviewQueue,
    private readonly lane: string,
  ) {}

  /** The verdict that stands on a revision; what waits is written as reopened. Only one's own is taken back. */
  readonly given: Ledger<number, Pick<GivenVerdict, "verdict" | "reason"> & { revision: number }> = {
    read: (id) => {
      const m = this.queue.find(id)?.measurement ?? this.last.get(id);
      if (!m || isWaiting(m)) return { verdict: "reopened", reason: null, revision: m?.revision ?? 0 };
      const { verdict, reason } = m.review;
      return { verdict: verdict as GivenVerdict["verdict"], reason, revision: m.revision };
    },
    write: async (id, { verdict, reason }, left) => {
      const item = this.queue.find(id);
      const own = item?.measurement.review.reviewer?.id === me.value?.person.id;
      if (!item || (left && !(own && sameValue(this.given.read(id), left))))
        throw new StepOvertaken(say("review-step-overtaken"));
      await this.give(item, { verdict, reason, points: null });
    },
  };

  /** Resolves once the verdict is stored, or kept where there is no connection; it stands in the queue from then on. */
  async give(item: ReviewItem, want: GivenVerdict): Promise<void> {
    const stored = await outbox.store(this.verdictOn(item, want));
    if (!stored) toast(say("review-verdict-kept"));
    const now = stored?.saved ?? expected(item.measurement, want);
    this.last.set(now.id, now);
    this.queue.replace(now);
    void refreshSurvey();
    void this.queue.readWork();
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

/** A height as it will be once the verdict is stored. */
function expected(m: Height, { verdict, reason, points }: GivenVerdict): Height {
  const reviewer = me.value ? { id: me.value.person.id, name: me.value.person.name } : null;
  return { ...m, ...points, review: { verdict, reason, reviewer, at: null, lot_id: null } };
}

function keyOf({ measurement }: ReviewItem): string {
  return `verdict.${measurement.id}`;
}
