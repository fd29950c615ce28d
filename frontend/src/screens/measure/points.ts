/** Points under the operator's hand: stored by a click, dragged, nudged, withdrawn; each of them a step that can be undone. */
import { computed } from "@preact/signals";
import type { ChangeSet } from "../../core/history";
import { say } from "../../core/messages";
import { newKey } from "../../core/random";
import { canWork } from "../../core/session";
import { toast } from "../../core/toasts";
import type { HeightAnswer, Target } from "../../core/types";
import { TARGET_NOUNS } from "../../core/words";
import { type ImagePoint, imagePoint, samePoint } from "../../viewer/points";
import type { DragPhase, Handle } from "../../viewer/tool";
import { type FramePoints, type Inset, movedOn } from "../../viewer/values";
import type { ClickTool, Desk } from "./desk";
import { awaiting, type Effect, type Selection } from "./flow";
import { type ClickLedger, clickLedger, contactLedger } from "./ledgers";
import { Previews } from "./previews";
import type { Entry } from "./records";
import type { Revise, SecondFrame } from "./secondFrame";
import { idOf } from "./standing";

/** A run of nudges becomes one revision and one undo step when it has been quiet for so long. */
const BURST_MS = 600;

interface Burst {
  readonly selection: Selection;
  readonly keys: readonly string[];
  readonly frame: number;
  readonly changes: ChangeSet;
  /** The contact in use moves along with the point. */
  readonly movesContact: boolean;
  timer: ReturnType<typeof setTimeout> | undefined;
}

/** A target's point as a person leaves it, and where it was proposed. */
export interface Confirmed {
  readonly target: Target;
  readonly point: ImagePoint;
  readonly proposed: FramePoints;
  readonly preview: HeightAnswer | null;
}

export class Points implements ClickTool {
  readonly active = computed(() => true);
  readonly contact = computed(() => this.desk.flow.value.contacts.get(this.desk.seenFrame.value) ?? null);
  readonly awaiting = computed(() => awaiting(this.desk.flow.value, this.desk.seenFrame.value));
  readonly placing = computed(
    () => canWork.value && this.desk.hasPose.value && this.desk.awaiting.value !== null,
  );
  readonly handles = computed<readonly Handle<ImagePoint>[]>(() =>
    this.desk.standing.selectable().flatMap((selection) => {
      const at = this.desk.standing.positionOf(selection);
      return at ? [{ id: idOf(selection), at }] : [];
    }),
  );
  readonly clicks: ClickLedger;
  private readonly contacts: ReturnType<typeof contactLedger>;
  private burst: Burst | null = null;
  private readonly previews: Previews;

  constructor(
    private readonly desk: Desk,
    private readonly second: SecondFrame,
  ) {
    this.previews = new Previews(desk);
    this.contacts = contactLedger(desk);
    this.clicks = clickLedger(
      desk,
      (key) => this.rest(key),
      (entry, withdrawn) => this.chooseAfter(entry, withdrawn),
    );
  }

  get moving(): boolean {
    return this.burst !== null;
  }

  /** A click on the frame, or Enter at the keyboard's cursor; where nothing is awaited it lets go of the selected point. */
  place(point: ImagePoint): boolean {
    const { desk } = this;
    const frame = desk.seenFrame.value;
    const { target } = desk.flow.value;
    this.endBurst();
    if (!this.placing.value || frame < 0 || !target) desk.dispatch({ type: "select", selection: null });
    else
      desk.history.run(desk.stepName(this.labelOf(target)), (changes) => {
        changes.touch(this.contacts, this.contactKey(frame));
        const effect = desk.dispatch({ type: "click", frame, point });
        if (effect?.type === "store") this.store(effect, changes);
        else if (effect?.type === "contact") this.snap(frame, point);
      });
    return true;
  }

  /** The contact goes to the tyre as a step of its own: one undo puts it back to the click. */
  private snap(frame: number, point: ImagePoint): void {
    const { desk } = this;
    if (!desk.snaps.value) return;
    void desk.snapping.ask(frame, point, (to) =>
      desk.history.run(desk.stepName(say("measure-step-snap")), (changes) =>
        changes.write(this.contacts, this.contactKey(frame), to),
      ),
    );
  }

  cursorStart(): ImagePoint | null {
    return this.desk.contact.value;
  }

  hover(point: ImagePoint | null): boolean {
    const { contact, awaiting: awaited, reel, flow, seenFrame, geometry } = this.desk;
    const target = flow.value.target;
    const recordingId = reel.player.value?.recordingId;
    const atPoint = point && awaited.value === "point" && !this.desk.snapping.isAtContact(point);
    if (!atPoint || !contact.value || recordingId === undefined || !target) {
      geometry.forgetHeight();
      return true;
    }
    geometry.wantHeight({
      recordingId,
      vehicleId: this.desk.vehicleId.value,
      frame: seenFrame.value,
      contact: contact.value,
      point,
      target,
      inset: this.desk.insetOf(target),
      sigma_px: this.desk.standing.revised(target)?.values.sigma_px ?? null,
      more: this.desk.standing.moreKept(target, seenFrame.value),
    });
    return true;
  }

  pick(handle: string): void {
    const selection = this.desk.standing.selectionOf(handle);
    if (selection) this.select(selection);
  }

  select(selection: Selection): void {
    this.endBurst();
    this.desk.dispatch({ type: "select", selection });
  }

  selectNext(): void {
    const all = this.desk.standing.selectable();
    if (all.length === 0) return;
    const now = this.desk.flow.value.selection;
    const at = all.findIndex((one) => one.key === now?.key && one.role === now?.role);
    const next = all[(at + 1) % all.length];
    if (next) this.select(next);
  }

  /** One step of a drag; the end of it stores, and a cancelled one puts everything back. */
  drag(handle: string, point: ImagePoint, phase: DragPhase): void {
    const selection = this.burst?.selection ?? this.desk.standing.selectionOf(handle);
    if (!selection || !canWork.value) return;
    if (phase === "cancel") {
      void this.burst?.changes.drop();
      this.burst = null;
      return;
    }
    if (!this.burst) {
      this.desk.dispatch({ type: "select", selection });
      this.begin(selection);
    }
    this.moveTo(point);
    if (phase === "end") this.endBurst();
  }

  nudge(dx: number, dy: number): boolean {
    const selection = this.desk.flow.value.selection;
    const at = selection && this.desk.standing.positionOf(selection);
    if (!selection || !at || !canWork.value) return false;
    if (!this.burst) this.begin(selection);
    this.moveTo(imagePoint(at[0] + dx, at[1] + dy));
    if (this.burst) {
      clearTimeout(this.burst.timer);
      this.burst.timer = setTimeout(() => this.endBurst(), BURST_MS);
    }
    return true;
  }

  /** Stores what has been dragged or nudged, as one revision each and one undo step; back where it was, it is neither. */
  endBurst(): void {
    const burst = this.burst;
    if (!burst) return;
    this.burst = null;
    clearTimeout(burst.timer);
    if (!burst.changes.keep()) void burst.changes.drop();
    else for (const key of burst.keys) this.desk.records.change(key, {});
  }

  /** Esc takes back one thing at a time. */
  cancel(): boolean {
    this.endBurst();
    const used = this.desk.standing.entriesHere().length > 0;
    this.desk.dispatch({ type: "escape", frame: this.desk.seenFrame.value, used });
    return true;
  }

  /** Del: withdraws the selected measurement, or takes away a contact that nothing stands on. */
  removeSelected(): void {
    const selection = this.desk.flow.value.selection;
    if (!selection) return;
    this.endBurst();
    if (selection.key === null) {
      this.desk.dispatch({ type: "select", selection: null });
      this.desk.history.run(this.desk.stepName(say("measure-step-contact-removal")), (changes) =>
        changes.write(this.contacts, this.contactKey(this.desk.seenFrame.value), null),
      );
    } else if (!this.second.removeHere(selection.key)) this.withdraw(selection.key);
  }

  withdraw(key: string): void {
    const values = this.desk.records.find(key)?.values;
    if (!values) return;
    this.desk.history.run(
      this.desk.stepName(say("measure-step-withdrawal", { target: values.target })),
      (changes) => changes.write(this.clicks, key, { ...values, withdrawn: true }),
    );
  }

  /** Another revision of what was clicked; read again once the server has it. */
  readonly revise: Revise = (key, to, label, preview) => {
    this.desk.history.run(this.desk.stepName(label), (changes) => {
      changes.touch(this.clicks, key);
      this.desk.records.change(key, to, { preview });
    });
    void this.rest(key);
  };

  setInset(key: string, inset: Inset): void {
    const values = this.desk.records.find(key)?.values;
    if (!values) return;
    this.desk.history.run(this.desk.stepName(say("measure-step-inset")), (changes) =>
      changes.write(this.clicks, key, { ...values, inset }),
    );
  }

  private labelOf(target: Target): string {
    if (this.desk.awaiting.value === "contact") return say("measure-step-contact");
    return this.desk.standing.revised(target) ? say("measure-step-new", { target }) : TARGET_NOUNS[target];
  }

  private contactKey(frame: number) {
    return { vehicleId: this.desk.vehicleId.value, frame };
  }

  private store(effect: Extract<Effect, { type: "store" }>, changes: ChangeSet): void {
    const { vehicleId, target, frame, contact, point } = effect;
    const { records, geometry } = this.desk;
    const inset = this.desk.insetOf(target);
    const more = this.desk.standing.moreKept(target, frame);
    const preview = geometry.answerFor(contact, point, target, inset, more);
    const snapped = this.desk.snapping.of(frame, contact);
    const old = this.desk.standing.revised(target);
    const key = old?.key ?? newKey();
    changes.touch(this.clicks, key);
    if (old) {
      records.change(key, { frame, contact, point, more, snapped, ...(inset ? { inset } : {}) }, { preview });
      toast(say("measure-afresh", { target }));
    } else {
      const values = {
        target,
        frame,
        contact,
        point,
        more,
        inset,
        sigma_px: null,
        withdrawn: false,
        snapped,
      };
      records.create(vehicleId, values, preview, key);
      this.second.last = key;
    }
    const missing = this.desk.standing.missing();
    this.desk.dispatch({ type: "stored", missing });
    if (missing.length === 0 && !old) this.desk.answered();
  }

  /** What was proposed on a frame becomes measurements: one step, which undo takes back as a whole. */
  takeProposed(frame: number, contact: ImagePoint, proposed: readonly Confirmed[]): void {
    const vehicleId = this.desk.vehicleId.value;
    if (vehicleId === null) return;
    this.endBurst();
    this.desk.history.run(this.desk.stepName(say("measure-step-proposals")), (changes) => {
      changes.touch(this.contacts, this.contactKey(frame));
      this.desk.dispatch({ type: "set-contact", frame, point: contact });
      for (const one of proposed) {
        const key = newKey();
        changes.touch(this.clicks, key);
        const { point, proposed } = one;
        const snapped = this.desk.snapping.of(frame, contact);
        const click = { target: one.target, frame, contact, point, proposed, snapped };
        const rest = { more: [], inset: this.desk.insetOf(one.target), sigma_px: null, withdrawn: false };
        this.desk.records.create(vehicleId, { ...click, ...rest }, one.preview, key);
        this.second.last = key;
      }
      this.desk.dispatch({ type: "stored", missing: this.desk.standing.missing() });
    });
  }

  /** What was taken back is asked for again; what is there again is not. */
  private chooseAfter(entry: Entry, withdrawn: boolean): void {
    if (entry.vehicleId !== this.desk.vehicleId.value) return;
    const target = withdrawn ? entry.values.target : (this.desk.standing.missing()[0] ?? null);
    this.desk.dispatch({ type: "choose", target });
  }

  /** Waits for the server; an undo that was refused says why. */
  async rest(key: string): Promise<void> {
    const entry = await this.desk.records.settled(key);
    if (entry?.state === "failed" || entry?.state === "conflict")
      toast(entry.problem ?? say("measure-no-way-back"), { kind: "problem" });
  }

  private begin(selection: Selection): void {
    const frame = this.desk.seenFrame.value;
    const keys = this.desk.standing.groupOf(selection).map((entry) => entry.key);
    const changes = this.desk.history.begin(this.desk.stepName(say("measure-step-move")));
    for (const key of keys) changes.touch(this.clicks, key);
    const contact = this.desk.contact.value;
    const movesContact =
      selection.role === "contact" &&
      (selection.key === null || samePoint(this.desk.standing.positionOf(selection), contact));
    if (movesContact) changes.touch(this.contacts, this.contactKey(frame));
    this.burst = { selection, keys, frame, changes, movesContact, timer: undefined };
  }

  private moveTo(point: ImagePoint): void {
    const burst = this.burst;
    if (!burst) return;
    const { frame, keys, selection } = burst;
    for (const key of keys) {
      const values = this.desk.records.find(key)?.values;
      if (values) this.desk.records.show(key, movedOn(values, frame, { [selection.role]: point }));
    }
    if (burst.movesContact) this.desk.dispatch({ type: "set-contact", frame, point });
    this.previews.want(keys);
  }
}
