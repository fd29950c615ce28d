/** The passes of the list: marked, taken out, brought back, by the outbox and each as a step. */
import { signal } from "@preact/signals";
import { ask } from "../../../components";
import type { Ledger } from "../../../core/history";
import { say } from "../../../core/messages";
import { outbox, type Wanted, type Wish } from "../../../core/outbox";
import { newKey } from "../../../core/random";
import { toast, toastProblem } from "../../../core/toasts";
import type { Vehicle } from "../../../core/types";
import { vehicleName } from "../../../core/words";
import { neighbour } from "../../../parts/vehicles/passes";
import type { PassDesk } from "../desk";
import { type AddedWant, PASS_ADDED, PASS_THERE, type Presence } from "./kinds";

export class Passes {
  readonly from = signal<number | null>(null);
  private readonly gone = new Map<number, Vehicle>();
  /** Keys of what this page itself waits for. */
  private readonly underWay = new Set<string>();

  constructor(private readonly desk: PassDesk) {}

  cancel(): boolean {
    const marked = this.from.value !== null;
    this.from.value = null;
    return marked;
  }

  mark(end: "first" | "last"): void {
    const frame = this.desk.seenFrame.value;
    if (frame < 0) return;
    if (end === "first" || this.from.value === null) {
      this.from.value = frame;
      toast(say("measure-pass-marked", { frame: String(frame) }));
      return;
    }
    const [first, last] = [Math.min(this.from.value, frame), Math.max(this.from.value, frame)];
    this.from.value = null;
    void this.add(first, last);
  }

  async remove(): Promise<void> {
    const open = this.desk.vehicle.value;
    if (!open) return;
    const vehicle = String(open.number);
    const count = this.desk.entries.value.filter((entry) => !entry.values.withdrawn).length;
    const title = say("measure-pass-delete-title", { vehicle });
    const body = say("measure-pass-delete-body", { vehicle, count });
    if (!(await ask({ title, body, action: say("measure-pass-delete") }))) return;
    await this.inTurn(() =>
      this.desk.history.run(say("measure-step-deletion", { vehicle }), (step) =>
        step.write(this.presence, open.id, false),
      ),
    );
  }

  private async add(first: number, last: number): Promise<void> {
    const recordingId = this.desk.reel.player.value?.recordingId;
    if (recordingId === undefined) return;
    const opened = this.desk.vehicleId.value;
    await this.inTurn(async () => {
      const stored = await this.store<Vehicle, AddedWant, { recordingId: number }>({
        key: newKey(),
        kind: PASS_ADDED,
        lane: `passes.${recordingId}`,
        about: { recordingId },
        what: say("measure-pass-new"),
        mine: say("measure-pass-new-frames", { first_frame: String(first), last_frame: String(last) }),
        saved: null,
        want: { first_frame: first, last_frame: last },
      });
      const vehicle = stored?.saved;
      if (!vehicle) return toast(say("measure-pass-kept"));
      this.desk.history.run(say("measure-step-new-pass", { vehicle: String(vehicle.number) }), (step) => {
        step.touch(this.presence, vehicle.id);
        this.desk.reading.put(vehicle);
        this.openUnless(vehicle, opened);
      });
    });
  }

  /** What was opened while something was stored stays open. */
  openUnless(vehicle: Vehicle, opened: number | null): void {
    if (this.desk.vehicleId.value === opened) this.desk.open(vehicle);
  }

  inTurn(work: () => Promise<void> | void): Promise<void> {
    return this.desk.history.inTurn(work).catch(toastProblem);
  }

  /** A change of passes, by the outbox; null: kept, and told once it is there. */
  async store<S, W, A>(wanted: Omit<Wanted<S, W, A>, "page">): Promise<Wish<S, W, A> | null> {
    this.underWay.add(wanted.key);
    try {
      return await outbox.store<S, W, A>({ ...wanted, page: this.page });
    } finally {
      this.underWay.delete(wanted.key);
    }
  }

  /** Whether a wish of this page's passes is stored that nothing here waits for: it was kept, or left by an earlier page. */
  cameThrough({ key, state, page }: Wish): boolean {
    return state === "saved" && page === this.page && !this.underWay.has(key);
  }

  private get page(): string {
    return `/surveys/${this.desk.surveyId}/measure`;
  }

  readonly presence: Ledger<number, boolean> = {
    read: (id) => this.desk.vehicles.get(id) !== undefined,
    write: (id, there) => this.turn(id, there),
  };

  /** The version that is seen; null while changes of one's own are on their way, which go out before and make another. */
  versionOf({ id, version }: Vehicle): number | null {
    return this.desk.vehicles.drafts.value.has(id) ? null : version;
  }

  /** Out of the list, and known for an undo. */
  takenOut(vehicle: Vehicle): void {
    this.gone.set(vehicle.id, vehicle);
    this.desk.vehicles.hide(vehicle.id);
  }

  private async turn(id: number, there: boolean): Promise<void> {
    const vehicle = this.desk.vehicles.shown(id) ?? this.gone.get(id);
    if (!vehicle) return;
    const opened = this.desk.vehicleId.value;
    const next = neighbour(this.desk.list.value, vehicle, 1) ?? neighbour(this.desk.list.value, vehicle, -1);
    const stored = await this.store<Presence, boolean, { id: number }>({
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
      this.desk.reading.put(stored?.saved?.vehicle ?? vehicle);
      this.openUnless(vehicle, opened);
      return;
    }
    this.takenOut(vehicle);
    if (this.desk.vehicleId.value !== id) return;
    if (next) this.desk.open(next);
    else this.desk.dispatch({ type: "open", vehicleId: null, target: null });
  }
}
