/** The click tool's state: recording, vehicle, tyre contacts, what the traffic says, and a turn under consideration. */
import { batch, computed, effect, signal } from "@preact/signals";
import { setQuery } from "../../core/address";
import { api } from "../../core/api";
import { History, type Ledger } from "../../core/history";
import { Latest } from "../../core/latest";
import { say } from "../../core/messages";
import { outbox, type Wish } from "../../core/outbox";
import { canWork } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { telling, toast } from "../../core/toasts";
import type { AxesAnswer, TrafficCheckBody, TurnedPose, Vehicle, WheelPair } from "../../core/types";
import { bestFrame, neighbour } from "../../parts/vehicles/passes";
import { fromServer, type ImagePoint, pair } from "../../viewer/points";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";
import { type PairAbout, pairWords, WHEEL_PAIR } from "./kinds";
import { type Clicks, WheelPairTool } from "./wheelPair";

export class TrafficModel {
  readonly reel = new Reel();
  readonly stage: FrameStage = new FrameStage(() => [this.stage.keyboard, this.clicks, this.turned]);
  readonly history = new History();
  readonly loaded = signal(false);
  readonly problem = signal<unknown>(null);
  readonly refused = signal<unknown>(null);
  readonly vehicles = signal<readonly Vehicle[]>([]);
  private readonly stored = signal<TrafficCheckBody | null>(null);
  /** What the server says; the pairs as they are wanted. */
  readonly check = computed<TrafficCheckBody | null>(() => {
    const stored = this.stored.value;
    const wishes = outbox.of<WheelPair, Clicks | null, PairAbout>(WHEEL_PAIR);
    return stored && { ...stored, pairs: withWishes(stored.pairs, wishes, this.surveyId) };
  });
  readonly vehicleId = signal<number | null>(null);
  readonly axes = signal<AxesAnswer | null>(null);
  readonly saving = signal(false);
  readonly preview = signal<TurnedPose | null>(null);
  readonly turning = signal(false);
  readonly clicks: WheelPairTool = new WheelPairTool(this);
  /** Esc leaves the turn that is looked at. */
  private readonly turned = {
    cancel: (): boolean => {
      const looked = this.preview.value !== null;
      this.preview.value = null;
      return looked;
    },
  };

  readonly passes = computed(() =>
    this.vehicles.value.filter((one) => one.recording_id === this.reel.recording.value?.id),
  );
  readonly vehicle = computed(() => this.passes.value.find((one) => one.id === this.vehicleId.value));
  readonly pose = computed(() =>
    this.check.value?.poses.find((one) => one.pose_id === this.reel.recording.value?.pose_id),
  );
  readonly pair = computed(() =>
    this.check.value?.pairs.find((one) => one.vehicle_id === this.vehicleId.value),
  );
  /** The contact through which the axes go: the first click, else the stored pair's. */
  readonly contact = computed(() => {
    const frame = this.reel.seen.value;
    const first = this.clicks.first.value;
    if (first?.frame === frame) return first?.at ?? null;
    return this.pair.value?.frame === frame && this.pair.value ? fromServer(this.pair.value.first) : null;
  });

  private readonly axesAsker = new Latest<ImagePoint, AxesAnswer>(
    (at) =>
      api.ask(
        "POST /recordings/{recording_id}/geometry/axes",
        { recording_id: this.reel.player.value?.recordingId ?? 0 },
        { body: { contact: pair(at) }, retry: true },
      ),
    (answer) => {
      this.axes.value = answer;
    },
  );
  private readonly stops: (() => void)[] = [];

  constructor(readonly surveyId: number) {
    this.stops.push(
      // what an earlier page left, or what was kept without a connection, has come through
      outbox.listen(WHEEL_PAIR, ({ about, state }: Wish<WheelPair, Clicks | null, PairAbout>) => {
        if (state === "saved" && about.surveyId === surveyId && !this.saving.value) void this.reload();
      }),
      effect(() => {
        const at = this.contact.value;
        // a turned pose is read through its own lines
        void this.reel.recording.value?.pose_id;
        this.axes.value = null;
        if (at) this.axesAsker.want(at);
        else this.axesAsker.cancel();
      }),
    );
  }

  async load(vehicleId: number | null): Promise<void> {
    this.problem.value = null;
    try {
      const [vehicles] = await Promise.all([
        api.ask("GET /surveys/{survey_id}/vehicles", { survey_id: this.surveyId }),
        this.read(),
      ]);
      this.vehicles.value = vehicles;
      const named = vehicles.find((one) => one.id === vehicleId);
      if (vehicleId !== null && !named)
        toast(say("address-elsewhere", { what: "vehicle" }), { kind: "problem" });
      const wanted = named ?? vehicles[0];
      if (wanted) this.open(wanted);
      else if (this.reel.recordings.value[0]) this.showRecording(this.reel.recordings.value[0].id, 0);
      this.loaded.value = true;
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.reel.close();
  }

  chooseRecording(id: number): void {
    const vehicle = this.vehicles.value.find((one) => one.recording_id === id);
    if (vehicle) this.open(vehicle);
    else this.showRecording(id, 0);
  }

  open(vehicle: Vehicle): void {
    const stored = this.check.value?.pairs.find((one) => one.vehicle_id === vehicle.id);
    const frame = stored?.frame ?? bestFrame(vehicle);
    batch(() => {
      this.showRecording(vehicle.recording_id, frame);
      this.vehicleId.value = vehicle.id;
      this.clicks.back();
      this.refused.value = null;
    });
    setQuery({ vehicle: vehicle.id });
  }

  openNext(step: 1 | -1): void {
    const next = neighbour(this.vehicles.value, this.vehicle.value, step);
    if (next) this.open(next);
  }

  mayClick(): boolean {
    const ready = this.vehicle.value !== undefined && this.reel.recording.value?.pose_id != null;
    return canWork.value && ready && !this.saving.value;
  }

  begun(): void {
    this.refused.value = null;
  }

  clicked(clicks: Clicks): void {
    if (this.vehicle.value) void this.change(this.vehicle.value, clicks, "checks-tyres");
  }

  async withdraw(): Promise<void> {
    if (this.pair.value && this.vehicle.value && !this.saving.value)
      await this.change(this.vehicle.value, null, "checks-withdrawal");
  }

  async previewTurn(): Promise<void> {
    const pose = this.pose.value;
    if (!pose) return;
    await telling(async () => {
      const turned = await api.ask("GET /poses/{pose_id}/turn", { pose_id: pose.pose_id });
      if (this.pose.value?.pose_id === pose.pose_id) this.preview.value = turned;
    });
  }

  async turn(): Promise<void> {
    const preview = this.preview.value;
    if (!preview) return;
    const { pose_id, turn_rad } = preview;
    await this.putPose(say("checks-turn-done"), async () => {
      await api.write("POST /poses/{pose_id}/turn", { pose_id }, { body: { turn_rad } });
    });
    if (this.preview.value === preview) this.preview.value = null;
  }

  /** Goes back to the pose before the turn, for every recording that uses the turned one. */
  async turnBack(): Promise<void> {
    const pose = this.pose.value;
    if (pose?.turned_from == null) return;
    const body = { pose_id: pose.turned_from };
    await this.putPose(say("checks-turn-back-done"), async () => {
      for (const { id } of pose.recordings)
        await api.write("PUT /recordings/{recording_id}", { recording_id: id }, { body });
    });
  }

  private async putPose(done: string, work: () => Promise<void>): Promise<void> {
    this.turning.value = true;
    await telling(async () => {
      await work();
      toast(done);
    });
    await this.reload();
    this.turning.value = false;
    void refreshSurvey();
  }

  private showRecording(id: number, frame: number): void {
    if (this.reel.player.value?.recordingId !== id) this.preview.value = null;
    this.reel.show(id, frame);
  }

  /** What each vehicle's pair is on the server; null: none. */
  private readonly pairs: Ledger<number, Clicks | null> = {
    read: (vehicleId) => {
      const stored = this.check.value?.pairs.find((one) => one.vehicle_id === vehicleId);
      return stored ? { frame: stored.frame, first: stored.first, second: stored.second } : null;
    },
    write: async (vehicleId, clicks) => {
      // taken back from elsewhere, it is shown where it happens
      const vehicle = this.vehicles.value.find((one) => one.id === vehicleId);
      if (vehicle && vehicleId !== this.vehicleId.value) this.open(vehicle);
      const stored = await outbox.store<WheelPair, Clicks | null, PairAbout>({
        key: `wheel-pair.${vehicleId}`,
        kind: WHEEL_PAIR,
        lane: `vehicle.${vehicleId}`,
        about: { id: vehicleId, surveyId: this.surveyId },
        what: say("checks-tyres", { vehicle: String(vehicle?.number ?? "") }),
        mine: clicks ? pairWords(clicks) : say("checks-tyres-none"),
        page: `/surveys/${this.surveyId}/checks?tab=traffic&vehicle=${vehicleId}`,
        saved: this.stored.value?.pairs.find((one) => one.vehicle_id === vehicleId) ?? null,
        want: clicks,
      });
      if (stored) await this.reload();
    },
  };

  private async change(
    vehicle: Vehicle,
    clicks: Clicks | null,
    what: "checks-tyres" | "checks-withdrawal",
  ): Promise<void> {
    this.saving.value = true;
    // now, not once it is stored: what is clicked or looked at meanwhile stays
    this.clicks.back();
    this.preview.value = null;
    try {
      await this.history.inTurn(() =>
        this.history.run(say(what, { vehicle: String(vehicle.number) }), (changes) =>
          changes.write(this.pairs, vehicle.id, clicks),
        ),
      );
    } catch (error) {
      this.refused.value = error;
    }
    this.saving.value = false;
  }

  private reload(): Promise<void> {
    return telling(() => this.read());
  }

  private async read(): Promise<void> {
    const [recordings, check] = await Promise.all([
      api.ask("GET /surveys/{survey_id}/recordings", { survey_id: this.surveyId }),
      api.ask("GET /surveys/{survey_id}/checks/traffic", { survey_id: this.surveyId }),
    ]);
    batch(() => {
      this.reel.recordings.value = recordings.filter((one) => one.state === "ready");
      this.stored.value = check;
    });
  }
}

function withWishes(
  stored: readonly WheelPair[],
  wishes: readonly Wish<WheelPair, Clicks | null, PairAbout>[],
  surveyId: number,
): WheelPair[] {
  const all = new Map(stored.map((one) => [one.vehicle_id, one]));
  for (const { about, want, saved } of wishes) {
    if (about.surveyId !== surveyId) continue;
    const { id: vehicle_id } = about;
    if (want) all.set(vehicle_id, { ...saved, ...want, vehicle_id, withdrawn: false } as WheelPair);
    else all.delete(vehicle_id);
  }
  return [...all.values()];
}
