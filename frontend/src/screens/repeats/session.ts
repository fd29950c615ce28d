/** A run of second clicks: a random few, each shown without its points; the last can be taken back. */
import { computed, signal } from "@preact/signals";
import { api } from "../../core/api";
import { toastProblem } from "../../core/toasts";
import type { Measurement, Recording, ToClickAgain } from "../../core/types";
import { BlindClicks } from "../../viewer/blind";
import { Geometry } from "../../viewer/geometry";
import { Player } from "../../viewer/player";
import { Stage } from "../../viewer/stage";

export class AgainSession {
  readonly stage = new Stage();
  readonly geometry = new Geometry();
  readonly items = signal<readonly ToClickAgain[] | null>(null);
  readonly at = signal(0);
  readonly problem = signal<unknown>(null);
  readonly player = signal<Player | null>(null);
  /** What was stored in this run, newest last; null where one was passed over. */
  readonly done = signal<readonly (Measurement | null)[]>([]);
  readonly blind = new BlindClicks(this.stage, this.geometry, (made) => this.next(made));
  readonly current = computed(() => this.items.value?.[this.at.value] ?? null);
  readonly stored = computed(() => this.done.value.filter((one) => one !== null).length);
  private recordings: readonly Recording[] = [];

  constructor(
    readonly surveyId: number,
    readonly onlyOwn: boolean,
  ) {}

  async load(): Promise<void> {
    this.problem.value = null;
    try {
      const [items, recordings] = await Promise.all([
        api.get<ToClickAgain[]>(`/surveys/${this.surveyId}/repeats/sample?only_own=${this.onlyOwn}`),
        api.get<Recording[]>(`/surveys/${this.surveyId}/recordings`),
      ]);
      this.recordings = recordings;
      this.items.value = items;
      this.show(0);
    } catch (error) {
      this.problem.value = error;
    }
  }

  close(): void {
    this.player.value?.close();
  }

  /** Passed over: the target cannot be seen well enough to click. */
  skip(): void {
    if (this.current.value && !this.blind.busy.value) this.next(null);
  }

  /** The last second click is withdrawn and comes again. */
  async undo(): Promise<void> {
    if (this.blind.takeBack() || this.done.value.length === 0 || this.blind.busy.value) return;
    const last = this.done.value.at(-1) ?? null;
    try {
      if (last) await api.del(`/measurements/${last.id}?revision=${last.revision}`);
      this.done.value = this.done.value.slice(0, -1);
      this.show(this.at.value - 1);
    } catch (error) {
      toastProblem(error);
    }
  }

  /** Back to the frame to click on. */
  showFrame(): void {
    const now = this.current.value;
    if (now) this.player.value?.go(now.frame);
  }

  private next(made: Measurement | null): void {
    this.done.value = [...this.done.value, made];
    this.show(this.at.value + 1);
  }

  private show(index: number): void {
    this.at.value = index;
    const item = this.current.value;
    this.blind.start(item);
    if (!item) return;
    const now = this.player.value;
    if (now?.recordingId === item.recording_id) now.go(item.frame);
    else {
      now?.close();
      const player = new Player(item.recording_id, item.frame);
      const facts = this.recordings.find((one) => one.id === item.recording_id);
      if (facts) player.describe(facts);
      this.player.value = player;
    }
    this.stage.fit();
    this.stage.focus();
  }
}
