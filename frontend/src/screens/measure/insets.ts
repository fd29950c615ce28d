/** What is assumed of the open vehicle's targets: their insets, and the side on which the driver sits. */
import { computed, signal } from "@preact/signals";
import { survey } from "../../core/survey";
import type { DriverSide, Target } from "../../core/types";
import { usualInset } from "../../parts/vehicles/insets";
import type { Inset } from "../../viewer/values";
import type { PassDesk } from "./desk";
import type { Points } from "./points";

export class Insets {
  /** Chosen for this vehicle's targets before they are measured. */
  private readonly chosen = signal<ReadonlyMap<string, Inset>>(new Map());

  constructor(
    private readonly desk: PassDesk,
    private readonly points: Points,
  ) {}

  forget(): void {
    this.chosen.value = new Map();
  }

  /** The inset a click would be stored with: chosen now, or of the measurement it revises; null: the survey's. */
  of(target: Target): Inset | null {
    return this.chosen.value.get(target) ?? this.desk.standing.revised(target)?.values.inset ?? null;
  }

  choose(target: Target, inset: Inset): void {
    this.chosen.value = new Map(this.chosen.value).set(target, inset);
    for (const entry of this.desk.entries.value)
      if (entry.values.target === target && !entry.values.withdrawn) this.points.setInset(entry.key, inset);
  }

  /** What the survey assumes for a target; null for an eye of which nobody knows the driver's side. */
  usual(target: Target): (Inset & { note: string }) | null {
    const vehicle = this.desk.vehicle.value;
    return usualInset(survey.value, target, vehicle?.side ?? null, vehicle?.category ?? null);
  }

  /** Where this vehicle's driver sits; null: as its direction and the survey's traffic say. Saved at once. */
  chooseSide(side: DriverSide | null): void {
    const vehicle = this.desk.vehicle.value;
    if (!vehicle || vehicle.driver_side === side) return;
    this.chosen.value = new Map([...this.chosen.value].filter(([target]) => target !== "driver_eye"));
    this.desk.edit({ driver_side: side });
    void this.desk.vehicles.flush(vehicle.id);
  }

  /** On which side the driver sits, said or following from the direction; null while neither is known. */
  readonly side = computed<DriverSide | null>(() => {
    const vehicle = this.desk.vehicle.value;
    return vehicle?.driver_side ?? vehicle?.side ?? null;
  });

  /** By one key: the other side than it is now; near where it is not known. */
  turnSide(): void {
    this.chooseSide(this.side.value === "near" ? "far" : "near");
  }
}
