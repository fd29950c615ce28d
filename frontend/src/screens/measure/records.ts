/**
 * The measurements of a survey as the operator wants them and as the server has them.
 * Every change only sets what is wanted; one loop per measurement brings the server there, in order, and says how far it is.
 */
import { signal } from "@preact/signals";
import { ApiError, explain } from "../../core/api";
import { newKey } from "../../core/random";
import type { HeightAnswer, Measurement, Vehicle } from "../../core/types";
import { sameValues, type Values, valuesOf } from "../../viewer/values";
import type { Outbox, OutboxItem } from "./outbox";

export interface Entry {
  readonly key: string;
  readonly vehicleId: number;
  /** What the server has. */
  readonly saved: Measurement | null;
  /** What is wanted; equal to `saved` once state is "saved". */
  readonly values: Values;
  readonly state: "saved" | "moving" | "saving" | "conflict" | "failed";
  /** The height of `values` before the server has stored them. */
  readonly preview: HeightAnswer | null;
  /** Why it could not be stored, or who changed it. */
  readonly problem: string | null;
  readonly theirs: Measurement | null;
}

/** The server's side, so that the loop can be tested without one. */
export interface RecordsPort {
  create(vehicleId: number, clientKey: string, values: Values): Promise<Measurement>;
  revise(id: number, revision: number, values: Values): Promise<Measurement>;
  withdraw(id: number, revision: number): Promise<Measurement>;
  restore(id: number, revision: number): Promise<Measurement>;
  read(id: number): Promise<Measurement>;
}

export class Records {
  readonly byVehicle = signal<ReadonlyMap<number, readonly Entry[]>>(new Map());
  private readonly loops = new Map<string, Promise<void>>();

  constructor(
    private readonly port: RecordsPort,
    private readonly outbox: Outbox,
    private readonly onStored: (entry: Entry) => void = () => {},
  ) {}

  of(vehicleId: number | null): readonly Entry[] {
    return vehicleId === null ? [] : (this.byVehicle.value.get(vehicleId) ?? []);
  }

  find(key: string): Entry | undefined {
    for (const entries of this.byVehicle.value.values()) {
      const found = entries.find((entry) => entry.key === key);
      if (found) return found;
    }
    return undefined;
  }

  /** Takes in what the server says of a vehicle; what is on its way from here stays as wanted. */
  take(vehicle: Vehicle): void {
    const now = this.of(vehicle.id);
    const known = new Map(now.map((entry) => [entry.saved?.id, entry]));
    const next = vehicle.measurements.map((m) => {
      const old = known.get(m.id);
      known.delete(m.id);
      if (!old) return fresh(m);
      if (old.state !== "saved") return old;
      return m.revision < (old.saved?.revision ?? 0) ? old : { ...fresh(m), key: old.key };
    });
    const rest = now.filter((e) => e.state !== "saved" && !next.some((n) => n.key === e.key));
    // a withdrawn measurement may have left the server's list; undo still needs it
    const withdrawn = now.filter((e) => e.state === "saved" && e.values.withdrawn && known.has(e.saved?.id));
    this.write(vehicle.id, [...next, ...rest, ...withdrawn.filter((e) => !rest.includes(e))]);
  }

  /** Sends what an earlier page left unsaved. Call after `take`. */
  resume(items: readonly OutboxItem[]): void {
    for (const item of items) {
      const here = this.of(item.vehicleId).find((e) => e.saved && e.saved.id === item.seriesId);
      if (here) {
        const stale = here.saved && item.revision !== null && here.saved.revision > item.revision;
        this.outbox.done(item.key);
        if (sameValues(here.values, item.values)) continue;
        this.put({ ...here, values: item.values });
        if (stale && here.saved) this.conflict(here.key, here.saved);
        else this.send(here.key);
      } else if (item.seriesId === null) {
        this.put(unsaved(item.key, item.vehicleId, item.values, null));
        this.send(item.key);
      } else this.outbox.done(item.key);
    }
  }

  create(vehicleId: number, values: Values, preview: HeightAnswer | null, key = newKey()): string {
    this.put(unsaved(key, vehicleId, values, preview));
    this.send(key);
    return key;
  }

  /** Sets what a measurement is to become and sends it. */
  change(key: string, change: Partial<Values>, options: { preview?: HeightAnswer | null } = {}): void {
    const entry = this.find(key);
    if (!entry) return;
    const values = { ...entry.values, ...change };
    const preview = options.preview === undefined ? entry.preview : options.preview;
    this.put({ ...entry, values, preview, state: "moving", problem: null });
    this.send(key);
  }

  /** Only shows: a point under a moving pointer. */
  show(key: string, change: Partial<Values>, preview?: HeightAnswer | null): void {
    const entry = this.find(key);
    if (!entry) return;
    const values = { ...entry.values, ...change };
    this.put({ ...entry, values, state: "moving", preview: preview === undefined ? entry.preview : preview });
  }

  /** Ends a conflict: theirs is taken, or mine is written on top of theirs. */
  resolve(key: string, choice: "mine" | "theirs"): void {
    const entry = this.find(key);
    if (!entry?.theirs) return;
    if (choice === "theirs") {
      this.outbox.done(key);
      this.put({ ...fresh(entry.theirs), key });
    } else {
      this.put({ ...entry, saved: entry.theirs, theirs: null, problem: null, state: "moving" });
      this.send(key);
    }
  }

  /** Tries again what the server refused, or lets it go. */
  retry(key: string): void {
    this.send(key);
  }

  discard(key: string): void {
    const entry = this.find(key);
    if (!entry) return;
    this.outbox.done(key);
    if (entry.saved) this.put({ ...fresh(entry.saved), key });
    else this.remove(entry);
  }

  /** Resolves when a measurement rests: stored, in conflict or refused. */
  async settled(key: string): Promise<Entry | undefined> {
    await this.loops.get(key);
    return this.find(key);
  }

  private send(key: string): void {
    const entry = this.find(key);
    if (!entry) return;
    this.put({ ...entry, state: "saving", problem: null });
    this.keep(key);
    if (!this.loops.has(key)) {
      const loop = this.bring(key).finally(() => {
        this.loops.delete(key);
        if (this.find(key)?.state === "saving") this.send(key);
      });
      this.loops.set(key, loop);
    }
  }

  /** One write at a time until the server has what is wanted. */
  private async bring(key: string): Promise<void> {
    for (let entry = this.find(key); entry; entry = this.find(key)) {
      // a point that is being moved is sent when it is let go
      if (entry.state !== "saving") return;
      if (entry.saved && sameValues(valuesOf(entry.saved), entry.values)) return this.arrived(entry);
      if (!entry.saved && entry.values.withdrawn) return this.remove(entry);
      const wanted = entry.values;
      try {
        const saved = await this.sendOne(entry);
        this.patch(key, { saved });
        this.keep(key);
      } catch (error) {
        if (!(await this.refused(key, wanted, error))) return;
      }
    }
  }

  private sendOne({ key, vehicleId, saved, values }: Entry): Promise<Measurement> {
    if (!saved) return this.port.create(vehicleId, key, values);
    if (values.withdrawn) return this.port.withdraw(saved.id, saved.revision);
    if (saved.withdrawn) return this.port.restore(saved.id, saved.revision);
    return this.port.revise(saved.id, saved.revision, values);
  }

  /** Answers true when the loop may go on: the refusal was only the echo of a write whose answer was lost. */
  private async refused(key: string, wanted: Values, error: unknown): Promise<boolean> {
    const entry = this.find(key);
    if (!entry) return false;
    if (error instanceof ApiError && error.status === 409 && entry.saved) {
      try {
        const theirs = await this.port.read(entry.saved.id);
        if (sameValues(valuesOf(theirs), wanted)) {
          this.patch(key, { saved: theirs });
          return true;
        }
        if (theirs.revision > entry.saved.revision) {
          this.conflict(key, theirs, error.message);
          return false;
        }
      } catch {
        // the first error says more
      }
    }
    this.patch(key, { state: "failed", problem: explain(error) });
    return false;
  }

  private conflict(key: string, theirs: Measurement, message?: string): void {
    const problem = message ?? "It was changed elsewhere while yours was not yet saved.";
    this.patch(key, { state: "conflict", theirs, problem });
  }

  private arrived(entry: Entry): void {
    this.outbox.done(entry.key);
    const rested: Entry = { ...entry, state: "saved", preview: null, problem: null, theirs: null };
    this.put(rested.saved ? { ...rested, values: valuesOf(rested.saved) } : rested);
    this.onStored(rested);
  }

  private keep(key: string): void {
    const entry = this.find(key);
    if (!entry) return;
    const { vehicleId, values, saved } = entry;
    this.outbox.put({
      key,
      vehicleId,
      values,
      seriesId: saved?.id ?? null,
      revision: saved?.revision ?? null,
    });
  }

  private patch(key: string, change: Partial<Entry>): void {
    const entry = this.find(key);
    if (entry) this.put({ ...entry, ...change });
  }

  private put(entry: Entry): void {
    const now = this.of(entry.vehicleId);
    const there = now.some((other) => other.key === entry.key);
    this.write(
      entry.vehicleId,
      there ? now.map((other) => (other.key === entry.key ? entry : other)) : [...now, entry],
    );
  }

  private remove(entry: Entry): void {
    this.outbox.done(entry.key);
    this.write(
      entry.vehicleId,
      this.of(entry.vehicleId).filter((other) => other.key !== entry.key),
    );
  }

  private write(vehicleId: number, entries: readonly Entry[]): void {
    this.byVehicle.value = new Map(this.byVehicle.value).set(vehicleId, entries);
  }
}

function fresh(m: Measurement): Entry {
  return {
    key: `m${m.id}`,
    vehicleId: m.vehicle_id,
    saved: m,
    values: valuesOf(m),
    state: "saved",
    preview: null,
    problem: null,
    theirs: null,
  };
}

function unsaved(key: string, vehicleId: number, values: Values, preview: HeightAnswer | null): Entry {
  return { key, vehicleId, saved: null, values, state: "saving", preview, problem: null, theirs: null };
}
