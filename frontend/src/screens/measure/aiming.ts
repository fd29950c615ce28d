/** What is drawn and asked for where the pointer is: the axes through the contact and the height under a resting pointer. */
import { computed, effect, untracked } from "@preact/signals";
import { AFTER_CLICK_MS } from "../../viewer/geometry";
import type { ImagePoint } from "../../viewer/points";
import type { PassDesk } from "./desk";
import type { SecondFrame } from "./secondFrame";

export class Aiming {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly stops: readonly (() => void)[];

  constructor(
    private readonly desk: PassDesk,
    private readonly second: SecondFrame,
  ) {
    this.stops = [
      effect(() => this.followAxes()),
      effect(() => this.refuseContact()),
      effect(() => {
        void this.aim.value;
        untracked(() => this.aimAgain());
      }),
    ];
  }

  close(): void {
    for (const stop of this.stops) stop();
    clearTimeout(this.timer);
  }

  /** What a height under the pointer is of: of anything else it would be a wrong number that looks right. */
  private readonly aim = computed(() => {
    const target = this.second.now.value?.target ?? this.desk.flow.value.target;
    const { inset_m, u_inset_m } = (target && this.desk.insetOf(target)) ?? {};
    const click = `${this.desk.seenFrame.value} ${target} ${this.desk.contact.value} ${this.desk.awaiting.value}`;
    return `${click} ${inset_m} ${u_inset_m} ${this.desk.vehicle.value?.side}`;
  });
  private followAxes(): void {
    const contact: ImagePoint | null = this.desk.contact.value;
    const recordingId = this.desk.reel.player.value?.recordingId;
    const target = this.desk.flow.value.target ?? "roof";
    const show = contact !== null && recordingId !== undefined && this.desk.hasPose.value;
    const of = { vehicleId: this.desk.vehicleId.value, side: this.desk.vehicle.value?.side ?? null };
    this.desk.geometry.showAxes(
      show ? { recordingId, contact, target, inset: this.desk.insetOf(target), ...of } : null,
    );
  }

  /** The height under a resting pointer was of something else: it goes at once, and is asked for again. */
  private aimAgain(): void {
    if (this.desk.stage.dragging.value) return;
    this.desk.geometry.forgetHeight();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      const at = this.desk.stage.pointer.value;
      if (at && !this.desk.stage.dragging.value) this.desk.stage.hover(at);
    }, AFTER_CLICK_MS);
  }

  /** A contact that cannot be on the road (above the horizon, outside the lens): the next click places it again. */
  private refuseContact(): void {
    if (this.desk.geometry.axes.value?.ok !== false) return;
    untracked(() => {
      if (this.desk.standing.entriesHere().length === 0) this.desk.dispatch({ type: "new-contact" });
    });
  }
}
