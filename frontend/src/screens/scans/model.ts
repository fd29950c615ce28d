/** One line-scan recording on the bench: its view, its vehicles, the boundaries in hand, and every change with its undo. */
import { computed, signal } from "@preact/signals";
import { asked, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { type ChangeSet, History, type Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox, type Wish } from "../../core/outbox";
import { may } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { Scan, ScanVehicle, ScanVehicleDetail } from "../../core/types";
import { EDGES } from "../../parts/strips/draw";
import { StripStage } from "../../parts/strips/stage";
import { Tiles, tileAddress } from "../../parts/strips/tiles";
import { revealLines, type StripPoint, type StripsView, showLines } from "../../parts/strips/view";
import { beside } from "../../parts/worklist";
import type { Tool } from "../../viewer/tool";
import type { Mode, Strips } from "./bench";
import { VehicleEdits } from "./edits";
import { LineHeights } from "./heights";
import { HeldBoundaries } from "./held";
import { Judging } from "./judging";
import { ADDED, ROD, SCAN_VERDICT, SCANNED } from "./kinds";
import { type RigChange, type RigName, rigValues } from "./rig";
import { RodDraft } from "./rod";
import { ScannedVehicles, type ScannedWish } from "./scanned";
import { Search } from "./search";
import { AxlesTool, Boundaries, HeightTool, RodTool, TwoLines } from "./tools";

export class ScanModel implements Strips {
  readonly scan = signal<Scan | null>(null);
  private readonly stop = new AbortController();
  readonly scanned = new ScannedVehicles(this);
  readonly vehicles = this.scanned.all;
  readonly chosenId = signal<number | null>(null);
  readonly detail = signal<ScanVehicleDetail | null>(null);
  readonly problem = signal<unknown>(null);
  readonly stage: StripStage = new StripStage(
    () => [this.judging.rejection, this.stage.keyboard, ...this.placingTools(), this.boundaryTool],
    () => this.show("fit"),
    (before) => this.keepInSight(before),
  );
  readonly view = this.stage.view;
  readonly mode = signal<Mode>("look");
  readonly busy = signal(false);
  /** Undo goes to the vehicle that it changes. */
  readonly history: History = new History(() => {
    const id = this.chosenId.peek();
    return () => {
      if (id !== this.chosenId.value && this.vehicles.value.some((one) => one.id === id)) this.choose(id);
    };
  });
  readonly heights = new LineHeights(this);
  readonly judging = new Judging(this, this.scanned);
  readonly boundaries: HeldBoundaries = new HeldBoundaries(this, this.scanned.boundaries, () => {
    this.heights.selected.value = null;
  });
  readonly edits = new VehicleEdits(this, this.scanned);
  readonly search = new Search(this, () => this.readScan(), this.stop.signal);
  readonly rod = new RodDraft(this, this.heights);
  private readonly axlesTool: AxlesTool = new AxlesTool(
    this,
    () => this.axlesOfChosen.value,
    (lines) => void this.edits.store("axles", lines),
  );
  readonly twoLines: TwoLines = new TwoLines(this, (low, high) => void this.storeTwo(low, high));
  private readonly boundaryTool: Boundaries = new Boundaries(this, this.heights);
  private readonly heightTool: HeightTool = new HeightTool(this, this.heights);
  private readonly rodTool: RodTool = new RodTool(this, this.rod);
  readonly tiles: Tiles;

  readonly chosen = computed(() => this.scanned.of(this.chosenId.value));
  /** The hub lines of the chosen vehicle, the first click among them. */
  readonly wheels = computed<readonly (number | null)[]>(() => {
    if (this.twoLines.first.value !== null) return [this.twoLines.first.value];
    const measured = this.chosen.value?.measurement;
    return measured ? [measured.front_wheel_line, measured.rear_wheel_line] : [];
  });
  readonly axlesOfChosen = computed<readonly number[]>(
    () => this.chosen.value?.measurement?.axle_lines ?? [],
  );

  private readonly deaf = [
    outbox.listen(SCANNED, (wish: ScannedWish) => {
      const noted = wish.about.scanId === this.id && this.scanned.follow(wish);
      if (noted && wish.state === "saved" && !this.busy.value) void this.reread();
    }),
    // another's verdict that was taken in a conflict
    outbox.listen(SCAN_VERDICT, ({ state, lane, theirs }: Wish<ScanVehicle>) => {
      if (state === "dropped" && theirs && lane === this.lane) this.scanned.follow({ saved: theirs });
    }),
    // what an earlier page left, or what was kept without a connection, has come through
    ...[ADDED, SCAN_VERDICT, ROD].map((kind) =>
      outbox.listen(kind, ({ state, lane }) => {
        if (state === "saved" && lane === this.lane && !this.busy.value) void this.reread();
      }),
    ),
  ];
  constructor(readonly id: number) {
    this.tiles = new Tiles((key) => (this.scan.value ? tileAddress(this.scan.value, key) : ""));
  }

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      await this.readScan();
      const job = this.scan.value?.job;
      if (job?.state === "running" || job?.state === "queued") void this.search.follow(job);
      const wanted = asked("vehicle");
      const first =
        wanted === null ? this.firstToSee() : this.vehicles.value.find((one) => one.id === wanted);
      // the strips may have had their size before there was a vehicle to show in them, or get it later (`arrived`)
      if (first) {
        this.choose(first.id);
        this.show("fit");
      } else if (wanted !== null) toast(say("address-elsewhere", { what: "vehicle" }), { kind: "problem" });
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    this.stop.abort();
    this.boundaries.flush();
    for (const stop of [...this.deaf, this.heights.kept.close]) stop();
    this.tiles.close();
  }

  choose(id: number | null): void {
    this.boundaries.flush();
    this.heights.end();
    this.mode.value = "look";
    this.twoLines.back();
    this.boundaries.edge.value = null;
    this.judging.rejection.cancel();
    this.chosenId.value = id;
    this.detail.value = null;
    setQuery({ vehicle: id });
    if (id === null) return;
    void this.readDetail(id);
    this.show("reveal");
  }

  /** Work begins with the first vehicle that is to be judged, else the first: one that can be made out. */
  private firstToSee(): ScanVehicle | undefined {
    return this.judging.next(null) ?? this.vehicles.value[0];
  }

  step(by: 1 | -1): void {
    const next = beside(this.vehicles.value, this.chosen.value?.id ?? null, by);
    if (next) this.choose(next.id);
    else toast(say(by === 1 ? "scan-last-vehicle" : "scan-first-vehicle"));
  }

  /** The lines of the chosen vehicle, on both strips. */
  private get span(): readonly [first: number, last: number] | null {
    const lines = this.boundaries.crossings.value;
    if (!lines) return null;
    const { front_line_1, front_line_2, rear_line_1, rear_line_2 } = lines;
    return [Math.min(front_line_1, front_line_2), Math.max(rear_line_1, rear_line_2)];
  }

  /** The chosen vehicle in sight: just so, or filling the window. */
  show(how: "reveal" | "fit"): void {
    const look = how === "fit" ? showLines : revealLines;
    if (this.span) this.view.value = look(this.view.value, ...this.span);
  }

  /** In a window of another size it is seen as before; one that was left is not gone back to. */
  private keepInSight(before: StripsView): void {
    if (this.span && revealLines(before, ...this.span) === before) this.show("reveal");
  }

  selectNext(): void {
    const { edge, crossings } = this.boundaries;
    const at = edge.value ? EDGES.indexOf(edge.value) : -1;
    // after the last boundary the points of the heights, then the first boundary again
    const last = this.heights.selected.value !== null || at === EDGES.length - 1 || !crossings.value;
    if (last && this.heights.selectNext()) edge.value = null;
    else if (crossings.value) edge.value = EDGES[(at + 1) % EDGES.length] ?? null;
  }

  cancel(): boolean {
    const placing = this.mode.value !== "look" || this.judging.rejection.begun.value;
    const chosen = this.heights.selected.value !== null;
    this.judging.rejection.cancel();
    this.heights.end();
    const held = this.boundaries.drop() || chosen || placing;
    this.mode.value = "look";
    this.twoLines.back();
    return held;
  }

  start(mode: Mode): void {
    const ofVehicle = mode === "wheels" || mode === "axles";
    if (!may("operator") || (ofVehicle && !this.chosen.value?.measurement)) return;
    const again = this.mode.value === mode;
    this.cancel();
    if (again) return;
    this.mode.value = mode;
    if (mode === "rod") this.rod.open();
  }

  private placingTools(): Tool<StripPoint>[] {
    switch (this.mode.value) {
      case "rod":
        return [this.rodTool];
      case "height":
        return [this.heightTool];
      case "axles":
        return [this.axlesTool];
      case "look":
        return [];
      default:
        return [this.twoLines];
    }
  }

  private async storeTwo(low: number, high: number): Promise<void> {
    const mode = this.mode.value;
    this.mode.value = "look";
    if (mode === "wheels") await this.edits.store("hubs", [low, high]);
    else await this.edits.addVehicle(low, high);
  }

  private async readScan(): Promise<void> {
    const scan = await api.ask("GET /scans/{scan_id}", { scan_id: this.id });
    this.take(scan);
    if (scan.state === "ready") await Promise.all([this.refresh(), this.heights.kept.load()]);
  }

  take(scan: Scan): void {
    this.scan.value = scan;
    if (scan.lines && scan.rows_px) this.stage.setStrips({ lines: scan.lines, rows: scan.rows_px });
  }

  async refresh(): Promise<void> {
    await this.scanned.load();
    if (this.chosenId.value !== null) await this.readDetail(this.chosenId.value);
  }

  readonly rig: Ledger<readonly RigName[], RigChange> = {
    nameOf: (names) => names.join(),
    read: (names) => (this.scan.value ? rigValues(this.scan.value, names) : {}),
    write: async (_names, values) => {
      const { version } = await api.ask("GET /scans/{scan_id}", { scan_id: this.id });
      const body = { ...values, version };
      this.take(await api.write("PATCH /scans/{scan_id}", { scan_id: this.id }, { body }));
      await this.refresh();
    },
  };

  private async reread(): Promise<void> {
    await Promise.all([this.refresh(), this.heights.kept.load()]).catch(toastProblem);
  }

  numberOf(id: number): number {
    return this.scanned.numberOf(id);
  }

  page(vehicleId?: number): string {
    const survey = this.scan.value?.survey_id ?? 0;
    return `/surveys/${survey}/scan?scan=${this.id}${vehicleId ? `&vehicle=${vehicleId}` : ""}`;
  }

  private get lane(): string {
    return `scan.${this.id}`;
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

  /** Kept at once: the outbox sends one change after the other. */
  change(label: string, work: (changes: ChangeSet) => Promise<void> | void): Promise<void> {
    return this.told(() => this.history.run(label, work));
  }

  /** One change after the other, after an undo that is under way; what goes wrong is told in words. */
  tell(work: () => Promise<void> | void): Promise<void> {
    return this.told(() => this.history.inTurn(work));
  }

  private async told(work: () => Promise<void> | void): Promise<void> {
    this.busy.value = true;
    try {
      await work();
    } catch (error) {
      toastProblem(error);
      await this.refresh().catch(() => undefined);
    } finally {
      this.busy.value = false;
    }
  }
}
