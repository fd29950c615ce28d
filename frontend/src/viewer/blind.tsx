/** Clicking again without seeing: contact, then target, on one frame; stored as a repeat of what was clicked first. */
import { computed, signal } from "@preact/signals";
import { say } from "../core/messages";
import { outbox } from "../core/outbox";
import { newKey } from "../core/random";
import { toast, toastProblem } from "../core/toasts";
import type { Blind, Measurement } from "../core/types";
import { linesShown } from "./display";
import type { Geometry } from "./geometry";
import { AxesLayer, PointMark } from "./Overlay";
import type { ImagePoint } from "./points";
import type { Reel } from "./reel";
import { type Repeat, repeatWish } from "./repeats";
import type { FrameStage } from "./stage";
import type { Tool } from "./tool";

export type Wanted = Readonly<Omit<Blind, "vehicle_number">>;

/** A second click as it was made; `made` is null while the server does not have it. */
export interface Again {
  readonly key: string;
  readonly vehicleId: number;
  readonly clicks: Repeat;
  readonly made: Measurement | null;
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
    /** What is wished in one lane goes out in its order: a verdict goes behind the click that it rests on. */
    private readonly lane: string,
    private readonly stored: (again: Again) => void,
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
      const { target, frame, measurement_id: repeat_of, vehicle_id: vehicleId } = wanted;
      const clicks = { target, frame, contact, point, repeat_of };
      const key = newKey();
      const want = { clicks, withdrawn: false };
      const stored = await outbox.store(repeatWish(key, this.lane, { vehicleId }, null, want));
      if (!stored) toast(say("blind-kept"));
      this.stored({ key, vehicleId, clicks, made: stored?.saved ?? null });
    } catch (error) {
      toastProblem(error);
    } finally {
      this.busy.value = false;
    }
  }
}
