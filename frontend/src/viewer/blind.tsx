/** Clicking again without seeing: contact, then target, on one frame; stored as a repeat of what was clicked first. */
import { computed, signal } from "@preact/signals";
import { api } from "../core/api";
import { say } from "../core/messages";
import { newKey } from "../core/random";
import { toast, toastProblem } from "../core/toasts";
import type { Measurement, Target } from "../core/types";
import { linesShown } from "./display";
import type { Geometry } from "./geometry";
import { AxesLayer, PointMark } from "./Overlay";
import { type ImagePoint, pair } from "./points";
import type { Reel } from "./reel";
import type { FrameStage } from "./stage";
import type { Tool } from "./tool";

/** What is to be clicked again; its own points are not in it. */
export interface Wanted {
  readonly measurement_id: number;
  readonly vehicle_id: number;
  readonly recording_id: number;
  readonly frame: number;
  readonly target: Target;
}

/** The sampling plan: every n-th measurement by a hash of its number, so that each reviewer gets the same ones. */
export function isDrawn(measurementId: number, oneIn: number): boolean {
  if (oneIn <= 0) return false;
  let hash = Math.imul(measurementId, 0x9e3779b1);
  hash = Math.imul(hash ^ (hash >>> 15), 0x85ebca6b);
  return ((hash ^ (hash >>> 13)) >>> 0) % oneIn === 0;
}

export class BlindClicks implements Tool<ImagePoint> {
  readonly wanted = signal<Wanted | null>(null);
  readonly contact = signal<ImagePoint | null>(null);
  readonly busy = signal(false);

  /** The frame to click on is the one that is seen. */
  readonly here = computed(
    () => this.wanted.value !== null && this.reel.seen.value === this.wanted.value.frame,
  );
  readonly placing = computed(() => this.here.value && !this.busy.value);
  readonly hint = computed(() => {
    const wanted = this.wanted.value;
    if (!wanted) return null;
    if (!this.here.value) return say("blind-elsewhere", { frame: String(wanted.frame) });
    return this.contact.value ? say("blind-target", { target: wanted.target }) : say("blind-contact");
  });

  constructor(
    private readonly stage: FrameStage,
    private readonly reel: Reel,
    private readonly geometry: Geometry,
    private readonly stored: (made: Measurement) => void,
  ) {}

  begin(wanted: Wanted | null): void {
    this.wanted.value = wanted;
    this.stage.keyboard.off();
    this.forget();
  }

  place(point: ImagePoint): boolean {
    const wanted = this.wanted.value;
    if (!wanted) return false;
    if (this.busy.value) return true;
    const contact = this.contact.value;
    if (!this.here.value) toast(say("blind-wrong-frame", { frame: String(wanted.frame) }));
    else if (contact) void this.store(wanted, contact, point);
    else {
      this.contact.value = point;
      const { recording_id: recordingId, target } = wanted;
      this.geometry.showAxes({ recordingId, contact: point, target, inset: null });
    }
    return true;
  }

  /** The contact is taken back; false if there is none. */
  back(): boolean {
    if (!this.contact.value) return false;
    this.forget();
    return true;
  }

  cancel(): boolean {
    return this.back();
  }

  layers() {
    const contact = this.contact.value;
    const axes = this.geometry.axes.value?.axes;
    if (!this.here.value || !contact) return null;
    return (
      <>
        {linesShown.value && axes && <AxesLayer axes={axes} stage={this.stage} />}
        <PointMark stage={this.stage} at={contact} kind="contact" selected />
      </>
    );
  }

  private forget(): void {
    this.contact.value = null;
    this.geometry.showAxes(null);
  }

  private async store(wanted: Wanted, contact: ImagePoint, point: ImagePoint): Promise<void> {
    this.busy.value = true;
    try {
      const { target, frame, measurement_id: repeat_of } = wanted;
      const clicks = { target, frame, contact: pair(contact), target_point: pair(point), repeat_of };
      const body = { client_key: newKey(), ...clicks };
      const made = await api.write(
        "POST /vehicles/{vehicle_id}/measurements",
        { vehicle_id: wanted.vehicle_id },
        { body, retry: true },
      );
      this.stored(made);
    } catch (error) {
      toastProblem(error);
    } finally {
      this.busy.value = false;
    }
  }
}
