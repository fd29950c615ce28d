/**
 * What Sightline proposes to click of the open vehicle: shown, corrected, and made measurements by a person's key alone.
 * Until then nothing of it is stored; what was turned down is clicked by hand.
 */
import { computed, effect, signal, untracked } from "@preact/signals";
import { api } from "../../../core/api";
import { Latest } from "../../../core/latest";
import { say } from "../../../core/messages";
import { canWork } from "../../../core/session";
import { telling, toastProblem } from "../../../core/toasts";
import type { HeightAnswer, PointProposal, Target } from "../../../core/types";
import { askHeight } from "../../../viewer/geometry";
import { fromServer, type ImagePoint, imagePoint, samePoint, screenDistance } from "../../../viewer/points";
import type { DragPhase, Handle, Tool } from "../../../viewer/tool";
import type { Desk } from "../desk";
import type { Points } from "../points";
import { Hands } from "./hands";
import { bestContact, frameOf, type InHand, type Placed, placedOf, type Role, type Shown } from "./placed";

/** A click this near to a proposed point goes to it. */
const REACH_PX = 12;

interface Answered {
  readonly contact: ImagePoint;
  readonly at: ImagePoint;
  readonly answer: HeightAnswer;
}

export class Proposals implements Tool<ImagePoint> {
  private readonly byVehicle = signal<ReadonlyMap<number, readonly PointProposal[]>>(new Map());
  private readonly corrected = signal<ReadonlyMap<Role, ImagePoint>>(new Map());
  /** Turned down: clicked by hand. */
  private readonly dropped = signal<ReadonlySet<Role>>(new Set());
  private readonly answers = signal<ReadonlyMap<Target, Answered>>(new Map());
  readonly selected = signal<Role | null>(null);
  private readonly confirmedOf = new Set<number>();
  private asked = 0;
  private readonly hands = new Hands();
  /** The vehicle that was begun by hand before its proposals came: no key means another thing until they are wanted. */
  readonly late = signal<number | null>(null);
  private before: ReadonlyMap<Role, ImagePoint> | null = null;
  private readonly stops: (() => void)[] = [];

  readonly all = computed(() => this.byVehicle.value.get(this.desk.vehicleId.value ?? -1) ?? []);
  readonly shown = computed<Shown | null>(() => this.onFrame(this.desk.seenFrame.value));
  readonly handles = computed<readonly Handle<ImagePoint>[]>(() =>
    this.inHand().map(({ role, at }) => ({ id: role, at })),
  );
  readonly hint = computed<string | null>(() => {
    if (!this.shown.value) return null;
    if (this.selected.value) return say("measure-proposed-selected");
    return say(this.ready.value ? "measure-proposed" : "measure-proposed-awaited");
  });
  /** Whether every height is here for the points as they stand. */
  readonly ready = computed(() => {
    const shown = this.shown.value;
    return shown?.targets.every(({ role }) => this.heightOf(role) !== null) ?? false;
  });

  private readonly asker = new Latest<readonly (() => Promise<[Target, Answered]>)[], [Target, Answered][]>(
    (wishes) => Promise.all(wishes.map((ask) => ask())),
    (found) => {
      this.answers.value = new Map(found);
    },
    (error) => toastProblem(error),
  );

  constructor(
    private readonly desk: Desk,
    private readonly points: () => Points,
    private readonly busy: () => boolean,
    private readonly next: () => void,
  ) {
    this.stops.push(
      () => this.hands.close(),
      effect(() => {
        const open = this.desk.vehicleId.value;
        untracked(() => {
          if (this.late.value !== open) this.late.value = null;
          this.hands.touched = false;
          this.forget();
        });
      }),
      effect(() => this.askHeights()),
    );
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.asker.cancel();
  }

  /** Reads what is proposed in a recording; what was asked before it no longer counts. */
  async load(recordingId: number): Promise<void> {
    this.asked += 1;
    const turn = this.asked;
    await telling(async () => {
      const found = await api.ask("GET /recordings/{recording_id}/proposals", { recording_id: recordingId });
      if (turn !== this.asked) return;
      const byVehicle = new Map<number, PointProposal[]>();
      for (const one of found) byVehicle.set(one.vehicle_id, [...(byVehicle.get(one.vehicle_id) ?? []), one]);
      this.forget();
      const open = this.desk.vehicleId.peek();
      const isNew = open !== null && !this.byVehicle.peek().has(open) && byVehicle.has(open);
      this.late.value = isNew && this.hands.touched ? open : null;
      this.byVehicle.value = byVehicle;
    });
  }

  /** The frame on which something is proposed of a vehicle that is asked for; null where nothing is. */
  frameOf(vehicleId: number, missing: readonly Target[]): number | null {
    return frameOf(this.byVehicle.value.get(vehicleId) ?? [], missing);
  }

  /** The height of a target with the points as they stand; null until the server has answered for them. */
  heightOf(target: Target): HeightAnswer | null {
    const shown = this.shown.value;
    const now = shown?.targets.find(({ role }) => role === target);
    const answered = this.answers.value.get(target);
    if (!shown || !now || !answered) return null;
    return samePoint(answered.at, now.at) && samePoint(answered.contact, shown.contact)
      ? answered.answer
      : null;
  }

  showLate(): void {
    this.late.value = null;
  }

  turnedDown(role: Role): boolean {
    return this.dropped.value.has(role);
  }

  inHand(): readonly InHand[] {
    const shown = this.shown.value;
    if (!shown) return [];
    return shown.contactInHand ? [shown.contactInHand, ...shown.targets] : shown.targets;
  }

  /** Goes to a point by its key; the same key once more turns its proposal down. False where there is none. */
  jump(role: Role): boolean {
    if (!canWork.value || !this.inHand().some((one) => one.role === role)) return false;
    if (this.selected.value === role) {
      this.selected.value = null;
      this.dropped.value = new Set(this.dropped.value).add(role);
      return false;
    }
    this.selected.value = role;
    return true;
  }

  /**
   * Enter: what is proposed of what is asked for becomes measurements, and on to the next vehicle; of one that has all of it
   * already, on to the next.
   */
  confirm(): boolean {
    const shown = this.shown.value;
    if (!shown) return this.goOn();
    if (!canWork.value) return false;
    if (!this.hands.armed || !this.ready.value) return true;
    const proposedOn = { frame: shown.frame, contact: shown.proposedContact };
    const confirmed = shown.targets.flatMap(({ role, at, proposed }) => {
      const preview = this.heightOf(role);
      if (preview?.status !== "ok") return [];
      return [{ target: role, point: at, proposed: { ...proposedOn, point: proposed }, preview }];
    });
    // where no target is proposed the contact alone is taken, and the targets are clicked on it
    const alone = shown.targets.length === 0;
    if (confirmed.length === 0 && !alone) return false;
    this.hands.armed = false;
    this.selected.value = null;
    this.confirmedOf.add(shown.vehicleId);
    this.points().takeProposed(shown.frame, shown.contact, confirmed);
    if (!alone && this.desk.standing.missing().length === 0) this.next();
    return true;
  }

  private goOn(): boolean {
    const done = this.desk.asked().length > 0 && this.desk.standing.missing().length === 0;
    if (!done || !canWork.value || this.busy()) return false;
    if (this.hands.armed) this.next();
    this.hands.armed = false;
    return true;
  }

  wasConfirmed(vehicleId: number | null): boolean {
    return vehicleId !== null && this.confirmedOf.has(vehicleId);
  }

  /** It is told once that a confirmed height is unusual. */
  doubted(vehicleId: number): boolean {
    return this.confirmedOf.delete(vehicleId);
  }

  /** A click on a proposed point goes to it; while one is selected, a click puts it there. */
  place(point: ImagePoint): boolean {
    const view = this.desk.stage.view.value;
    const near = this.inHand().find(
      ({ at }) => screenDistance(view.toScreen(at), view.toScreen(point)) <= REACH_PX,
    );
    if (near && near.role !== this.selected.value) {
      this.selected.value = near.role;
      return true;
    }
    return this.moveSelected(point);
  }

  pick(handle: string): void {
    this.selected.value = handle as Role;
  }

  drag(handle: string, at: ImagePoint, phase: DragPhase): void {
    if (!canWork.value) return;
    this.before ??= this.corrected.value;
    if (phase === "cancel") this.corrected.value = this.before;
    else {
      this.selected.value = handle as Role;
      this.moveSelected(at);
    }
    if (phase !== "move") this.before = null;
  }

  nudge(dx: number, dy: number): boolean {
    const now = this.inHand().find(({ role }) => role === this.selected.value);
    return now !== undefined && this.moveSelected(imagePoint(now.at[0] + dx, now.at[1] + dy));
  }

  /** Ctrl+Z before anything is stored: the point that was moved goes back to where it was proposed. */
  back(): boolean {
    const role = this.selected.value;
    if (!role || !this.corrected.value.has(role)) return false;
    this.corrected.value = new Map([...this.corrected.value].filter(([one]) => one !== role));
    return true;
  }

  /** Esc: lets go of the point; then turns all of it down. */
  cancel(): boolean {
    if (!this.shown.value) return false;
    if (this.selected.value) this.selected.value = null;
    else this.dropped.value = new Set(this.inHand().map(({ role }) => role));
    return true;
  }

  private moveSelected(at: ImagePoint): boolean {
    const role = this.selected.value;
    if (!role || !canWork.value || !this.inHand().some((one) => one.role === role)) return false;
    this.corrected.value = new Map(this.corrected.value).set(role, at);
    return true;
  }

  private forget(): void {
    this.corrected.value = new Map();
    this.dropped.value = new Set();
    this.answers.value = new Map();
    this.selected.value = null;
    this.asker.cancel();
  }

  private onFrame(frame: number): Shown | null {
    const { desk } = this;
    const vehicleId = desk.vehicleId.value;
    if (vehicleId === null || vehicleId === this.late.value) return null;
    if (!canWork.value || !desk.hasPose.value || this.busy()) return null;
    const placed = placedOf(this.all.value).filter((one) => one.frame === frame);
    const best = bestContact(placed);
    if (!best) return null;
    const clicked = desk.flow.value.contacts.get(frame) ?? null;
    if (!clicked && (this.dropped.value.has("contact") || desk.flow.value.renew)) return null;
    const missing = this.missing();
    const targets = missing.flatMap((target) => {
      const found = placed.find(({ point }) => point === target);
      return found ? [{ ...this.handOf(target, found), role: target }] : [];
    });
    if (targets.length === 0 && (clicked || missing.length === 0)) return null;
    const contactInHand = clicked ? null : this.handOf("contact", best);
    return {
      vehicleId,
      frame,
      contact: clicked ?? this.handOf("contact", best).at,
      proposedContact: fromServer(best.point_px),
      contactInHand,
      targets,
    };
  }

  /** Asked for, not measured, not turned down; a rejected one is clicked by hand. */
  private missing(): readonly Target[] {
    const { standing } = this.desk;
    return standing
      .missing()
      .filter((target) => !standing.revised(target) && !this.dropped.value.has(target));
  }

  private handOf(role: Role, { point_px, expected_px }: Placed): InHand {
    const proposed = fromServer(point_px);
    return { role, proposed, expected_px, at: this.corrected.value.get(role) ?? proposed };
  }

  private askHeights(): void {
    const shown = this.shown.value;
    const recordingId = this.desk.reel.player.value?.recordingId;
    if (!shown || recordingId === undefined) return;
    const { contact, frame, vehicleId } = shown;
    const wishes = shown.targets.map(({ role, at }) => {
      const wish = { recordingId, vehicleId, frame, contact, point: at, target: role, sigma_px: null };
      const inset = this.desk.insetOf(role);
      return async (): Promise<[Target, Answered]> => [
        role,
        { contact, at, answer: await askHeight({ ...wish, inset }) },
      ];
    });
    this.asker.want(wishes);
  }
}
