/** The rod's marks while the line camera is calibrated: clicked on camera 1, solved by the server, stored as a whole. */
import { signal } from "@preact/signals";
import { api } from "../../core/api";
import type { Ledger } from "../../core/history";
import { Latest } from "../../core/latest";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { toast, toastProblem } from "../../core/toasts";
import type { LinePose, RodMark, SolvedRod } from "../../core/types";
import { type Place, showLines } from "../../parts/strips/view";
import type { Bench } from "./bench";
import type { LineHeights } from "./heights";
import { FRESH, ROD, type RodValues, rodOf } from "./kinds";
import { rodWords } from "./wanted";

/** Where the next click belongs: the rod's distance, the mark's height, and how much higher the one after it is. */
export interface NextMark {
  readonly distance_m: number | null;
  readonly height_m: number;
  readonly step_m: number;
}

export class RodDraft {
  readonly values = signal<RodValues>(FRESH);
  readonly next = signal<NextMark>({ distance_m: null, height_m: 0, step_m: 0.5 });
  readonly solved = signal<SolvedRod | null>(null);
  readonly changed = signal(false);
  private readonly asker = new Latest<RodValues, SolvedRod>(
    (values) =>
      api.ask(
        "POST /scans/{scan_id}/line-pose/preview",
        { scan_id: this.bench.id },
        { body: { ...values, marks: [...values.marks] }, retry: true },
      ),
    (answer) => {
      this.solved.value = answer;
    },
    toastProblem,
  );

  constructor(
    private readonly bench: Bench,
    private readonly heights: LineHeights,
  ) {}

  /** Begins with what was clicked and not stored yet, else with the marks that are stored. */
  open(): void {
    if (!this.changed.value) this.reset();
    this.next.value = { ...this.next.value, distance_m: null, height_m: 0 };
    const lines = this.values.value.marks.map((mark) => mark.line);
    if (lines.length > 0)
      this.bench.view.value = showLines(this.bench.view.value, Math.min(...lines), Math.max(...lines), 0.5);
  }

  reset(): void {
    const pose = this.heights.kept.pose.value;
    const kept = this.kept();
    if (kept) this.show(kept);
    else {
      this.values.value = pose ? rodOf(pose) : FRESH;
      this.solved.value = pose?.solved ?? null;
    }
    this.changed.value = false;
  }

  /** What is not yet stored counts as if it were. */
  private kept(): RodValues | null {
    return outbox.get<LinePose, RodValues, { scanId: number }>(keyOf(this.bench.id))?.want ?? null;
  }

  click(at: Place): void {
    const { distance_m, height_m, step_m } = this.next.value;
    if (distance_m === null) {
      toast(say("scan-rod-distance-first"));
      return;
    }
    const mark = { distance_m, height_m, row_px: at.row, line: Math.max(at.line, 0) };
    this.put([...this.values.value.marks, mark], say("scan-step-mark"));
    this.next.value = { distance_m, step_m, height_m: Number((height_m + step_m).toFixed(6)) };
  }

  remove(index: number): void {
    this.put(
      this.values.value.marks.filter((_, at) => at !== index),
      say("scan-step-mark-removed"),
    );
  }

  clear(): void {
    this.put([], say("scan-step-marks-removed"));
    this.next.value = { ...this.next.value, height_m: 0 };
  }

  change(part: Partial<Omit<RodValues, "marks">>): void {
    this.show({ ...this.values.value, ...part });
  }

  async store(): Promise<void> {
    const values = this.values.value;
    await this.bench.change(say("scan-step-calibration"), async (changes) => {
      // before the first one there was none, and none can be put back
      if (this.heights.kept.pose.value) await changes.write(this.stored, "pose", values);
      else await this.send(values);
      // what was taken up while it was stored stays
      if (this.bench.mode.value === "rod") this.bench.cancel();
      const older = this.heights.kept.older.value.length > 0;
      toast(say(this.kept() ? "scan-rod-kept" : older ? "scan-rod-stored-older" : "scan-rod-stored"));
    });
  }

  /** Resolves when it is stored, or kept where there is no connection. */
  private async send(values: RodValues): Promise<void> {
    const { id } = this.bench;
    const stored = await outbox.store<LinePose, RodValues, { scanId: number }>({
      key: keyOf(id),
      kind: ROD,
      lane: `scan.${id}`,
      about: { scanId: id },
      what: say("scan-step-calibration"),
      mine: rodWords(values.marks),
      page: this.bench.page(),
      saved: this.heights.kept.pose.value,
      want: values,
    });
    if (stored) await this.heights.kept.load();
    if (this.values.value === values) this.changed.value = false;
  }

  private readonly stored: Ledger<"pose", RodValues | null> = {
    read: () => this.kept() ?? (this.heights.kept.pose.value ? rodOf(this.heights.kept.pose.value) : null),
    write: (_key, values) => (values ? this.send(values) : undefined),
  };

  private readonly marks: Ledger<"marks", readonly RodMark[]> = {
    read: () => this.values.value.marks,
    write: (_key, marks) => {
      // taken back from elsewhere, it is shown where it happens
      if (this.bench.mode.value !== "rod") this.bench.start("rod");
      this.show({ ...this.values.value, marks });
    },
  };

  private put(marks: readonly RodMark[], label: string): void {
    this.bench.history.run(label, (changes) => changes.write(this.marks, "marks", marks));
  }

  private show(values: RodValues): void {
    this.values.value = values;
    this.changed.value = true;
    if (values.marks.length > 0) this.asker.want(values);
    else this.solved.value = null;
  }
}

function keyOf(scanId: number): string {
  return `rod.${scanId}`;
}
