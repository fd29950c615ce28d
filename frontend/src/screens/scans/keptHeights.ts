/** Heights of a line scan's vehicles as they are stored or on their way there, and what of them can be put back. */
import { computed, signal } from "@preact/signals";
import { api } from "../../core/api";
import type { Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import type { LineHeight, LineHeightAnswer, LinePose, LinePoses, Target } from "../../core/types";
import { STATE_WORDS } from "../../core/words";
import { isWaiting } from "../../parts/verdicts/given";
import type { Bench } from "./bench";
import { expected, type HeightWish, wantedWords } from "./expected";
import { type Clicks, clicksOf, type HeightAbout, type HeightWanted, LINE_HEIGHT } from "./kinds";

export class KeptHeights {
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
  readonly older = computed<readonly LineHeight[]>(() =>
    this.all.value.filter((one) => one.older && !one.withdrawn),
  );

  private readonly waiting = computed<ReadonlyMap<number, number>>(() => {
    const found = new Map<number, number>();
    for (const height of this.all.value)
      if (!height.withdrawn && isWaiting(height))
        found.set(height.vehicle_id, (found.get(height.vehicle_id) ?? 0) + 1);
    return found;
  });

  /** No longer told of what the outbox does. */
  readonly close: () => void;

  /** `answered`: what the server said for the clicks in hand on a target, before they are stored. */
  constructor(
    private readonly bench: Bench,
    private readonly answered: (target: Target) => LineHeightAnswer | null,
  ) {
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

  waitingOf(vehicleId: number): number {
    return this.waiting.value.get(vehicleId) ?? 0;
  }

  /** The clicks of each target of each vehicle on the server; null: none, or withdrawn. */
  readonly clicks: Ledger<{ id: number; target: Target }, Clicks | null> = {
    nameOf: ({ id, target }) => `${id}:${target}`,
    read: ({ id, target }) => {
      const newest = this.newest(id, target);
      return newest && !newest.withdrawn ? clicksOf(newest) : null;
    },
    write: ({ id, target }, clicks) => this.want(id, target, clicks),
  };

  private newest(id: number, target: Target): LineHeight | undefined {
    return this.all.value.find((one) => one.vehicle_id === id && one.target === target);
  }

  private saved({ id, target }: { id: number; target: Target }): LineHeight | null {
    return this.stored.value.find((one) => one.vehicle_id === id && one.target === target) ?? null;
  }

  /** Resolves when the height is stored, or kept where there is no connection. */
  private async want(id: number, target: Target, clicks: Clicks | null): Promise<void> {
    const saved = this.saved({ id, target });
    const answer = this.answered(target);
    const same = saved && !saved.withdrawn && clicks && !outbox.get(heightKey(id, target));
    await outbox.store<LineHeight, HeightWanted, HeightAbout>({
      key: heightKey(id, target),
      kind: LINE_HEIGHT,
      lane: `scan.${this.bench.id}`,
      about: { id, scanId: this.bench.id, target, answer },
      what: say("scan-step-height", { target, vehicle: String(this.bench.numberOf(id)) }),
      mine: clicks ? wantedWords(answer, clicks) : STATE_WORDS.withdrawn,
      page: this.bench.page(id),
      saved,
      want: { clicks, ...(same ? { again: saved.revision } : {}) },
    });
  }
}

export function heightKey(vehicleId: number, target: Target): string {
  return `height.${vehicleId}.${target}`;
}

function withHeight(all: readonly LineHeight[], made: LineHeight): readonly LineHeight[] {
  return [...all.filter((one) => one.vehicle_id !== made.vehicle_id || one.target !== made.target), made];
}
