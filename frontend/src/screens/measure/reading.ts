/** What the server has of the survey's vehicles: read at first, and again after something of them was stored. */
import { batch } from "@preact/signals";
import { say } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { Vehicle } from "../../core/types";
import { listVehicles, readVehicle } from "./ports";
import type { PassTable } from "./table";

const REST_MS = 250;

export class Reading {
  /** Vehicles of which something was stored since they were read. */
  private readonly stale = new Set<number>();
  /** How often something of a vehicle was stored: what was asked for before the last time lacks it. */
  private readonly stored = new Map<number, number>();
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `doubted`: whether something of a vehicle was confirmed as proposed, so that a doubt about it is told. */
  constructor(
    private readonly desk: PassTable,
    private readonly doubted: (vehicleId: number) => boolean,
  ) {}

  close(): void {
    clearTimeout(this.timer);
  }

  /** All vehicles of the survey, in place of those that were here; the measurements of those that are `isFresh`. */
  takeAll(vehicles: readonly Vehicle[], isFresh: (vehicle: Vehicle) => boolean = () => true): void {
    batch(() => {
      this.desk.vehicles.takeAll(vehicles);
      for (const vehicle of vehicles) if (isFresh(vehicle)) this.desk.records.take(vehicle);
    });
  }

  put(vehicle: Vehicle): void {
    this.desk.vehicles.take(vehicle);
    this.desk.records.take(vehicle);
  }

  async again(): Promise<void> {
    const before = new Map(this.stored);
    const vehicles = await listVehicles(this.desk.surveyId);
    this.takeAll(vehicles, ({ id }) => this.stored.get(id) === before.get(id));
  }

  /** One vehicle again: its state and version follow from what was stored. */
  soon(vehicleId: number): void {
    this.stored.set(vehicleId, (this.stored.get(vehicleId) ?? 0) + 1);
    this.stale.add(vehicleId);
    this.staleSoon();
  }

  /** What was stored while the list was still on its way waits for it. */
  staleSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (!this.desk.loaded.value) return;
      for (const id of this.stale) void this.one(id);
      this.stale.clear();
    }, REST_MS);
  }

  async one(vehicleId: number): Promise<void> {
    try {
      const before = this.stored.get(vehicleId);
      const vehicle = await readVehicle(vehicleId);
      if (this.stored.get(vehicleId) !== before) return; // it is read once more
      this.put(vehicle);
      const left = vehicleId !== this.desk.vehicleId.value && vehicle.doubts.length > 0;
      if (left && this.doubted(vehicleId))
        toast(say("measure-proposed-doubt", { vehicle: String(vehicle.number) }), { kind: "problem" });
    } catch {
      // it is read again after the next change
    }
  }
}
