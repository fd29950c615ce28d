/**
 * The measurements of a survey as the operator wants them and as the server has them.
 * Every change only sets what is wanted; one loop per measurement brings the server there, in order, and says how far it is.
 */
import { signal } from "@preact/signals";
import { say } from "../../core/messages";
import type { Outbox, Wish } from "../../core/outbox";
import { newKey } from "../../core/random";
import type { HeightAnswer, Measurement, Vehicle } from "../../core/types";
import { formatHeight } from "../../core/units";
import { STATE_WORDS } from "../../core/words";
import { type Values, valuesOf } from "../../viewer/values";
import { MEASUREMENT, type MeasurementAbout } from "./kinds";

export interface Entry {
  readonly key: string;
  readonly vehicleId: number;
  readonly saved: Measurement | null;
  /** What is wanted; equal to `saved` once state is "saved". */
  readonly values: Values;
  readonly state: "saved" | "moving" | "saving" | "conflict" | "failed";
  /** The height of `values` before the server has stored them. */
  readonly preview: HeightAnswer | null;
  readonly problem: string | null;
  readonly theirs: Measurement | null;
}

/** Of a refused click nothing is stored. */
export function isStored({ state, saved }: Entry): boolean {
  return !(state === "failed" && !saved);
}

type Clicked = Wish<Measurement, Values, MeasurementAbout>;

export class Records {
  readonly byVehicle = signal<ReadonlyMap<number, readonly Entry[]>>(new Map());
  private readonly numbers = new Map<number, number>();
  /** No longer told of what the outbox does. */
  readonly close: () => void;

  constructor(
    private readonly outbox: Outbox,
    private readonly surveyId: number,
    private readonly onStored: (vehicleId: number) => void = () => {},
  ) {
    this.close = outbox.listen(MEASUREMENT, (wish: Clicked) => this.follow(wish));
  }

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
    this.numbers.set(vehicle.id, vehicle.number);
    const now = this.of(vehicle.id);
    const known = new Map(now.map((entry) => [(entry.saved ?? entry.theirs)?.id, entry]));
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

  /** Shows what an earlier page left unsaved and the outbox sends. Call after `take`. */
  resume(): void {
    for (const wish of this.outbox.of<Measurement, Values, MeasurementAbout>(MEASUREMENT)) this.follow(wish);
  }

  create(vehicleId: number, values: Values, preview: HeightAnswer | null, key = newKey()): string {
    this.put(unsaved(key, vehicleId, values, preview));
    this.send(key);
    return key;
  }

  change(key: string, change: Partial<Values>, options: { preview?: HeightAnswer | null } = {}): void {
    const entry = this.find(key);
    if (!entry) return;
    const values = { ...entry.values, ...change };
    const preview = options.preview === undefined ? entry.preview : options.preview;
    this.put({ ...entry, values, preview, state: "moving", problem: null });
    this.send(key);
  }

  show(key: string, change: Partial<Values>, preview?: HeightAnswer | null): void {
    const entry = this.find(key);
    if (!entry) return;
    const values = { ...entry.values, ...change };
    this.put({ ...entry, values, state: "moving", preview: preview === undefined ? entry.preview : preview });
  }

  /** Resolves when a measurement rests: stored, in conflict or refused. */
  async settled(key: string): Promise<Entry | undefined> {
    await this.outbox.settled(key);
    return this.find(key);
  }

  private send(key: string): void {
    const entry = this.find(key);
    if (!entry) return;
    this.put({ ...entry, state: "saving", problem: null });
    const { vehicleId, saved, values } = entry;
    this.outbox.want<Measurement, Values, MeasurementAbout>({
      key,
      kind: MEASUREMENT,
      lane: `vehicle.${vehicleId}`,
      about: { vehicleId },
      what: say("scan-step-height", { target: values.target, vehicle: String(this.numbers.get(vehicleId)) }),
      mine: wordsOf(entry),
      page: `/surveys/${this.surveyId}/measure?vehicle=${vehicleId}`,
      saved,
      want: values,
    });
  }

  /** What the outbox says of a measurement; a point that is being moved stays under the hand that moves it. */
  private follow(wish: Clicked): void {
    const { key, saved, state, problem, theirs } = wish;
    const { vehicleId } = wish.about;
    if (state === "saved" && wish.page.startsWith(`/surveys/${this.surveyId}/`)) this.onStored(vehicleId);
    if (!this.find(key) && !this.byVehicle.value.has(vehicleId)) return;
    const entry = this.find(key) ?? this.adopted(wish);
    this.letGo(entry, wish);
    if (state === "saved" || state === "dropped") {
      if (!saved) this.remove(entry);
      else if (entry.state === "moving") this.put({ ...entry, saved });
      else this.put({ ...fresh(saved), key });
    } else {
      const moving = entry.state === "moving";
      const shown = state === "held" ? "saving" : state;
      this.put(
        moving ? { ...entry, saved } : { ...entry, saved, values: wish.want, state: shown, problem, theirs },
      );
    }
  }

  /** An entry for what an earlier page wished, in place of the one that the server's measurement has here. */
  private adopted({ key, about: { vehicleId }, want, saved }: Clicked): Entry {
    const others = this.of(vehicleId).filter((entry) => !saved || entry.saved?.id !== saved.id);
    const entry = { ...unsaved(key, vehicleId, want, null), saved };
    this.write(vehicleId, [...others, entry]);
    return entry;
  }

  /** One row a measurement: what the server has is shown by the entry that wants to change it. */
  private letGo({ vehicleId, key }: Entry, wish: Clicked): void {
    const there = wish.saved ?? wish.theirs;
    const now = this.of(vehicleId);
    const left = now.filter((other) => other.key === key || !there || other.saved?.id !== there.id);
    if (left.length < now.length) this.write(vehicleId, left);
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

/** What it is to become, for whoever has to choose: the height as it was answered for the clicks, if it was. */
function wordsOf({ values, preview }: Entry): string {
  if (values.withdrawn) return STATE_WORDS.withdrawn;
  if (preview?.status !== "ok") return say("measure-clicked-on", { frame: String(values.frame) });
  return formatHeight(preview.height_m, preview.U95_height_m);
}
