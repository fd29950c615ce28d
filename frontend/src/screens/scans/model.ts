/** One line-scan recording on the bench: its view, its vehicles, the boundaries in hand, and every change with its undo. */
import { computed, signal } from "@preact/signals";
import { asked, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { type ChangeSet, History, type Ledger } from "../../core/history";
import { followJob, jobProblem } from "../../core/jobs";
import { say } from "../../core/messages";
import { outbox, type Wish } from "../../core/outbox";
import { newKey } from "../../core/random";
import { may, me } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { Job, LineHeight, Scan, ScanMethod, ScanVehicle, ScanVehicleDetail } from "../../core/types";
import { fixed } from "../../core/units";
import type { Tool } from "../../viewer/tool";
import type { Mode, Strips } from "./bench";
import { LineHeights, mayBeJudged } from "./heights";
import {
  ADDED,
  type Axles,
  type Crossings,
  crossingsOf,
  EDGES,
  type Edge,
  type Facts,
  HEIGHT_VERDICT,
  type Hubs,
  laneByPerson,
  ROD,
  SCAN_VERDICT,
  SCANNED,
  type ScannedWanted,
  scannedWords,
  type Verdict,
  verdictWords,
} from "./kinds";
import { type RigChange, type RigName, rigValues } from "./rig";
import { RodDraft } from "./rod";
import { StripStage } from "./stage";
import { Tiles } from "./tiles";
import { AxlesTool, Boundaries, HeightTool, RodTool, TwoLines } from "./tools";
import { verdictLedger } from "./verdicts";
import { revealLines, type StripPoint, showLines } from "./view";

type ScannedWish = Wish<ScanVehicle, ScannedWanted, { id: number; scanId: number }>;

export class ScanModel implements Strips {
  readonly scan = signal<Scan | null>(null);
  private readonly stored = signal<readonly ScanVehicle[]>([]);
  /** The vehicles as they are wanted: what the outbox keeps stands in them. */
  readonly vehicles = computed<readonly ScanVehicle[]>(() => withWishes(this.stored.value, this.wishes()));
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
  /** What a reason is being written for: the motion, or a height by its number. */
  readonly rejecting = signal<"motion" | number | null>(null);
  readonly job = signal<Job | null>(null);
  /** Undo goes to the vehicle that it changes. */
  readonly history: History = new History(() => {
    const id = this.chosenId.peek();
    return () => {
      if (id !== this.chosenId.value && this.vehicles.value.some((one) => one.id === id)) this.choose(id);
    };
  });
  readonly heights = new LineHeights(this);
  readonly rod = new RodDraft(this, this.heights);
  private readonly axlesTool: AxlesTool = new AxlesTool(
    this,
    () => this.axlesOfChosen.value,
    (lines) => void this.storeAxles(lines),
  );
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
  readonly axlesOfChosen = computed<readonly number[]>(
    () => this.chosen.value?.measurement?.axle_lines ?? [],
  );

  /** The height that the keys of the review judge: the one picked, or the next that waits; null: the motion. */
  readonly judged = computed<LineHeight | null>(() => {
    const vehicle = this.chosen.value;
    const picked = this.heights.selected.value;
    const height = picked && this.heights.of(picked.target);
    if (height && mayBeJudged(height)) return height;
    if (!vehicle || this.motionWaits(vehicle)) return null;
    return this.heights.waitingOf(vehicle.id)[0] ?? null;
  });

  /** Every vehicle as the server had it last, those taken out too. */
  private readonly seen = new Map<number, ScanVehicle>();
  private readonly stop = new AbortController();
  private readonly deaf = [
    outbox.listen(SCANNED, (wish: ScannedWish) => {
      if (wish.about.scanId === this.id) this.follow(wish);
    }),
    // what an earlier page left, or what was kept without a connection, has come through
    ...[ADDED, SCAN_VERDICT, HEIGHT_VERDICT, ROD].map((kind) =>
      outbox.listen(kind, ({ state, lane }) => {
        if (state === "saved" && lane === this.lane && !this.busy.value) void this.reread();
      }),
    ),
  ];
  private judging = false;
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
        void this.followSearch(scan.job);
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
    this.flush();
    for (const stop of [...this.deaf, this.heights.close]) stop();
    this.tiles.close();
  }

  choose(id: number | null): void {
    this.flush();
    this.heights.end();
    this.mode.value = "look";
    this.twoLines.back();
    this.edge.value = null;
    this.rejecting.value = null;
    this.chosenId.value = id;
    this.detail.value = null;
    setQuery({ vehicle: id });
    if (id === null) return;
    void this.readDetail(id);
    this.show("reveal");
  }

  /** Work begins with the first vehicle that is to be judged, else the first: one that can be made out. */
  private firstToSee(): ScanVehicle | undefined {
    return this.nextToJudge(null) ?? this.vehicles.value[0];
  }

  /** The next that this person may judge and nobody has, from the one after `id` on and round to it again. */
  private nextToJudge(id: number | null): ScanVehicle | undefined {
    const all = this.vehicles.value;
    const on = all.findIndex((one) => one.id === id) + 1;
    return [...all.slice(on), ...all.slice(0, on)].find((one) => one.id !== id && this.waits(one));
  }

  /** Its motion or one of its heights waits for this person's verdict. */
  private waits(vehicle: ScanVehicle): boolean {
    return this.motionWaits(vehicle) || this.heights.waitingOf(vehicle.id).length > 0;
  }

  private motionWaits(vehicle: ScanVehicle): boolean {
    return waitsForVerdict(vehicle) && !this.keptMotions.value.has(vehicle.id);
  }

  /** Vehicles whose motion has a verdict that is not stored yet. */
  private readonly keptMotions = computed(
    () => new Set(outbox.of<ScanVehicle, unknown, { id: number }>(SCAN_VERDICT).map((one) => one.about.id)),
  );

  /** What was chosen or taken up while something was stored stays. */
  private chooseUnless(id: number, before: number | null): void {
    if (this.chosenId.value === before && this.mode.value === "look") this.choose(id);
  }

  step(by: 1 | -1): void {
    const all = this.vehicles.value;
    const at = all.findIndex((one) => one.id === this.chosenId.value);
    const next = at < 0 ? (by === 1 ? all[0] : all.at(-1)) : all[at + by];
    if (next) this.choose(next.id);
    else toast(say(by === 1 ? "scan-last-vehicle" : "scan-first-vehicle"));
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
      await this.change(say("scan-step-boundaries", { vehicle: String(vehicle.number) }), async (changes) => {
        await changes.write(this.boundaries, vehicle.id, draft);
      });
    if (this.draft.value === draft) this.draft.value = null;
  }

  cancel(): boolean {
    clearTimeout(this.nudging);
    const placing = this.mode.value !== "look" || this.rejecting.value !== null;
    const chosen = this.edge.value !== null || this.heights.selected.value !== null;
    const held = this.draft.value !== null || chosen || placing;
    this.rejecting.value = null;
    this.heights.end();
    this.draft.value = null;
    this.edge.value = null;
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

  /** The tools of what is taken up. */
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
    if (mode === "wheels") await this.storeWheels(low, high);
    else await this.addVehicle(low, high);
  }

  async storeWheels(front: number | null, rear: number | null): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle?.measurement) return;
    await this.change(say("scan-step-wheels", { vehicle: String(vehicle.number) }), async (changes) => {
      await changes.write(this.hubs, vehicle.id, [front, rear]);
    });
  }

  /** Null: as the program finds them. */
  async storeAxles(lines: Axles): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle?.measurement) return;
    await this.change(say("scan-step-axles", { vehicle: String(vehicle.number) }), async (changes) => {
      await changes.write(this.axles, vehicle.id, lines);
    });
  }

  /** Null: as the program tells it. */
  async storeLane(lane: string | null): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle?.measurement) return;
    await this.change(say("scan-step-lane", { vehicle: String(vehicle.number) }), async (changes) => {
      await changes.write(this.lanes, vehicle.id, lane);
    });
  }

  async fillIn(facts: Facts): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle) return;
    await this.change(say("scan-step-known", { vehicle: String(vehicle.number) }), async (changes) => {
      changes.touch(this.facts, { id: vehicle.id, names: Object.keys(facts) as (keyof Facts)[] });
      await this.want(vehicle.id, { facts });
    });
  }

  async remove(): Promise<void> {
    const vehicle = this.chosen.value;
    if (!vehicle || !may("operator")) return;
    const named = { vehicle: String(vehicle.number) };
    await this.change(say("scan-step-take-out", named), async (changes) => {
      await changes.write(this.presence, vehicle.id, false);
      toast(say("scan-taken-out", named));
    });
  }

  /** By keyboard: accepts what the keys judge. */
  accept(): void {
    const height = this.judged.value;
    void (height ? this.reviewHeight(height, "accepted") : this.review("accepted"));
  }

  /** By keyboard: asks why it is rejected. */
  reject(): void {
    const m = this.chosen.value?.measurement;
    const height = this.judged.value;
    if (height || (m?.status === "ok" && !m.mine && may("reviewer")))
      this.rejecting.value = height ? height.id : "motion";
  }

  async reviewHeight(one: LineHeight, verdict: Verdict["verdict"], reason?: string): Promise<void> {
    if (!mayBeJudged(one) || this.judging) return;
    const named = { vehicle: String(this.numberOf(one.vehicle_id)), target: one.target };
    if (verdict === "accepted" && one.review.verdict === "accepted") {
      this.passOn(one);
      return;
    }
    await this.judge(
      say("scan-step-height-verdict", named),
      this.heights.verdicts,
      { id: one.vehicle_id, target: one.target },
      { verdict, reason: reason ?? null },
      (given) => this.passOn(one, say("scan-height-verdict-done", { ...named, verdict: given })),
    );
  }

  /** From a height that was judged to the next that waits; what was picked meanwhile stays. */
  private passOn(one: LineHeight, done = ""): void {
    if (this.heights.selected.value?.target === one.target) this.heights.selected.value = null;
    this.goOn(one.vehicle_id, done);
  }

  async review(verdict: Verdict["verdict"], reason?: string): Promise<void> {
    const vehicle = this.chosen.value;
    const measured = vehicle?.measurement;
    if (!vehicle || !measured || measured.mine || !may("reviewer") || this.judging) return;
    const { id, number } = vehicle;
    if (verdict === "accepted" && measured.review.verdict === "accepted") {
      this.goOn(id);
      return;
    }
    await this.judge(
      say("scan-wish-verdict", { vehicle: String(number) }),
      this.verdicts,
      id,
      { verdict, reason: reason ?? null },
      (given) => this.goOn(id, say("scan-verdict-done", { vehicle: String(number), verdict: given })),
    );
  }

  /** Gives a verdict as a step that can be taken back, and goes on once it is stored or kept. */
  private async judge<K>(
    label: string,
    ledger: Ledger<K, Verdict>,
    key: K,
    want: Verdict,
    goOn: (verdict: "accepted" | "rejected") => void,
  ): Promise<void> {
    this.judging = true;
    await this.change(label, async (changes) => {
      await changes.write(ledger, key, want);
      if (want.verdict !== "reopened") goOn(want.verdict);
    });
    this.judging = false;
  }

  /** To the next vehicle that waits for a verdict once nothing of this one does, unless something else was taken up meanwhile; says what was done. */
  private goOn(id: number, done = ""): void {
    if (this.chosenId.value !== id || this.mode.value !== "look") return;
    const here = this.chosen.value;
    const rest = here !== null && this.waits(here);
    const next = rest ? undefined : this.nextToJudge(id);
    if (next) this.choose(next.id);
    const words = [done, rest || next ? "" : say("scan-verdict-none-left")].filter(Boolean).join(" ");
    if (words) toast(words);
  }

  /** Looks for vehicles, or (without `search`) measures those that are known again. */
  async find(method: ScanMethod, search: boolean): Promise<void> {
    await this.tell(async () =>
      this.followSearch(
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
    const before = this.chosenId.value;
    await this.tell(async () => {
      const added = await outbox.store<ScanVehicle, unknown, { scanId: number }>({
        key: newKey(),
        kind: ADDED,
        lane: this.lane,
        about: { scanId: this.id },
        what: say("scan-wish-a-vehicle"),
        mine: say("scan-wish-lines", { front: fixed(front, 1), rear: fixed(rear, 1) }),
        page: this.page(),
        saved: null,
        want: { front_line_1: front, rear_line_1: rear },
      });
      const made = added?.saved;
      if (!made) toast(say("scan-kept-vehicle"));
      else
        await this.history.run(
          say("scan-step-vehicle", { vehicle: String(made.number) }),
          async (changes) => {
            changes.touch(this.presence, made.id);
            await this.readVehicles();
            this.chooseUnless(made.id, before);
          },
        );
    });
  }

  /** Whether a vehicle is in the list. */
  private readonly presence: Ledger<number, boolean> = {
    read: (id) => this.vehicles.value.some((one) => one.id === id),
    write: (id, there) => this.putThere(id, there),
  };

  private readonly boundaries: Ledger<number, Crossings | null> = {
    read: (id) => {
      const measured = this.measurementOf(id);
      return measured ? crossingsOf(measured) : null;
    },
    write: (id, lines) => (lines ? this.want(id, { boundaries: lines }) : undefined),
  };

  private readonly facts: Ledger<{ id: number; names: readonly (keyof Facts)[] }, Facts> = {
    nameOf: ({ id, names }) => `${id}:${names}`,
    read: ({ id, names }) => {
      const vehicle = this.vehicles.value.find((one) => one.id === id);
      return Object.fromEntries(names.map((name) => [name, vehicle?.[name] ?? null]));
    },
    write: ({ id }, facts) => this.want(id, { facts }),
  };

  /** Values of the rig, and the recording's name. */
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

  private readonly hubs: Ledger<number, Hubs> = {
    read: (id) => {
      const measured = this.measurementOf(id);
      return [measured?.front_wheel_line ?? null, measured?.rear_wheel_line ?? null];
    },
    write: (id, hubs) => this.want(id, { hubs }),
  };

  private readonly axles: Ledger<number, Axles> = {
    read: (id) => {
      const measured = this.measurementOf(id);
      return measured?.axles_by === "person" ? measured.axle_lines : null;
    },
    write: (id, axles) => this.want(id, { axles }),
  };

  private readonly lanes: Ledger<number, string | null> = {
    read: (id) => laneByPerson(this.measurementOf(id)),
    write: (id, lane) => this.want(id, { lane }),
  };

  private readonly verdicts = verdictLedger<number>(
    (id) => {
      const measured = this.measurementOf(id);
      return (
        measured && {
          review: measured.review,
          kept: outbox.get<ScanVehicle, Verdict, unknown>(verdictKey(measured.id))?.want,
        }
      );
    },
    (id, want) => this.giveVerdict(id, want),
  );

  private async giveVerdict(id: number, want: Verdict): Promise<void> {
    const vehicle = this.vehicles.value.find((one) => one.id === id);
    const measured = vehicle?.measurement;
    if (!measured) return;
    const stored = await outbox.store({
      key: verdictKey(measured.id),
      kind: SCAN_VERDICT,
      lane: this.lane,
      about: { id, measurementId: measured.id, by: me.value?.person.id ?? 0 },
      what: say("scan-wish-verdict", { vehicle: String(vehicle.number) }),
      mine: verdictWords(want),
      page: this.page(id),
      saved: vehicle,
      want,
    });
    if (stored) await this.refresh();
  }

  private measurementOf(id: number): ScanVehicle["measurement"] {
    return this.vehicles.value.find((one) => one.id === id)?.measurement ?? null;
  }

  private async putThere(id: number, there: boolean): Promise<void> {
    const before = this.chosenId.value;
    await this.want(id, { there });
    if (there && this.numberOf(id) > 0) this.chooseUnless(id, before);
    else if (this.chosenId.value === id) this.choose(null);
  }

  /** What a vehicle is to become. Resolves when it is stored, or kept where there is no connection. */
  private async want(id: number, change: ScannedWanted): Promise<void> {
    const key = `scanned.${id}`;
    const before = outbox.get<ScanVehicle, ScannedWanted, unknown>(key)?.want;
    const facts = change.facts && { ...before?.facts, ...change.facts };
    const want = { ...before, ...change, ...(facts ? { facts } : {}) };
    const stored = await outbox.store<ScanVehicle, ScannedWanted, { id: number; scanId: number }>({
      key,
      kind: SCANNED,
      lane: this.lane,
      about: { id, scanId: this.id },
      what: say("scan-step-vehicle", { vehicle: String(this.numberOf(id)) }),
      mine: scannedWords(want),
      page: this.page(id),
      saved: this.seen.get(id) ?? null,
      want,
    });
    if (stored) await this.refresh();
  }

  private wishes(): ScannedWish[] {
    return outbox
      .of<ScanVehicle, ScannedWanted, { id: number; scanId: number }>(SCANNED)
      .filter((wish) => wish.about.scanId === this.id);
  }

  /** What the outbox has brought to the server, at once in the list. */
  private follow({ saved, state }: ScannedWish): void {
    if (!saved) return;
    this.note([saved]);
    const others = this.stored.value.filter((one) => one.id !== saved.id);
    const before = this.stored.value.find((one) => one.id === saved.id);
    const at = before ? this.stored.value.indexOf(before) : others.length;
    this.stored.value = saved.deleted ? others : others.toSpliced(at, 0, { ...before, ...saved });
    if (state === "saved" && !this.busy.value) void this.reread();
  }

  private note(vehicles: readonly ScanVehicle[]): void {
    for (const one of vehicles)
      if (one.version >= (this.seen.get(one.id)?.version ?? 0)) this.seen.set(one.id, one);
  }

  private async reread(): Promise<void> {
    await Promise.all([this.refresh(), this.heights.load()]).catch(toastProblem);
  }

  numberOf(id: number): number {
    return this.seen.get(id)?.number ?? 0;
  }

  page(vehicleId?: number): string {
    const survey = this.scan.value?.survey_id ?? 0;
    return `/surveys/${survey}/scan?scan=${this.id}${vehicleId ? `&vehicle=${vehicleId}` : ""}`;
  }

  private get lane(): string {
    return `scan.${this.id}`;
  }

  private async readVehicles(): Promise<void> {
    const found = await api.ask("GET /scans/{scan_id}/vehicles", { scan_id: this.id });
    this.note(found);
    this.stored.value = found;
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

  private async followSearch(job: Job): Promise<void> {
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
      if (over.state === "failed") toastProblem(jobProblem(over, say("scan-search-stopped")));
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

  /** Kept at once: the outbox sends one change after the other. */
  change(label: string, work: (changes: ChangeSet) => Promise<void>): Promise<void> {
    return this.told(() => this.history.run(label, work));
  }

  /** One change after the other, after an undo that is under way; what goes wrong is told in words. */
  tell(work: () => Promise<void>): Promise<void> {
    return this.told(() => this.history.inTurn(work));
  }

  private async told(work: () => Promise<void>): Promise<void> {
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

function waitsForVerdict({ measurement: m }: ScanVehicle): boolean {
  return m?.status === "ok" && !m.mine && !["accepted", "rejected"].includes(m.review?.verdict);
}

function sameCrossings(a: Crossings, b: Crossings): boolean {
  return EDGES.every((edge) => a[edge] === b[edge]);
}
