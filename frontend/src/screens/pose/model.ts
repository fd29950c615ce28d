/** The road pose page's state: recording, lens, board, span, tape; the board found on the frame; the pose and its history. */
import { batch, computed, effect, signal } from "@preact/signals";
import { asked, query } from "../../core/address";
import { api, explain } from "../../core/api";
import { cancelJob, followInto } from "../../core/jobs";
import { Latest } from "../../core/latest";
import { say, sentenceOf } from "../../core/messages";
import { canWork } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { telling, toast, toastProblem } from "../../core/toasts";
import type { BoardFinding, Camera, Job, Pose, PoseSummary, StillSpan } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { linesShown } from "../../viewer/display";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";
import {
  type BoardForm,
  type BoardSought,
  boardOf,
  EMPTY_FORM,
  fromPose,
  inUnit,
  NOT_MEASURED,
  problemsOf,
  requestOf,
} from "./form";

/** A frame is looked at for the board when the operator rests on it for so long. */
const REST_MS = 300;

export class PoseModel {
  readonly reel = new Reel();
  readonly stage = new FrameStage();
  readonly loaded = signal(false);
  readonly problem = signal<unknown>(null);
  readonly cameras = signal<readonly Camera[]>([]);
  readonly poses = signal<readonly PoseSummary[]>([]);
  readonly form = signal<BoardForm>(EMPTY_FORM);
  readonly finding = signal<BoardFinding | null>(null);
  readonly findingProblem = signal<string | null>(null);
  readonly looking = signal(false);
  readonly job = signal<Job | null>(null);
  readonly pose = signal<Pose | null>(null);
  readonly tried = signal(false);
  /** The frames in which the board was found to stand still, until they are taken or others are marked. */
  readonly offered = signal<StillSpan | null>(null);
  /** Counts up when a pose was found just now: its verdict is to be seen. */
  readonly found = signal(0);

  /** Calibrations of the recording's camera first; of the others if it has none. */
  readonly calibrations = computed(() => {
    const own = this.cameras.value.filter((camera) => camera.id === this.reel.recording.value?.camera_id);
    const from = own.length > 0 ? own : this.cameras.value;
    return from.flatMap((camera) =>
      camera.calibrations.map((one) => ({
        ...one,
        camera: camera.name,
        current: camera.current_calibration_id === one.id,
      })),
    );
  });
  readonly running = computed(() => {
    const state = this.job.value?.state;
    return state === "queued" || state === "running";
  });
  readonly problems = computed(() => problemsOf(this.form.value));

  /** Changes only with the board that is looked for, not with every letter typed. */
  private readonly boardSought = computed(() => JSON.stringify(boardOf(this.form.value)));

  private readonly looker = new Latest<
    { recordingId: number; frame: number; board: BoardSought },
    BoardFinding
  >(
    ({ recordingId, frame, board }) => {
      const { calibrationId } = this.form.value;
      const body = { frame, ...board, ...(calibrationId === null ? {} : { calibration_id: calibrationId }) };
      return api.ask("POST /recordings/{recording_id}/board", { recording_id: recordingId }, { body });
    },
    (finding, wish) => {
      this.looking.value = false;
      const player = this.reel.player.value;
      if (player?.recordingId !== wish.recordingId || player.frame.value !== wish.frame) return;
      this.finding.value = finding;
      this.findingProblem.value = finding.found ? null : sentenceOf(finding.reason);
      if (finding.found) void this.offerSpan(wish);
    },
    (error) => {
      this.looking.value = false;
      this.findingProblem.value = explain(error);
    },
  );
  private readonly stops: (() => void)[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly stopJob = new AbortController();

  constructor(readonly surveyId: number) {
    let unit = lengthUnit.peek();
    this.stops.push(
      effect(() => this.lookWhenResting()),
      // the lengths that are typed stay what they are
      effect(() => {
        const now = lengthUnit.value;
        if (now !== unit) this.form.value = inUnit(this.form.peek(), unit, now);
        unit = now;
      }),
    );
  }

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const [cameras] = await Promise.all([
        api.ask("GET /surveys/{survey_id}/cameras", { survey_id: this.surveyId }),
        this.read(),
      ]);
      batch(() => {
        this.cameras.value = cameras;
        this.loaded.value = true;
      });
      const wanted = asked("recording");
      const ready = this.reel.recordings.value.filter((one) => one.state === "ready");
      if (wanted !== null && !ready.some((one) => one.id === wanted))
        toast(say("address-elsewhere", { what: "recording" }), { kind: "problem" });
      const first =
        ready.find((one) => one.id === wanted) ?? ready.find((one) => one.pose_id === null) ?? ready[0];
      if (first) await this.openRecording(first.id);
    } catch (error) {
      this.problem.value = error;
    }
  }

  private async read(): Promise<void> {
    const [recordings, poses] = await Promise.all([
      api.ask("GET /surveys/{survey_id}/recordings", { survey_id: this.surveyId }),
      api.ask("GET /surveys/{survey_id}/poses", { survey_id: this.surveyId }),
    ]);
    batch(() => {
      this.reel.recordings.value = recordings;
      this.poses.value = poses;
    });
  }

  close(): void {
    for (const stop of this.stops) stop();
    clearTimeout(this.timer);
    this.stopJob.abort();
    this.reel.close();
  }

  async openRecording(id: number): Promise<void> {
    const recording = this.reel.recordings.value.find((one) => one.id === id);
    if (!recording) return;
    const frame = Number(query.value.get("frame") ?? 0);
    batch(() => {
      this.reel.show(id, Math.max(0, frame));
      if (!this.running.value) this.job.value = null;
      this.pose.value = null;
      this.finding.value = null;
      this.offered.value = null;
    });
    const calibrations = this.calibrations.value;
    const current = calibrations.find((one) => one.current) ?? calibrations.at(-1);
    this.set({ ...NOT_MEASURED, calibrationId: current?.id ?? null, first: null, last: null });
    const poseId = recording.pose_id ?? this.poses.value.find((one) => one.recording_id === id)?.id;
    if (poseId !== undefined && poseId !== null) await this.showPose(poseId);
    else if (this.poses.value[0]) await this.borrowBoard(this.poses.value[0].id);
  }

  set(change: Partial<BoardForm>): void {
    this.form.value = { ...this.form.value, ...change };
  }

  mark(end: "first" | "last"): void {
    this.offered.value = null;
    const frame = this.reel.player.value?.frame.value ?? 0;
    const { first, last } = this.form.value;
    if (end === "first") this.set({ first: frame, last: last !== null && last < frame ? null : last });
    else this.set({ last: frame, first: first === null || first > frame ? frame : first });
  }

  /** The frames in which a board that was found stands still, where nobody has marked any: to be taken with one click. */
  private async offerSpan(wish: { recordingId: number; frame: number; board: BoardSought }): Promise<void> {
    const marked = this.form.value.first !== null && this.form.value.last !== null;
    if (marked || !canWork.value || this.offered.value) return;
    const { recordingId, frame, board } = wish;
    try {
      const found = await api.ask(
        "POST /recordings/{recording_id}/board/span",
        { recording_id: recordingId },
        { body: { frame, ...board } },
      );
      // what was marked or opened meanwhile counts
      const { first, last } = this.form.value;
      if (this.reel.player.value?.recordingId === recordingId && (first === null || last === null))
        this.offered.value = found;
    } catch {
      // marked by hand instead
    }
  }

  takeOffered(): void {
    const found = this.offered.value;
    this.offered.value = null;
    if (found) this.set({ first: found.first_frame, last: found.last_frame });
  }

  lookNow(): void {
    const player = this.reel.player.value;
    const board = boardOf(this.form.value);
    if (!player || board === null) return;
    this.looking.value = true;
    this.looker.want({ recordingId: player.recordingId, frame: player.frame.value, board });
  }

  async run(): Promise<void> {
    this.tried.value = true;
    const body = requestOf(this.form.value);
    const recording = this.reel.recording.value;
    if (!body || !recording) return;
    try {
      this.pose.value = null;
      const job = await api.write(
        "POST /recordings/{recording_id}/poses",
        { recording_id: recording.id },
        { body },
      );
      await this.finished(await followInto(this.job, job, this.stopJob.signal), recording.id);
    } catch (error) {
      if (this.stopJob.signal.aborted) return;
      this.job.value = null;
      toastProblem(error);
    }
  }

  cancel(): void {
    const job = this.job.value;
    if (job) void cancelJob(job.id).catch(toastProblem);
  }

  async showPose(id: number): Promise<void> {
    const open = this.reel.player.value;
    await telling(async () => {
      const pose = await api.ask("GET /poses/{pose_id}", { pose_id: id });
      if (this.reel.player.value !== open) return; // another recording was opened meanwhile
      const own = pose.recording_id === open?.recordingId;
      batch(() => {
        this.pose.value = pose;
        this.set(fromPose(pose, own));
      });
      if (own && this.finding.value === null) open?.go(pose.first_frame);
    });
  }

  async choose(id: number): Promise<void> {
    const recording = this.reel.recording.value;
    if (!recording) return;
    await telling(async () => {
      const changed = await api.write(
        "PUT /recordings/{recording_id}",
        { recording_id: recording.id },
        { body: { pose_id: id } },
      );
      this.reel.recordings.value = this.reel.recordings.value.map((one) =>
        one.id === changed.id ? changed : one,
      );
      if (this.reel.recording.value?.id === recording.id) await this.showPose(id);
      toast(say("pose-chosen"));
      void refreshSurvey();
    });
  }

  private async finished(job: Job, recordingId: number): Promise<void> {
    if (job.state !== "done") return;
    const id = job.result?.["pose_id"];
    await this.read();
    batch(() => {
      this.job.value = null;
      linesShown.value = true;
    });
    void refreshSurvey();
    if (typeof id !== "number" || this.reel.player.value?.recordingId !== recordingId) return;
    await this.showPose(id);
    this.found.value += 1;
  }

  /** The board of an earlier pose is most likely the same board: take its size, not its tape. */
  private async borrowBoard(id: number): Promise<void> {
    try {
      const open = this.reel.player.value;
      const pose = await api.ask("GET /poses/{pose_id}", { pose_id: id });
      const { columns, rows, square } = fromPose(pose, false);
      if (this.reel.player.value === open) this.set({ columns, rows, square });
    } catch {
      // the form stays as it is: the operator fills it in
    }
  }

  private lookWhenResting(): void {
    const frame = this.reel.seen.value;
    const told = this.boardSought.value !== "null";
    clearTimeout(this.timer);
    this.finding.value = null;
    this.findingProblem.value = null;
    if (frame === null || this.reel.player.value?.playing.value || !told) return;
    this.timer = setTimeout(() => this.lookNow(), REST_MS);
  }
}
