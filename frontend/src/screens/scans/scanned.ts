/** The vehicles of a line scan: as the server has them, as they are wanted, and what of them can be put back. */
import { computed, signal } from "@preact/signals";
import { api } from "../../core/api";
import type { Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox, type Wish } from "../../core/outbox";
import { me } from "../../core/session";
import type { ScanVehicle } from "../../core/types";
import type { Crossings } from "../../parts/strips/draw";
import { ownReview, verdictLedger } from "../../parts/verdicts/given";
import { type Review, verdictWords } from "../../parts/verdicts/kind";
import type { Bench } from "./bench";
import { crossingsOf, type MotionVerdict, SCAN_VERDICT, SCANNED, standing, type VerdictAbout } from "./kinds";
import { type Facts, type ScannedWanted, scannedWords } from "./wanted";

type ScannedAbout = { id: number; scanId: number };
export type ScannedWish = Wish<ScanVehicle, ScannedWanted, ScannedAbout>;

export type Part = "hubs" | "axles" | "lane";

export class ScannedVehicles {
  private readonly stored = signal<readonly ScanVehicle[]>([]);
  /** As they are wanted: what the outbox keeps stands in them. */
  readonly all = computed<readonly ScanVehicle[]>(() => withWishes(this.stored.value, this.wishes()));
  /** Every vehicle as the server had it last, those taken out too. */
  private readonly seen = new Map<number, ScanVehicle>();

  constructor(private readonly bench: Pick<Bench, "id" | "page"> & { refresh(): Promise<void> }) {}

  of(id: number | null): ScanVehicle | null {
    return this.all.value.find((one) => one.id === id) ?? null;
  }

  numberOf(id: number): number {
    return this.seen.get(id)?.number ?? 0;
  }

  async load(): Promise<void> {
    const found = await api.ask("GET /scans/{scan_id}/vehicles", { scan_id: this.bench.id });
    this.note(found);
    this.stored.value = found;
  }

  readonly boundaries: Ledger<number, Crossings | null> = {
    read: (id) => {
      const measured = this.measurementOf(id);
      return measured ? crossingsOf(measured) : null;
    },
    write: (id, lines) => (lines ? this.want(id, { boundaries: lines }) : undefined),
  };

  readonly facts: Ledger<{ id: number; names: readonly (keyof Facts)[] }, Facts> = {
    nameOf: ({ id, names }) => `${id}:${names}`,
    read: ({ id, names }) => {
      const vehicle = this.of(id);
      return Object.fromEntries(names.map((name) => [name, vehicle?.[name] ?? null]));
    },
    write: ({ id }, facts) => this.want(id, { facts }),
  };

  readonly parts: { readonly [P in Part]: Ledger<number, ScannedWanted[P] | null> } = {
    hubs: this.part("hubs"),
    axles: this.part("axles"),
    lane: this.part("lane"),
  };

  /** A part of what a person says of a vehicle; null: as the program finds it. */
  private part<P extends Part>(part: P): Ledger<number, ScannedWanted[P] | null> {
    return {
      read: (id) => standing(this.of(id))[part] ?? null,
      write: (id, said) => this.want(id, { [part]: said } as ScannedWanted),
    };
  }

  readonly verdicts = verdictLedger<MotionVerdict>({
    stands: (id) => {
      const measured = this.measurementOf(id);
      if (!measured) return null;
      const kept = outbox.get<ScanVehicle, MotionVerdict, unknown>(verdictKey(measured.id))?.want;
      return { of: measured.id, review: kept ? ownReview(kept) : measured.review };
    },
    give: (id, want) => this.giveVerdict(id, want),
    overtaken: async (id) => {
      const measured = this.measurementOf(id);
      if (measured) outbox.discard(verdictKey(measured.id));
      await this.bench.refresh();
    },
  });

  private async giveVerdict(id: number, want: MotionVerdict): Promise<Review | null> {
    const vehicle = this.of(id);
    const measured = vehicle?.measurement;
    if (!measured) return null;
    const stored = await outbox.store<ScanVehicle, MotionVerdict, VerdictAbout>({
      key: verdictKey(measured.id),
      kind: SCAN_VERDICT,
      lane: `scan.${this.bench.id}`,
      about: { id, measurementId: measured.id, by: me.value?.person.id ?? 0 },
      what: say("scan-wish-verdict", { vehicle: String(vehicle.number) }),
      mine: verdictWords(want),
      page: this.bench.page(id),
      saved: vehicle,
      want,
    });
    if (stored) await this.bench.refresh();
    return stored?.saved?.measurement?.review ?? ownReview(want);
  }

  private measurementOf(id: number): ScanVehicle["measurement"] {
    return this.of(id)?.measurement ?? null;
  }

  /** What a vehicle is to become. Resolves when it is stored, or kept where there is no connection. */
  async want(id: number, change: ScannedWanted): Promise<void> {
    const key = `scanned.${id}`;
    const before = outbox.get<ScanVehicle, ScannedWanted, unknown>(key)?.want;
    const facts = change.facts && { ...before?.facts, ...change.facts };
    const want = { ...before, ...change, ...(facts ? { facts } : {}) };
    const stored = await outbox.store<ScanVehicle, ScannedWanted, ScannedAbout>({
      key,
      kind: SCANNED,
      lane: `scan.${this.bench.id}`,
      about: { id, scanId: this.bench.id },
      what: say("scan-step-vehicle", { vehicle: String(this.numberOf(id)) }),
      mine: scannedWords(want),
      page: this.bench.page(id),
      saved: this.seen.get(id) ?? null,
      want,
    });
    if (stored) await this.bench.refresh();
  }

  private wishes(): ScannedWish[] {
    return outbox
      .of<ScanVehicle, ScannedWanted, ScannedAbout>(SCANNED)
      .filter((wish) => wish.about.scanId === this.bench.id);
  }

  /** What the outbox has brought to the server, at once in the list; whether it has brought anything. */
  follow({ saved }: Pick<ScannedWish, "saved">): boolean {
    if (!saved) return false;
    this.note([saved]);
    const others = this.stored.value.filter((one) => one.id !== saved.id);
    const before = this.stored.value.find((one) => one.id === saved.id);
    const at = before ? this.stored.value.indexOf(before) : others.length;
    this.stored.value = saved.deleted ? others : others.toSpliced(at, 0, { ...before, ...saved });
    return true;
  }

  private note(vehicles: readonly ScanVehicle[]): void {
    for (const one of vehicles)
      if (one.version >= (this.seen.get(one.id)?.version ?? 0)) this.seen.set(one.id, one);
  }
}

function withWishes(stored: readonly ScanVehicle[], wishes: readonly ScannedWish[]): readonly ScanVehicle[] {
  const all = new Map(stored.map((one) => [one.id, one]));
  for (const { about, saved, want } of wishes) {
    const now = all.get(about.id) ?? (want.there ? saved : null);
    if (want.there === false) all.delete(about.id);
    else if (now) all.set(about.id, withWish(now, want));
  }
  return [...all.values()];
}

function withWish(
  vehicle: ScanVehicle,
  { boundaries, hubs, axles, lane, facts }: ScannedWanted,
): ScanVehicle {
  const lines = hubs ? { front_wheel_line: hubs[0], rear_wheel_line: hubs[1] } : {};
  const counted = axles ? { axle_lines: [...axles], axles_by: "person" as const } : {};
  const where = lane ? { lane, lane_by: "person" as const } : lane === null ? { lane_by: null } : {};
  const measurement = vehicle.measurement && {
    ...vehicle.measurement,
    ...boundaries,
    ...lines,
    ...counted,
    ...where,
  };
  return { ...vehicle, ...facts, measurement };
}

function verdictKey(measurementId: number): string {
  return `scan-verdict.${measurementId}`;
}
