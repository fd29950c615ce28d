/** Clicking again without seeing: contact, then target, on one frame; stored as a repeat of what was clicked first. */
import { signal } from "@preact/signals";
import { api } from "../core/api";
import { newKey } from "../core/random";
import { toast, toastProblem } from "../core/toasts";
import type { Measurement, Target } from "../core/types";
import type { Geometry } from "./geometry";
import { type ImagePoint, imagePoint, pair } from "./points";
import type { Stage } from "./stage";

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

export class BlindClicks {
  readonly wanted = signal<Wanted | null>(null);
  readonly contact = signal<ImagePoint | null>(null);
  /** The cursor for placing points by keyboard; null while it is off. */
  readonly cursor = signal<ImagePoint | null>(null);
  readonly busy = signal(false);

  constructor(
    private readonly stage: Stage,
    private readonly geometry: Geometry,
    private readonly stored: (made: Measurement) => void,
  ) {}

  start(wanted: Wanted | null): void {
    this.wanted.value = wanted;
    this.cursor.value = null;
    this.forget();
  }

  /** A click on the frame that is shown, or Enter at the keyboard's cursor. */
  async place(point: ImagePoint, shownFrame: number | null): Promise<void> {
    const wanted = this.wanted.value;
    if (!wanted || this.busy.value) return;
    if (shownFrame !== wanted.frame) {
      toast(`Click on frame ${wanted.frame}, where the first clicks are.`);
      return;
    }
    const contact = this.contact.value;
    if (!contact) {
      this.contact.value = point;
      const { recording_id: recordingId, target } = wanted;
      this.geometry.showAxes({ recordingId, contact: point, target, inset: null });
      return;
    }
    await this.store(wanted, contact, point);
  }

  /** The contact is taken back; false if there is none. */
  takeBack(): boolean {
    if (!this.contact.value) return false;
    this.forget();
    return true;
  }

  toggleCursor(): void {
    const { width, height } = this.stage.viewport.value.image;
    if (this.cursor.value) this.cursor.value = null;
    else this.moveTo(this.stage.pointer.value ?? imagePoint(Math.round(width / 2), Math.round(height / 2)));
  }

  nudge(dx: number, dy: number): boolean {
    const at = this.cursor.value;
    if (!at) return false;
    this.moveTo(imagePoint(at[0] + dx, at[1] + dy));
    return true;
  }

  private moveTo(to: ImagePoint): void {
    const { width, height } = this.stage.viewport.value.image;
    const within = (value: number, size: number): number => Math.min(Math.max(value, 0), size - 1);
    const at = imagePoint(within(to[0], width), within(to[1], height));
    this.cursor.value = at;
    this.stage.viewport.value = this.stage.viewport.value.revealing(at);
    this.stage.pointer.value = at;
  }

  private forget(): void {
    this.contact.value = null;
    this.geometry.showAxes(null);
  }

  private async store(wanted: Wanted, contact: ImagePoint, point: ImagePoint): Promise<void> {
    this.busy.value = true;
    try {
      const { target, frame, measurement_id: repeat_of } = wanted;
      const clicks = { target, frame, contact: pair(contact), point: pair(point), repeat_of };
      const body = { client_key: newKey(), ...clicks };
      const path = `/vehicles/${wanted.vehicle_id}/measurements`;
      const made = await api.post<Measurement>(path, body, { retry: true });
      this.stored(made);
    } catch (error) {
      toastProblem(error);
    } finally {
      this.busy.value = false;
    }
  }
}
