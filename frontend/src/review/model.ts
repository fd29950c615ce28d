/** The review queue: one measurement at a time with its picture, its points and its history; a verdict for each. */
import { batch, computed, effect, signal } from "@preact/signals";
import { api } from "../api";
import { Geometry } from "../measure/geometry";
import { setQuery } from "../router";
import { refreshSurvey } from "../state/survey";
import { toast, toastProblem } from "../state/toasts";
import type { Measurement, Recording, ReviewItem, Verdict } from "../types";
import { Player } from "../viewer/player";
import { fromServer, type ImagePoint, imagePoint, pair } from "../viewer/points";
import { Stage } from "../viewer/stage";

/** The states that the queue can be asked for; reopened ones are to review again. */
export type Shown = Exclude<Verdict, "reopened"> | "all";

/** Points of a fix that has not been saved yet. */
export interface Fix {
  readonly contact: ImagePoint;
  readonly point: ImagePoint;
  readonly selected: "contact" | "point";
}

export class ReviewModel {
  readonly stage = new Stage();
  readonly geometry = new Geometry();
  readonly shown = signal<Shown>("to_review");
  readonly items = signal<readonly ReviewItem[] | null>(null);
  readonly problem = signal<unknown>(null);
  readonly currentId = signal<number | null>(null);
  readonly player = signal<Player | null>(null);
  readonly fix = signal<Fix | null>(null);
  readonly rejecting = signal(false);
  readonly busy = signal(false);

  readonly current = computed(
    () => this.items.value?.find((item) => item.measurement.id === this.currentId.value) ?? null,
  );
  readonly contact = computed<ImagePoint | null>(() => {
    const m = this.current.value?.measurement;
    return this.fix.value?.contact ?? (m ? fromServer(m.contact) : null);
  });
  readonly point = computed<ImagePoint | null>(() => {
    const m = this.current.value?.measurement;
    return this.fix.value?.point ?? (m ? fromServer(m.point) : null);
  });
  /** The picture that is seen is the one the points were clicked on. */
  readonly onFrame = computed(
    () => this.player.value?.shown.value?.frame === this.current.value?.measurement.frame,
  );

  private recordings: readonly Recording[] = [];

  /** Whether a fix would be computed with another road pose than the measurement was: then its words say so. */
  poseChanged(m: Measurement): boolean {
    const now = this.recordings.find((one) => one.id === m.recording_id)?.pose_id;
    return now !== undefined && m.pose_id !== null && now !== m.pose_id;
  }

  private readonly stops: (() => void)[] = [];

  constructor(readonly surveyId: number) {
    this.stops.push(effect(() => this.followAxes()));
  }

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const [items, recordings] = await Promise.all([
        this.read(),
        this.recordings.length > 0
          ? this.recordings
          : api.get<Recording[]>(`/surveys/${this.surveyId}/recordings`),
      ]);
      this.recordings = recordings;
      this.items.value = items;
      const wanted = Number(new URLSearchParams(location.search).get("measurement"));
      const first =
        items.find((item) => item.measurement.id === wanted) ?? items.find((item) => !item.mine) ?? items[0];
      if (first) this.open(first);
      else this.currentId.value = null;
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.player.value?.close();
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
      this.fix.value = null;
      this.rejecting.value = false;
      this.geometry.forgetHeight();
      this.showFrame(m);
    });
    setQuery({ measurement: m.id });
  }

  /** Back to the frame on which the points were clicked. */
  showFrame(m: Measurement): void {
    const now = this.player.value;
    if (now?.recordingId === m.recording_id) {
      now.stop();
      now.go(m.frame);
      return;
    }
    now?.close();
    const player = new Player(m.recording_id, m.frame);
    const facts = this.recordings.find((one) => one.id === m.recording_id);
    if (facts) player.describe(facts);
    this.player.value = player;
  }

  go(step: 1 | -1): void {
    const items = this.items.value ?? [];
    const at = items.findIndex((item) => item.measurement.id === this.currentId.value);
    const next = items[at + step];
    if (next) this.open(next);
    else toast(step === 1 ? "This is the end of the queue." : "This is the start of the queue.");
  }

  /** True if this person may give a verdict on what is shown. */
  get mayJudge(): boolean {
    return this.current.value !== null && !this.current.value.mine && !this.busy.value;
  }

  async judge(verdict: "accepted" | "rejected" | "fixed" | "reopened", reason?: string): Promise<void> {
    const item = this.current.value;
    if (!item || !this.mayJudge) return;
    const fix = this.fix.value;
    const points =
      verdict === "fixed" && fix
        ? { contact: pair(fix.contact), point: pair(fix.point), frame: item.measurement.frame }
        : {};
    this.busy.value = true;
    try {
      const body = { revision: item.measurement.revision, verdict, ...(reason ? { reason } : {}), ...points };
      const judged = await api.post<Measurement>(`/measurements/${item.measurement.id}/reviews`, body);
      this.after(item, judged);
      void refreshSurvey();
    } catch (error) {
      toastProblem(error);
      await this.refreshItem(item);
    } finally {
      this.busy.value = false;
    }
  }

  startFix(): void {
    const { contact, point } = { contact: this.contact.value, point: this.point.value };
    if (!contact || !point || !this.mayJudge) return;
    this.rejecting.value = false;
    this.fix.value = { contact, point, selected: "point" };
    const m = this.current.value?.measurement;
    if (m) this.player.value?.go(m.frame);
    this.stage.focus();
  }

  move(role: "contact" | "point", to: ImagePoint): void {
    const fix = this.fix.value;
    if (!fix) return;
    this.fix.value = { ...fix, [role]: to, selected: role };
    this.askHeight();
  }

  nudge(dx: number, dy: number): boolean {
    const fix = this.fix.value;
    if (!fix) return false;
    const at = fix[fix.selected];
    this.move(fix.selected, imagePoint(at[0] + dx, at[1] + dy));
    return true;
  }

  cancel(): void {
    if (this.fix.value) this.fix.value = null;
    this.rejecting.value = false;
    this.geometry.forgetHeight();
  }

  private askHeight(): void {
    const m = this.current.value?.measurement;
    const fix = this.fix.value;
    if (!m || !fix) return;
    const inset = { inset_m: m.inset_m, u_inset_m: m.u_inset_m };
    this.geometry.wantHeight({
      recordingId: m.recording_id,
      target: m.target,
      frame: m.frame,
      contact: fix.contact,
      point: fix.point,
      inset,
      sigma_px: m.sigma_px,
    });
  }

  /** What has been judged leaves the queue of the unjudged, and the next one opens. */
  private after(item: ReviewItem, judged: Measurement): void {
    const items = this.items.value ?? [];
    const at = items.indexOf(item);
    // one's own measurements wait for somebody else: go on with the next that can be judged
    const next = items.find((other, i) => i > at && !other.mine) ?? items[at + 1] ?? items[at - 1];
    const stays = this.shown.value === "all" || this.shown.value === judged.review.verdict;
    batch(() => {
      this.items.value = stays
        ? items.map((other) => (other === item ? { ...item, measurement: judged } : other))
        : items.filter((other) => other !== item);
      if (next) this.open(next);
      else {
        this.currentId.value = stays ? judged.id : null;
        this.fix.value = null;
        this.rejecting.value = false;
      }
    });
  }

  /** A verdict was refused, perhaps because the operator changed the points meanwhile: show what there is now. */
  private async refreshItem(item: ReviewItem): Promise<void> {
    try {
      const measurement = await api.get<Measurement>(`/measurements/${item.measurement.id}`);
      if (measurement.revision === item.measurement.revision) return;
      this.items.value = (this.items.value ?? []).map((other) =>
        other === item ? { ...item, measurement } : other,
      );
      this.fix.value = null;
    } catch {
      // the refusal's own sentence has been shown
    }
  }

  private read(): Promise<ReviewItem[]> {
    return api.get<ReviewItem[]>(`/surveys/${this.surveyId}/review-queue?state=${this.shown.value}`);
  }

  private followAxes(): void {
    const m = this.current.value?.measurement;
    const contact = this.contact.value;
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
