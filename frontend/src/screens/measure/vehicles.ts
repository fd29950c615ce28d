/**
 * The vehicle records of a survey: what the server has, what the operator has typed since, and what to do when somebody
 * else changed the same record meanwhile. Fields changed on one side only are merged; the others are asked about.
 */
import { signal } from "@preact/signals";
import { ApiError, explain } from "../../core/api";
import type { Vehicle, VehicleFields } from "../../core/types";

const FIELDS = [
  "first_frame",
  "best_frame",
  "last_frame",
  "make",
  "model",
  "year",
  "category",
  "manufacturer_height_m",
  "u_manufacturer_height_m",
  "height_source",
  "lighting",
  "notes",
] as const satisfies readonly (keyof VehicleFields)[];
export type Field = (typeof FIELDS)[number];
export type Changes = Partial<VehicleFields>;

export const FIELD_WORDS: Record<Field, string> = {
  first_frame: "First frame",
  best_frame: "Best frame",
  last_frame: "Last frame",
  make: "Make",
  model: "Model",
  year: "Year",
  category: "Category",
  manufacturer_height_m: "Manufacturer height",
  u_manufacturer_height_m: "± of the manufacturer height",
  height_source: "Source of the height",
  lighting: "Lighting",
  notes: "Notes",
};

export interface Draft {
  /** What the server had when the first of these changes was made. */
  readonly base: Vehicle;
  readonly changes: Changes;
  readonly state: "typing" | "saving" | "conflict" | "failed";
  readonly problem: string | null;
  readonly theirs: Vehicle | null;
  /** Fields that both sides changed, each to something else. */
  readonly disputed: readonly Field[];
}

export interface VehiclesPort {
  /** Fields left out stay as they are. */
  save(id: number, version: number, changes: Changes): Promise<Vehicle>;
}

export class Vehicles {
  readonly list = signal<readonly Vehicle[]>([]);
  readonly drafts = signal<ReadonlyMap<number, Draft>>(new Map());
  private readonly timers = new Map<number, ReturnType<typeof setTimeout>>();
  private readonly running = new Map<number, Promise<void>>();

  constructor(
    private readonly port: VehiclesPort,
    private readonly onMerged: (message: string) => void = () => {},
    private readonly delay_ms = 500,
  ) {}

  get(id: number | null): Vehicle | undefined {
    return this.list.value.find((vehicle) => vehicle.id === id);
  }

  /** The record as the operator sees it: the server's with what has been typed since. */
  shown(id: number | null): Vehicle | undefined {
    const vehicle = this.get(id);
    const draft = id === null ? undefined : this.drafts.value.get(id);
    return vehicle && draft ? { ...vehicle, ...draft.changes } : vehicle;
  }

  take(vehicle: Vehicle): void {
    const known = this.get(vehicle.id);
    if (known && known.version > vehicle.version) return;
    const others = this.list.value.filter((other) => other.id !== vehicle.id);
    this.list.value = [...others, vehicle].sort(byRecordingAndNumber);
  }

  takeAll(vehicles: readonly Vehicle[]): void {
    this.list.value = [...vehicles].sort(byRecordingAndNumber);
  }

  drop(id: number): void {
    this.list.value = this.list.value.filter((vehicle) => vehicle.id !== id);
    this.setDraft(id, null);
  }

  /** Somebody begins to type: what they see now is what their change will be compared with. */
  hold(id: number): void {
    const base = this.get(id);
    if (base && !this.drafts.value.has(id)) this.setDraft(id, { ...clean(base), changes: {} });
  }

  /** The field was left; without a change there is nothing to keep. */
  release(id: number): void {
    const draft = this.drafts.value.get(id);
    if (draft && draft.state === "typing" && Object.keys(draft.changes).length === 0) this.setDraft(id, null);
  }

  /** Changes fields at once on the screen and soon on the server. */
  edit(id: number, changes: Changes): void {
    const base = this.drafts.value.get(id)?.base ?? this.get(id);
    if (!base) return;
    const old = this.drafts.value.get(id);
    this.setDraft(id, {
      base,
      changes: { ...old?.changes, ...changes },
      state: old?.state === "conflict" ? "conflict" : "typing",
      problem: null,
      theirs: old?.theirs ?? null,
      disputed: old?.disputed ?? [],
    });
    clearTimeout(this.timers.get(id));
    this.timers.set(
      id,
      setTimeout(() => void this.flush(id), this.delay_ms),
    );
  }

  /** Saves what has been typed, now. Resolves when it rests. */
  async flush(id: number): Promise<void> {
    clearTimeout(this.timers.get(id));
    this.timers.delete(id);
    while (this.running.has(id)) await this.running.get(id);
    const draft = this.drafts.value.get(id);
    if (!draft || draft.state === "conflict" || Object.keys(draft.changes).length === 0) return;
    const run = this.save(id, draft).finally(() => this.running.delete(id));
    this.running.set(id, run);
    await run;
  }

  /** Ends a conflict with the operator's choice for each disputed field. */
  async settle(id: number, choice: ReadonlyMap<Field, "mine" | "theirs">): Promise<void> {
    const draft = this.drafts.value.get(id);
    if (!draft?.theirs) return;
    const changes: Record<string, unknown> = { ...draft.changes };
    for (const [field, side] of choice) if (side === "theirs") delete changes[field];
    this.take(draft.theirs);
    if (Object.keys(changes).length === 0) return this.setDraft(id, null);
    this.setDraft(id, { ...clean(draft.theirs), changes: changes as Changes });
    await this.flush(id);
  }

  private async save(id: number, draft: Draft): Promise<void> {
    this.setDraft(id, { ...draft, state: "saving" });
    try {
      const saved = await this.port.save(id, draft.base.version, draft.changes);
      this.take(saved);
      const now = this.drafts.value.get(id);
      const later = now ? changedSince(draft.changes, now.changes) : {};
      this.setDraft(id, Object.keys(later).length > 0 ? { ...clean(saved), changes: later } : null);
    } catch (error) {
      await this.refused(id, draft, error);
    }
  }

  private async refused(id: number, draft: Draft, error: unknown): Promise<void> {
    const theirs = error instanceof ApiError && error.status === 409 ? currentOf(error) : null;
    const now = this.drafts.value.get(id) ?? draft;
    if (!theirs) {
      this.setDraft(id, { ...now, state: "failed", problem: explain(error) });
      return;
    }
    const disputed = disputedFields(draft.base, now.changes, theirs);
    if (disputed.length > 0) {
      this.setDraft(id, { ...now, state: "conflict", problem: explain(error), theirs, disputed });
      return;
    }
    // both sides' changes fit together: keep both, and say so
    this.take(theirs);
    const agreed = Object.entries(now.changes).every(([k, v]) => theirs[k as Field] === v);
    this.setDraft(id, agreed ? null : { ...clean(theirs), changes: now.changes });
    if (agreed) return;
    this.onMerged(`${explain(error)} Your changes are to other fields, so both are kept.`);
    this.timers.set(
      id,
      setTimeout(() => void this.flush(id), 0),
    );
  }

  private setDraft(id: number, draft: Draft | null): void {
    const drafts = new Map(this.drafts.value);
    if (draft) drafts.set(id, draft);
    else drafts.delete(id);
    this.drafts.value = drafts;
  }
}

/** Fields that both sides changed from the base, to different values. */
export function disputedFields(base: Vehicle, mine: Changes, theirs: Vehicle): Field[] {
  return FIELDS.filter(
    (field) =>
      field in mine &&
      mine[field] !== base[field] &&
      theirs[field] !== base[field] &&
      theirs[field] !== mine[field],
  );
}

function changedSince(sent: Changes, now: Changes): Changes {
  return Object.fromEntries(Object.entries(now).filter(([field, value]) => sent[field as Field] !== value));
}

function clean(base: Vehicle): Omit<Draft, "changes"> {
  return { base, state: "typing", problem: null, theirs: null, disputed: [] };
}

function currentOf(error: ApiError): Vehicle | null {
  const body = error.body as { current?: Vehicle; error?: { current?: Vehicle } } | null;
  return body?.current ?? body?.error?.current ?? null;
}

function byRecordingAndNumber(a: Vehicle, b: Vehicle): number {
  return a.recording_id - b.recording_id || a.number - b.number;
}
