/** A run of second clicks: a random few, each shown without its points; the last can be taken back. */
import { computed, signal } from "@preact/signals";
import { api } from "../../core/api";
import { History, type Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import type { Measurement, ToClickAgain } from "../../core/types";
import { type Again, BlindClicks } from "../../viewer/blind";
import { Geometry } from "../../viewer/geometry";
import { Reel } from "../../viewer/reel";
import { REPEAT, type RepeatWanted, repeatWish } from "../../viewer/repeats";
import { FrameStage } from "../../viewer/stage";

export class AgainSession {
  readonly reel = new Reel();
  readonly stage: FrameStage = new FrameStage(() => [this.stage.keyboard, this.blind]);
  readonly history = new History();
  readonly geometry = new Geometry();
  readonly items = signal<readonly ToClickAgain[] | null>(null);
  readonly at = signal(0);
  readonly problem = signal<unknown>(null);
  /** What was clicked in this run, newest last; null where one was passed over. */
  readonly done = signal<readonly (Again | null)[]>([]);
  readonly blind: BlindClicks;
  readonly current = computed(() => this.items.value?.[this.at.value] ?? null);
  readonly stored = computed(() => this.done.value.filter((one) => one !== null).length);
  private readonly newest = new Map<string, Measurement>();
  private readonly deaf: () => void;

  /** What stands at each place of the run: a repeat, null where one was passed over, undefined where none is yet. */
  private readonly repeats: Ledger<number, Again | null | undefined> = {
    read: (index) => this.done.value[index],
    write: async (index, again) => {
      const now = this.done.value[index];
      if (now) await this.turn(now, true);
      if (again) await this.turn(again, false);
      this.done.value = this.done.value.slice(0, index);
      if (again !== undefined) this.done.value = [...this.done.value, again];
      this.show(this.done.value.length);
    },
  };

  constructor(
    readonly surveyId: number,
    readonly onlyOwn: boolean,
  ) {
    this.blind = new BlindClicks(this.stage, this.reel, this.geometry, this.lane, (again) =>
      this.next(again),
    );
    this.deaf = outbox.listen<Measurement, RepeatWanted, unknown>(REPEAT, ({ key, saved }) => {
      if (saved) this.newest.set(key, saved);
    });
  }

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
    this.deaf();
    this.reel.close();
  }

  /** Passed over: the target cannot be seen well enough to click. */
  skip(): void {
    if (this.current.value && !this.blind.busy.value) this.next(null);
  }

  showFrame(): void {
    const now = this.current.value;
    if (now) this.reel.show(now.recording_id, now.frame);
  }

  private get lane(): string {
    return `repeats ${this.surveyId}`;
  }

  /** Withdrawn or brought back: kept at once, sent in its turn. */
  private async turn({ key, vehicleId, clicks, made }: Again, withdrawn: boolean): Promise<void> {
    const saved = this.newest.get(key) ?? made;
    await outbox.store(repeatWish(key, this.lane, { vehicleId }, saved, { clicks, withdrawn }));
  }

  private next(again: Again | null): void {
    this.history.run(say(again ? "again-undo-clicks" : "again-undo-skip"), (changes) => {
      changes.touch(this.repeats, this.at.value);
      this.done.value = [...this.done.value, again];
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
