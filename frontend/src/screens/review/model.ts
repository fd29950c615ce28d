/** The review queue: one measurement at a time with its picture, its points and its history; a verdict for each. */
import { batch, computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { asked, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { History } from "../../core/history";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import { telling, toast, toastProblem } from "../../core/toasts";
import type { Measurement, ReviewItem } from "../../core/types";
import { vehicleName } from "../../core/words";
import { isWaiting } from "../../parts/verdicts/given";
import { Rejection } from "../../parts/verdicts/rejection";
import { beside } from "../../parts/worklist";
import { type Again, BlindClicks } from "../../viewer/blind";
import { Geometry } from "../../viewer/geometry";
import { fromServer, type ImagePoint, pair } from "../../viewer/points";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";
import { insetOf } from "../../viewer/values";
import { clicksOf, type Fix, FixTool, isMoved } from "./fix";
import { Verdicts } from "./giving";
import { isOfFrame, isOfLine } from "./kinds";
import { LinePicture } from "./LinePicture";
import { ReviewQueue, type Shown } from "./queue";
import { REASONS } from "./reasons";
import { isOwn, Repeats } from "./repeats";

export class ReviewModel {
  readonly reel = new Reel();
  readonly stage: FrameStage = new FrameStage(() =>
    this.rejection.begun.value
      ? [this.rejection]
      : this.hidden.value
        ? [this.stage.keyboard, this.blind]
        : [this.fixing],
  );
  readonly geometry = new Geometry();
  readonly strips = new LinePicture();
  readonly queue: ReviewQueue;
  readonly repeats: Repeats;
  readonly problem = signal<unknown>(null);
  readonly currentId = signal<number | null>(null);
  readonly fixing = new FixTool({
    moved: (fix) => (fix ? this.askHeight(fix) : this.geometry.forgetHeight()),
    save: () => void this.judge("fixed"),
    differs: (fix) => this.differs(fix),
  });
  readonly fix: ReadonlySignal<Fix | null> = this.fixing.fix;
  readonly rejection: Rejection = new Rejection(REASONS, (reason) => void this.judge("rejected", reason));
  /** Verdicts can be taken back, each where it was given; a fix cannot: its points are a revision, and one's own. */
  readonly history: History = new History(() => {
    const id = this.currentId.peek();
    return async () => {
      const item = id !== null && id !== this.current.value?.measurement.id && (await this.queue.bring(id));
      if (item) this.open(item);
    };
  });
  readonly busy = signal(false);
  readonly blind: BlindClicks;
  private readonly given: Verdicts;
  private readonly revealed = signal<ReadonlySet<number>>(new Set());

  readonly current = computed(() => this.queue.find(this.currentId.value) ?? null);
  /** What is open, where it is of a frame: in a line scan nothing is fixed or clicked again. */
  readonly ofFrame = computed<Measurement | null>(() => {
    const m = this.current.value?.measurement;
    return m && isOfFrame(m) ? m : null;
  });
  /** Neither points nor height of what is open may be seen yet. */
  readonly hidden = computed(() => this.current.value !== null && this.isHidden(this.current.value));
  readonly contact = computed<ImagePoint | null>(() => {
    const m = this.ofFrame.value;
    return this.fix.value?.contact ?? (m ? fromServer(m.contact) : null);
  });
  readonly point = computed<ImagePoint | null>(() => {
    const m = this.ofFrame.value;
    return this.fix.value?.point ?? (m ? fromServer(m.target_point) : null);
  });
  /** The picture that is seen is the one the points were clicked on. */
  readonly onFrame = computed(
    () => this.reel.seen.value !== null && this.reel.seen.value === this.ofFrame.value?.frame,
  );

  /** Whether a fix would be computed with another road pose than the measurement was: then its words say so. */
  poseChanged(m: Measurement): boolean {
    const now = this.reel.recordings.value.find((one) => one.id === m.recording_id)?.pose_id;
    return now !== undefined && m.pose_id !== null && now !== m.pose_id;
  }

  /** Other points than those that stand, or the same with a road pose that they were not computed with. */
  private differs(fix: Fix): boolean {
    const m = this.ofFrame.value;
    return m !== null && (isMoved(m, fix) || this.poseChanged(m));
  }

  private readonly stops: (() => void)[] = [];

  constructor(readonly surveyId: number) {
    const lane = `review ${surveyId}`;
    this.queue = new ReviewQueue(surveyId);
    this.given = new Verdicts(this.queue, lane);
    this.repeats = new Repeats(lane, (id) => this.readComparisons(id));
    this.blind = new BlindClicks(this.stage, this.reel, this.geometry, lane, (again) =>
      this.clickedAgain(again),
    );
    this.stops.push(
      this.given.close,
      effect(() => this.followAxes()),
    );
  }

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const wanted = asked("measurement");
      const [named, recordings] = await Promise.all([
        this.queue.load(wanted),
        this.reel.recordings.value.length > 0
          ? this.reel.recordings.value
          : api.ask("GET /surveys/{survey_id}/recordings", { survey_id: this.surveyId }),
      ]);
      this.reel.recordings.value = recordings;
      if (wanted !== null && !named)
        toast(say("address-elsewhere", { what: "measurement" }), { kind: "problem" });
      const items = this.queue.items.value ?? [];
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
    this.strips.close();
  }

  async leaveLot(): Promise<void> {
    setQuery({ lot: null });
    await this.load();
  }

  isHidden({ judged, measurement: m }: ReviewItem): boolean {
    return judged.blind && may("reviewer") && !this.revealed.value.has(m.id) && isWaiting(m);
  }

  async choosePlan(blind_one_in: number): Promise<void> {
    if (await this.queue.choosePlan(blind_one_in)) await this.load();
  }

  /** The points and the height are shown: it was clicked again. */
  private reveal(id: number): void {
    if (this.blind.wanted.value?.measurement_id === id) this.blind.begin(null);
    this.revealed.value = new Set(this.revealed.value).add(id);
    const m = this.ofFrame.value;
    if (m?.id === id) this.aimAt(m);
  }

  async show(shown: Shown): Promise<void> {
    this.queue.shown.value = shown;
    this.queue.items.value = null;
    setQuery({ measurement: null, lot: null });
    await this.load();
  }

  open(item: ReviewItem): void {
    const m = item.measurement;
    batch(() => {
      this.currentId.value = m.id;
      this.fixing.leave();
      this.rejection.cancel();
      this.repeats.comparisons.value = null;
      this.geometry.forgetHeight();
      if (isOfFrame(m)) this.openFrame(item, m);
      else this.blind.begin(null);
      this.strips.show(isOfLine(m) ? m : null);
    });
    setQuery({ measurement: m.id });
    if (isOfFrame(m)) void this.readComparisons(m.id);
  }

  private openFrame(item: ReviewItem, m: Measurement): void {
    this.showFrame(m);
    if (this.isHidden(item)) this.stage.whole();
    else this.aimAt(m);
    this.blind.begin(this.isHidden(item) ? { ...m, measurement_id: m.id } : null);
  }

  showFrame(m: Measurement): void {
    this.reel.show(m.recording_id, m.frame);
  }

  /** What is to be judged, large enough to be judged. */
  private aimAt(m: Measurement): void {
    this.stage.aim(fromServer(m.contact), fromServer(m.target_point));
  }

  go(step: 1 | -1): void {
    const next = beside(this.queue.items.value ?? [], this.currentId.value, step);
    if (next) this.open(next);
    else if (step === 1 && this.queue.more.value) this.goFurther();
    else toast(say(step === 1 ? "review-queue-end" : "review-queue-start"));
  }

  /** To what comes after the end of the list, once it is there; not where another list, or nothing, came. */
  private goFurther(): void {
    void this.queue.loadMore().then((came) => {
      if (came) this.go(1);
    });
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
    this.geometry.forgetHeight();
    this.rejection.begin();
  }

  async judge(verdict: "accepted" | "rejected" | "fixed" | "reopened", reason?: string): Promise<void> {
    const item = this.current.value;
    const fix = this.fix.value;
    if (!item || !(verdict === "rejected" ? this.mayReject : this.mayJudge)) return;
    const { id, target } = item.measurement;
    const frame = this.ofFrame.value?.frame;
    this.busy.value = true;
    try {
      if (verdict === "fixed" && fix && frame !== undefined)
        await this.given.give(item, {
          verdict,
          reason: null,
          points: { contact: pair(fix.contact), target_point: pair(fix.point), frame },
        });
      else
        await this.history.run(
          say("review-step-verdict", { target, vehicle: vehicleName(item.vehicle.number) }),
          (changes) => changes.write(this.given.given, id, { verdict, reason: reason ?? null }),
        );
      if (verdict !== "reopened") this.goOn(id);
    } catch (error) {
      toastProblem(error);
      // told here, and the measurement is looked at again: nothing is left to choose
      this.given.forget(id);
      await this.refreshItem(item);
    } finally {
      this.busy.value = false;
    }
  }

  /** Points to correct: those that stand, or this person's own second click. */
  startFix(own: Measurement | null = null): void {
    const contact = own ? fromServer(own.contact) : this.contact.value;
    const point = own ? fromServer(own.target_point) : this.point.value;
    if (!contact || !point || !this.mayJudge) return;
    this.rejection.cancel();
    this.fixing.begin(contact, point);
    const m = this.ofFrame.value;
    if (m) this.showFrame(m);
    if (own && this.fix.value) this.askHeight(this.fix.value);
    this.stage.focus();
  }

  /** A second click that went wrong leaves the figures; what was seen stays seen. */
  async takeBack(repeat: Measurement): Promise<void> {
    await telling(async () =>
      this.history.run(say("review-again-take-back"), (changes) =>
        changes.write(this.repeats.standing, repeat, false),
      ),
    );
  }

  cancel(): void {
    this.fixing.leave();
    this.rejection.cancel();
    this.geometry.forgetHeight();
  }

  private askHeight(fix: Fix): void {
    const m = this.ofFrame.value;
    if (m) this.geometry.wantHeight(clicksOf(m, fix));
  }

  /** On to the next that waits, unless something else was opened meanwhile. What was judged stays in the list, to go back to. */
  private goOn(id: number): void {
    this.cancel();
    if (this.currentId.value !== id) return;
    const next = this.queue.waitsAfter(id);
    if (next) this.open(next);
    else if (this.queue.more.value) this.goFurther();
  }

  /** A verdict was refused, perhaps because the operator changed the points meanwhile: show what there is now. */
  private async refreshItem({ measurement: { id } }: ReviewItem): Promise<void> {
    // what was begun on another one meanwhile stays
    if ((await this.queue.refresh(id)) && this.currentId.value === id) this.fixing.leave();
  }

  private clickedAgain({ clicks }: Again): void {
    this.reveal(clicks.repeat_of);
    void this.readComparisons(clicks.repeat_of);
  }

  private async readComparisons(id: number): Promise<void> {
    await telling(async () => {
      const found = await this.repeats.read(id);
      if (this.currentId.value !== id) return;
      this.repeats.comparisons.value = found;
      if (found.some(isOwn)) this.reveal(id);
    });
  }

  private followAxes(): void {
    const m = this.ofFrame.value;
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
