/** The click tool's state: recording, vehicle, tyre contacts, what the traffic says, and a turn under consideration. */
import { batch, computed, effect, signal } from "@preact/signals";
import { setQuery } from "../../core/address";
import { api } from "../../core/api";
import { Latest } from "../../core/latest";
import { canWork } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast, toastProblem } from "../../core/toasts";
import type { AxesAnswer, Recording, Vehicle } from "../../core/types";
import { bestFrame, neighbour } from "../../parts/vehicles/passes";
import { Player } from "../../viewer/player";
import { fromServer, type ImagePoint, imagePoint, pair } from "../../viewer/points";
import { Stage } from "../../viewer/stage";
import type { TrafficCheck, TurnedPose, WheelPair } from "./types";

interface Clicks {
  frame: number;
  frame_crc?: number;
  first: [number, number];
  second: [number, number];
}

/** What brings a vehicle back to how it was: its pair before, or none. */
interface Undo {
  vehicleId: number;
  before: Clicks | null;
}

export class TrafficModel {
  readonly stage = new Stage();
  readonly loaded = signal(false);
  readonly problem = signal<unknown>(null);
  /** Why the last two clicks were not taken. */
  readonly refused = signal<unknown>(null);
  readonly recordings = signal<readonly Recording[]>([]);
  readonly vehicles = signal<readonly Vehicle[]>([]);
  readonly check = signal<TrafficCheck | null>(null);
  readonly player = signal<Player | null>(null);
  readonly vehicleId = signal<number | null>(null);
  /** The first tyre, while the second is still to be clicked. */
  readonly first = signal<{ frame: number; at: ImagePoint } | null>(null);
  readonly cursor = signal<ImagePoint | null>(null);
  readonly axes = signal<AxesAnswer | null>(null);
  readonly saving = signal(false);
  readonly preview = signal<TurnedPose | null>(null);
  readonly turning = signal(false);
  readonly undos = signal<readonly Undo[]>([]);

  readonly recording = computed(() =>
    this.recordings.value.find((one) => one.id === this.player.value?.recordingId),
  );
  readonly passes = computed(() =>
    this.vehicles.value.filter((one) => one.recording_id === this.recording.value?.id),
  );
  readonly vehicle = computed(() => this.passes.value.find((one) => one.id === this.vehicleId.value));
  readonly pose = computed(() =>
    this.check.value?.poses.find((one) => one.pose_id === this.recording.value?.pose_id),
  );
  readonly pair = computed(() =>
    this.check.value?.pairs.find((one) => one.vehicle_id === this.vehicleId.value),
  );
  readonly shownFrame = computed(() => this.player.value?.shown.value?.frame ?? null);
  readonly placing = computed(
    () => canWork.value && this.vehicle.value !== undefined && this.recording.value?.pose_id != null,
  );
  /** The contact through which the axes go: the first click, else the stored pair's. */
  readonly contact = computed(() => {
    const frame = this.shownFrame.value;
    if (this.first.value?.frame === frame) return this.first.value?.at ?? null;
    return this.pair.value?.frame === frame && this.pair.value ? fromServer(this.pair.value.first) : null;
  });

  private readonly axesAsker = new Latest<ImagePoint, AxesAnswer>(
    (at) =>
      api.post<AxesAnswer>(
        `/recordings/${this.player.value?.recordingId}/geometry/axes`,
        { contact: pair(at) },
        { quiet: true },
      ),
    (answer) => {
      this.axes.value = answer;
    },
  );
  private readonly stops: (() => void)[] = [];

  constructor(readonly surveyId: number) {
    this.stops.push(
      effect(() => {
        const at = this.contact.value;
        // a turned pose is read through its own lines
        void this.recording.value?.pose_id;
        this.axes.value = null;
        if (at) this.axesAsker.want(at);
        else this.axesAsker.cancel();
      }),
      // a tyre clicked on one frame cannot go with another on the next: the vehicle has moved
      effect(() => {
        const frame = this.shownFrame.value;
        const first = this.first.peek();
        if (first && frame !== null && first.frame !== frame) this.first.value = null;
      }),
    );
  }

  async load(vehicleId: number | null): Promise<void> {
    this.problem.value = null;
    try {
      const [recordings, vehicles, check] = await Promise.all([
        api.get<Recording[]>(`/surveys/${this.surveyId}/recordings`),
        api.get<Vehicle[]>(`/surveys/${this.surveyId}/vehicles`),
        api.get<TrafficCheck>(`/surveys/${this.surveyId}/checks/traffic`),
      ]);
      batch(() => {
        this.recordings.value = recordings.filter((one) => one.state === "ready");
        this.vehicles.value = vehicles;
        this.check.value = check;
      });
      const wanted = vehicles.find((one) => one.id === vehicleId) ?? vehicles[0];
      if (wanted) this.open(wanted);
      else if (this.recordings.value[0]) this.openRecording(this.recordings.value[0].id);
      this.loaded.value = true;
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.player.value?.close();
  }

  openRecording(id: number, frame = 0): void {
    const recording = this.recordings.value.find((one) => one.id === id);
    if (!recording || this.player.value?.recordingId === id) return;
    this.player.value?.close();
    const player = new Player(id, frame);
    player.describe(recording);
    batch(() => {
      this.player.value = player;
      this.preview.value = null;
    });
  }

  /** Another recording, with its first pass. */
  chooseRecording(id: number): void {
    const vehicle = this.vehicles.value.find((one) => one.recording_id === id);
    if (vehicle) this.open(vehicle);
    else this.openRecording(id);
  }

  open(vehicle: Vehicle): void {
    const stored = this.check.value?.pairs.find((one) => one.vehicle_id === vehicle.id);
    const frame = stored?.frame ?? bestFrame(vehicle);
    this.openRecording(vehicle.recording_id, frame);
    batch(() => {
      this.vehicleId.value = vehicle.id;
      this.first.value = null;
      this.refused.value = null;
    });
    this.player.value?.go(frame);
    setQuery({ vehicle: vehicle.id });
  }

  openNext(step: 1 | -1): void {
    const next = neighbour(this.vehicles.value, this.vehicle.value, step);
    if (next) this.open(next);
  }

  /** A click on the frame, or Enter at the cursor: the first tyre, then the second. */
  place(at: ImagePoint): void {
    const frame = this.shownFrame.value;
    if (!this.placing.value || this.saving.value || frame === null) return;
    this.refused.value = null;
    if (this.first.value === null) {
      this.first.value = { frame, at };
      return;
    }
    const frame_crc = this.player.value?.checksumOf(frame);
    const clicks = { frame, first: pair(this.first.value.at), second: pair(at) };
    void this.store(frame_crc === undefined ? clicks : { ...clicks, frame_crc });
  }

  async undo(): Promise<void> {
    if (this.first.value) {
      this.first.value = null;
      return;
    }
    const last = this.undos.value.at(-1);
    if (!last || this.saving.value) return;
    this.undos.value = this.undos.value.slice(0, -1);
    const vehicle = this.vehicles.value.find((one) => one.id === last.vehicleId);
    if (vehicle && vehicle.id !== this.vehicleId.value) this.open(vehicle);
    await this.write(last.vehicleId, last.before);
  }

  /** Takes the vehicle's pair out of the check. */
  async withdraw(): Promise<void> {
    const before = this.pair.value;
    if (!before || this.saving.value) return;
    if (await this.write(before.vehicle_id, null)) this.remember(before.vehicle_id, clicksOf(before));
  }

  async previewTurn(): Promise<void> {
    const pose = this.pose.value;
    if (!pose) return;
    try {
      this.preview.value = await api.get<TurnedPose>(`/poses/${pose.pose_id}/turn`);
    } catch (error) {
      toastProblem(error);
    }
  }

  async turn(): Promise<void> {
    const preview = this.preview.value;
    if (!preview) return;
    this.turning.value = true;
    try {
      await api.post(`/poses/${preview.pose_id}/turn`, { turn_rad: preview.turn_rad });
      toast("The turned pose now holds for new measurements; stored ones keep theirs.");
    } catch (error) {
      toastProblem(error);
    }
    await this.reload();
    batch(() => {
      this.preview.value = null;
      this.turning.value = false;
    });
    void refreshSurvey();
  }

  /** Goes back to the pose before the turn, for every recording that uses the turned one. */
  async turnBack(): Promise<void> {
    const pose = this.pose.value;
    if (pose?.turned_from == null) return;
    this.turning.value = true;
    try {
      for (const one of pose.recordings)
        await api.put(`/recordings/${one.id}`, { pose_id: pose.turned_from });
      toast("The pose before the turn holds again.");
    } catch (error) {
      toastProblem(error);
    }
    await this.reload();
    this.turning.value = false;
  }

  toggleCursor(): void {
    this.cursor.value = this.cursor.value ? null : (this.stage.pointer.value ?? this.stage.centre());
  }

  moveCursor(dx: number, dy: number): boolean {
    const at = this.cursor.value;
    if (!at) return false;
    const moved = imagePoint(at[0] + dx, at[1] + dy);
    if (this.stage.viewport.value.contains(moved)) {
      this.cursor.value = moved;
      this.stage.pointer.value = moved;
    }
    return true;
  }

  private async store(clicks: Clicks): Promise<void> {
    const id = this.vehicleId.value;
    const before = this.pair.value;
    if (id !== null && (await this.write(id, clicks))) this.remember(id, before ? clicksOf(before) : null);
  }

  private remember(vehicleId: number, before: Clicks | null): void {
    this.undos.value = [...this.undos.value, { vehicleId, before }];
  }

  private async write(vehicleId: number, clicks: Clicks | null): Promise<boolean> {
    this.saving.value = true;
    let done = false;
    try {
      const path = `/vehicles/${vehicleId}/wheel-pair`;
      if (clicks) await api.post(path, clicks);
      else await api.del(path);
      done = true;
      await this.reload();
    } catch (error) {
      this.refused.value = error;
    }
    batch(() => {
      this.first.value = null;
      this.preview.value = null;
      this.saving.value = false;
    });
    return done;
  }

  private async reload(): Promise<void> {
    try {
      const [recordings, check] = await Promise.all([
        api.get<Recording[]>(`/surveys/${this.surveyId}/recordings`),
        api.get<TrafficCheck>(`/surveys/${this.surveyId}/checks/traffic`),
      ]);
      batch(() => {
        this.recordings.value = recordings.filter((one) => one.state === "ready");
        this.check.value = check;
      });
    } catch (error) {
      toastProblem(error);
    }
  }
}

function clicksOf(stored: WheelPair): Clicks {
  return { frame: stored.frame, first: stored.first, second: stored.second };
}
