/**
 * Heights of scanned vehicles by two clicks on camera 1: tyre's contact, then target. Nothing is computed here; the
 * server answers while the pointer moves, and what it stores is the same figure.
 */
import { computed, signal } from "@preact/signals";
import { api, explain } from "../../core/api";
import { Latest } from "../../core/latest";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { toast } from "../../core/toasts";
import type { LineHeight, LineHeightAnswer, Target } from "../../core/types";
import { REQUIRED } from "../../core/words";
import { type Place, placeOf } from "../../parts/strips/view";
import type { Bench } from "./bench";
import { heightKey, KeptHeights } from "./keptHeights";
import { type Clicks, clicksOf, contactBody, type Inset, insetSaid, pointBody } from "./kinds";

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
  readonly kept: KeptHeights;
  readonly target = signal<Target | null>(null);
  readonly contact = signal<Place | null>(null);
  /** What the clicks in hand and the pointer give. */
  readonly live = signal<Live | null>(null);
  readonly selected = signal<Selected | null>(null);
  /** Clicks moved by keyboard, not stored yet. */
  readonly moved = signal<(Clicks & { target: Target }) | null>(null);

  readonly ofChosen = computed<readonly LineHeight[]>(() => {
    const id = this.bench.chosenId.value;
    return this.kept.all.value.filter((one) => one.vehicle_id === id && !one.withdrawn);
  });

  /** What was chosen of heights that are not there yet, by vehicle and target. */
  private readonly insets = signal<ReadonlyMap<string, Inset>>(new Map());
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

  constructor(private readonly bench: Bench) {
    this.kept = new KeptHeights(bench, (target) => {
      const live = this.live.value;
      return live?.target === target ? live.answer : null;
    });
  }

  of(target: Target): LineHeight | null {
    return this.ofChosen.value.find((one) => one.target === target) ?? null;
  }

  /** The inset that a click on this target would be stored with; null: the survey's. */
  insetOf(target: Target): Inset | null {
    const before = this.of(target);
    return before ? insetSaid(before) : (this.insets.value.get(this.keyOf(target)) ?? null);
  }

  /** Takes a target up; a contact that this vehicle has already is used again. */
  begin(target: Target | null): void {
    const wanted = target ?? this.missing() ?? "roof";
    if (!canWork.value || this.bench.chosenId.value === null) return;
    if (!this.kept.pose.value) {
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
    const before = this.of(target);
    this.insets.value = new Map(this.insets.value).set(this.keyOf(target), inset);
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
      (changes) => changes.write(this.kept.clicks, { id: vehicle.id, target }, null),
    );
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

  private keyOf(target: Target): string {
    return heightKey(this.bench.chosenId.value ?? 0, target);
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

  private async store(id: number, number: number, target: Target, clicks: Clicks): Promise<void> {
    await this.bench.change(say("scan-step-height", { target, vehicle: String(number) }), (changes) =>
      changes.write(this.kept.clicks, { id, target }, clicks),
    );
  }
}

function bodyOf({ target, contact, point, inset }: Looked) {
  return { ...contactBody(target, contact, inset), ...(point ? pointBody(point) : {}) };
}
