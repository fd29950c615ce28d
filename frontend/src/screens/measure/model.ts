/**
 * The measure page's state: survey, passes, the frame, the flow of clicks. Views read its signals; keys and buttons call it.
 * Points (storing, dragging, nudging) live in `points.ts`, which this hands out as `points`.
 */
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { History } from "../../core/history";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { canWork } from "../../core/session";
import { stored } from "../../core/stored";
import { toast } from "../../core/toasts";
import type { AskedTarget, NotVisible, Target, Vehicle } from "../../core/types";
import { bestFrame, type Filter, listed, neighbour, nextOpen, type Order } from "../../parts/vehicles/passes";
import { Geometry } from "../../viewer/geometry";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";
import type { Inset } from "../../viewer/values";
import { Aiming } from "./aiming";
import { Assist } from "./assist/assist";
import { Snapping } from "./assist/snapping";
import type { ClickTool, PassDesk } from "./desk";
import type { Changes } from "./fields";
import { type Effect, type Flow, type FlowEvent, firstMissing, START, step } from "./flow";
import { Insets } from "./insets";
import { factLedger } from "./ledgers";
import { PageAddress } from "./pageAddress";
import { PASS_ADDED, PASS_JOINED, PASS_SPLIT, PASS_THERE } from "./passes/kinds";
import { Passes } from "./passes/list";
import { Points } from "./points";
import * as server from "./ports";
import { Proposals } from "./proposals/proposals";
import { Reading } from "./reading";
import { Records } from "./records";
import { SecondFrame } from "./secondFrame";
import { Standing } from "./standing";
import { Vehicles } from "./vehicles";
import { WholePass } from "./wholePass";

export const filter = stored<Filter>("passes.filter", "all");
export const order = stored<Order>("passes.order", "number");

export class MeasureModel implements PassDesk {
  readonly reel = new Reel();
  /** Who has a click, a key or Esc first: this order, and no other place, says so. */
  readonly stage: FrameStage = new FrameStage(() => [
    this.assist,
    this.stage.keyboard,
    this.second,
    this.whole,
    this.passes,
    this.proposals,
    this.points,
  ]);
  readonly history: History = new History(() => this.place());
  readonly geometry = new Geometry();
  readonly records: Records;
  readonly vehicles: Vehicles;
  readonly standing: Standing = new Standing(this);
  readonly second: SecondFrame = new SecondFrame(this, (...change) => this.points.revise(...change));
  readonly points: Points = new Points(this, this.second);
  readonly passes: Passes = new Passes(this);
  readonly insets: Insets = new Insets(this, this.points);
  readonly whole: WholePass = new WholePass(this, this.second, this.points.revise);
  readonly snapping: Snapping = new Snapping(this);
  /** Where the proposed contact was turned down, a click means another place. */
  readonly snaps = computed(
    () => canWork.value && this.hasPose.value && !this.proposals.turnedDown("contact"),
  );
  readonly assist: Assist;
  readonly proposals: Proposals;
  private readonly aiming: Aiming;
  private readonly address: PageAddress;
  readonly flow = signal<Flow>(START);
  readonly vehicleId = computed(() => this.flow.value.vehicleId);
  readonly loaded = signal(false);
  readonly problem = signal<unknown>(null);

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

  /** Told when something of a vehicle has been stored, for the other tabs. */
  onStored: (vehicleId: number) => void = () => {};

  /** The player's wishes when the open pass was opened. */
  private wishesThen = 0;
  readonly facts: ReturnType<typeof factLedger>;
  private readonly stops: (() => void)[] = [];
  readonly reading = new Reading(this, (vehicleId) => this.proposals.doubted(vehicleId));

  constructor(readonly surveyId: number) {
    const stored = (vehicleId: number): void => {
      this.reading.soon(vehicleId);
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
    this.aiming = new Aiming(this, this.second);
    this.address = new PageAddress(this, (vehicle) => this.enter(vehicle));
    this.stops.push(
      ...[PASS_ADDED, PASS_THERE, PASS_SPLIT, PASS_JOINED].map((kind) =>
        outbox.listen(kind, (wish) => {
          // where it fails, the list is read again with the next change
          if (this.passes.cameThrough(wish)) void this.reading.again().catch(() => undefined);
        }),
      ),
      effect(() => {
        void this.reel.player.value?.recordingId;
        untracked(() => void this.readProposals());
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
        this.reading.takeAll(vehicles);
        this.loaded.value = true;
      });
      this.address.openFirst();
      this.records.resume();
      this.reading.staleSoon();
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    for (const stop of this.stops) stop();
    this.address.close();
    this.reading.close();
    this.aiming.close();
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

  open(vehicle: Vehicle, frame = this.usualFrame(vehicle)): void {
    this.leave();
    batch(() => {
      this.enter(vehicle);
      this.wishesThen = this.reel.show(vehicle.recording_id, frame).wishes;
    });
  }

  private enter(vehicle: Vehicle): void {
    const contacts = this.standing.contactsOf(vehicle.id);
    const target = canWork.value ? firstMissing(this.standing.targetsOf(vehicle.id), askedOf(vehicle)) : null;
    batch(() => {
      this.step({ type: "open", vehicleId: vehicle.id, target, contacts });
      this.insets.forget();
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
    const have = this.standing.targetsOf(vehicle.id);
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

  insetOf(target: Target): Inset | null {
    return this.insets.of(target);
  }

  asked(): readonly Target[] {
    const vehicle = this.vehicle.value;
    return vehicle ? askedOf(vehicle) : [];
  }

  /** The target that is not visible: asks why, beside its row. */
  askWhyUnseen(): void {
    const target = this.flow.value.target;
    if (target && target !== "other" && !this.standing.targetsOf(this.vehicleId.value).has(target))
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
      const missing = this.standing.missing();
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
    const done = this.asked().length > 0 && this.standing.missing().length === 0;
    if (done && before.id === this.vehicleId.value && !before.make && !before.model) this.confirmNext();
  }

  edit(changes: Changes, vehicle = this.vehicle.value): void {
    if (!vehicle) return;
    this.history.run(say("measure-step-vehicle", { vehicle: String(vehicle.number) }), (step) => {
      for (const field of Object.keys(changes) as (keyof Changes)[])
        step.touch(this.facts, { id: vehicle.id, field });
      this.vehicles.edit(vehicle.id, changes);
    });
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
}

/** What is asked for of a vehicle and was not said to be unseen. */
function askedOf(vehicle: Vehicle): readonly AskedTarget[] {
  return vehicle.asked.filter((target) => vehicle[`${target}_not_visible`] === null);
}
