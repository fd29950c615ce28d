/** Points under the operator's hand: stored by a click, dragged, nudged, withdrawn; each of them a step that can be undone. */
import { signal } from "@preact/signals";
import { toast } from "../../core/toasts";
import type { HeightAnswer, Target } from "../../core/types";
import { REQUIRED, TARGET_WORDS } from "../../core/words";
import { type ImagePoint, imagePoint, samePoint } from "../../viewer/points";
import {
  type FramePoints,
  framesOf,
  type Inset,
  movedOn,
  ofFrames,
  pointsOn,
  type Values,
} from "../../viewer/values";
import type { Desk } from "./desk";
import type { Effect, Role, Selection } from "./flow";
import { Previews } from "./previews";
import type { Entry } from "./records";
import type { SecondFrame } from "./secondFrame";

/** A run of nudges becomes one revision and one undo step when it has been quiet for so long. */
const BURST_MS = 600;

interface Burst {
  readonly selection: Selection;
  readonly before: ReadonlyMap<string, Values>;
  readonly frame: number;
  readonly contactBefore: ImagePoint | null;
  timer: ReturnType<typeof setTimeout> | undefined;
}

export class Points {
  /** The cursor for placing points by keyboard; null while it is off. */
  readonly cursor = signal<ImagePoint | null>(null);
  private burst: Burst | null = null;
  private readonly previews: Previews;

  constructor(
    private readonly desk: Desk,
    private readonly second: SecondFrame,
  ) {
    this.previews = new Previews(desk);
  }

  /** A click on the frame, or Enter at the keyboard's cursor. */
  place(point: ImagePoint): void {
    const frame = this.desk.seenFrame.value;
    if (frame < 0) return;
    this.endBurst();
    if (this.second.place(point)) return;
    this.desk.dispatch({ type: "click", frame, point });
    if (this.desk.awaiting.value !== "point") this.desk.geometry.forgetHeight();
  }

  hover(point: ImagePoint | null): void {
    if (this.second.hover(point)) return;
    const { contact, awaiting, player, flow, seenFrame, geometry } = this.desk;
    const target = flow.value.target;
    if (!point || awaiting.value !== "point" || !contact.value || !player.value || !target) {
      if (geometry.live.value) geometry.forgetHeight();
      return;
    }
    const { recordingId } = player.value;
    const inset = this.desk.insetOf(target);
    geometry.wantHeight({
      recordingId,
      frame: seenFrame.value,
      contact: contact.value,
      point,
      target,
      inset,
      sigma_px: this.revised(target)?.values.sigma_px ?? null,
      more: this.moreKept(target, seenFrame.value),
    });
  }

  carryOut(effect: Effect): void {
    if (effect.type === "contact") this.placedContact(effect);
    else this.store(effect);
  }

  /** The operator picked a point on the picture. */
  pick(selection: Selection): void {
    this.endBurst();
    this.desk.dispatch({ type: "select", selection });
  }

  selectNext(): void {
    const all = this.selectable();
    if (all.length === 0) return;
    const now = this.desk.flow.value.selection;
    const at = all.findIndex((one) => one.key === now?.key && one.role === now?.role);
    const next = all[(at + 1) % all.length];
    if (next) this.pick(next);
  }

  /** Points on the frame that is seen; a contact that several measurements share is one point. */
  selectable(): Selection[] {
    const here = this.entriesHere();
    const points: Selection[] = here.map((entry) => ({ key: entry.key, role: "point" }));
    const contacts: Selection[] = [];
    const seen: ImagePoint[] = [];
    for (const entry of here) {
      const { contact } = this.here(entry);
      if (seen.some((one) => samePoint(one, contact))) continue;
      seen.push(contact);
      contacts.push({ key: entry.key, role: "contact" });
    }
    const contact = this.desk.contact.value;
    if (contact && !seen.some((one) => samePoint(one, contact)))
      contacts.push({ key: null, role: "contact" });
    return [...points.reverse(), ...contacts];
  }

  positionOf(selection: Selection): ImagePoint | null {
    if (selection.key === null) return this.desk.contact.value;
    const entry = this.desk.records.find(selection.key);
    return entry ? this.here(entry)[selection.role] : null;
  }

  /** The points of a measurement on the frame that is seen; on any other, those of its first frame. */
  here({ values }: Entry): FramePoints {
    return pointsOn(values, this.desk.seenFrame.value) ?? values;
  }

  entriesHere(): Entry[] {
    const frame = this.desk.seenFrame.value;
    return this.desk.entries.value.filter(
      (entry) => pointsOn(entry.values, frame) !== undefined && !entry.values.withdrawn,
    );
  }

  /** One step of a drag; the end of it stores. */
  drag(selection: Selection, point: ImagePoint, phase: "move" | "end" | "cancel"): void {
    if (phase === "move") {
      if (!this.burst) {
        this.desk.dispatch({ type: "select", selection });
        this.begin(selection);
      }
      this.moveTo(point);
    } else if (this.burst) {
      if (phase === "end") this.moveTo(point);
      else this.moveTo(this.startOf(this.burst) ?? point);
      this.endBurst();
    }
  }

  /** Moves the selected point, or the keyboard's cursor. False if there is nothing to move. */
  nudge(dx: number, dy: number): boolean {
    const cursor = this.cursor.value;
    if (cursor) {
      this.moveCursor(imagePoint(cursor[0] + dx, cursor[1] + dy));
      return true;
    }
    const selection = this.desk.flow.value.selection;
    const at = selection && this.positionOf(selection);
    if (!selection || !at) return false;
    if (!this.burst) this.begin(selection);
    this.moveTo(imagePoint(at[0] + dx, at[1] + dy));
    if (this.burst) {
      clearTimeout(this.burst.timer);
      this.burst.timer = setTimeout(() => this.endBurst(), BURST_MS);
    }
    return true;
  }

  /** Stores what has been dragged or nudged, as one revision each and one undo step. */
  endBurst(): void {
    const burst = this.burst;
    if (!burst) return;
    this.burst = null;
    clearTimeout(burst.timer);
    const { records } = this.desk;
    const after = new Map<string, Values>();
    for (const key of burst.before.keys()) {
      const entry = records.find(key);
      if (!entry) continue;
      after.set(key, entry.values);
      records.change(key, {});
    }
    const contactAfter = this.desk.flow.value.contacts.get(burst.frame) ?? null;
    const apply = (values: ReadonlyMap<string, Values>, contact: ImagePoint | null): void => {
      this.desk.dispatch({ type: "set-contact", frame: burst.frame, point: contact });
      for (const [key, one] of values) records.change(key, ofFrames(framesOf(one)), { preview: null });
      for (const key of values.keys()) void this.rest(key);
    };
    this.desk.undo.push({
      label: "move of a point",
      undo: () => apply(burst.before, burst.contactBefore),
      redo: () => apply(after, contactAfter),
    });
  }

  /** Del: withdraws the selected measurement, or takes away a contact that nothing stands on. */
  removeSelected(): void {
    const selection = this.desk.flow.value.selection;
    if (!selection) return;
    this.endBurst();
    if (selection.key === null) {
      this.desk.dispatch({ type: "escape", frame: this.desk.seenFrame.value, used: false });
      this.desk.dispatch({ type: "set-contact", frame: this.desk.seenFrame.value, point: null });
    } else if (!this.second.removeHere(selection.key)) this.withdraw(selection.key);
  }

  withdraw(key: string): void {
    const entry = this.desk.records.find(key);
    if (!entry) return;
    const target = entry.values.target;
    this.setWithdrawn(key, true, target);
    this.desk.undo.push({
      label: `withdrawal of ${TARGET_WORDS[target].toLowerCase()}`,
      undo: () => this.setWithdrawn(key, false, null),
      redo: () => this.setWithdrawn(key, true, target),
    });
  }

  /** Another inset: a new revision, and a step that can be undone. */
  setInset(key: string, inset: Inset): void {
    const before = this.desk.records.find(key)?.values.inset ?? null;
    const set = (to: Inset | null) => (): void => {
      this.desk.records.change(key, { inset: to }, { preview: null });
      void this.rest(key);
    };
    set(inset)();
    this.desk.undo.push({ label: "inset", undo: set(before), redo: set(inset) });
  }

  toggleCursor(): void {
    if (this.cursor.value) {
      this.cursor.value = null;
      this.desk.stage.pointer.value = null;
      this.desk.geometry.forgetHeight();
      return;
    }
    this.moveCursor(this.desk.stage.pointer.value ?? this.desk.contact.value ?? this.desk.stage.centre());
    this.desk.stage.focus();
  }

  /** Targets that a vehicle has; a rejected one counts as missing. */
  targetsOf(vehicleId: number | null): Set<Target> {
    return new Set(this.standingOf(vehicleId).map((entry) => entry.values.target));
  }

  /** The contact to go on with on each frame; that of a rejected measurement is not offered again. */
  contactsOf(vehicleId: number): Map<number, ImagePoint> {
    return new Map(this.standingOf(vehicleId).map((entry) => [entry.values.frame, entry.values.contact]));
  }

  missing(): Target[] {
    const have = this.targetsOf(this.desk.vehicleId.value);
    return REQUIRED.filter((target) => !have.has(target));
  }

  private standingOf(vehicleId: number | null): Entry[] {
    return this.desk.records.of(vehicleId).filter((entry) => !entry.values.withdrawn && !isRejected(entry));
  }

  private moveCursor(point: ImagePoint): void {
    const { stage } = this.desk;
    const { width, height } = stage.viewport.value.image;
    const at = imagePoint(
      Math.min(Math.max(point[0], 0), width - 1),
      Math.min(Math.max(point[1], 0), height - 1),
    );
    this.cursor.value = at;
    stage.viewport.value = stage.viewport.value.revealing(at);
    stage.pointer.value = at;
    this.hover(at);
  }

  private placedContact(effect: Extract<Effect, { type: "contact" }>): void {
    const { frame, before, point } = effect;
    const set = (to: ImagePoint | null) => () =>
      this.desk.dispatch({ type: "set-contact", frame, point: to });
    this.desk.undo.push({ label: "contact point", undo: set(before), redo: set(point) });
  }

  private store(effect: Extract<Effect, { type: "store" }>): void {
    const { vehicleId, target, frame, contact, point } = effect;
    const { records, geometry } = this.desk;
    const inset = this.desk.insetOf(target);
    const more = this.moreKept(target, frame);
    const preview = geometry.answerFor(contact, point, target, inset, more);
    const old = this.revised(target);
    if (old) this.replace(old, { frame, contact, point, more, ...(inset ? { inset } : {}) }, preview);
    else {
      const key = records.create(
        vehicleId,
        { target, frame, contact, point, more, inset, sigma_px: null, withdrawn: false },
        preview,
      );
      this.second.last = key;
      this.desk.undo.push({
        label: TARGET_WORDS[target].toLowerCase(),
        undo: () => this.setWithdrawn(key, true, target),
        redo: () => this.setWithdrawn(key, false, null),
      });
    }
    this.desk.dispatch({ type: "stored", missing: this.missing() });
  }

  private replace(old: Entry, change: Partial<Values>, preview: HeightAnswer | null): void {
    const { records } = this.desk;
    const before = old.values;
    records.change(old.key, change, { preview });
    toast(`${TARGET_WORDS[before.target]} is measured afresh; the click before stays in its history.`);
    const set = (values: Partial<Values>) => (): void => {
      records.change(old.key, values, { preview: null });
      void this.rest(old.key);
    };
    this.desk.undo.push({
      label: `new ${TARGET_WORDS[before.target].toLowerCase()}`,
      undo: set(before),
      redo: set(change),
    });
  }

  /** What is wanted is set at once; the server follows in order, so that undo works without a connection too. */
  private setWithdrawn(key: string, withdrawn: boolean, target: Target | null): void {
    this.desk.records.change(key, { withdrawn }, { preview: null });
    void this.rest(key);
    this.desk.dispatch({ type: "choose", target: withdrawn ? target : (this.missing()[0] ?? null) });
  }

  /** The measurement that a click at this target would revise; "other" always makes a new one. */
  revised(target: Target): Entry | undefined {
    if (target === "other") return undefined;
    return this.desk.entries.value.findLast(
      (entry) => entry.values.target === target && !entry.values.withdrawn && entry.state !== "conflict",
    );
  }

  private moreKept(target: Target, frame: number): readonly FramePoints[] {
    const old = this.revised(target)?.values;
    return old?.frame === frame ? old.more : [];
  }

  /** Waits for the server; an undo that was refused says why. */
  async rest(key: string): Promise<void> {
    const entry = await this.desk.records.settled(key);
    if (entry?.state === "failed" || entry?.state === "conflict")
      toast(entry.problem ?? "This could not be taken back.", { kind: "problem" });
  }

  private begin(selection: Selection): void {
    const frame = this.desk.seenFrame.value;
    const group = this.groupOf(selection);
    this.burst = {
      selection,
      before: new Map(group.map((entry) => [entry.key, entry.values])),
      frame,
      contactBefore: this.desk.contact.value,
      timer: undefined,
    };
  }

  /** Measurements that move with a point: all that share a contact, or the one. */
  private groupOf({ key, role }: Selection): Entry[] {
    const entry = key === null ? undefined : this.desk.records.find(key);
    if (!entry) return [];
    if (role === "point") return [entry];
    const { contact } = this.here(entry);
    return this.entriesHere().filter((other) => samePoint(this.here(other).contact, contact));
  }

  private startOf(burst: Burst): ImagePoint | null {
    const { key, role } = burst.selection;
    const before = key === null ? undefined : burst.before.get(key);
    return key === null ? burst.contactBefore : ((before && pointsOn(before, burst.frame)?.[role]) ?? null);
  }

  private moveTo(point: ImagePoint): void {
    const burst = this.burst;
    if (!burst) return;
    const role: Role = burst.selection.role;
    for (const key of burst.before.keys()) {
      const values = this.desk.records.find(key)?.values;
      if (values) this.desk.records.show(key, movedOn(values, burst.frame, { [role]: point }));
    }
    const start = this.startOf(burst);
    if (role === "contact" && (start === null || samePoint(start, burst.contactBefore))) {
      this.desk.dispatch({ type: "set-contact", frame: burst.frame, point });
    }
    this.previews.want(burst.before.keys());
  }
}

/** Rejected by a reviewer and not yet clicked again. */
function isRejected(entry: Entry): boolean {
  return entry.state === "saved" && entry.saved?.review.verdict === "rejected";
}
