/** One line-scan recording on the bench: its view, its vehicles, the boundaries in hand, and every change with its undo. */
import { computed, signal } from "@preact/signals";
import { setQuery } from "../../core/address";
import { api } from "../../core/api";
import { type ChangeSet, History, type Ledger } from "../../core/history";
import { followJob } from "../../core/jobs";
import { may } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { Job, Scan, ScanMethod, ScanVehicle, ScanVehicleDetail } from "../../core/types";
import type { Tool } from "../../viewer/tool";
import type { Mode, Strips } from "./bench";
import { type Crossings, EDGES, type Edge } from "./draw";
import { LineHeights } from "./heights";
import { RodDraft } from "./rod";
import { StripStage } from "./stage";
import { Tiles } from "./tiles";
import { Boundaries, HeightTool, RodTool, TwoLines } from "./tools";
import { revealLines, type StripPoint, showLines } from "./view";

export type Facts = Partial<
  Pick<ScanVehicle, "make" | "model" | "category" | "true_length_m" | "true_wheelbase_m">
>;

export class ScanModel implements Strips {
  readonly scan = signal<Scan | null>(null);
  readonly vehicles = signal<readonly ScanVehicle[]>([]);
  readonly chosenId = signal<number | null>(null);
  readonly detail = signal<ScanVehicleDetail | null>(null);
  readonly problem = signal<unknown>(null);
  readonly stage: StripStage = new StripStage(
    () => [this.stage.keyboard, ...this.placingTools(), this.boundaryTool],
    () => this.show("fit"),
  );
  readonly view = this.stage.view;
  readonly edge = signal<Edge | null>(null);
  /** Boundaries in hand, not stored yet. */
  readonly draft = signal<Crossings | null>(null);
  readonly mode = signal<Mode>("look");
  readonly busy = signal(false);
  /** A reason is being written. */
  readonly rejecting = signal(false);
  readonly job = signal<Job | null>(null);
  readonly history = new History();
  readonly heights = new LineHeights(this);
  readonly rod = new RodDraft(this, this.heights);
  readonly twoLines: TwoLines = new TwoLines(this, (low, high) => void this.storeTwo(low, high));
  private readonly boundaryTool: Boundaries = new Boundaries(this, this.heights);
  private readonly heightTool: HeightTool = new HeightTool(this, this.heights);
  private readonly rodTool: RodTool = new RodTool(this, this.rod);
  readonly tiles: Tiles;

  readonly chosen = computed(() => this.vehicles.value.find((one) => one.id === this.chosenId.value) ?? null);
  readonly crossings = computed<Crossings | null>(() => {
    const measured = this.chosen.value?.measurement;
    return this.draft.value ?? (measured ? crossingsOf(measured) : null);
  });
  /** The hub lines of the chosen vehicle, the first click among them. */
  readonly wheels = computed<readonly (number | null)[]>(() => {
    if (this.twoLines.first.value !== null) return [this.twoLines.first.value];
    const measured = this.chosen.value?.measurement;
    return measured ? [measured.front_wheel_line, measured.rear_wheel_line] : [];
  });

  private readonly stop = new AbortController();
  private nudging: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly id: number) {
    this.tiles = new Tiles(
      ({ camera, level, index }) =>
        `/api/scans/${id}/tiles/${camera}/${level}/${index}?v=${this.scan.value?.tiles_version ?? ""}`,
    );
  }

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const scan = await api.ask("GET /scans/{scan_id}", { scan_id: this.id });
      this.take(scan);
      if (scan.state === "ready") await Promise.all([this.readVehicles(), this.heights.load()]);
      if (scan.job && (scan.job.state === "running" || scan.job.state === "queued"))
        void this.follow(scan.job);
      const asked = Number(new URLSearchParams(location.search).get("vehicle"));
      const first = this.vehicles.value.find((one) => one.id === asked);
      if (first) this.choose(first.id);
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    this.stop.abort();
    this.flush();
    this.tiles.close();
  }

  choose(id: number | null): void {
    this.flush();
    this.heights.end();
    this.mode.value = "look";
    this.twoLines.back();
    this.edge.value = null;
    this.rejecting.value = false;
    this.chosenId.value = id;
    this.detail.value = null;
    setQuery({ vehicle: id });
    if (id === null) return;
    void this.readDetail(id);
    this.show("reveal");
  }

  step(by: 1 | -1): void {
    const all = this.vehicles.value;
    const at = all.findIndex((one) => one.id === this.chosenId.value);
    const next = at < 0 ? (by === 1 ? all[0] : all.at(-1)) : all[at + by];
    if (next) this.choose(next.id);
    else toast(by === 1 ? "This is the last vehicle." : "This is the first vehicle.");
  }

  /** The chosen vehicle in sight: just so, or filling the window. */
  show(how: "reveal" | "fit"): void {
    const lines = this.crossings.value;
    const view = this.view.value;
    if (!lines) return;
    const first = Math.min(lines.front_line_1, lines.front_line_2);
    const last = Math.max(lines.rear_line_1, lines.rear_line_2);
    this.view.value = how === "fit" ? showLines(view, first, last) : revealLines(view, first, last);
  }

  selectNext(): void {
    const at = this.edge.value ? EDGES.indexOf(this.edge.value) : -1;
    // after the last boundary the points of the heights, then the first boundary again
    const last = this.heights.selected.value !== null || at === EDGES.length - 1 || !this.crossings.value;
    if (last && this.heights.selectNext()) this.edge.value = null;
    else if (this.crossings.value) this.edge.value = EDGES[(at + 1) % EDGES.length] ?? null;
  }

  moveEdge(edge: Edge, line: number): void {
    const now = this.crossings.value;
    const scan = this.scan.value;
    if (!now || !scan?.lines || !may("operator")) return;
    this.edge.value = edge;
    this.heights.selected.value = null;
    this.draft.value = { ...now, [edge]: Math.min(Math.max(line, 0), scan.lines - 1) };
  }

  /** By keyboard; stored once the keys rest. */
  nudge(by: number): boolean {
    const edge = this.edge.value;
    const now = this.crossings.value;
    if (!edge || !now) return false;
    this.moveEdge(edge, now[edge] + by);
    clearTimeout(this.nudging);
    this.nudging = setTimeout(() => void this.storeDraft(), 600);
    return true;
  }

  /** What is in hand is measured and stored as a revision. */
  async storeDraft(): Promise<void> {
    clearTimeout(this.nudging);
    this.nudging = undefined;
    const draft = this.draft.value;
    const vehicle = this.chosen.value;
    const before = vehicle?.measurement;
    if (!draft || !vehicle || !before) return;
    if (!sameCrossings(draft, before))
      await this.change(`boundaries of vehicle ${vehicle.number}`, async (changes) => {
        await changes.write(this.boundaries, vehicle.id, draft);
      });
    if (this.draft.value === draft) this.draft.value = null;
  }

  cancel(): boolean {
    clearTimeout(this.nudging);
    const placing = this.mode.value !== "look" || this.rejecting.value;
    const chosen = this.edge.value !== null || this.heights.selected.value !== null;
    const held = this.draft.value !== null || chosen || placing;
    this.rejecting.value = false;
    this.heights.end();
    this.draft.value = null;
    this.edge.value = null;
    this.mode.value = "look";
    this.twoLines.back();
    return held;
  }

  start(mode: Mode): void {
    if (!may("operator") || (mode === "wheels" && !this.chosen.value?.measurement)) return;
    const again = this.mode.value === mode;
    this.cancel();
    if (again) return;
    this.mode.value = mode;
    if (mode === "rod") this.rod.open();
  }

  /** The tools of what is taken up. */
  private placingTools(): Tool<StripPoint>[] {
    switch (this.mode.value) {
      case "rod":
        return [this.rodTool];
      case "height":
        return [this.heightTool];
      case "look":
        return [];
      default:
        return [this.twoLines];
    }
  }

  private async storeTwo(low: number, high: number): Promise<void> {
    const mode = this.mode.value;
    this.mode.value = "look";
    if (mode === "wheels") await this.storeWheels(low, high);
    else await this.addVehicle(low, high);
  }

  async storeWheels(front: number | null, rear: number | null): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle?.measurement) return;
    await this.change(`wheels of vehicle ${vehicle.number}`, async (changes) => {
      await changes.write(this.hubs, vehicle.id, [front, rear]);
    });
  }

  async fillIn(facts: Facts & { catalogue_id?: number }): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle) return;
    await this.tell(async () => {
      const { make, model, category, true_length_m, true_wheelbase_m } = vehicle;
      await this.putFacts(vehicle.id, facts);
      // an entry of the catalogue says more than these fields: done again, it is chosen again
      this.history.push({
        label: `what is known of vehicle ${vehicle.number}`,
        undo: () => this.putFacts(vehicle.id, { make, model, category, true_length_m, true_wheelbase_m }),
        redo: () => this.putFacts(vehicle.id, facts),
      });
    });
  }

  async remove(): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle || !may("operator")) return;
    await this.change(`taking out vehicle ${vehicle.number}`, async (changes) => {
      await changes.write(this.presence, vehicle.id, false);
      toast(`Vehicle ${vehicle.number} was taken out; Ctrl Z brings it back.`);
    });
  }

  async review(verdict: "accepted" | "rejected" | "reopened", reason?: string): Promise<void> {
    const measured = this.chosen.value?.measurement;
    if (!measured || measured.mine || !may("reviewer")) return;
    await this.tell(async () => {
      await api.write(
        "POST /scan-measurements/{measurement_id}/review",
        { measurement_id: measured.id },
        { body: { verdict, ...(reason ? { reason } : {}) } },
      );
      await this.refresh();
    });
  }

  /** Looks for vehicles, or (without `search`) measures those that are known again. */
  async find(method: ScanMethod, search: boolean): Promise<void> {
    await this.tell(async () =>
      this.follow(
        await api.write("POST /scans/{scan_id}/find", { scan_id: this.id }, { body: { method, search } }),
      ),
    );
  }

  take(scan: Scan): void {
    this.scan.value = scan;
    if (scan.lines && scan.rows_px) this.stage.setStrips({ lines: scan.lines, rows: scan.rows_px });
  }

  async refresh(): Promise<void> {
    await this.readVehicles();
    if (this.chosenId.value !== null) await this.readDetail(this.chosenId.value);
  }

  private async addVehicle(front: number, rear: number): Promise<void> {
    await this.tell(async () => {
      const lines = { front_line_1: front, rear_line_1: rear };
      const made = await api.write("POST /scans/{scan_id}/vehicles", { scan_id: this.id }, { body: lines });
      await this.history.run(`vehicle ${made.number}`, async (changes) => {
        changes.touch(this.presence, made.id);
        await this.readVehicles();
        this.choose(made.id);
      });
    });
  }

  /** Whether a vehicle is in the list. */
  private readonly presence: Ledger<number, boolean> = {
    read: (id) => this.vehicles.value.some((one) => one.id === id),
    write: (id, there) => (there ? this.restore(id) : this.takeOut(id)),
  };

  private readonly boundaries: Ledger<number, Crossings | null> = {
    read: (id) => {
      const measured = this.measurementOf(id);
      return measured ? crossingsOf(measured) : null;
    },
    write: (id, lines) => (lines ? this.putBoundaries(id, lines) : undefined),
  };

  private readonly hubs: Ledger<number, readonly [number | null, number | null]> = {
    read: (id) => {
      const measured = this.measurementOf(id);
      return [measured?.front_wheel_line ?? null, measured?.rear_wheel_line ?? null];
    },
    write: (id, [front, rear]) => this.putWheels(id, front, rear),
  };

  private measurementOf(id: number): ScanVehicle["measurement"] {
    return this.vehicles.value.find((one) => one.id === id)?.measurement ?? null;
  }

  private async takeOut(id: number): Promise<void> {
    const version = this.versionOf(id) || undefined;
    await api.write("DELETE /scan-vehicles/{vehicle_id}", { vehicle_id: id, version });
    if (this.chosenId.value === id) this.choose(null);
    await this.readVehicles();
  }

  private async restore(id: number): Promise<void> {
    await api.write("POST /scan-vehicles/{vehicle_id}/restore", { vehicle_id: id });
    await this.readVehicles();
    this.choose(id);
  }

  private async putBoundaries(id: number, lines: Crossings): Promise<void> {
    await api.write(
      "PUT /scan-vehicles/{vehicle_id}/boundaries",
      { vehicle_id: id },
      { body: { ...lines, version: this.versionOf(id) } },
    );
    await this.refresh();
  }

  private async putWheels(id: number, front: number | null, rear: number | null): Promise<void> {
    const version = this.versionOf(id);
    await api.write(
      "PUT /scan-vehicles/{vehicle_id}/wheels",
      { vehicle_id: id },
      { body: { front_wheel_line: front, rear_wheel_line: rear, version } },
    );
    await this.refresh();
  }

  private async putFacts(id: number, facts: Facts & { catalogue_id?: number }): Promise<void> {
    await api.write(
      "PUT /scan-vehicles/{vehicle_id}/facts",
      { vehicle_id: id },
      { body: { ...facts, version: this.versionOf(id) } },
    );
    await this.refresh();
  }

  private versionOf(id: number): number {
    return this.vehicles.value.find((one) => one.id === id)?.version ?? 0;
  }

  private async readVehicles(): Promise<void> {
    this.vehicles.value = await api.ask("GET /scans/{scan_id}/vehicles", { scan_id: this.id });
  }

  private async readDetail(id: number): Promise<void> {
    try {
      const found = await api.ask(
        "GET /scan-vehicles/{vehicle_id}",
        { vehicle_id: id },
        { signal: this.stop.signal },
      );
      if (this.chosenId.value === id) this.detail.value = found;
    } catch (error) {
      if (!this.stop.signal.aborted) toastProblem(error);
    }
  }

  private async follow(job: Job): Promise<void> {
    this.job.value = job;
    try {
      const over = await followJob(
        job.id,
        (now) => {
          this.job.value = now;
        },
        this.stop.signal,
      );
      this.job.value = null;
      if (over.state === "failed") toastProblem(new Error(over.error ?? "The search stopped."));
      const scan = await api.ask("GET /scans/{scan_id}", { scan_id: this.id });
      this.take(scan);
      if (scan.state === "ready") await Promise.all([this.refresh(), this.heights.load()]);
    } catch (error) {
      this.job.value = null;
      if (!this.stop.signal.aborted) toastProblem(error);
    }
  }

  /** Boundaries in hand are stored before something else is taken up. */
  private flush(): void {
    if (this.nudging !== undefined) void this.storeDraft();
    else this.draft.value = null;
  }

  change(label: string, work: (changes: ChangeSet) => Promise<void>): Promise<void> {
    return this.tell(() => this.history.run(label, work));
  }

  /** One change after the other, after an undo that is under way; what goes wrong is told in words. */
  async tell(work: () => Promise<void>): Promise<void> {
    this.busy.value = true;
    try {
      await this.history.inTurn(work);
    } catch (error) {
      toastProblem(error);
      await this.refresh().catch(() => undefined);
    } finally {
      this.busy.value = false;
    }
  }
}

function crossingsOf(one: Crossings): Crossings {
  const { front_line_1, rear_line_1, front_line_2, rear_line_2 } = one;
  return { front_line_1, rear_line_1, front_line_2, rear_line_2 };
}

function sameCrossings(a: Crossings, b: Crossings): boolean {
  return EDGES.every((edge) => a[edge] === b[edge]);
}
