/** The review queue: one measurement at a time with its picture, its points and its history; a verdict for each. */
import { batch, computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { asked, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { outbox, type Wanted } from "../../core/outbox";
import { may, me } from "../../core/session";
import { stored } from "../../core/stored";
import { refreshSurvey } from "../../core/survey";
import { toast, toastProblem } from "../../core/toasts";
import type { Comparison, Measurement, ReviewItem, Verdict } from "../../core/types";
import { STATE_WORDS, TARGET_WORDS, vehicleName } from "../../core/words";
import { BlindClicks, isDrawn } from "../../viewer/blind";
import { Geometry } from "../../viewer/geometry";
import { fromServer, type ImagePoint, pair, samePoint } from "../../viewer/points";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";
import { valuesOf } from "../../viewer/values";
import { type Fix, FixTool } from "./fix";
import { type GivenVerdict, VERDICT, type VerdictAbout } from "./kinds";

/** The states that the queue can be asked for; reopened ones are to review again. */
export type Shown = Exclude<Verdict, "reopened"> | "all";

const PAGE = 200;
const ONE_IN = 5;

/** How many measurements are clicked blind before their points are shown: one in n, all (1) or none (0). */
const plans = stored<Record<string, number>>("review.blind", {}, (v) => typeof v === "object" && v !== null);

export class ReviewModel {
  readonly reel = new Reel();
  readonly stage: FrameStage = new FrameStage(() =>
    this.hidden.value ? [this.stage.keyboard, this.blind] : [this.fixing, this.verdicts],
  );
  readonly geometry = new Geometry();
  readonly shown = signal<Shown>("to_review");
  readonly items = signal<readonly ReviewItem[] | null>(null);
  readonly problem = signal<unknown>(null);
  readonly currentId = signal<number | null>(null);
  readonly fixing = new FixTool({
    moved: (fix) => (fix ? this.askHeight(fix) : this.geometry.forgetHeight()),
    save: () => void this.judge("fixed"),
    differs: (fix) => this.differs(fix),
  });
  readonly fix: ReadonlySignal<Fix | null> = this.fixing.fix;
  readonly rejecting = signal(false);
  readonly busy = signal(false);
  /** True while the server has more of the queue than was read. */
  readonly more = signal(false);
  readonly oneIn: ReadonlySignal<number>;
  /** The repeats of what is shown, each with its difference; null until they are here. */
  readonly comparisons = signal<readonly Comparison[] | null>(null);
  readonly blind: BlindClicks = new BlindClicks(this.stage, this.reel, this.geometry, (made) =>
    this.clickedAgain(made),
  );
  /** Esc leaves a rejection that was begun. */
  private readonly verdicts = {
    cancel: (): boolean => {
      const begun = this.rejecting.value;
      this.cancel();
      return begun;
    },
  };
  private readonly revealed = signal<ReadonlySet<number>>(new Set());

  readonly current = computed(
    () => this.items.value?.find((item) => item.measurement.id === this.currentId.value) ?? null,
  );
  /** Neither points nor height of what is open may be seen yet. */
  readonly hidden = computed(() => this.current.value !== null && this.isHidden(this.current.value));
  readonly ownRepeat = computed(() => this.comparisons.value?.filter(isOwn).at(-1) ?? null);
  readonly contact = computed<ImagePoint | null>(() => {
    const m = this.current.value?.measurement;
    return this.fix.value?.contact ?? (m ? fromServer(m.contact) : null);
  });
  readonly point = computed<ImagePoint | null>(() => {
    const m = this.current.value?.measurement;
    return this.fix.value?.point ?? (m ? fromServer(m.target_point) : null);
  });
  /** The picture that is seen is the one the points were clicked on. */
  readonly onFrame = computed(
    () => this.reel.seen.value !== null && this.reel.seen.value === this.current.value?.measurement.frame,
  );

  /** Whether a fix would be computed with another road pose than the measurement was: then its words say so. */
  poseChanged(m: Measurement): boolean {
    const now = this.reel.recordings.value.find((one) => one.id === m.recording_id)?.pose_id;
    return now !== undefined && m.pose_id !== null && now !== m.pose_id;
  }

  /** Other points than those that stand, or the same with a road pose that they were not computed with. */
  private differs({ contact, point }: Fix): boolean {
    const m = this.current.value?.measurement;
    if (!m) return false;
    const moved = !samePoint(contact, fromServer(m.contact)) || !samePoint(point, fromServer(m.target_point));
    return moved || this.poseChanged(m);
  }

  private readonly stops: (() => void)[] = [];

  constructor(readonly surveyId: number) {
    const asked = new URLSearchParams(location.search).get("blind");
    if (asked !== null && /^\d{1,3}$/.test(asked)) this.plan(Number(asked));
    this.oneIn = computed(() => plans.value[String(surveyId)] ?? ONE_IN);
    this.stops.push(effect(() => this.followAxes()));
  }

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const wanted = asked("measurement");
      const [page, alone, recordings] = await Promise.all([
        this.read({ limit: PAGE }),
        wanted && wanted < 2 ** 31 ? this.read({ measurement: wanted, state: "all" }) : [],
        this.reel.recordings.value.length > 0
          ? this.reel.recordings.value
          : api.ask("GET /surveys/{survey_id}/recordings", { survey_id: this.surveyId }),
      ]);
      this.reel.recordings.value = recordings;
      // what the address names comes first if it is not in the first page of a long queue
      const known = page.some((item) => item.measurement.id === wanted);
      const items = known ? page : [...alone, ...page];
      this.items.value = items;
      this.more.value = page.length === PAGE;
      const named = items.find((item) => item.measurement.id === wanted);
      if (wanted !== null && !named)
        toast(say("address-elsewhere", { what: "measurement" }), { kind: "problem" });
      const first = named ?? items.find((item) => !item.mine) ?? items[0];
      if (first) this.open(first);
      else this.currentId.value = null;
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.reel.close();
  }

  async loadMore(): Promise<void> {
    const items = this.items.value ?? [];
    const last = items.at(-1);
    if (!last || !this.more.value) return;
    try {
      const page = await this.read({ limit: PAGE, after: last.measurement.id });
      const known = new Set(items.map((item) => item.measurement.id));
      this.items.value = [...items, ...page.filter((item) => !known.has(item.measurement.id))];
      this.more.value = page.length === PAGE;
    } catch (error) {
      toastProblem(error);
    }
  }

  /** Which measurements this person clicks blind from now on in this survey. */
  plan(oneIn: number): void {
    plans.value = { ...plans.value, [String(this.surveyId)]: oneIn };
    setQuery({ blind: oneIn });
    const item = this.current?.value;
    if (item) this.open(item);
  }

  isHidden(item: ReviewItem): boolean {
    const m = item.measurement;
    const waits = m.review.verdict === "to_review" || m.review.verdict === "reopened";
    if (!waits || item.mine || m.status !== "ok" || !may("reviewer")) return false;
    return isDrawn(m.id, this.oneIn.value) && !this.revealed.value.has(m.id);
  }

  /** The points and the height are shown, clicked again or not. */
  reveal(id: number): void {
    if (this.blind.wanted.value?.measurement_id === id) this.blind.begin(null);
    this.revealed.value = new Set(this.revealed.value).add(id);
  }

  async show(shown: Shown): Promise<void> {
    this.shown.value = shown;
    this.items.value = null;
    setQuery({ measurement: null });
    await this.load();
  }

  open(item: ReviewItem): void {
    const m = item.measurement;
    batch(() => {
      this.currentId.value = m.id;
      this.fixing.leave();
      this.rejecting.value = false;
      this.comparisons.value = null;
      this.geometry.forgetHeight();
      this.showFrame(m);
      this.blind.begin(this.isHidden(item) ? { ...m, measurement_id: m.id } : null);
    });
    setQuery({ measurement: m.id });
    void this.readComparisons(m.id);
  }

  /** Back to the frame on which the points were clicked. */
  showFrame(m: Measurement): void {
    this.reel.show(m.recording_id, m.frame);
  }

  go(step: 1 | -1): void {
    const items = this.items.value ?? [];
    const at = items.findIndex((item) => item.measurement.id === this.currentId.value);
    const next = items[at + step];
    if (next) this.open(next);
    else if (step === 1 && this.more.value) void this.loadMore().then(() => this.go(1));
    else toast(say(step === 1 ? "review-queue-end" : "review-queue-start"));
  }

  /** True if this person may give a verdict on what is shown. */
  get mayJudge(): boolean {
    return this.current.value !== null && !this.current.value.mine && !this.hidden.value && !this.busy.value;
  }

  async judge(verdict: "accepted" | "rejected" | "fixed" | "reopened", reason?: string): Promise<void> {
    const item = this.current.value;
    if (!item || !this.mayJudge) return;
    const fix = this.fix.value;
    const points =
      verdict === "fixed" && fix
        ? { contact: pair(fix.contact), target_point: pair(fix.point), frame: item.measurement.frame }
        : null;
    this.busy.value = true;
    try {
      const stored = await outbox.store(this.verdictOn(item, { verdict, reason: reason ?? null, points }));
      if (!stored) toast(say("review-verdict-kept"));
      this.after(item, stored?.saved ?? null);
      void refreshSurvey();
    } catch (error) {
      toastProblem(error);
      // told here, and the measurement is looked at again: nothing is left to choose
      outbox.discard(keyOf(item));
      await this.refreshItem(item);
    } finally {
      this.busy.value = false;
    }
  }

  private verdictOn(item: ReviewItem, want: GivenVerdict): Wanted<Measurement, GivenVerdict, VerdictAbout> {
    const m = item.measurement;
    const verdict = STATE_WORDS[want.verdict];
    return {
      key: keyOf(item),
      kind: VERDICT,
      lane: `review ${this.surveyId}`,
      about: { id: m.id, revision: m.revision, by: me.value?.person.id ?? 0 },
      what: say("review-verdict-of", {
        target: TARGET_WORDS[m.target],
        vehicle: vehicleName(item.vehicle.number),
      }),
      mine: want.reason ? say("review-verdict-reason", { verdict, reason: want.reason }) : verdict,
      page: `/surveys/${this.surveyId}/review?measurement=${m.id}`,
      saved: m,
      want,
    };
  }

  /** Points to correct: those that stand, or this person's own second click. */
  startFix(own: Measurement | null = null): void {
    const contact = own ? fromServer(own.contact) : this.contact.value;
    const point = own ? fromServer(own.target_point) : this.point.value;
    if (!contact || !point || !this.mayJudge) return;
    this.rejecting.value = false;
    this.fixing.begin(contact, point);
    const m = this.current.value?.measurement;
    if (m) this.showFrame(m);
    if (own && this.fix.value) this.askHeight(this.fix.value);
    this.stage.focus();
  }

  /** A second click that went wrong leaves the figures; what was seen stays seen. */
  async takeBack(repeat: Measurement): Promise<void> {
    try {
      await api.write("DELETE /measurements/{measurement_id}", {
        measurement_id: repeat.id,
        revision: repeat.revision,
      });
      if (repeat.repeat_of !== null) await this.readComparisons(repeat.repeat_of);
    } catch (error) {
      toastProblem(error);
    }
  }

  cancel(): void {
    this.fixing.leave();
    this.rejecting.value = false;
    this.geometry.forgetHeight();
  }

  private askHeight(fix: Fix): void {
    const m = this.current.value?.measurement;
    if (!m) return;
    const inset = { inset_m: m.inset_m, u_inset_m: m.u_inset_m };
    this.geometry.wantHeight({
      recordingId: m.recording_id,
      target: m.target,
      frame: m.frame,
      contact: fix.contact,
      point: fix.point,
      inset,
      sigma_px: m.sigma_px,
      more: valuesOf(m).more,
    });
  }

  /** What has been judged leaves the queue of the unjudged, and the next one opens. Null: kept, and not stored yet. */
  private after(item: ReviewItem, judged: Measurement | null): void {
    const items = this.items.value ?? [];
    const at = items.indexOf(item);
    // one's own measurements wait for somebody else: go on with the next that can be judged
    const next = items.find((other, i) => i > at && !other.mine) ?? items[at + 1] ?? items[at - 1];
    const stays = judged && (this.shown.value === "all" || this.shown.value === judged.review.verdict);
    batch(() => {
      this.items.value = stays
        ? items.map((other) => (other === item ? { ...item, measurement: judged } : other))
        : items.filter((other) => other !== item);
      if (next) this.open(next);
      else {
        this.currentId.value = stays ? judged.id : null;
        this.fixing.leave();
        this.rejecting.value = false;
      }
    });
  }

  /** A verdict was refused, perhaps because the operator changed the points meanwhile: show what there is now. */
  private async refreshItem(item: ReviewItem): Promise<void> {
    try {
      const measurement = await api.ask("GET /measurements/{measurement_id}", {
        measurement_id: item.measurement.id,
      });
      if (measurement.revision === item.measurement.revision) return;
      this.items.value = (this.items.value ?? []).map((other) =>
        other === item ? { ...item, measurement } : other,
      );
      this.fixing.leave();
    } catch {
      // the refusal's own sentence has been shown
    }
  }

  private read(page: {
    limit?: number;
    after?: number;
    measurement?: number;
    state?: Shown;
  }): Promise<ReviewItem[]> {
    const asked = { survey_id: this.surveyId, state: this.shown.value, ...page };
    return api.ask("GET /surveys/{survey_id}/review-queue", asked);
  }

  private clickedAgain(made: Measurement): void {
    const id = made.repeat_of;
    if (id === null) return;
    this.reveal(id);
    void this.readComparisons(id);
  }

  private async readComparisons(id: number): Promise<void> {
    try {
      const found = await api.ask("GET /measurements/{measurement_id}/repeats", { measurement_id: id });
      if (this.currentId.value !== id) return;
      this.comparisons.value = found;
      if (found.some(isOwn)) this.reveal(id);
    } catch (error) {
      toastProblem(error);
    }
  }

  private followAxes(): void {
    const m = this.current.value?.measurement;
    const contact = this.contact.value;
    if (this.hidden.value) return;
    const show = m && contact && this.onFrame.value;
    this.geometry.showAxes(
      show
        ? {
            recordingId: m.recording_id,
            contact,
            target: m.target,
            inset: { inset_m: m.inset_m, u_inset_m: m.u_inset_m },
          }
        : null,
    );
  }
}

function isOwn(one: Comparison): boolean {
  return one.repeat.created_by !== null && one.repeat.created_by.id === me.value?.person.id;
}

function keyOf({ measurement }: ReviewItem): string {
  return `verdict.${measurement.id}`;
}
