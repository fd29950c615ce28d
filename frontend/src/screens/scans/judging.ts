/** Verdicts on the motions and heights of a line scan: what waits, what the keys judge, and the way on to the next. */
import { computed, signal } from "@preact/signals";
import type { Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { LineHeight, ScanVehicle } from "../../core/types";
import type { Bench } from "./bench";
import { type LineHeights, mayBeJudged } from "./heights";
import { SCAN_VERDICT, type Verdict } from "./kinds";
import type { ScannedVehicles } from "./scanned";

export class Judging {
  /** What a reason is being written for: the motion, or a height by its number. */
  readonly rejecting = signal<"motion" | number | null>(null);
  private busy = false;

  constructor(
    private readonly bench: Bench & { choose(id: number | null): void },
    private readonly scanned: ScannedVehicles,
    private readonly heights: LineHeights,
  ) {}

  /** The height that the keys of the review judge: the one picked, or the next that waits; null: the motion. */
  readonly judged = computed<LineHeight | null>(() => {
    const vehicle = this.bench.chosen.value;
    const picked = this.heights.selected.value;
    const height = picked && this.heights.of(picked.target);
    if (height && mayBeJudged(height)) return height;
    if (!vehicle || this.motionWaits(vehicle)) return null;
    return this.heights.waitingOf(vehicle.id)[0] ?? null;
  });

  /** The next that this person may judge and nobody has, from the one after `id` on and round to it again. */
  next(id: number | null): ScanVehicle | undefined {
    const all = this.scanned.all.value;
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

  /** By keyboard: accepts what the keys judge. */
  accept(): void {
    const height = this.judged.value;
    void (height ? this.reviewHeight(height, "accepted") : this.review("accepted"));
  }

  /** By keyboard: asks why it is rejected. */
  reject(): void {
    const m = this.bench.chosen.value?.measurement;
    const height = this.judged.value;
    if (height || (m?.status === "ok" && !m.mine && may("reviewer")))
      this.rejecting.value = height ? height.id : "motion";
  }

  async reviewHeight(one: LineHeight, verdict: Verdict["verdict"], reason?: string): Promise<void> {
    if (!mayBeJudged(one) || this.busy) return;
    const named = { vehicle: String(this.scanned.numberOf(one.vehicle_id)), target: one.target };
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
    const vehicle = this.bench.chosen.value;
    const measured = vehicle?.measurement;
    if (!vehicle || !measured || measured.mine || !may("reviewer") || this.busy) return;
    const { id, number } = vehicle;
    if (verdict === "accepted" && measured.review.verdict === "accepted") {
      this.goOn(id);
      return;
    }
    await this.judge(
      say("scan-wish-verdict", { vehicle: String(number) }),
      this.scanned.verdicts,
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
    this.busy = true;
    await this.bench.change(label, async (changes) => {
      await changes.write(ledger, key, want);
      if (want.verdict !== "reopened") goOn(want.verdict);
    });
    this.busy = false;
  }

  /** To the next vehicle that waits for a verdict once nothing of this one does, unless something else was taken up meanwhile; says what was done. */
  private goOn(id: number, done = ""): void {
    if (this.bench.chosenId.value !== id || this.bench.mode.value !== "look") return;
    const here = this.bench.chosen.value;
    const rest = here !== null && this.waits(here);
    const next = rest ? undefined : this.next(id);
    if (next) this.bench.choose(next.id);
    const words = [done, rest || next ? "" : say("scan-verdict-none-left")].filter(Boolean).join(" ");
    if (words) toast(words);
  }
}

function waitsForVerdict({ measurement: m }: ScanVehicle): boolean {
  return m?.status === "ok" && !m.mine && !["accepted", "rejected"].includes(m.review?.verdict);
}
