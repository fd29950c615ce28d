import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Recording } from "../core/types";
import { Player } from "./player";

/** Frames come only when let go, so that a test decides who overtakes whom. */
const waiting = new Map<number, () => void>();
const recording = {
  id: 1,
  frame_count: 100,
  width_px: 640,
  height_px: 480,
  vfr: true,
  thumbs: [],
} as unknown as Recording;
/** A recording whose second second has half the frame rate. */
const time_s = Array.from({ length: 100 }, (_, n) => (n < 30 ? n / 30 : 1 + (n - 30) / 15));

let player: Player;
const settle = () => new Promise((done) => setTimeout(done, 2));

async function letGo(frame: number): Promise<void> {
  waiting.get(frame)?.();
  waiting.delete(frame);
  await settle();
}

beforeEach(() => {
  waiting.clear();
  vi.stubGlobal("createImageBitmap", async () => ({ width: 640, height: 480, close() {} }));
  vi.stubGlobal("fetch", (url: string) => {
    const frame = /frames\/(\d+)\.jpg/.exec(url)?.[1];
    if (frame === undefined) {
      const table = { first: 0, pts: [], time_s, crc: time_s.map((_, n) => 1000 + n), key: [] };
      return Promise.resolve(new Response(JSON.stringify(table)));
    }
    return new Promise((resolve) => {
      waiting.set(Number(frame), () => resolve(new Response("", { headers: { "Sightline-Frame": frame } })));
    });
  });
  player = new Player(1, 10);
});

afterEach(() => {
  player.close();
  vi.unstubAllGlobals();
});

describe("Player", () => {
  it("asks for its first frame before the recording is known", async () => {
    expect(waiting.has(10)).toBe(true);
    await letGo(10);
    expect(player.shown.value?.frame).toBe(10);
    expect(player.loading.value).toBe(false);
  });

  it("never shows an older answer over a newer wish, but shows the way there", async () => {
    await letGo(10);
    player.describe(recording);
    player.go(11);
    player.go(12);
    await letGo(12);
    expect(player.shown.value?.frame).toBe(12);
    await letGo(11);
    expect(player.shown.value?.frame).toBe(12);
    player.go(13);
    player.go(14);
    await letGo(13);
    expect(player.shown.value?.frame).toBe(13);
    expect(player.loading.value).toBe(true);
  });

  it("stays inside the recording", () => {
    player.describe(recording);
    player.go(1e9);
    expect(player.frame.value).toBe(99);
    player.step(Number.NEGATIVE_INFINITY);
    expect(player.frame.value).toBe(0);
  });

  it("goes a second by the frames' own times, not by a frame rate", async () => {
    player.describe(recording);
    await settle();
    player.go(0);
    player.stepSeconds(1);
    expect(player.frame.value).toBe(30);
    player.stepSeconds(1);
    expect(player.frame.value).toBe(45);
  });

  it("asks with the frame's checksum once it is known, so that it may be kept for ever", async () => {
    const asked = vi.spyOn(globalThis, "fetch");
    player.describe(recording);
    await settle();
    player.go(55);
    expect(asked.mock.calls.some(([url]) => String(url).endsWith("/frames/55.jpg?v=1055"))).toBe(true);
  });

  it("refuses a picture that is not the frame asked for", async () => {
    const other = new Player(1, 20);
    vi.stubGlobal("fetch", async () => new Response("", { headers: { "Sightline-Frame": "21" } }));
    other.go(30);
    await settle();
    expect(other.shown.value).toBeNull();
    expect(other.problem.value).toContain("frame 21 for frame 30");
    other.close();
  });
});

describe("Player, ahead and meanwhile", () => {
  const withThumbs = {
    ...recording,
    thumbs: [0, 25, 50, 75].map((frame) => ({ frame, url: `/thumbs/${frame}` })),
  };

  it("shows the nearest thumbnail after a jump, and no frame that could be clicked on", async () => {
    await letGo(10);
    player.describe(withThumbs as unknown as Recording);
    await settle();
    player.go(60);
    await settle();
    expect(player.preview.value?.frame).toBe(50);
    expect(player.shown.value).toBeNull();
    await letGo(60);
    expect(player.preview.value).toBeNull();
    expect(player.shown.value?.frame).toBe(60);
  });

  it("asks once for a thumbnail that is on its way", async () => {
    const asked = vi.spyOn(globalThis, "fetch");
    const thumbs = () => asked.mock.calls.filter(([url]) => String(url).startsWith("/thumbs/"));
    player.describe(withThumbs as unknown as Recording);
    player.openAt(11);
    player.go(12);
    await settle();
    expect(thumbs()).toHaveLength(1);
    expect(player.preview.value?.frame).toBe(0);
    player.go(10);
    await settle();
    expect(thumbs()).toHaveLength(1);
  });

  it("keeps the picture for a small step", async () => {
    await letGo(10);
    player.describe(withThumbs as unknown as Recording);
    player.go(11);
    await settle();
    expect(player.preview.value).toBeNull();
    expect(player.shown.value?.frame).toBe(10);
  });

  it("fetches what is expected next when the neighbours are here", async () => {
    player.describe(recording);
    player.expect([70, 71]);
    await letGo(10);
    for (const n of [11, 12, 13, 14, 15, 16, 17, 18, 9, 8]) await letGo(n);
    expect([...waiting.keys()]).toEqual([70]);
    await letGo(70);
    expect([...waiting.keys()]).toEqual([71]);
    await letGo(71);
    player.go(70);
    expect(player.shown.value?.frame).toBe(70);
  });

  it("drops a request for a frame that is no longer wanted", async () => {
    const asked = vi.spyOn(globalThis, "fetch");
    player.describe(recording);
    player.go(60);
    const signal = asked.mock.calls.find(([url]) => String(url).includes("frames/60.jpg"))?.[1]?.signal;
    expect(signal?.aborted).toBe(false);
    player.go(20);
    expect(signal?.aborted).toBe(true);
  });
});
