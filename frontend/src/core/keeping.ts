/**
 * What the outbox keeps in local storage until the server has it, and how what a tab left comes to another: each item names
 * its tab; a page holds the lock of its tab for as long as it is open, and what stands under a free one is taken over.
 */
import { newKey } from "./random";
import type { Wanted } from "./wish";

/** A write that was sent and whose answer has not come: its key, and what it asks for. */
export interface Begun {
  readonly idempotencyKey: string;
  readonly want: unknown;
}

export interface Kept extends Wanted<unknown, unknown, unknown> {
  /** Sent again with its key before anything else, so that it is stored once. */
  readonly begun: Begun | null;
  readonly order: number;
  readonly tab: string;
  /** Milliseconds since 1970 at which its tab was last alive. */
  readonly touched: number;
}

/** Where the browser keeps no locks (it does over https only): a tab that has not touched its items for so long is gone. */
export const ORPHANED_AFTER_MS = 45_000;
const TOUCH_EVERY_MS = 10_000;

type Store = Pick<Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">;
type Locks = Pick<LockManager, "request"> | undefined;
/** Takes over the items that were left. */
type Adopt = (left: (one: Kept) => boolean) => Promise<void>;

const browserLocks = (): Locks => (typeof navigator === "undefined" ? undefined : navigator.locks);
const lockOf = (tab: string): string => `sightline.outbox.page.${tab}`;

export class Keeping {
  /** The tabs of whose end this page will hear. */
  private readonly watched = new Set<string>();
  private prefix = "";

  constructor(
    private readonly tab: string = browserLocks() ? newKey() : tabName(),
    private readonly storage: () => Store = () => localStorage,
    private readonly now: () => number = Date.now,
    private readonly locks: Locks = browserLocks(),
  ) {
    locks?.request(lockOf(tab), () => new Promise(() => {})).catch(() => undefined);
  }

  /** Whose items these are from now on; what was left of them is adopted now and as soon as a tab is gone, until the end. */
  open(person: number | string | null, end: AbortSignal, adopt: Adopt): void {
    this.watched.clear();
    this.prefix = person === null ? "" : `sightline.outbox.${person}.`;
    if (person === null) return;
    const told = ({ key }: StorageEvent): void => {
      if (key?.startsWith(this.prefix)) this.watch(end, adopt);
    };
    window.addEventListener("storage", told);
    end.addEventListener("abort", () => window.removeEventListener("storage", told));
    void adopt((one) => one.tab === this.tab);
    this.watch(end, adopt);
    if (this.locks) return;
    const adoptOld = () => void adopt((one) => this.now() - one.touched > ORPHANED_AFTER_MS);
    adoptOld();
    const timer = setInterval(() => {
      this.touch();
      adoptOld();
    }, TOUCH_EVERY_MS);
    end.addEventListener("abort", () => clearInterval(timer));
  }

  /** What the other tabs have kept is this one's as soon as they are gone, closed or killed: then their lock is free. */
  private watch(end: AbortSignal, adopt: Adopt): void {
    if (!this.locks) return;
    for (const { tab } of this.all()) {
      if (tab === this.tab || this.watched.has(tab)) continue;
      this.watched.add(tab);
      // the lock is held until all is taken over, so that nobody else takes it too
      const gone = async (): Promise<void> => {
        if (end.aborted) return;
        this.watched.delete(tab);
        await adopt((one) => one.tab === tab);
        this.watch(end, adopt);
      };
      this.locks.request(lockOf(tab), { signal: end }, gone).catch(() => undefined);
    }
  }

  all(): Kept[] {
    const found: Kept[] = [];
    if (!this.prefix) return found;
    try {
      const store = this.storage();
      for (let i = 0; i < store.length; i += 1) {
        const name = store.key(i);
        const one = name?.startsWith(this.prefix) ? parse(store.getItem(name)) : null;
        if (one) found.push(one);
      }
    } catch {
      return found;
    }
    return found;
  }

  /** As this tab's. */
  keep(one: Omit<Kept, "tab" | "touched">): void {
    const kept: Kept = { ...one, tab: this.tab, touched: this.now() };
    try {
      this.storage().setItem(this.prefix + one.key, JSON.stringify(kept));
    } catch {
      // a full or forbidden store: it still goes out from memory, and leaving the page warns
    }
  }

  forget(key: string): void {
    try {
      this.storage().removeItem(this.prefix + key);
    } catch {
      // nothing was kept, so nothing is to be removed
    }
  }

  private touch(): void {
    for (const one of this.all()) if (one.tab === this.tab) this.keep(one);
  }
}

function parse(text: string | null): Kept | null {
  try {
    const one = JSON.parse(text ?? "null") as Kept | null;
    const named = one && [one.key, one.kind, one.lane, one.tab].every((name) => typeof name === "string");
    return named ? one : null;
  } catch {
    return null;
  }
}

/** A name for this tab that survives a reload of it, where no lock tells that the page before is gone. */
function tabName(): string {
  try {
    const kept = sessionStorage.getItem("sightline.tab") ?? newKey();
    sessionStorage.setItem("sightline.tab", kept);
    return kept;
  } catch {
    return newKey();
  }
}
