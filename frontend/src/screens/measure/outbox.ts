/**
 * What is not yet on the server, kept in local storage so that a closed lid or a crash loses nothing.
 * One item per measurement: what it is to become. A tab looks after its own items; items of a tab that is gone are adopted.
 */
import { newKey } from "../../core/random";
import type { Values } from "../../viewer/values";

export interface OutboxItem {
  readonly key: string;
  readonly vehicleId: number;
  /** The measurement on the server and the revision last seen of it; null while it was never stored. */
  readonly seriesId: number | null;
  readonly revision: number | null;
  readonly values: Values;
  readonly tab: string;
  /** Milliseconds since 1970 at which its tab was last alive. */
  readonly touched: number;
}

/** A tab that has not touched its items for so long is gone. */
export const ORPHANED_AFTER_MS = 45_000;
const TOUCH_EVERY_MS = 10_000;

type Store = Pick<Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">;

export class Outbox {
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(
    private readonly prefix: string,
    private readonly tab: string,
    private readonly store: Store = localStorage,
    private readonly now: () => number = Date.now,
  ) {}

  put(item: Omit<OutboxItem, "tab" | "touched">): void {
    this.write({ ...item, tab: this.tab, touched: this.now() });
    this.timer ??= setInterval(() => this.touch(), TOUCH_EVERY_MS);
  }

  done(key: string): void {
    try {
      this.store.removeItem(this.prefix + key);
    } catch {
      // nothing was kept, so nothing is to be removed
    }
  }

  /** Items left by this tab before a reload, or by a tab that is gone; they are this tab's from now on. */
  adopt(): OutboxItem[] {
    const orphans = this.all().filter(
      (item) => item.tab === this.tab || this.now() - item.touched > ORPHANED_AFTER_MS,
    );
    for (const item of orphans) this.put(item);
    return orphans;
  }

  /** Everything kept, whichever tab it belongs to. */
  all(): OutboxItem[] {
    const found: OutboxItem[] = [];
    try {
      for (let i = 0; i < this.store.length; i += 1) {
        const name = this.store.key(i);
        if (!name?.startsWith(this.prefix)) continue;
        const item = parse(this.store.getItem(name));
        if (item) found.push(item);
      }
    } catch {
      return found;
    }
    return found;
  }

  close(): void {
    clearInterval(this.timer);
    this.timer = undefined;
  }

  private touch(): void {
    const mine = this.all().filter((item) => item.tab === this.tab);
    for (const item of mine) this.write({ ...item, touched: this.now() });
    if (mine.length === 0) this.close();
  }

  private write(item: OutboxItem): void {
    try {
      this.store.setItem(this.prefix + item.key, JSON.stringify(item));
    } catch {
      // a full or forbidden store: the measurement still goes out from memory, and leaving the page warns
    }
  }
}

function parse(text: string | null): OutboxItem | null {
  try {
    const item = JSON.parse(text ?? "null") as OutboxItem | null;
    if (!item || typeof item.key !== "string" || !item.values) return null;
    // kept by a page that knew of one frame only
    return { ...item, values: { ...item.values, more: item.values.more ?? [] } };
  } catch {
    return null;
  }
}

/** A name for this tab that survives a reload of it. */
export function tabName(): string {
  try {
    const kept = sessionStorage.getItem("sightline.tab") ?? newKey();
    sessionStorage.setItem("sightline.tab", kept);
    return kept;
  } catch {
    return newKey();
  }
}
