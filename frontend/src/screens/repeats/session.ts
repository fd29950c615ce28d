/** A run of second clicks: a random few, each shown without its points; the last can be taken back. */
import { computed, signal } from "@preact/signals";
import { api } from "../../core/api";
import { History, type Ledger } from "../../core/history";
import { say } from "../../core/messages";
import type { Measurement, ToClickAgain } from "../../core/types";
import { BlindClicks } from "../../viewer/blind";
import { Geometry } from "../../viewer/geometry";
import { Reel } from "../../viewer/reel";
import { FrameStage } from "../../viewer/stage";

export class AgainSession {
  readonly reel = new Reel();
  readonly stage: FrameStage = new FrameStage(() => [this.stage.keyboard, this.blind]);
  readonly history = new History();
  readonly geometry = new Geometry();
  readonly items = signal<readonly ToClickAgain[] | null>(null);
  readonly at = signal(0);
  readonly problem = signal<unknown>(null);
  /** What was stored in this run, newest last; null where one was passed over. */
  readonly done = signal<readonly (Measurement | null)[]>([]);
  readonly blind: BlindClicks = new BlindClicks(this.stage, this.reel, this.geometry, (made) =>
    this.next(made),
  );
  readonly current = computed(() => this.items.value?.[this.at.value] ?? null);
  readonly stored = computed(() => this.done.value.filter((one) => one !== null).length);
  private readonly newest = new Map<number, Measurement>();

  /** What stands at each place of the run: a repeat, null where one was passed over, undefined where none is yet. */
  private readonly repeats: Ledger<number, Measurement | null | undefined> = {
    read: (index) => this.done.value[index],
    write: async (index, made) => {
      const now = this.done.value[index];
      if (now)
        this.keep(
          await api.write("DELETE /measurements/{measurement_id}", {
            measurement_id: now.id,
            revision: now.revision,
          }),
        );
      const again = made && (await this.restore(made));
      this.done.value = this.done.value.slice(0, index);
      if (again !== undefined) this.done.value = [...this.done.value, again];
      this.show(this.done.value.length);
    },
  };

  constructor(
    readonly surveyId: number,
    readonly onlyOwn: boolean,
  ) {}

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const [items, recordings] = await Promise.all([
        api.ask("GET /surveys/{survey_id}/repeats/sample", {
          survey_id: this.surveyId,
          only_own: this.onlyOwn,
        }),
        api.ask("GET /surveys/{survey_id}/recordings", { survey_id: this.surveyId }),
      ]);
      this.reel.recordings.value = recordings;
      this.items.value = items;
      this.show(0);
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    this.reel.close();
  }

  /** Passed over: the target cannot be seen well enough to click. */
  skip(): void {
    if (this.current.value && !this.blind.busy.value) this.next(null);
  }

  /** Back to the frame to click on. */
  showFrame(): void {
    const now = this.current.value;
    if (now) this.reel.show(now.recording_id, now.frame);
  }

  private keep(changed: Measurement): Measurement {
    this.newest.set(changed.id, changed);
    return changed;
  }

  private async restore({ id, revision }: Measurement): Promise<Measurement> {
    const body = { revision: this.newest.get(id)?.revision ?? revision };
    return this.keep(
      await api.write("POST /measurements/{measurement_id}/restore", { measurement_id: id }, { body }),
    );
  }

  private next(made: Measurement | null): void {
    this.history.run(say(made ? "again-undo-clicks" : "again-undo-skip"), (changes) => {
      changes.touch(this.repeats, this.at.value);
      this.done.value = [...this.done.value, made];
    });
    this.show(this.done.value.length);
  }

  private show(index: number): void {
    this.at.value = index;
    const item = this.current.value;
    this.blind.begin(item);
    if (!item) return;
    this.reel.show(item.recording_id, item.frame);
    this.stage.fit();
    this.stage.focus();
  }
}
