/**
 * Heights of scanned vehicles by two clicks on camera 1: tyre's contact, then target. Nothing is computed here; the
 * server answers while the pointer moves, and what it stores is the same figure.
 */
import { computed, signal } from "@preact/signals";
import { api, explain } from "../../core/api";
import type { Ledger } from "../../core/history";
import { Latest } from "../../core/latest";
import { say } from "../../core/messages";
import { outbox, type Wish } from "../../core/outbox";
import { canWork, may, me } from "../../core/session";
import { toast } from "../../core/toasts";
import type { LineHeight, LineHeightAnswer, LinePose, LinePoses, Target } from "../../core/types";
import { fixed, formatHeight } from "../../core/units";
import { REQUIRED, STATE_WORDS, TARGETS } from "../../core/words";
import type { Bench } from "./bench";
import {
  type Clicks,
  clicksOf,
  contactBody,
  HEIGHT_VERDICT,
  type HeightAbout,
  type HeightVerdictAbout,
  type HeightWanted,
  type Inset,
  insetSaid,
  LINE_HEIGHT,
  placeOf,
  pointBody,
  type Verdict,
  verdictWords,
} from "./kinds";
import { verdictLedger } from "./verdicts";
import type { Place } from "./view";

export interface Selected {
  readonly target: Target;
  readonly role: "contact" | "point";
}

interface Looked {
  readonly target: Target;
  readonly contact: Place;
  readonly point: Place | null;
  readonly inset: Inset | null;
}

export interface Live extends Looked {
  readonly answer: LineHeightAnswer | null;
  readonly problem: string | null;
}

const RESTS_MS = 600;

export class LineHeights {
  readonly poses = signal<LinePoses | null>(null);
  readonly pose = computed<LinePose | null>(() => this.poses.value?.current ?? null);
  readonly stored = signal<readonly LineHeight[]>([]);
  /** The newest revision of every target of every vehicle; in place of it what the outbox keeps. */
  readonly all = computed<readonly LineHeight[]>(() =>
    outbox
      .of<LineHeight, HeightWanted, HeightAbout>(LINE_HEIGHT)
      .filter((wish) => wish.about.scanId === this.bench.id)
      .reduce((all, wish) => withHeight(all, expected(wish)), this.stored.value),
  );
  /** The target that is clicked now. */
  readonly target = signal<Target | null>(null);
  readonly contact = signal<Place | null>(null);
  /** What the clicks in hand and the pointer give. */
  readonly live = signal<Live | null>(null);
  /** The point that the arrow keys move. */
  readonly selected = signal<Selected | null>(null);
  /** Clicks moved by keyboard, not stored yet. */
  readonly moved = signal<(Clicks & { target: Target }) | null>(null);

  readonly ofChosen = computed<readonly LineHeight[]>(() => {
    const id = this.bench.chosenId.value;
    return this.all.value.filter((one) => one.vehicle_id === id && !one.withdrawn);
  });

  readonly older = computed<readonly LineHeight[]>(() =>
    this.all.value.filter((one) => one.older && !one.withdrawn),
  );

  private readonly waiting = computed<ReadonlyMap<number, readonly LineHeight[]>>(() => {
    const waiting = this.all.value.filter((one) => mayBeJudged(one) && !isJudged(one) && !isKept(one));
    waiting.sort((a, b) => TARGETS.indexOf(a.target) - TARGETS.indexOf(b.target));
    const byVehicle = new Map<number, LineHeight[]>();
    for (const one of waiting) byVehicle.set(one.vehicle_id, [...(byVehicle.get(one.vehicle_id) ?? []), one]);
    return byVehicle;
  });

  private readonly insets = new Map<Target, Inset>();
  private resting: ReturnType<typeof setTimeout> | undefined;
  private readonly asker = new Latest<Looked, LineHeightAnswer>(
    (wish) =>
      api.ask(
        "POST /scans/{scan_id}/line-height",
        { scan_id: this.bench.id },
        { body: { ...bodyOf(wish), vehicle_id: this.bench.chosenId.peek() }, retry: true },
      ),
    (answer, wish) => {
      this.live.value = { ...wish, answer, problem: null };
    },
    (error) => {
      const now = this.live.value;
      if (now) this.live.value = { ...now, answer: null, problem: explain(error) };
    },
  );

  /** No longer told of what the outbox does. */
  readonly close: () => void;

  constructor(private readonly bench: Bench) {
    this.close = outbox.listen(LINE_HEIGHT, ({ about, saved }: HeightWish) => {
      if (about.scanId === bench.id && saved) this.stored.value = withHeight(this.stored.value, saved);
    });
  }

  async load(): Promise<void> {
    const [poses, all] = await Promise.all([
      api.ask("GET /scans/{scan_id}/line-pose", { scan_id: this.bench.id }),
      api.ask("GET /scans/{scan_id}/heights", { scan_id: this.bench.id }),
    ]);
    this.poses.value = poses;
    this.stored.value = all;
  }

  of(target: Target): LineHeight | null {
    return this.ofChosen.value.find((one) => one.target === target) ?? null;
  }

  /** The inset that a click on this target would be stored with; null: the survey's. */
  insetOf(target: Target): Inset | null {
    const before = this.of(target);
    return this.insets.get(target) ?? (before && insetSaid(before));
  }

  /** Takes a target up; a contact that this vehicle has already is used again. */
  begin(target: Target | null): void {
    const wanted = target ?? this.missing() ?? "roof";
    if (!canWork.value || this.bench.chosenId.value === null) return;
    if (!this.pose.value) {
      toast(say("scan-heights-calibrate-first"));
      return;
    }
    this.flush();
    this.bench.cancel();
    const newest = this.ofChosen.value.reduce<LineHeight | null>(
      (best, one) => (best && best.revision_id > one.revision_id ? best : one),
      null,
    );
    this.bench.mode.value = "height";
    this.target.value = wanted;
    this.contact.value = newest && placeOf(newest.contact);
    this.point(null);
  }

  newContact(): boolean {
    if (this.bench.mode.value !== "height") return false;
    this.contact.value = null;
    this.forget();
    return true;
  }

  /** Lets go of everything in hand; what was moved by keyboard is stored. */
  end(): void {
    this.flush();
    this.target.value = null;
    this.contact.value = null;
    this.selected.value = null;
    this.forget();
  }

  /** The pointer is here on camera 1 (null: elsewhere). */
  point(at: Place | null): void {
    const target = this.target.value;
    if (!target) return;
    const contact = this.contact.value ?? at;
    if (!contact) {
      this.forget();
      return;
    }
    this.look({ target, contact, point: this.contact.value ? at : null, inset: this.insetOf(target) });
  }

  click(at: Place): void {
    const target = this.target.value;
    const vehicle = this.bench.chosen.value;
    if (!target || !vehicle) return;
    const contact = this.contact.value;
    if (!contact) {
      this.contact.value = at;
      this.point(at);
      return;
    }
    if (target === "driver_eye" && !this.insetOf(target)) {
      toast(say("scan-height-side-first"));
      return;
    }
    // stored in its turn; the next target is asked for at once
    void this.store(vehicle.id, vehicle.number, target, { contact, point: at, inset: this.insetOf(target) });
    this.selected.value = { target, role: "point" };
    const next = this.missing();
    this.target.value = next;
    this.forget();
    if (next === null) this.bench.mode.value = "look";
  }

  async setInset(target: Target, inset: Inset): Promise<void> {
    this.insets.set(target, inset);
    const before = this.of(target);
    if (before) await this.again(target, { ...clicksOf(before), inset });
  }

  /** Stores the same clicks with the calibration that counts now, or other clicks. */
  async again(target: Target, clicks?: Clicks): Promise<void> {
    const before = this.of(target);
    const vehicle = this.bench.chosen.value;
    if (before && vehicle) await this.store(vehicle.id, vehicle.number, target, clicks ?? clicksOf(before));
  }

  async withdraw(target: Target): Promise<void> {
    const before = this.of(target);
    const vehicle = this.bench.chosen.value;
    if (!before || !vehicle) return;
    // now, not once it is stored: what is picked meanwhile stays
    this.selected.value = null;
    await this.bench.change(
      say("scan-step-withdraw", { target, vehicle: String(vehicle.number) }),
      async (changes) => void (await changes.write(this.ledger, { id: vehicle.id, target }, null)),
    );
  }

  /** A vehicle's heights that wait for a verdict that this person may give, in the order of their targets. */
  waitingOf(vehicleId: number): readonly LineHeight[] {
    return this.waiting.value.get(vehicleId) ?? [];
  }

  /** A verdict is put back on the revision that is the newest then. */
  readonly verdicts = verdictLedger<{ id: number; target: Target }>(
    (key) => {
      const one = this.saved(key);
      return (
        one && {
          review: one.review,
          kept: outbox.get<LineHeight, Verdict, HeightVerdictAbout>(verdictKey(one.revision_id))?.want,
        }
      );
    },
    async (key, want) => {
      const one = this.saved(key);
      if (one) await this.give(one, want);
    },
    ({ id, target }) => `${id}:${target}`,
  );

  private async give(one: LineHeight, want: Verdict): Promise<void> {
    const { id, revision, revision_id, vehicle_id, target } = one;
    const vehicle = String(this.bench.numberOf(vehicle_id));
    const stored = await outbox.store<LineHeight, Verdict, HeightVerdictAbout>({
      key: verdictKey(revision_id),
      kind: HEIGHT_VERDICT,
      lane: `scan.${this.bench.id}`,
      about: { id, revision, vehicleId: vehicle_id, target, by: me.value?.person.id ?? 0 },
      what: say("scan-step-height-verdict", { target, vehicle }),
      mine: verdictWords(want),
      page: this.bench.page(vehicle_id),
      saved: one,
      want,
    });
    if (stored?.saved) this.stored.value = withHeight(this.stored.value, stored.saved);
  }

  /** Contact and target of the selected height in turn; false where there is none. */
  selectNext(): boolean {
    const heights = this.ofChosen.value;
    const now = this.selected.value;
    if (heights.length === 0) return false;
    if (now?.role === "point") this.selected.value = { ...now, role: "contact" };
    else {
      const at = heights.findIndex((one) => one.target === now?.target);
      const next = heights[at + 1];
      if (!next) {
        this.selected.value = null;
        return false;
      }
      this.selected.value = { target: next.target, role: "point" };
    }
    return true;
  }

  /** By keyboard; stored once the keys rest. */
  nudge(lines: number, rows: number): boolean {
    const now = this.selected.value;
    const before = now && this.of(now.target);
    if (!now || !before || !canWork.value) return false;
    const held = this.moved.value?.target === now.target ? this.moved.value : clicksOf(before);
    const at = held[now.role];
    const to = { ...held, target: now.target, [now.role]: { line: at.line + lines, row: at.row + rows } };
    this.moved.value = to;
    this.look(to);
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.flush(), RESTS_MS);
    return true;
  }

  private flush(): void {
    clearTimeout(this.resting);
    const moved = this.moved.value;
    if (!moved) return;
    void this.again(moved.target, moved).finally(() => {
      if (this.moved.value !== moved) return;
      this.moved.value = null;
      if (!this.target.value) this.forget();
    });
  }

  private missing(): Target | null {
    return REQUIRED.find((target) => !this.of(target)) ?? null;
  }

  private look(wish: Looked): void {
    const now = this.live.value;
    this.live.value = { ...wish, answer: now?.answer ?? null, problem: null };
    this.asker.want(wish);
  }

  private forget(): void {
    this.asker.cancel();
    this.live.value = null;
  }

  /** The clicks of each target of each vehicle on the server; null: none, or withdrawn. */
  private readonly ledger: Ledger<{ id: number; target: Target }, Clicks | null> = {
    nameOf: ({ id, target }) => `${id}:${target}`,
    read: ({ id, target }) => {
      const newest = this.newest(id, target);
      return newest && !newest.withdrawn ? clicksOf(newest) : null;
    },
    write: ({ id, target }, clicks) => this.want(id, target, clicks),
  };

  private async store(id: number, number: number, target: Target, clicks: Clicks): Promise<void> {
    await this.bench.change(
      say("scan-step-height", { target, vehicle: String(number) }),
      async (changes) => void (await changes.write(this.ledger, { id, target }, clicks)),
    );
  }

  private newest(id: number, target: Target): LineHeight | undefined {
    return this.all.value.find((one) => one.vehicle_id === id && one.target === target);
  }

  /** As the server has it. */
  private saved({ id, target }: { id: number; target: Target }): LineHeight | null {
    return this.stored.value.find((one) => one.vehicle_id === id && one.target === target) ?? null;
  }

  /** Resolves when the height is stored, or kept where there is no connection. */
  private async want(id: number, target: Target, clicks: Clicks | null): Promise<void> {
    const saved = this.saved({ id, target });
    const { live } = this;
    const answer = live.value?.target === target ? live.value.answer : null;
    const same = saved && !saved.withdrawn && clicks && !outbox.get(heightKey(id, target));
    await outbox.store<LineHeight, HeightWanted, HeightAbout>({
      key: heightKey(id, target),
      kind: LINE_HEIGHT,
      lane: `scan.${this.bench.id}`,
      about: { id, scanId: this.bench.id, target, answer },
      what: say("scan-step-height", { target, vehicle: String(this.bench.numberOf(id)) }),
      mine: clicks ? wordsOf(answer, clicks) : STATE_WORDS.withdrawn,
      page: this.bench.page(id),
      saved,
      want: { clicks, ...(same ? { again: saved.revision } : {}) },
    });
  }
}

/** Whether this person may give a verdict on it: it has a figure, stands, and is not of their own clicks. */
export function mayBeJudged(one: LineHeight): boolean {
  return may("reviewer") && one.status === "ok" && !one.withdrawn && !one.mine;
}

function isJudged({ review }: LineHeight): boolean {
  return review.verdict === "accepted" || review.verdict === "rejected";
}

/** A verdict on it is on its way. */
function isKept({ revision_id }: LineHeight): boolean {
  return outbox.get(verdictKey(revision_id)) !== undefined;
}

function verdictKey(revisionId: number): string {
  return `height-verdict.${revisionId}`;
}

type HeightWish = Wish<LineHeight, HeightWanted, HeightAbout>;

export function heightKey(vehicleId: number, target: Target): string {
  return `height.${vehicleId}.${target}`;
}

/** The height as it will be once it is stored: its clicks, and what the server answered for them. */
function expected({ about: { id, target, answer }, saved, want: { clicks } }: HeightWish): LineHeight {
  const [contact, point] = [clicks?.contact, clicks?.point];
  return {
    ...NOT_YET,
    ...saved,
    vehicle_id: id,
    target,
    ...(clicks?.inset ?? {}),
    ...(contact ? { contact: [contact.line, contact.row] } : {}),
    ...(point ? { target_point: [point.line, point.row] } : {}),
    ...(clicks ? { ...NO_FIGURES, ...(answer && answer.status !== "contact" ? figuresOf(answer) : {}) } : {}),
    // the newest of its vehicle
    revision_id: Number.MAX_SAFE_INTEGER,
    older: false,
    withdrawn: clicks === null,
    // a new revision waits for a verdict, of somebody else
    mine: true,
    review: WAITS,
  };
}

const WAITS: LineHeight["review"] = {
  verdict: "to_review",
  reason: null,
  reviewer: null,
  at: null,
  lot_id: null,
};

const NO_FIGURES: Pick<LineHeight, Figure | "budget"> = {
  status: "not_measurable",
  reason: null,
  distance_m: null,
  U95_distance_m: null,
  height_m: null,
  u_height_m: null,
  U95_height_m: null,
  budget: [],
  flags: [],
};

type Figure =
  | "status"
  | "reason"
  | "distance_m"
  | "U95_distance_m"
  | "height_m"
  | "u_height_m"
  | "U95_height_m"
  | "flags";

const NOT_YET = {
  ...NO_FIGURES,
  id: 0,
  revision: 0,
  line_pose_id: 0,
  code_version: "",
  sigma_px: 1,
  inset_m: 0,
  u_inset_m: 0,
  inset_from: "usual" as const,
  side: null,
  computing_id: null,
  contact: [0, 0] satisfies LineHeight["contact"],
  target_point: [0, 0] satisfies LineHeight["contact"],
  u_distance_m: null,
  created_by: null,
  created_at: "",
};

function figuresOf(answer: LineHeightAnswer): Partial<LineHeight> {
  const { status, reason, distance_m, U95_distance_m, height_m, u_height_m, U95_height_m, flags } = answer;
  if (status === "contact") return {};
  return { status, reason, distance_m, U95_distance_m, height_m, u_height_m, U95_height_m, flags };
}

function withHeight(all: readonly LineHeight[], made: LineHeight): readonly LineHeight[] {
  return [...all.filter((one) => one.vehicle_id !== made.vehicle_id || one.target !== made.target), made];
}

function wordsOf(answer: LineHeightAnswer | null, { point }: Clicks): string {
  if (answer?.status === "ok") return formatHeight(answer.height_m, answer.U95_height_m);
  return say("scan-wish-clicked", { line: fixed(point.line, 0), row: fixed(point.row, 0) });
}

function bodyOf({ target, contact, point, inset }: Looked) {
  return { ...contactBody(target, contact, inset), ...(point ? pointBody(point) : {}) };
}
