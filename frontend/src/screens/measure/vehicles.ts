/**
 * The vehicle records of a survey: what the server has, what the operator has typed since, and what to do when somebody
 * else changed the same record meanwhile. Fields changed on one side only are merged; the others are asked about.
 */
import { computed, signal } from "@preact/signals";
import { say } from "../../core/messages";
import type { Outbox, Wish } from "../../core/outbox";
import type { Vehicle } from "../../core/types";
import { type Changes, disputedFields, type Field } from "./fields";
import { factWords, VEHICLE } from "./kinds";

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

type Typed = Wish<Vehicle, Changes, { id: number }>;

export class Vehicles {
  readonly list = signal<readonly Vehicle[]>([]);
  /** What is typed, by vehicle; the outbox keeps it. */
  readonly drafts = computed<ReadonlyMap<number, Draft>>(
    () => new Map(this.outbox.of<Vehicle, Changes, { id: number }>(VEHICLE).flatMap(draftOf)),
  );
  /** No longer told of what the outbox does. */
  readonly close: () => void;
  private readonly held = new Map<number, Vehicle>();
  private readonly timers = new Map<number, ReturnType<typeof setTimeout>>();

  constructor(
    private readonly outbox: Outbox,
    private readonly surveyId: number,
    private readonly told: { merged?: (message: string) => void; stored?: (id: number) => void } = {},
    private readonly delay_ms = 500,
  ) {
    this.close = outbox.listen(VEHICLE, (wish: Typed) => this.follow(wish));
  }

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

  /** Out of the list; what was typed of it is still stored. */
  hide(id: number): void {
    this.list.value = this.list.value.filter((vehicle) => vehicle.id !== id);
  }

  /** Somebody begins to type: what they see now is what their change will be compared with. */
  hold(id: number): void {
    const base = this.get(id);
    if (base && !this.held.has(id)) this.held.set(id, base);
  }

  /** The field was left; what is typed next is compared with what is seen then. */
  release(id: number): void {
    this.held.delete(id);
  }

  edit(id: number, changes: Changes): void {
    const before = this.drafts.value.get(id);
    const base = before?.base ?? this.held.get(id) ?? this.get(id);
    if (!base) return;
    this.want(id, base, { ...before?.changes, ...changes }, true);
    clearTimeout(this.timers.get(id));
    this.timers.set(
      id,
      setTimeout(() => void this.flush(id), this.delay_ms),
    );
  }

  async flush(id: number): Promise<void> {
    clearTimeout(this.timers.get(id));
    this.timers.delete(id);
    this.outbox.send(keyOf(id));
    await this.outbox.settled(keyOf(id));
  }

  /** Ends a conflict with the operator's choice for each disputed field. */
  async settle(id: number, choice: ReadonlyMap<Field, "mine" | "theirs">): Promise<void> {
    const draft = this.drafts.value.get(id);
    if (!draft?.theirs) return;
    const kept = Object.entries(draft.changes).filter(([field]) => choice.get(field as Field) !== "theirs");
    this.take(draft.theirs);
    if (kept.length === 0) return this.outbox.discard(keyOf(id));
    this.want(id, draft.theirs, Object.fromEntries(kept) as Changes, true);
    this.outbox.resolve(keyOf(id), "mine");
    await this.outbox.settled(keyOf(id));
  }

  private want(id: number, base: Vehicle, changes: Changes, held: boolean): void {
    this.outbox.want<Vehicle, Changes, { id: number }>(
      {
        key: keyOf(id),
        kind: VEHICLE,
        lane: `vehicle.${id}`,
        about: { id },
        what: say("measure-facts-of", { vehicle: String(base.number) }),
        mine: factWords(changes),
        page: `/surveys/${this.surveyId}/measure?vehicle=${id}`,
        saved: base,
        want: changes,
      },
      { held },
    );
  }

  private follow({ about, saved, state, problem, page }: Typed): void {
    if (state === "saved" && page.startsWith(`/surveys/${this.surveyId}/`)) this.told.stored?.(about.id);
    if (!saved || !this.get(about.id)) return;
    if (state !== "held") this.take(saved);
    if (state === "saving" && problem) this.told.merged?.(say("measure-merged", { problem }));
  }
}

function keyOf(id: number): string {
  return `vehicle.${id}`;
}

function draftOf({ about, saved, want, state, problem, theirs }: Typed): [number, Draft][] {
  if (!saved) return [];
  const shown = state === "held" ? "typing" : state === "conflict" || state === "failed" ? state : "saving";
  const disputed = theirs ? disputedFields(saved, want, theirs) : [];
  return [[about.id, { base: saved, changes: want, state: shown, problem, theirs, disputed }]];
}

function byRecordingAndNumber(a: Vehicle, b: Vehicle): number {
  return a.recording_id - b.recording_id || a.number - b.number;
}
