/** Tiles of the strips as bitmaps: fetched when wanted, dropped when no longer. */
import { signal } from "@preact/signals";
import type { Scan } from "../../core/types";
import { BitmapCache } from "../../viewer/bitmapCache";
import { fetchPicture, isAbort } from "../../viewer/frames";
import { levelFor, type StripsView, tilesIn } from "./view";

const MOST_BYTES = 160 * 2 ** 20;

export interface TileKey {
  readonly camera: 1 | 2;
  readonly level: number;
  readonly index: number;
}

export class Tiles {
  /** Counts arrivals, so that what draws from here draws again. */
  readonly arrived = signal(0);
  readonly failed = signal(false);
  private readonly lost = new Set<string>();
  private readonly cache: BitmapCache<TileKey, ImageBitmap>;

  constructor(address: (key: TileKey) => string, maxBytes = MOST_BYTES) {
    this.cache = new BitmapCache<TileKey, ImageBitmap>((key, abort) => fetchPicture(address(key), abort), {
      maxBytes,
      nameOf,
      onChange: () => {
        this.arrived.value = this.arrived.peek() + 1;
      },
    });
  }

  /** A tile that is here; asking makes it the newest. */
  get(key: TileKey): ImageBitmap | null {
    return this.cache.get(key) ?? null;
  }

  /** Exactly these are wanted now; what else is under way is dropped. */
  want(keys: readonly TileKey[]): void {
    this.cache.keepOnly(keys);
    for (const key of keys)
      if (!this.lost.has(nameOf(key)))
        this.cache.fetch(key).catch((error: unknown) => {
          if (isAbort(error)) return;
          this.lost.add(nameOf(key));
          this.failed.value = true;
        });
  }

  /** Those that could not be fetched are asked for again. */
  retry(): void {
    this.lost.clear();
    this.failed.value = false;
    this.arrived.value++;
  }

  close(): void {
    this.cache.clear();
  }
}

export function tileAddress({ id, tiles_version }: Scan, { camera, level, index }: TileKey): string {
  return `/api/scans/${id}/tiles/${camera}/${level}/${index}?v=${tiles_version ?? ""}`;
}

/** Tiles of the level that fits, and of the coarsest, which stands in until they are here. */
export function tilesSeen(scan: Scan, view: StripsView): TileKey[] {
  if (scan.levels.length === 0) return [];
  const finest = levelFor(view.perPx, scan.levels.length, window.devicePixelRatio || 1);
  const keys: TileKey[] = [];
  for (const level of new Set([finest, scan.levels.length - 1])) {
    const about = scan.levels[level];
    if (!about) continue;
    const [first, last] = tilesIn(view, about.step, scan.tile_lines, about.tiles);
    for (let index = first; index <= last; index++)
      for (const camera of [1, 2] as const) keys.push({ camera, level, index });
  }
  return keys;
}

function nameOf(key: TileKey): string {
  return `${key.camera}/${key.level}/${key.index}`;
}
