import { describe, expect, it } from "vitest";
import { neighbours, runsOf } from "./ahead";
import { BitmapCache, type Picture } from "./bitmapCache";

class Fake implements Picture {
  readonly width = 10;
  readonly height = 10;
  closed = false;
  constructor(readonly frame: number) {}
  close(): void {
    this.closed = true;
  }
}

function cacheOf(maxFrames: number) {
  const loads: number[] = [];
  const made: Fake[] = [];
  const cache = new BitmapCache<number, Fake>(
    async (frame, signal) => {
      loads.push(frame);
      await Promise.resolve();
      if (signal.aborted) throw new DOMException("stop", "AbortError");
      const picture = new Fake(frame);
      made.push(picture);
      return picture;
    },
    { maxBytes: maxFrames * 400 },
  );
  return { cache, loads, made };
}

describe("BitmapCache", () => {
  it("asks once for a frame, however often it is wanted", async () => {
    const { cache, loads } = cacheOf(5);
    const [a, b] = await Promise.all([cache.fetch(3), cache.fetch(3)]);
    expect(a).toBe(b);
    expect(await cache.fetch(3)).toBe(a);
    expect(loads).toEqual([3]);
  });

  it("stays within its bytes, lets the least recently used go and closes it", async () => {
    const { cache, made } = cacheOf(3);
    for (const n of [0, 1, 2]) await cache.fetch(n);
    cache.get(0);
    await cache.fetch(3);
    expect(cache.keys()).toEqual([2, 0, 3]);
    expect(made.find((p) => p.frame === 1)?.closed).toBe(true);
    expect(made.find((p) => p.frame === 0)?.closed).toBe(false);
  });

  it("drops stale requests and keeps nothing of them", async () => {
    const { cache } = cacheOf(5);
    const stale = cache.fetch(7);
    const wanted = cache.fetch(8);
    cache.keepOnly([8]);
    await expect(stale).rejects.toThrow();
    await wanted;
    expect(cache.keys()).toEqual([8]);
  });

  it("can ask again for a frame after it was dropped", async () => {
    const { cache, loads } = cacheOf(5);
    const stale = cache.fetch(7);
    cache.keepOnly([]);
    const again = cache.fetch(7);
    await expect(stale).rejects.toThrow();
    await expect(again).resolves.toMatchObject({ frame: 7 });
    expect(loads).toEqual([7, 7]);
  });

  it("lets a failed frame be tried again", async () => {
    let fail = true;
    const cache = new BitmapCache<number, Fake>(
      async (frame) => {
        if (fail) throw new Error("offline");
        return new Fake(frame);
      },
      { maxBytes: 4000 },
    );
    await expect(cache.fetch(1)).rejects.toThrow("offline");
    fail = false;
    await expect(cache.fetch(1)).resolves.toMatchObject({ frame: 1 });
  });

  it("names the loaded ranges", async () => {
    const { cache } = cacheOf(9);
    for (const n of [5, 3, 4, 9]) await cache.fetch(n);
    expect(runsOf(cache.keys())).toEqual([
      [3, 5],
      [9, 9],
    ]);
  });
});

describe("BitmapCache with keys of several parts", () => {
  it("tells them apart by their name, and closes what arrives after it was cleared", async () => {
    const pictures: Fake[] = [];
    const cache = new BitmapCache<{ tile: number }, Fake>(
      async ({ tile }) => {
        await Promise.resolve();
        const picture = new Fake(tile);
        pictures.push(picture);
        return picture;
      },
      { maxBytes: 4000, nameOf: ({ tile }) => tile },
    );
    expect(await cache.fetch({ tile: 1 })).toBe(await cache.fetch({ tile: 1 }));
    const late = cache.fetch({ tile: 2 });
    cache.clear();
    await expect(late).rejects.toThrow("no longer wanted");
    expect(pictures.map((picture) => picture.closed)).toEqual([true, true]);
    expect(cache.keys()).toEqual([]);
  });
});

describe("neighbours", () => {
  it("looks ahead in the direction of travel and stays inside the recording", () => {
    expect(neighbours(2, -1, 100, 4, 1)).toEqual([1, 0, 3]);
    expect(neighbours(98, 1, 100, 3, 1)).toEqual([99, 97]);
  });
});
