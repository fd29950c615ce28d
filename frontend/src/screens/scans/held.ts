/** The boundaries of the chosen vehicle: dragged or nudged in hand, measured and stored as a revision once they rest. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { ChangeSet, Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { sameValue } from "../../core/same";
import { may } from "../../core/session";
import type { Scan, ScanVehicle } from "../../core/types";
import type { Crossings, Edge } from "../../parts/strips/draw";
import { crossingsOf } from "./kinds";

const RESTS_MS = 600;

interface Table {
  readonly scan: ReadonlySignal<Scan | null>;
  readonly chosen: ReadonlySignal<ScanVehicle | null>;
  change(label: string, work: (changes: ChangeSet) => Promise<void> | void): Promise<void>;
}

export class HeldBoundaries {
  readonly edge = signal<Edge | null>(null);
  readonly draft = signal<Crossings | null>(null);
  readonly crossings = computed<Crossings | null>(() => {
    const measured = this.bench.chosen.value?.measurement;
    return this.draft.value ?? (measured ? crossingsOf(measured) : null);
  });
  private nudging: ReturnType<typeof setTimeout> | undefined;

  /** `taken`: a boundary was taken up, so that no other point is. */
  constructor(
    private readonly bench: Table,
    private readonly stored: Ledger<number, Crossings | null>,
    private readonly taken: () => void,
  ) {}

  move(edge: Edge, line: number): void {
    const now = this.crossings.value;
    const scan = this.bench.scan.value;
    if (!now || !scan?.lines || !may("operator")) return;
    this.edge.value = edge;
    this.taken();
    this.draft.value = { ...now, [edge]: Math.min(Math.max(line, 0), scan.lines - 1) };
  }

  /** By keyboard; stored once the keys rest. */
  nudge(by: number): boolean {
    const edge = this.edge.value;
    const now = this.crossings.value;
    if (!edge || !now) return false;
    this.move(edge, now[edge] + by);
    clearTimeout(this.nudging);
    this.nudging = setTimeout(() => void this.store(), RESTS_MS);
    return true;
  }

  /** What is in hand is measured and stored as a revision. */
  async store(): Promise<void> {
    clearTimeout(this.nudging);
    this.nudging = undefined;
    const draft = this.draft.value;
    const vehicle = this.bench.chosen.value;
    const before = vehicle?.measurement;
    if (!draft || !vehicle || !before) return;
    if (!sameValue(draft, crossingsOf(before)))
      await this.bench.change(say("scan-step-boundaries", { vehicle: String(vehicle.number) }), (changes) =>
        changes.write(this.stored, vehicle.id, draft),
      );
    if (this.draft.value === draft) this.draft.value = null;
  }

  /** Boundaries in hand are stored before something else is taken up. */
  flush(): void {
    if (this.nudging !== undefined) void this.store();
    else this.draft.value = null;
  }

  drop(): boolean {
    clearTimeout(this.nudging);
    const held = this.draft.value !== null || this.edge.value !== null;
    this.draft.value = null;
    this.edge.value = null;
    return held;
  }
}
