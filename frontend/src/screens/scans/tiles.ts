/** Tiles of the strips as bitmaps: fetched when wanted, dropped when no longer, the oldest forgotten past a bound in bytes. */
import { signal } from "@preact/signals";

const MOST_BYTES = 160 * 2 ** 20;

export interface TileKey {
  readonly camera: 1 | 2;
  readonly level: number;
  readonly index: number;
}

type Entry = { bitmap: ImageBitmap; bytes: number } | "failed";

export class Tiles {
  /** Counts arrivals, so that what draws from here draws again. */
  readonly arrived = signal(0);
  readonly failed = signal(false);
  private readonly kept = new Map<string, Entry>();
  private readonly running = new Map<string, AbortController>();
  private bytes = 0;

  constructor(
    private readonly address: (key: TileKey) => string,
    private readonly most = MOST_BYTES,
  ) {}

  /** A tile that is here; asking makes it the newest. */
  get(key: TileKey): ImageBitmap | null {
    const name = nameOf(key);
    const entry = this.kept.get(name);
    if (!entry || entry === "failed") return null;
    this.kept.delete(name);
    this.kept.set(name, entry);
    return entry.bitmap;
  }

  /** Exactly these are wanted now; what else is under way is dropped. */
  want(keys: readonly TileKey[]): void {
    const names = new Map(keys.map((key) => [nameOf(key), key]));
    for (const [name, stop] of this.running) if (!names.has(name)) stop.abort();
    for (const [name, key] of names) {
      if (!this.kept.has(name) && !this.running.has(name)) void this.fetch(name, key);
    }
  }

  /** Those that could not be fetched are asked for again. */
  retry(): void {
    for (const [name, entry] of this.kept) if (entry === "failed") this.kept.delete(name);
    this.failed.value = false;
    this.arrived.value++;
  }

  close(): void {
    for (const stop of this.running.values()) stop.abort();
    for (const entry of this.kept.values()) if (entry !== "failed") entry.bitmap.close();
    this.kept.clear();
  }

  private async fetch(name: string, key: TileKey): Promise<void> {
    const stop = new AbortController();
    this.running.set(name, stop);
    try {
      const answer = await fetch(this.address(key), { signal: stop.signal, credentials: "same-origin" });
      if (!answer.ok) throw new Error(`tile ${name}: status ${answer.status}`);
      const bitmap = await createImageBitmap(await answer.blob());
      this.keep(name, { bitmap, bytes: bitmap.width * bitmap.height * 4 });
    } catch {
      if (!stop.signal.aborted) {
        this.kept.set(name, "failed");
        this.failed.value = true;
      }
    } finally {
      this.running.delete(name);
      this.arrived.value++;
    }
  }

  private keep(name: string, entry: Exclude<Entry, "failed">): void {
    this.kept.set(name, entry);
    this.bytes += entry.bytes;
    for (const [old, one] of this.kept) {
      if (this.bytes <= this.most || old === name) break;
      this.kept.delete(old);
      if (one === "failed") continue;
      this.bytes -= one.bytes;
      one.bitmap.close();
    }
  }
}

function nameOf(key: TileKey): string {
  return `${key.camera}/${key.level}/${key.index}`;
}
