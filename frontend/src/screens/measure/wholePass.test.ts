import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../testing/server";
import type { Said } from "../../core/messages";
import { imagePoint } from "../../viewer/points";
import { MeasureModel } from "./model";

let server: FakeServer;
let model: MeasureModel;
const quiet = () => vi.advanceTimersByTimeAsync(20);
const at = (x: number, y: number) => imagePoint(x, y);

const POINTS = [
  { frame: 39, point: "contact", at: [80, 400], sigma_px: [0.1, 0.1] },
  { frame: 39, point: "target", at: [71, 300], sigma_px: [0.1, 0.1] },
  { frame: 40, point: "contact", at: [100, 400], sigma_px: [0.1, 0.1] },
];
const BLURRED = { code: "followed-blurred", values: {}, message: "It is too blurred here." };
const DROPPED = [{ frame: 40, point: "target", reason: BLURRED }];
const HEIGHT = { status: "ok", height_m: 0.81, U95_height_m: 0.01, u_height_m: 0.005, frames: 2, budget: [] };

function answers(reason: Said | null = null): void {
  server.on("POST", /^\/vehicles\/7\/follow$/, () =>
    reason === null
      ? { reason, points: POINTS, dropped: DROPPED, height: HEIGHT }
      : { reason, points: [], dropped: [], height: null },
  );
}

beforeEach(async () => {
  vi.useFakeTimers();
  localStorage.clear();
  server = new FakeServer();
  model = new MeasureModel(1);
  model.reel.recordings.value = [recording()];
  model.vehicles.takeAll([vehicle([])]);
  model.open(vehicle([]));
  await quiet();
  for (const point of [at(100, 400), at(101, 250), at(90, 300)]) {
    model.points.place(point);
    await quiet();
  }
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const key = () => model.entries.value[1]?.key ?? null;

describe("following through the pass", () => {
  it("shows the points and which frames are whole, and stores nothing", async () => {
    answers();
    const before = server.writes.length;
    await model.whole.start(key());
    expect(model.whole.frames.value).toEqual([
      { frame: 39, whole: true },
      { frame: 40, whole: false },
    ]);
    expect(model.whole.now.value?.answer.height?.height_m).toBe(0.81);
    expect(server.writes.slice(before)).toEqual(["POST /vehicles/7/follow"]);
  });

  it("keeps it as one revision that asks the server to follow, and can be undone", async () => {
    answers();
    await model.whole.start(key());
    model.whole.keep();
    await quiet();
    expect(server.writes.at(-1)).toMatch(/^PUT \/measurements\//);
    expect(model.entries.value[1]?.values.follow).toEqual({ second: null });
    expect(model.whole.now.value).toBeNull();
    await model.history.undo();
    await quiet();
    expect(model.entries.value[1]?.values.follow).toBeUndefined();
  });

  it("leaves everything as it was on Esc", async () => {
    answers();
    await model.whole.start(key());
    expect(model.whole.cancel()).toBe(true);
    expect(model.whole.now.value).toBeNull();
    expect(model.whole.cancel()).toBe(false);
  });

  it("shows nothing where nothing can be followed", async () => {
    answers({
      code: "follow-not-from-here",
      values: {},
      message: "The vehicle cannot be followed from this frame.",
    });
    await model.whole.start(key());
    expect(model.whole.now.value).toBeNull();
    expect(model.whole.looking.value).toBe(false);
  });
});
