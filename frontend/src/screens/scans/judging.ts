/** Verdicts on the motions of a line scan: what waits, and the way on to the next. Heights are judged in the review. */
import { computed } from "@preact/signals";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { ScanVehicle } from "../../core/types";
import { Rejection } from "../../parts/verdicts/rejection";
import { nextThat } from "../../parts/worklist";
import type { Bench } from "./bench";
import { type MotionVerdict, SCAN_VERDICT } from "./kinds";
import type { ScannedVehicles } from "./scanned";

/** Why a motion is rejected, in the order of their digit keys. */
const REASONS = ["scan-reason-boundary", "scan-reason-not-one", "scan-reason-match"] as const;

export class Judging {
  readonly rejection: Rejection = new Rejection(REASONS, (reason) => void this.review("rejected", reason));
  private busy = false;

  constructor(
    private readonly bench: Bench & { choose(id: number | null): void },
    private readonly scanned: ScannedVehicles,
  ) {}

  /** The next that this person may judge and nobody has, from the one after `id` on and round to it again. */
  next(id: number | null): ScanVehicle | undefined {
    return nextThat(this.scanned.all.value, id, (one) => this.waits(one));
  }

  private waits(vehicle: ScanVehicle): boolean {
    return waitsForVerdict(vehicle) && !this.keptMotions.value.has(vehicle.id);
  }

  /** Vehicles whose motion has a verdict that is not stored yet. */
  private readonly keptMotions = computed(
    () => new Set(outbox.of<ScanVehicle, unknown, { id: number }>(SCAN_VERDICT).map((one) => one.about.id)),
  );

  /** By keyboard: asks why it is rejected. */
  reject(): void {
    const m = this.bench.chosen.value?.measurement;
    if (m?.status === "ok" && !m.mine && may("reviewer")) this.rejection.begin();
  }

  async review(verdict: MotionVerdict["verdict"], reason?: string): Promise<void> {
    const vehicle = this.bench.chosen.value;
    const measured = vehicle?.measurement;
    if (!vehicle || !measured || measured.mine || !may("reviewer") || this.busy) return;
    const { id, number } = vehicle;
    this.rejection.cancel();
    if (verdict === "accepted" && measured.review.verdict === "accepted") {
      this.goOn(id);
      return;
    }
    const named = { vehicle: String(number) };
    this.busy = true;
    await this.bench.change(say("scan-wish-verdict", named), async (changes) => {
      await changes.write(this.scanned.verdicts, id, { verdict, reason: reason ?? null });
      const kept = this.keptMotions.value.has(id) ? say("review-verdict-kept") : null;
      if (verdict !== "reopened") this.goOn(id, kept ?? say("scan-verdict-done", { ...named, verdict }));
      else if (kept) toast(kept);
    });
    this.busy = false;
  }

  /** To the next vehicle that waits for a verdict, unless something else was taken up meanwhile; says what was done. */
  private goOn(id: number, done = ""): void {
    if (this.bench.chosenId.value !== id || this.bench.mode.value !== "look") return;
    const next = this.next(id);
    if (next) this.bench.choose(next.id);
    const words = [done, next ? "" : say("scan-verdict-none-left")].filter(Boolean).join(" ");
    if (words) toast(words);
  }
}

function waitsForVerdict({ measurement: m }: ScanVehicle): boolean {
  return m?.status === "ok" && !m.mine && !["accepted", "rejected"].includes(m.review?.verdict);
}
