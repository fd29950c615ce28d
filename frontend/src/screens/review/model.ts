/** The review queue: one measurement at a time with its picture, its points and its history; a verdict for each. */
import { batch, computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { asked, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { History, type Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox, type Wanted } from "../../core/outbox";
import { may, me } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast, toastProblem } from "../../core/toasts";
import type {
  Comparison,
  LineHeightQueue,
  Measurement,
  ReviewItem,
  ReviewPlan,
  ReviewWork,
  Verdict,
} from "../../core/types";
import { STATE_WORDS, TARGET_WORDS, vehicleName } from "../../core/words";
import { type Again, BlindClicks } from "../../viewer/blind";
import { Geometry } from "../../viewer/geometry";
import { fromServer, type ImagePoint, pair, samePoint } from "../../viewer/points";
import { Reel } from "../../viewer/reel";
import { repeatWish } from "../../viewer/repeats";
import { FrameStage } from "../../viewer/stage";
import { insetOf, valuesOf } from "../../viewer/values";
import { type Fix, FixTool } from "./fix";
import { type GivenVerdict, VERDICT, type VerdictAbout } from "./kinds";

/** The states that the queue can be asked for; reopened ones are to review again. */
export type Shown = Exclude<Verdict, "reopened"> | "all";

const PAGE = 200;

export class ReviewModel {
  readonly reel = new Reel();
  readonly stage: FrameStage = new FrameStage(() =>
    this.rejecting.value
      ? [this.verdicts]
      : this.hidden.value
        ? [this.stage.keyboard, this.blind]
        : [this.fixing, this.verdicts],
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
  /** Why it is rejected, chosen or in one's own words. */
  readonly reason = signal("");
  /** Verdicts can be taken back, each where it was given; a fix cannot: its points are a revision, and one's own. */
  readonly history: History = new History(() => {
    const item = this.current.peek();
    return () => {
      if (item && this.currentId.value !== item.measurement.id)
        this.open(this.itemOf(item.measurement.id) ?? item);
    };
  });
  /** Which measurements are clicked blind: the survey's, not the reviewer's choice. */
  readonly plan = signal<ReviewPlan | null>(null);
  readonly work = signal<ReviewWork | null>(null);
  /** Heights of line scans that wait: they have a bench of their own, and stand in this queue. */
  readonly lineHeights = signal<LineHeightQueue | null>(null);
  readonly busy = signal(false);
  /** True while the server has more of the queue than was read. */
  readonly more = signal(false);
  /** The repeats of what is shown, each with its difference; null until they are here. */
  readonly comparisons = signal<readonly Comparison[] | null>(null);
  readonly blind: BlindClicks;
  /** Esc leaves a rejection that was begun, Enter gives it once it has a reason. */
  private readonly verdicts = {
    confirm: (): boolean => {
      const ready = this.rejecting.value && this.reason.value.trim() !== "";
      if (ready) void this.judge("rejected", this.reason.value.trim());
      return ready;
    },
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
    this.blind = new BlindClicks(this.stage, this.reel, this.geometry, this.lane, (again) =>
      this.clickedAgain(again),
    );
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
        this.readPlan(),
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

  /** The open lot whose sample alone is shown, by the address. */
  get lot(): number | null {
    return asked("lot");
  }

  /** The sample of the lot that is shown has its verdicts: what is next is to decide on the lot. */
  readonly lotJudged = computed(
    () =>
      this.lot !== null &&
      !this.more.value &&
      this.items.value?.some((item) => isWaiting(item.measurement)) === false,
  );

  async leaveLot(): Promise<void> {
    setQuery({ lot: null });
    await this.load();
  }

  isHidden(item: ReviewItem): boolean {
    if (!item.judged.blind || !may("reviewer") || this.revealed.value.has(item.measurement.id)) return false;
    return isWaiting(item.measurement);
  }

  /** An administrator's choice, for everybody who reviews this survey. */
  async choosePlan(blind_one_in: number): Promise<void> {
    const version = this.plan.value?.version ?? 0;
    try {
      this.plan.value = await api.write(
        "PUT /surveys/{survey_id}/review-plan",
        { survey_id: this.surveyId },
        { body: { blind_one_in, version } },
      );
      await this.load();
    } catch (error) {
      toastProblem(error);
      await this.readPlan();
    }
  }

  private async readPlan(): Promise<void> {
    const survey_id = this.surveyId;
    [this.plan.value, this.work.value, this.lineHeights.value] = await Promise.all([
      api.ask("GET /surveys/{survey_id}/review-plan", { survey_id }),
      api.ask("GET /surveys/{survey_id}/review-work", { survey_id }),
      api.ask("GET /surveys/{survey_id}/line-height-queue", { survey_id }),
    ]);
  }

  private async readWork(): Promise<void> {
    try {
      this.work.value = await api.ask("GET /surveys/{survey_id}/review-work", { survey_id: this.surveyId });
    } catch {
      // it is read again after the next verdict
    }
  }

  /** The points and the height are shown: it was clicked again. */
  private reveal(id: number): void {
    if (this.blind.wanted.value?.measurement_id === id) this.blind.begin(null);
    this.revealed.value = new Set(this.revealed.value).add(id);
    const item = this.itemOf(id);
    if (item && this.currentId.value === id) this.aimAt(item.measurement);
  }

  async show(shown: Shown): Promise<void> {
    this.shown.value = shown;
    this.items.value = null;
    setQuery({ measurement: null, lot: null });
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
      if (this.isHidden(item)) this.stage.whole();
      else this.aimAt(m);
      this.blind.begin(this.isHidden(item) ? { ...m, measurement_id: m.id } : null);
    });
    setQuery({ measurement: m.id });
    void this.readComparisons(m.id);
  }

  /** Back to the frame on which the points were clicked. */
  showFrame(m: Measurement): void {
    this.reel.show(m.recording_id, m.frame);
  }

  /** What is to be judged, large enough to be judged. */
  private aimAt(m: Measurement): void {
    this.stage.aim(fromServer(m.contact), fromServer(m.target_point));
  }

  private itemOf(id: number): ReviewItem | undefined {
    return this.items.value?.find((item) => item.measurement.id === id);
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
    return this.mayReject && !this.hidden.value;
  }

  /** What cannot be clicked again can still be rejected. */
  get mayReject(): boolean {
    return this.current.value !== null && !this.current.value.mine && !this.busy.value;
  }

  startReject(): void {
    if (!this.mayReject) return;
    this.fixing.leave();
    this.reason.value = "";
    this.rejecting.value = true;
  }

  async judge(verdict: "accepted" | "rejected" | "fixed" | "reopened", reason?: string): Promise<void> {
    const item = this.current.value;
    const fix = this.fix.value;
    if (!item || !(verdict === "rejected" ? this.mayReject : this.mayJudge)) return;
    const { id, target, frame } = item.measurement;
    this.busy.value = true;
    try {
      if (verdict === "fixed" && fix)
        await this.give(item, {
          verdict,
          reason: null,
          points: { contact: pair(fix.contact), target_point: pair(fix.point), frame },
        });
      else
        await this.history.run(
          say("review-step-verdict", { target, vehicle: vehicleName(item.vehicle.number) }),
          async (changes) => {
            await changes.write(this.given, id, { verdict, reason: reason ?? null });
          },
        );
      if (verdict !== "reopened") this.goOn(id);
    } catch (error) {
      toastProblem(error);
      // told here, and the measurement is looked at again: nothing is left to choose
      outbox.discard(keyOf(item));
      await this.refreshItem(item);
    } finally {
      this.busy.value = false;
    }
  }

  /** The verdict that stands on a measurement; what waits is written as reopened. */
  private readonly given: Ledger<number, Pick<GivenVerdict, "verdict" | "reason">> = {
    read: (id) => {
      const m = this.itemOf(id)?.measurement;
      if (!m || isWaiting(m)) return { verdict: "reopened", reason: null };
      return { verdict: m.review.verdict as GivenVerdict["verdict"], reason: m.review.reason };
    },
    write: async (id, want) => {
      const item = this.itemOf(id);
      if (item) await this.give(item, { ...want, points: null });
    },
  };

  /** Resolves once the verdict is stored, or kept where there is no connection; it stands in the queue from then on. */
  private async give(item: ReviewItem, want: GivenVerdict): Promise<void> {
    const stored = await outbox.store(this.verdictOn(item, want));
    if (!stored) toast(say("review-verdict-kept"));
    const { id } = item.measurement;
    const measurement = stored?.saved ?? expected(item.measurement, want);
    this.items.value = (this.items.value ?? []).map((other) =>
      other.measurement.id === id ? { ...other, measurement } : other,
    );
    void refreshSurvey();
    void this.readWork();
  }

  private get lane(): string {
    return `review ${this.surveyId}`;
  }

  private verdictOn(item: ReviewItem, want: GivenVerdict): Wanted<Measurement, GivenVerdict, VerdictAbout> {
    const m = item.measurement;
    const verdict = STATE_WORDS[want.verdict];
    return {
      key: keyOf(item),
      kind: VERDICT,
      lane: this.lane,
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
    const step = say("review-again-take-back");
    await this.history
      .run(step, async (changes) => {
        await changes.write(this.repeats, repeat, false);
      })
      .catch(toastProblem);
  }

  /** Whether a second click stands. */
  private readonly repeats: Ledger<Measurement, boolean> = {
    nameOf: ({ id }) => id,
    read: ({ id }) => this.comparisons.value?.some(({ repeat }) => repeat.id === id) === true,
    write: async (repeat, stands) => {
      const saved = this.turned.get(repeat.id) ?? repeat;
      const about = { vehicleId: repeat.vehicle_id };
      const want = { clicks: null, withdrawn: !stands };
      const stored = await outbox.store(repeatWish(`repeat.${repeat.id}`, this.lane, about, saved, want));
      if (stored?.saved) this.turned.set(repeat.id, stored.saved);
      if (repeat.repeat_of !== null) await this.readComparisons(repeat.repeat_of);
    },
  };
  private readonly turned = new Map<number, Measurement>();

  cancel(): void {
    this.reason.value = "";
    this.fixing.leave();
    this.rejecting.value = false;
    this.geometry.forgetHeight();
  }

  private askHeight(fix: Fix): void {
    const m = this.current.value?.measurement;
    if (!m) return;
    const inset = insetOf(m);
    this.geometry.wantHeight({
      recordingId: m.recording_id,
      vehicleId: m.vehicle_id,
      target: m.target,
      frame: m.frame,
      contact: fix.contact,
      point: fix.point,
      inset,
      sigma_px: m.sigma_px,
      more: valuesOf(m).more,
    });
  }

  /** On to the next that waits, unless something else was opened meanwhile. What was judged stays in the list, to go back to. */
  private goOn(id: number): void {
    this.cancel();
    if (this.currentId.value !== id) return;
    const items = this.items.value ?? [];
    const at = items.findIndex((item) => item.measurement.id === id);
    const waits = (item: ReviewItem): boolean => !item.mine && isWaiting(item.measurement);
    const next = items.find((item, i) => i > at && waits(item)) ?? items.find(waits);
    if (next) this.open(next);
    else if (this.more.value) void this.loadMore().then(() => this.go(1));
  }

  /** A verdict was refused, perhaps because the operator changed the points meanwhile: show what there is now. */
  private async refreshItem(item: ReviewItem): Promise<void> {
    try {
      const measurement = await api.ask("GET /measurements/{measurement_id}", {
        measurement_id: item.measurement.id,
      });
      if (measurement.revision === item.measurement.revision) return;
      this.items.value = (this.items.value ?? []).map((other) =>
        other.measurement.id === measurement.id ? { ...other, measurement } : other,
      );
      // what was begun on another one meanwhile stays
      if (this.currentId.value === measurement.id) this.fixing.leave();
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
    const lot = this.lot && page.measurement === undefined ? { lot: this.lot } : {};
    const wanted = { survey_id: this.surveyId, state: this.shown.value, ...lot, ...page };
    return api.ask("GET /surveys/{survey_id}/review-queue", wanted);
  }

  private clickedAgain({ clicks }: Again): void {
    this.reveal(clicks.repeat_of);
    void this.readComparisons(clicks.repeat_of);
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
            vehicleId: m.vehicle_id,
            inset: insetOf(m),
          }
        : null,
    );
  }
}

/** True while nobody has said anything of what stands; what was reopened waits again. */
function isWaiting({ review }: Measurement): boolean {
  return review.verdict === "to_review" || review.verdict === "reopened";
}

/** A measurement as it will be once the verdict is stored. */
function expected(m: Measurement, { verdict, reason, points }: GivenVerdict): Measurement {
  const reviewer = me.value ? { id: me.value.person.id, name: me.value.person.name } : null;
  return { ...m, ...points, review: { verdict, reason, reviewer, at: null, lot_id: null } };
}

function isOwn(one: Comparison): boolean {
  return one.repeat.created_by !== null && one.repeat.created_by.id === me.value?.person.id;
}

function keyOf({ measurement }: ReviewItem): string {
  return `verdict.${measurement.id}`;
}
