/** One line-scan recording on the bench: its view, its vehicles, the boundaries in hand, and every change with its undo. */
import { computed, signal } from "@preact/signals";
import { setQuery } from "../../core/address";
import { api } from "../../core/api";
import { History } from "../../core/history";
import { followJob } from "../../core/jobs";
import { may } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { Job, Scan, ScanMethod, ScanVehicle, ScanVehicleDetail } from "../../core/types";
import type { Mode } from "./bench";
import { type Crossings, EDGES, type Edge } from "./draw";
import { LineHeights } from "./heights";
import { RodDraft } from "./rod";
import { Tiles } from "./tiles";
import { fitAll, revealLines, showLines, type View } from "./view";

export type Facts = Partial<
  Pick<ScanVehicle, "make" | "model" | "category" | "true_length_m" | "true_wheelbase_m">
>;

export class ScanModel {
  readonly scan = signal<Scan | null>(null);
  readonly vehicles = signal<readonly ScanVehicle[]>([]);
  readonly chosenId = signal<number | null>(null);
  readonly detail = signal<ScanVehicleDetail | null>(null);
  readonly problem = signal<unknown>(null);
  readonly view = signal<View | null>(null);
  readonly edge = signal<Edge | null>(null);
  /** Boundaries in hand, not stored yet. */
  readonly draft = signal<Crossings | null>(null);
  readonly mode = signal<Mode>("look");
  /** First of two clicks: a wheel's hub, or the front of a new vehicle. */
  readonly firstClick = signal<number | null>(null);
  readonly busy = signal(false);
  /** A reason is being written. */
  readonly rejecting = signal(false);
  readonly job = signal<Job | null>(null);
  readonly history = new History();
  readonly heights = new LineHeights(this);
  readonly rod = new RodDraft(this, this.heights);
  readonly tiles: Tiles;

  readonly chosen = computed(() => this.vehicles.value.find((one) => one.id === this.chosenId.value) ?? null);
  readonly crossings = computed<Crossings | null>(() => {
    const measured = this.chosen.value?.measurement;
    return this.draft.value ?? (measured ? crossingsOf(measured) : null);
  });
  /** The hub lines of the chosen vehicle, the first click among them. */
  readonly wheels = computed<readonly (number | null)[]>(() => {
    if (this.firstClick.value !== null) return [this.firstClick.value];
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
      const scan = await api.get<Scan>(`/scans/${this.id}`);
      this.scan.value = scan;
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

  /** The window of one strip has this size now. */
  measured(width: number, height: number, resize: (view: View) => View): void {
    const scan = this.scan.value;
    if (!scan?.lines || !scan.rows_px) return;
    const old = this.view.value;
    this.view.value = old ? resize(old) : fitAll({ lines: scan.lines, rows: scan.rows_px }, width, height);
    if (!old) this.show("fit");
  }

  choose(id: number | null): void {
    this.flush();
    this.heights.end();
    this.mode.value = "look";
    this.firstClick.value = null;
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
    if (!view || !lines) return;
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
    await this.tell(async () => {
      await this.putBoundaries(vehicle.id, draft);
      this.pushUndo(
        `boundaries of vehicle ${vehicle.number}`,
        () => this.putBoundaries(vehicle.id, crossingsOf(before)),
        () => this.putBoundaries(vehicle.id, draft),
      );
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
    this.firstClick.value = null;
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

  /** A click on strip 1 while something is asked for. */
  async click(line: number, row: number): Promise<void> {
    if (this.mode.value === "rod") return this.rod.click({ line, row });
    if (this.mode.value === "height") return this.heights.click({ line, row });
    const first = this.firstClick.value;
    if (first === null) {
      this.firstClick.value = line;
      return;
    }
    const mode = this.mode.value;
    this.mode.value = "look";
    this.firstClick.value = null;
    const [low, high] = first < line ? [first, line] : [line, first];
    if (mode === "wheels") await this.storeWheels(low, high);
    else if (mode === "new") await this.addVehicle(low, high);
  }

  async storeWheels(front: number | null, rear: number | null): Promise<void> {
    const vehicle = this.chosen.value;
    const before = vehicle?.measurement;
    if (!vehicle || !before) return;
    await this.tell(async () => {
      await this.putWheels(vehicle.id, front, rear);
      this.pushUndo(
        `wheels of vehicle ${vehicle.number}`,
        () => this.putWheels(vehicle.id, before.front_wheel_line, before.rear_wheel_line),
        () => this.putWheels(vehicle.id, front, rear),
      );
    });
  }

  async fillIn(facts: Facts & { catalogue_id?: number }): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle) return;
    await this.tell(async () => {
      const { make, model, category, true_length_m, true_wheelbase_m } = vehicle;
      await this.putFacts(vehicle.id, facts);
      this.pushUndo(
        `what is known of vehicle ${vehicle.number}`,
        () => this.putFacts(vehicle.id, { make, model, category, true_length_m, true_wheelbase_m }),
        () => this.putFacts(vehicle.id, facts),
      );
    });
  }

  async remove(): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle || !may("operator")) return;
    await this.tell(async () => {
      const gone = async () => {
        const version = this.versionOf(vehicle.id) ?? vehicle.version;
        await api.del(`/scan-vehicles/${vehicle.id}?version=${version}`);
        if (this.chosenId.value === vehicle.id) this.choose(null);
        await this.readVehicles();
      };
      await gone();
      this.pushUndo(`taking out vehicle ${vehicle.number}`, () => this.restore(vehicle.id), gone);
      toast(`Vehicle ${vehicle.number} was taken out; Ctrl Z brings it back.`);
    });
  }

  async review(verdict: "accepted" | "rejected" | "reopened", reason?: string): Promise<void> {
    const measured = this.chosen.value?.measurement;
    if (!measured || measured.mine || !may("reviewer")) return;
    await this.tell(async () => {
      await api.post(`/scan-measurements/${measured.id}/review`, { verdict, ...(reason ? { reason } : {}) });
      await this.refresh();
    });
  }

  /** Looks for vehicles, or (without `search`) measures those that are known again. */
  async find(method: ScanMethod, search: boolean): Promise<void> {
    await this.tell(async () =>
      this.follow(await api.post<Job>(`/scans/${this.id}/find`, { method, search })),
    );
  }

  take(scan: Scan): void {
    this.scan.value = scan;
  }

  async refresh(): Promise<void> {
    await this.readVehicles();
    if (this.chosenId.value !== null) await this.readDetail(this.chosenId.value);
  }

  private async addVehicle(front: number, rear: number): Promise<void> {
    await this.tell(async () => {
      const made = await api.post<ScanVehicle>(`/scans/${this.id}/vehicles`, {
        front_line_1: front,
        rear_line_1: rear,
      });
      await this.readVehicles();
      this.choose(made.id);
      const gone = async () => {
        await api.del(`/scan-vehicles/${made.id}`);
        if (this.chosenId.value === made.id) this.choose(null);
        await this.readVehicles();
      };
      this.pushUndo(`vehicle ${made.number}`, gone, () => this.restore(made.id));
    });
  }

  private async restore(id: number): Promise<void> {
    await api.post(`/scan-vehicles/${id}/restore`);
    await this.readVehicles();
    this.choose(id);
  }

  private async putBoundaries(id: number, lines: Crossings): Promise<void> {
    await api.put(`/scan-vehicles/${id}/boundaries`, { ...lines, version: this.versionOf(id) });
    await this.refresh();
  }

  private async putWheels(id: number, front: number | null, rear: number | null): Promise<void> {
    const version = this.versionOf(id);
    await api.put(`/scan-vehicles/${id}/wheels`, { front_wheel_line: front, rear_wheel_line: rear, version });
    await this.refresh();
  }

  private async putFacts(id: number, facts: Facts & { catalogue_id?: number }): Promise<void> {
    await api.put(`/scan-vehicles/${id}/facts`, { ...facts, version: this.versionOf(id) });
    await this.refresh();
  }

  private versionOf(id: number): number | undefined {
    return this.vehicles.value.find((one) => one.id === id)?.version;
  }

  private async readVehicles(): Promise<void> {
    this.vehicles.value = await api.get<ScanVehicle[]>(`/scans/${this.id}/vehicles`);
  }

  private async readDetail(id: number): Promise<void> {
    try {
      const found = await api.get<ScanVehicleDetail>(`/scan-vehicles/${id}`, { signal: this.stop.signal });
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
      this.scan.value = await api.get<Scan>(`/scans/${this.id}`);
      if (this.scan.value.state === "ready") await Promise.all([this.refresh(), this.heights.load()]);
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

  pushUndo(label: string, undo: () => Promise<void>, redo: () => Promise<void>): void {
    this.history.push({ label, undo, redo });
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
