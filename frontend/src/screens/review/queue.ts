/** What is to be reviewed: the queue as far as it was read, what is left of the work, and which of it is clicked blind. */
import { computed, signal } from "@preact/signals";
import { asked } from "../../core/address";
import { api } from "../../core/api";
import { telling, toastProblem } from "../../core/toasts";
import type { ReviewItem, ReviewPlan, ReviewWork, Verdict } from "../../core/types";
import { isWaiting } from "../../parts/verdicts/given";
import { nextThat } from "../../parts/worklist";
import { type Height, readHeight } from "./kinds";

/** The states that the queue can be asked for; reopened ones are to review again. */
export type Shown = Exclude<Verdict, "reopened"> | "all";

const PAGE = 200;

export class ReviewQueue {
  readonly shown = signal<Shown>("to_review");
  readonly items = signal<readonly ReviewItem[] | null>(null);
  /** True while the server has more of the queue than was read. */
  readonly more = signal(false);
  /** Which measurements are clicked blind: the survey's, not the reviewer's choice. */
  readonly plan = signal<ReviewPlan | null>(null);
  readonly work = signal<ReviewWork | null>(null);
  /** The sample of the lot that is shown has its verdicts: what is next is to decide on the lot. */
  readonly lotJudged = computed(
    () =>
      this.lot !== null &&
      !this.more.value &&
      this.items.value?.some((item) => isWaiting(item.measurement)) === false,
  );

  constructor(readonly surveyId: number) {}

  /** The open lot whose sample alone is shown, by the address. */
  get lot(): number | null {
    return asked("lot");
  }

  /** Reads the first page, and before it what the address names if it is not there; answers what was named. */
  async load(named: number | null): Promise<ReviewItem | undefined> {
    const [page, alone] = await Promise.all([
      this.read({ limit: PAGE }),
      named && named < 2 ** 31 ? this.read({ measurement: named, state: "all" }) : [],
      this.readPlan(),
    ]);
    const known = page.some((item) => item.measurement.id === named);
    this.items.value = known ? page : [...alone, ...page];
    this.more.value = page.length === PAGE;
    return named === null ? undefined : this.find(named);
  }

  /** Whether more came to the list, or none is left. */
  async loadMore(): Promise<boolean> {
    const after = this.items.value?.at(-1)?.measurement.id;
    if (!after || !this.more.value) return false;
    let came = false;
    await telling(async () => {
      const page = await this.read({ limit: PAGE, after });
      const items = this.items.value ?? [];
      if (items.at(-1)?.measurement.id !== after) return; // another list, or more of this one, is there by now
      const fresh = page.filter((item) => !this.find(item.measurement.id));
      this.items.value = [...items, ...fresh];
      this.more.value = page.length === PAGE;
      came = fresh.length > 0 || !this.more.value;
    });
    return came;
  }

  /** A measurement as it stands; one of another state, which this list does not show, from the server, before the list. */
  async bring(id: number): Promise<ReviewItem | undefined> {
    const [alone] = this.find(id) ? [] : await this.read({ measurement: id, state: "all" });
    if (alone && !this.find(id)) this.items.value = [alone, ...(this.items.value ?? [])];
    return this.find(id);
  }

  find(id: number | null): ReviewItem | undefined {
    return this.items.value?.find((item) => item.measurement.id === id);
  }

  /** The next after an item that waits for this person's verdict; from the beginning if none comes after it. */
  waitsAfter(id: number): ReviewItem | undefined {
    return nextThat(this.items.value ?? [], id, (item) => !item.mine && isWaiting(item.measurement));
  }

  /** The measurement as it is now, in the place of what was read. What was told of another revision does not hold of this one. */
  replace(measurement: Height): void {
    const before = this.find(measurement.id);
    if (!before) return;
    const same = before.measurement.revision === measurement.revision;
    const judged = same ? before.judged : { ...before.judged, signs: [], error_m: null, U95_error_m: null };
    this.put({ ...before, measurement, judged });
    if (!same) void this.readJudged(measurement);
  }

  private put(item: ReviewItem): void {
    this.items.value = (this.items.value ?? []).map((other) =>
      other.measurement.id === item.measurement.id ? item : other,
    );
  }

  /** What the server tells beside the revision that stands now. */
  private async readJudged({ id, revision }: Height): Promise<void> {
    const [now] = await this.read({ measurement: id, state: "all" }).catch(() => []);
    const here = this.find(id);
    if (here?.measurement.revision === revision && now?.measurement.revision === revision)
      this.put({ ...here, mine: now.mine, judged: now.judged });
  }

  /** Reads a measurement anew, which is then in its place; answers whether it has another revision now. */
  async refresh(measurement_id: number): Promise<boolean> {
    const now = await readHeight(measurement_id).catch(() => null); // why it is asked for has been said
    const before = this.find(measurement_id)?.measurement.revision;
    if (now) this.replace(now);
    return now !== null && now.revision !== before;
  }

  /** An administrator's choice, for everybody who reviews this survey; answers whether it was made. */
  async choosePlan(blind_one_in: number): Promise<boolean> {
    const version = this.plan.value?.version ?? 0;
    try {
      this.plan.value = await api.write(
        "PUT /surveys/{survey_id}/review-plan",
        { survey_id: this.surveyId },
        { body: { blind_one_in, version } },
      );
      return true;
    } catch (error) {
      toastProblem(error);
      await this.readPlan();
      return false;
    }
  }

  async readWork(): Promise<void> {
    const answer = api.ask("GET /surveys/{survey_id}/review-work", { survey_id: this.surveyId });
    this.work.value = await answer.catch(() => this.work.value); // it is read again after the next verdict
  }

  private async readPlan(): Promise<void> {
    const answer = api.ask("GET /surveys/{survey_id}/review-plan", { survey_id: this.surveyId });
    [this.plan.value] = await Promise.all([answer, this.readWork()]);
  }

  private read(page: {
    limit?: number;
    after?: number;
    measurement?: number;
    state?: Shown;
  }): Promise<ReviewItem[]> {
    const lot = this.lot && page.measurement === undefined ? { lot: this.lot } : {};
    const wanted = { survey_id: this.surveyId, state: this.shown.value, ...lot, ...page };
    return api.ask("GET /surveys/{survey_id}/review-queue", wanted);
  }
}
