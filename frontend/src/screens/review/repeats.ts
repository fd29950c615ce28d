/** Second clicks of the measurement that is open, each with its difference from the first. */
import { computed, signal } from "@preact/signals";
import { api } from "../../core/api";
import type { Ledger } from "../../core/history";
import { outbox } from "../../core/outbox";
import { me } from "../../core/session";
import type { Comparison, Measurement } from "../../core/types";
import { repeatWish } from "../../viewer/repeats";

export class Repeats {
  readonly comparisons = signal<readonly Comparison[] | null>(null);
  /** This person's own, the last of them. */
  readonly own = computed(() => this.comparisons.value?.filter(isOwn).at(-1) ?? null);
  /** What the server says of those that were withdrawn or put back. */
  private readonly turned = new Map<number, Measurement>();

  constructor(
    private readonly lane: string,
    private readonly refresh: (measurementId: number) => Promise<void>,
  ) {}

  read(measurementId: number): Promise<Comparison[]> {
    return api.ask("GET /measurements/{measurement_id}/repeats", { measurement_id: measurementId });
  }

  readonly standing: Ledger<Measurement, boolean> = {
    nameOf: ({ id }) => id,
    read: ({ id }) => this.comparisons.value?.some(({ repeat }) => repeat.id === id) === true,
    write: async (repeat, stands) => {
      const saved = this.turned.get(repeat.id) ?? repeat;
      const about = { vehicleId: repeat.vehicle_id };
      const want = { clicks: null, withdrawn: !stands };
      const stored = await outbox.store(repeatWish(`repeat.${repeat.id}`, this.lane, about, saved, want));
      if (stored?.saved) this.turned.set(repeat.id, stored.saved);
      if (repeat.repeat_of !== null) await this.refresh(repeat.repeat_of);
    },
  };
}

export function isOwn(one: Comparison): boolean {
  return one.repeat.created_by !== null && one.repeat.created_by.id === me.value?.person.id;
}
