/**
 * The measure page's state: survey, passes, the frame, the flow of clicks. Views read its signals; keys and buttons call it.
 * Points (storing, dragging, nudging) live in `points.ts`, which this hands out as `points`.
 */
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { ask } from "../../components";
import { asked, query, setQuery } from "../../core/address";
import { History, type Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox, type Wanted, type Wish } from "../../core/outbox";
import { newKey } from "../../core/random";
import { canWork } from "../../core/session";
import { stored } from "../../core/stored";
import { survey } from "../../core/survey";
import { toast, toastProblem } from "../../core/toasts";
import type { AskedTarget, DriverSide, NotVisible, Recording, Target, Vehicle } from "../../core/types";
import { vehicleName } from "../../core/words";
import { usualInset } from "../../parts/vehicles/insets";
import {
  bestFrame,
  type Filter,
  firstOpen,
  listed,
  neighbour,
  nextOpen,
  type Order,
} from "../../parts/vehicles/passes";
import { AFTER_CLICK_MS, Geometry } from "../../viewer/geometry";
import { type ImagePoint, screenDistance } from "../../viewer/points";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";
import type { Inset } from "../../viewer/values";
import { Assist } from "./assist/assist";
import { Snapping } from "./assist/snapping";
import type { ClickTool, Desk } from "./desk";
import type { Changes } from "./fields";
import { type Effect, type Flow, type FlowEvent, firstMissing, START, step } from "./flow";
import { factLedger } from "./ledgers";
import {
  type AddedWant,
  PASS_ADDED,
  PASS_JOINED,
  PASS_SPLIT,
  PASS_THERE,
  type Presence,
} from "./passes/kinds";
import { Points } from "./points";
import * as server from "./ports";
import { Proposals } from "./proposals/proposals";
import { Records } from "./records";
import { SecondFrame } from "./secondFrame";
import { Vehicles } from "./vehicles";
import { WholePass } from "./wholePass";

/** A pointer this near to the contact is at it. */
const AT_CONTACT_PX = 12;

export const filter = stored<Filter>("passes.filter", "all");
export const order = stored<Order>("passes.order", "number");

export class MeasureModel implements Desk {
  readonly reel = new Reel();
  /** Who has a click, a key or Esc first: this order, and no other place, says so. */
  readonly stage: FrameStage = new FrameStage(() => [
    this.assist,
    this.stage.keyboard,
    this.second,
    this.whole,
    this.span,
    this.proposals,
    this.points,
  ]);
  readonly history: History = new History(() => this.place());
  readonly geometry = new Geometry();
  readonly records: Records;
  readonly vehicles: Vehicles;
  readonly second: SecondFrame = new SecondFrame(this, () => this.points);
  readonly points: Points = new Points(this, this.second);
  readonly whole: WholePass = new WholePass(this, () => ({
    clicks: this.points.clicks,
    rest: (key) => this.points.rest(key),
    last: () => this.second.last,
  }));
  readonly snapping: Snapping = new Snapping(this);
  /** Where the proposed contact was turned down, a click means another place. */
  readonly snaps = computed(
    () => canWork.value && this.hasPose.value && !this.proposals.turnedDown("contact"),
  );
  readonly assist: Assist;
  readonly proposals: Proposals;
  readonly flow = signal<Flow>(START);
  readonly vehicleId = computed(() => this.flow.value.vehicleId);
  readonly loaded = signal(false);
  readonly problem = signal<unknown>(null);
  /** The first frame of a pass that is being marked. */
  readonly passFrom = signal<number | null>(null);
  /** Insets chosen for this vehicle's targets before they are measured. */
  readonly chosenInsets = signal<ReadonlyMap<string, Inset>>(new Map());

  /** The target of which is asked why it is not visible. */
  readonly whyUnseen = signal<AskedTarget | null>(null);

  readonly list = computed(() => listed(this.vehicles.list.value, filter.value, order.value));
  readonly vehicle = computed(() => this.vehicles.shown(this.vehicleId.value));
  readonly entries = computed(() => this.records.of(this.vehicleId.value));
  /** The frame that is seen: clicks, contacts and marks belong to it. */
  readonly seenFrame = computed(() => this.reel.seen.value ?? -1);
  private readonly clicking = computed<ClickTool>(() =>
    this.second.active.value ? this.second : this.points,
  );
  readonly contact = computed(() => this.clicking.value.contact.value);
  readonly awaiting = computed(() => this.clicking.value.awaiting.value);
  readonly hasPose = computed(
    () => this.reel.recording.value === undefined || this.reel.recording.value.pose_id !== null,
  );

  /** A pass whose first frame is marked: Esc forgets the mark. */
  private readonly span = {
    cancel: (): boolean => {
      const marked = this.passFrom.value !== null;
      this.passFrom.value = null;
      return marked;
    },
  };

  /** Told when something of a vehicle has been stored, for the other tabs. */
  onStored: (vehicleId: number) => void = () => {};

  /** What a height under the pointer is of: of anything else it would be a wrong number that looks right. */
  private readonly aim = computed(() => {
    const target = this.second.now.value?.target ?? this.flow.value.target;
    const { inset_m, u_inset_m } = (target && this.insetOf(target)) ?? {};
    const click = `${this.seenFrame.value} ${target} ${this.contact.value} ${this.awaiting.value}`;
    return `${click} ${inset_m} ${u_inset_m} ${this.vehicle.value?.side}`;
  });
  /** The player's wishes when the open pass was opened. */
  private wishesThen = 0;
  /** Taken out, as they were. */
  private readonly gone = new Map<number, Vehicle>();
  /** Keys of what this page itself waits for. */
  private readonly underWay = new Set<string>();
  readonly facts: ReturnType<typeof factLedger>;
  private readonly stops: (() => void)[] = [];
  private aimTimer: ReturnType<typeof setTimeout> | undefined;
  private urlTimer: ReturnType<typeof setTimeout> | undefined;
  /** Vehicles of which something was stored since they were read. */
  private readonly stale = new Set<number>();
  private refreshTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly surveyId: number) {
    const stored = (vehicleId: number): void => {
      this.refreshSoon(vehicleId);
      this.onStored(vehicleId);
    };
    this.records = new Records(outbox, surveyId, stored);
    this.vehicles = new Vehicles(outbox, surveyId, { merged: toast, stored });
    this.assist = new Assist(this);
    this.proposals = new Proposals(
      this,
      () => this.points,
      () => this.second.active.value,
      () => this.confirmNext(),
    );
    this.facts = factLedger(this.vehicles);
    this.startFromAddress();
    this.stops.push(
      ...[PASS_ADDED, PASS_THERE, PASS_SPLIT, PASS_JOINED].map((kind) =>
        outbox.listen(kind, (wish) => this.follow(wish)),
      ),
      effect(() => this.followAxes()),
      effect(() => this.followAddress()),
      effect(() => this.refuseContact()),
      effect(() => {
        void this.reel.player.value?.recordingId;
        untracked(() => void this.readProposals());
      }),
      effect(() => {
        void this.aim.value;
        untracked(() => this.aimAgain());
      }),
    );
  }

  /** Everything the page needs, side by side; the first frame is already on its way if the address names it. */
  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const [recordings, vehicles] = await Promise.all([
        server.listRecordings(this.surveyId),
        server.listVehicles(this.surveyId),
      ]);
      batch(() => {
        this.reel.recordings.value = recordings;
        this.vehicles.takeAll(vehicles);
        for (const vehicle of vehicles) this.records.take(vehicle);
        this.loaded.value = true;
      });
      this.openFirst();
      this.records.resume();
      // what an earlier page left may have been stored while the list was read
      for (const id of this.stale) this.refreshSoon(id);
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    for (const stop of this.stops) stop();
    clearTimeout(this.urlTimer);
    clearTimeout(this.refreshTimer);
    clearTimeout(this.aimTimer);
    const id = this.vehicleId.value;
    if (id !== null) void this.vehicles.flush(id);
    this.points.endBurst();
    this.assist.close();
    this.proposals.close();
    this.reel.close();
    this.records.close();
    this.vehicles.close();
  }

  dispatch(event: FlowEvent): Effect | null {
    if (event.type === "choose") this.second.leave();
    return this.step(event);
  }

  /** Opens a pass at its best frame, or at the frame asked for. */
  open(vehicle: Vehicle, frame = this.usualFrame(vehicle)): void {
    this.leave();
    batch(() => {
      this.enter(vehicle);
      this.wishesThen = this.reel.show(vehicle.recording_id, frame).wishes;
    });
  }

  /** Opens a pass on the frame that is there. */
  private enter(vehicle: Vehicle): void {
    const contacts = this.points.contactsOf(vehicle.id);
    const target = canWork.value ? firstMissing(this.points.targetsOf(vehicle.id), askedOf(vehicle)) : null;
    batch(() => {
      this.step({ type: "open", vehicleId: vehicle.id, target, contacts });
      this.chosenInsets.value = new Map();
      this.whyUnseen.value = null;
    });
  }

  /** What is open now, and how to come back to it: undo goes to what it changes. */
  private place(): () => void {
    const id = this.vehicleId.peek();
    const [recording, frame] = [this.reel.player.peek()?.recordingId, this.seenFrame.peek()];
    return () => {
      const vehicle = this.vehicles.get(id);
      if (vehicle && id !== this.vehicleId.value) this.open(vehicle, frame < 0 ? undefined : frame);
      else if (recording !== undefined && frame >= 0) this.reel.show(recording, frame);
    };
  }

  /** A step's name, with the vehicle that it is done on. */
  stepName(step: string): string {
    const vehicle = this.vehicle.value;
    return vehicle ? say("measure-step-of", { step, vehicle: String(vehicle.number) }) : step;
  }

  /** The operator turns to a recording: no pass is open until one is chosen. */
  chooseRecording(recordingId: number): void {
    const first = this.list.value.find((vehicle) => vehicle.recording_id === recordingId);
    if (first) this.open(first);
    else {
      this.leave();
      this.step({ type: "open", vehicleId: null, target: null });
      this.reel.show(recordingId, 0);
    }
  }

  go(direction: 1 | -1): void {
    const next = neighbour(this.list.value, this.vehicle.value, direction);
    if (next) this.open(next);
    else toast(say(direction === 1 ? "measure-last-pass" : "measure-first-pass"));
  }

  /** Ctrl+Enter: what is typed is saved, and on to the next pass with something to do. */
  confirmNext(): void {
    const next =
      nextOpen(this.list.value, this.vehicle.value) ?? nextOpen(this.vehicles.list.value, this.vehicle.value);
    if (next) {
      this.open(next);
      return;
    }
    this.leave();
    toast(say("measure-all-passes-done"));
  }

  toBestFrame(): void {
    const vehicle = this.vehicle.value;
    if (vehicle) this.reel.show(vehicle.recording_id, this.usualFrame(vehicle));
  }

  /** That of what is proposed and still asked for, else the best one. */
  private usualFrame(vehicle: Vehicle): number {
    const have = this.points.targetsOf(vehicle.id);
    const missing = askedOf(vehicle).filter((target) => !have.has(target));
    return this.proposals.frameOf(vehicle.id, missing) ?? bestFrame(vehicle);
  }

  /** Reads what is proposed in the recording that is open, and goes there unless a person is at work already. */
  async readProposals(): Promise<void> {
    const recordingId = this.reel.player.value?.recordingId;
    if (recordingId === undefined) return;
    await this.proposals.load(recordingId);
    const [vehicle, player] = [this.vehicle.value, this.reel.player.value];
    const atWork = this.stage.pointer.value !== null || this.flow.value.contacts.size > 0;
    // the frame that is asked for: the one that is seen lags behind it
    const stayed =
      player?.wishes === this.wishesThen && player.frame.value === (vehicle && bestFrame(vehicle));
    if (stayed && !atWork) this.toBestFrame();
  }

  /** The inset a click would be stored with: chosen now, or of the measurement it revises; null: the survey's. */
  insetOf(target: Target): Inset | null {
    return this.chosenInsets.value.get(target) ?? this.points.revised(target)?.values.inset ?? null;
  }

  /** Chooses the inset of a target of this vehicle, for what is measured of it and for the clicks to come. */
  chooseInset(target: Target, inset: Inset): void {
    this.chosenInsets.value = new Map(this.chosenInsets.value).set(target, inset);
    for (const entry of this.entries.value)
      if (entry.values.target === target && !entry.values.withdrawn) this.points.setInset(entry.key, inset);
  }

  /** What the survey assumes for a target; null for an eye of which nobody knows the driver's side. */
  usualInset(target: Target): (Inset & { note: string }) | null {
    const vehicle = this.vehicle.value;
    return usualInset(survey.value, target, vehicle?.side ?? null, vehicle?.category ?? null);
  }

  /** Where this vehicle's driver sits; null: as its direction and the survey's traffic say. Saved at once. */
  chooseSide(side: DriverSide | null): void {
    const vehicle = this.vehicle.value;
    if (!vehicle || vehicle.driver_side === side) return;
    this.chosenInsets.value = new Map(
      [...this.chosenInsets.value].filter(([target]) => target !== "driver_eye"),
    );
    this.edit({ driver_side: side });
    void this.vehicles.flush(vehicle.id);
  }

  /** On which side the driver sits, said or following from the direction; null while neither is known. */
  readonly side = computed<DriverSide | null>(() => {
    const vehicle = this.vehicle.value;
    return vehicle?.driver_side ?? vehicle?.side ?? null;
  });

  /** By one key: the other side than it is now; near where it is not known. */
  turnSide(): void {
    this.chooseSide(this.side.value === "near" ? "far" : "near");
  }

  asked(): readonly Target[] {
    const vehicle = this.vehicle.value;
    return vehicle ? askedOf(vehicle) : [];
  }

  /** The target that is not visible: asks why, beside its row. */
  askWhyUnseen(): void {
    const target = this.flow.value.target;
    if (target && target !== "other" && !this.points.targetsOf(this.vehicleId.value).has(target))
      this.whyUnseen.value = target;
  }

  /** Why a target cannot be measured of this vehicle; null: it can. Saved at once, and on to the next target. */
  setUnseen(target: AskedTarget, why: NotVisible | null): void {
    const vehicle = this.vehicle.value;
    this.whyUnseen.value = null;
    if (!vehicle) return;
    this.edit({ [`${target}_not_visible`]: why });
    void this.vehicles.flush(vehicle.id);
    if (!why) this.step({ type: "choose", target });
    else {
      const missing = this.points.missing();
      this.step({ type: "stored", missing });
      if (missing.length === 0) this.answered();
    }
  }

  /** A vehicle of which something was confirmed goes on to the next by itself. */
  answered(): void {
    if (this.proposals.wasConfirmed(this.vehicleId.value)) this.confirmNext();
  }

  /** Make and model were the last thing asked for of a vehicle that had none: on to the next one. */
  named(before: Vehicle): void {
    const done = this.asked().length > 0 && this.points.missing().length === 0;
    if (done && before.id === this.vehicleId.value && !before.make && !before.model) this.confirmNext();
  }

  /** Edits vehicle facts, as a step that can be undone. */
  edit(changes: Changes, vehicle = this.vehicle.value): void {
    if (!vehicle) return;
    this.history.run(say("measure-step-vehicle", { vehicle: String(vehicle.number) }), (step) => {
      for (const field of Object.keys(changes) as (keyof Changes)[])
        step.touch(this.facts, { id: vehicle.id, field });
      this.vehicles.edit(vehicle.id, changes);
    });
  }

  markPass(end: "first" | "last"): void {
    const frame = this.seenFrame.value;
    if (frame < 0) return;
    if (end === "first" || this.passFrom.value === null) {
      this.passFrom.value = frame;
      toast(say("measure-pass-marked", { frame: String(frame) }));
      return;
    }
    const [first, last] = [Math.min(this.passFrom.value, frame), Math.max(this.passFrom.value, frame)];
    this.passFrom.value = null;
    void this.addPass(first, last);
  }

  async removePass(): Promise<void> {
    const open = this.vehicle.value;
    if (!open) return;
    const vehicle = String(open.number);
    const count = this.entries.value.filter((entry) => !entry.values.withdrawn).length;
    const title = say("measure-pass-delete-title", { vehicle });
    const body = say("measure-pass-delete-body", { vehicle, count });
    if (!(await ask({ title, body, action: say("measure-pass-delete") }))) return;
    await this.inTurn(() =>
      this.history.run(say("measure-step-deletion", { vehicle }), async (step) => {
        await step.write(this.passes, open.id, false);
      }),
    );
  }

  private async addPass(first: number, last: number): Promise<void> {
    const recordingId = this.reel.player.value?.recordingId;
    if (recordingId === undefined) return;
    const known = this.vehicles.list.value.filter((one) => one.recording_id === recordingId);
    const opened = this.vehicleId.value;
    await this.inTurn(async () => {
      const stored = await this.stored<Vehicle, AddedWant, { recordingId: number; surveyId: number }>({
        key: newKey(),
        kind: PASS_ADDED,
        lane: `passes.${recordingId}`,
        about: { recordingId, surveyId: this.surveyId },
        what: say("measure-pass-new"),
        mine: say("measure-pass-new-frames", { first_frame: String(first), last_frame: String(last) }),
        saved: null,
        want: { first_frame: first, last_frame: last, known: known.map(({ id }) => id) },
      });
      const vehicle = stored?.saved;
      if (!vehicle) return toast(say("measure-pass-kept"));
      this.history.run(say("measure-step-new-pass", { vehicle: String(vehicle.number) }), (step) => {
        step.touch(this.passes, vehicle.id);
        this.put(vehicle);
        this.openUnless(vehicle, opened);
      });
    });
  }

  /** What was opened while something was stored stays open. */
  openUnless(vehicle: Vehicle, opened: number | null): void {
    if (this.vehicleId.value === opened) this.open(vehicle);
  }

  inTurn(work: () => Promise<void>): Promise<void> {
    return this.history.inTurn(work).catch(toastProblem);
  }

  /** A change of passes, by the outbox; null: kept, and told once it is there. */
  async stored<S, W, A>(wanted: Omit<Wanted<S, W, A>, "page">): Promise<Wish<S, W, A> | null> {
    this.underWay.add(wanted.key);
    const page = `/surveys/${this.surveyId}/measure`;
    try {
      return await outbox.store<S, W, A>({ ...wanted, page });
    } finally {
      this.underWay.delete(wanted.key);
    }
  }

  /** What was kept without a connection, or left by an earlier page, is there now. */
  private follow({ key, state, page }: Wish): void {
    const own = page === `/surveys/${this.surveyId}/measure`;
    if (state === "saved" && own && !this.underWay.has(key)) void this.readAgain();
  }

  private async readAgain(): Promise<void> {
    try {
      const vehicles = await server.listVehicles(this.surveyId);
      batch(() => {
        this.vehicles.takeAll(vehicles);
        for (const vehicle of vehicles) this.records.take(vehicle);
      });
    } catch {
      // the list is read again with the next change
    }
  }

  /** Whether a pass is in the list. */
  readonly passes: Ledger<number, boolean> = {
    read: (id) => this.vehicles.get(id) !== undefined,
    write: (id, there) => this.turnPass(id, there),
  };

  /** The version that is seen; null while changes of one's own are on their way, which go out before and make another. */
  versionOf({ id, version }: Vehicle): number | null {
    return this.vehicles.drafts.value.has(id) ? null : version;
  }

  /** Out of the list, and known for an undo. */
  takenOut(vehicle: Vehicle): void {
    this.gone.set(vehicle.id, vehicle);
    this.vehicles.hide(vehicle.id);
  }

  private async turnPass(id: number, there: boolean): Promise<void> {
    const vehicle = this.vehicles.shown(id) ?? this.gone.get(id);
    if (!vehicle) return;
    const opened = this.vehicleId.value;
    const next = neighbour(this.list.value, vehicle, 1) ?? neighbour(this.list.value, vehicle, -1);
    const stored = await this.stored<Presence, boolean, { id: number }>({
      key: `pass.${id}`,
      kind: PASS_THERE,
      lane: `vehicle.${id}`,
      about: { id },
      what: say("measure-vehicle-number", { vehicle: vehicleName(vehicle.number) }),
      mine: say(there ? "measure-pass-bring-back" : "measure-pass-delete"),
      saved: { there: !there, version: this.versionOf(vehicle), vehicle },
      want: there,
    });
    if (there) {
      this.put(stored?.saved?.vehicle ?? vehicle);
      this.openUnless(vehicle, opened);
      return;
    }
    this.takenOut(vehicle);
    if (this.vehicleId.value !== id) return;
    if (next) this.open(next);
    else this.step({ type: "open", vehicleId: null, target: null });
  }

  put(vehicle: Vehicle): void {
    this.vehicles.take(vehicle);
    this.records.take(vehicle);
  }

  /** Reads one vehicle again: its state and version follow from what was stored. */
  refreshSoon(vehicleId: number): void {
    this.stale.add(vehicleId);
    clearTimeout(this.refreshTimer);
    this.refreshTimer = setTimeout(() => {
      if (!this.loaded.value) return;
      for (const id of this.stale) void this.refresh(id);
      this.stale.clear();
    }, 250);
  }

  async refresh(vehicleId: number): Promise<void> {
    try {
      const vehicle = await server.readVehicle(vehicleId);
      this.put(vehicle);
      const left = vehicleId !== this.vehicleId.value && vehicle.doubts.length > 0;
      if (left && this.proposals.doubted(vehicleId))
        toast(say("measure-proposed-doubt", { vehicle: String(vehicle.number) }), { kind: "problem" });
    } catch {
      // it is read again after the next change
    }
  }

  private step(event: FlowEvent): Effect | null {
    const { flow, effect: outcome } = step(this.flow.value, event);
    this.flow.value = flow;
    return outcome;
  }

  private leave(): void {
    this.points.endBurst();
    this.stage.keyboard.off();
    this.second.forget();
    this.whole.forget();
    this.geometry.forgetHeight();
    const id = this.vehicleId.value;
    if (id !== null && this.vehicles.drafts.value.has(id)) void this.vehicles.flush(id);
  }

  /** Starts the first frame before anything else is known, when the address says which. */
  private startFromAddress(): void {
    const params = new URLSearchParams(location.search);
    const recordingId = Number(params.get("recording"));
    const frame = Number(params.get("frame"));
    if (params.has("frame") && recordingId > 0 && frame >= 0) this.reel.show(recordingId, frame);
  }

  /**
   * The pass the address names, else the first with something to do: of the recording that it names, if it does. Where it
   * names one that is not here, that is said, and no other is opened in its place.
   */
  private openFirst(): void {
    const now = this.reel.player.value;
    const facts = this.reel.recordings.value.find((one) => one.id === now?.recordingId);
    if (now && facts) now.describe(facts);
    else if (now) this.reel.close();
    const [vehicleId, recordingId] = [asked("vehicle"), asked("recording")];
    const named = this.vehicles.get(vehicleId);
    const recording = this.reel.recordings.value.find((one) => one.id === recordingId);
    const missed = missedBy(vehicleId, named, recordingId, recording);
    if (missed) toast(say("address-elsewhere", { what: missed }), { kind: "problem" });
    const here = this.reel.player.value;
    // what was pressed on the frame of the address, while the passes were still on their way, counts
    if (named && named.recording_id === here?.recordingId) this.enter(named);
    else if (named) this.open(named, here?.frame.value ?? bestFrame(named));
    if (!this.reel.player.value) this.openIn(recording, missed === null);
  }

  /** The first pass with something to do in a recording, or in any; without `pass` its first frame only. */
  private openIn(recording: Recording | undefined, pass: boolean): void {
    const wanted = ({ recording_id }: Vehicle) => !recording || recording_id === recording.id;
    const list = this.list.value.filter(wanted);
    const next = firstOpen(list) ?? list[0] ?? this.vehicles.list.value.find(wanted);
    const ready = this.reel.recordings.value.find(
      (one) => one.state === "ready" && (!recording || one === recording),
    );
    if (next && pass) this.open(next);
    else if (ready) this.reel.show(ready.id, 0);
  }

  private followAxes(): void {
    const contact: ImagePoint | null = this.contact.value;
    const recordingId = this.reel.player.value?.recordingId;
    const target = this.flow.value.target ?? "roof";
    const show = contact !== null && recordingId !== undefined && this.hasPose.value;
    const of = { vehicleId: this.vehicleId.value, side: this.vehicle.value?.side ?? null };
    this.geometry.showAxes(
      show ? { recordingId, contact, target, inset: this.insetOf(target), ...of } : null,
    );
  }

  atContact(pointer: ImagePoint): boolean {
    const contact = this.contact.value;
    if (!contact) return false;
    const view = this.stage.view.value;
    const clicked = this.snapping.of(this.seenFrame.value, contact)?.from;
    return [contact, ...(clicked ? [clicked] : [])].some(
      (at) => screenDistance(view.toScreen(at), view.toScreen(pointer)) <= AT_CONTACT_PX,
    );
  }

  /** The height under a resting pointer was of something else: it goes at once, and is asked for again. */
  private aimAgain(): void {
    if (this.stage.dragging.value) return;
    this.geometry.forgetHeight();
    clearTimeout(this.aimTimer);
    this.aimTimer = setTimeout(() => {
      const at = this.stage.pointer.value;
      if (at && !this.stage.dragging.value) this.stage.hover(at);
    }, AFTER_CLICK_MS);
  }

  /** A contact that cannot be on the road (above the horizon, outside the lens): the next click places it again. */
  private refuseContact(): void {
    if (this.geometry.axes.value?.ok !== false) return;
    untracked(() => {
      if (this.points.entriesHere().length === 0) this.step({ type: "new-contact" });
    });
  }

  private followAddress(): void {
    const recording = this.reel.player.value?.recordingId ?? null;
    // also after a link to this page took it out of the address
    void query.value;
    // the frame that is seen, so that a copied address shows what its sender saw
    const frame = this.seenFrame.value;
    const vehicle = this.vehicleId.value;
    if (frame < 0 || !this.loaded.value || this.reel.player.value?.playing.value) return;
    clearTimeout(this.urlTimer);
    this.urlTimer = setTimeout(() => setQuery({ recording, frame, vehicle }), 250);
  }
}

/** What the address names and is not here; null where all of it is. */
function missedBy(
  vehicleId: number | null,
  vehicle: Vehicle | undefined,
  recordingId: number | null,
  recording: Recording | undefined,
): "vehicle" | "recording" | null {
  if (vehicle) return null;
  if (recordingId !== null && recording?.state !== "ready") return "recording";
  return vehicleId === null ? null : "vehicle";
}

/** What is asked for of a vehicle and was not said to be unseen. */
function askedOf(vehicle: Vehicle): readonly AskedTarget[] {
  return vehicle.asked.filter((target) => vehicle[`${target}_not_visible`] === null);
}
