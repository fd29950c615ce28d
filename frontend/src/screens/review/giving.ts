/** Verdicts on their way to the server, each a value of its measurement that can be put back. */
import { say } from "../../core/messages";
import { outbox, type Wanted } from "../../core/outbox";
import { me } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { ReviewItem } from "../../core/types";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { ownReview, verdictLedger } from "../../parts/verdicts/given";
import { type Verdict, verdictWords } from "../../parts/verdicts/kind";
import { type GivenVerdict, type Height, VERDICT, type VerdictAbout } from "./kinds";
import type { ReviewQueue } from "./queue";

export class Verdicts {
  /** As each height was left by the last verdict on it, whether a list shows it or not. */
  private readonly last = new Map<number, Height>();

  constructor(
    private readonly queue: ReviewQueue,
    private readonly lane: string,
  ) {}

  /** Hears also of what was kept without a connection, once it is sent or let go; ends with `close`. */
  readonly close = outbox.listen<Height, GivenVerdict, VerdictAbout>(VERDICT, ({ state, saved }) => {
    if ((state === "saved" || state === "dropped") && saved) this.note(saved);
  });

  readonly given = verdictLedger<Verdict>({
    stands: (id) => {
      const m = this.queue.find(id)?.measurement ?? this.last.get(id);
      return m ? { of: m.revision, review: m.review } : null;
    },
    give: async (id, want) => {
      const item = this.queue.find(id);
      return item ? (await this.give(item, { ...want, points: null })).review : null;
    },
    overtaken: async (id) => {
      this.forget(id);
      await this.queue.refresh(id);
    },
  });

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
  forget(id: number): void {
    outbox.discard(keyOf(id));
  }

  private verdictOn(item: ReviewItem, want: GivenVerdict): Wanted<Height, GivenVerdict, VerdictAbout> {
    const m = item.measurement;
    return {
      key: keyOf(m.id),
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
function expected(m: Height, want: GivenVerdict): Height {
  return { ...m, ...want.points, review: ownReview(want) };
}

function keyOf(id: number): string {
  return `verdict.${id}`;
}
