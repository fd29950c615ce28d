import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../../testing/server";
import { tryAgainNow } from "../../../core/api";
import { outbox } from "../../../core/outbox";
import type { Vehicle } from "../../../core/types";
import { MeasureModel } from "../model";
import { joinPass, splitPass } from "./actions";

let server: FakeServer;
let model: MeasureModel;
let there: Vehicle[];
const quiet = () => vi.advanceTimersByTimeAsync(20);
const spans = () =>
  model.vehicles.list.value.map((one) => `${one.number}: ${one.first_frame} to ${one.last_frame}`);

function change(id: number, facts: Partial<Vehicle>): Vehicle {
  const now = there.find((one) => one.id === id);
  if (!now) throw 404;
  const next = { ...now, ...facts, version: now.version + 1 };
  there = there.map((one) => (one.id === id ? next : one));
  return next;
}

const gone: Vehicle[] = [];

beforeEach(async () => {
  vi.useFakeTimers();
  history.replaceState(null, "", "/surveys/1/measure?vehicle=7");
  there = [vehicle(), vehicle([], { id: 8, number: 8, first_frame: 60, last_frame: 80, best_frame: 70 })];
  gone.length = 0;
  server = new FakeServer();
  server.on("GET", /\/recordings$/, () => [recording()]);
  server.on("GET", /\/surveys\/1\/vehicles/, () => there);
  server.on("GET", /^\/vehicles\/(\d+)$/, (match) => there.find((one) => one.id === Number(match[1])));
  server.on("PUT", /^\/vehicles\/(\d+)$/, (match, body) => change(Number(match[1]), body));
  server.on("POST", /\/recordings\/1\/vehicles$/, (_match, body) => {
    const made = vehicle([], { id: 9, number: 9, ...body });
    there = [...there, made];
    return made;
  });
  server.on("DELETE", /^\/vehicles\/(\d+)\?/, (match) => {
    const id = Number(match[1]);
    gone.push(...there.filter((one) => one.id === id));
    there = there.filter((one) => one.id !== id);
    return null;
  });
  server.on("POST", /^\/vehicles\/(\d+)\/restore$/, (match) => {
    const back = gone.find((one) => one.id === Number(match[1]));
    if (!back) throw 404;
    there = [...there, { ...back, version: back.version + 1 }];
    return there.at(-1);
  });
  server.on("POST", /^\/vehicles\/7\/split$/, (_match, body) => {
    const frame = Number(body["frame"]);
    const later = vehicle([], { id: 10, number: 10, first_frame: frame, last_frame: 50, best_frame: null });
    const earlier = change(7, { last_frame: frame - 1, best_frame: null });
    there = [...there, later];
    return { earlier, later };
  });
  server.on("POST", /^\/vehicles\/7\/join$/, () => {
    gone.push(...there.filter((one) => one.id === 8));
    there = there.filter((one) => one.id !== 8);
    return change(7, { last_frame: 80 });
  });
  model = new MeasureModel(1);
  await model.load();
  await quiet();
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

const undo = async () => {
  await model.history.undo();
  await vi.advanceTimersByTimeAsync(1000);
};
const redo = async () => {
  await model.history.redo();
  await vi.advanceTimersByTimeAsync(1000);
};

describe("passes", () => {
  it("split, put together again and split once more, each as change sets", async () => {
    model.reel.show(1, 44);
    await quiet();
    await splitPass(model);
    expect(spans()).toEqual(["7: 30 to 43", "8: 60 to 80", "10: 44 to 50"]);
    await undo();
    expect(spans()).toEqual(["7: 30 to 50", "8: 60 to 80"]);
    expect(there.map((one) => [one.id, one.last_frame, one.best_frame])).toEqual([
      [7, 50, 40],
      [8, 80, 70],
    ]);
    await redo();
    expect(spans()).toEqual(["7: 30 to 43", "8: 60 to 80", "10: 44 to 50"]);
    expect(there.find((one) => one.id === 7)?.last_frame).toBe(43);
  });

  it("joined, taken apart and joined again", async () => {
    await joinPass(model);
    expect(spans()).toEqual(["7: 30 to 80"]);
    await undo();
    expect(spans()).toEqual(["7: 30 to 50", "8: 60 to 80"]);
    expect(there.map((one) => one.id).sort()).toEqual([7, 8]);
    await redo();
    expect(spans()).toEqual(["7: 30 to 80"]);
  });

  it("marked without a connection are kept, and made once when it is back", async () => {
    server.down = true;
    model.passes.mark("first");
    model.reel.show(1, 44);
    model.passes.mark("last");
    await quiet();
    expect(outbox.counts.value.kept).toBe(1);
    server.down = false;
    tryAgainNow();
    await vi.advanceTimersByTimeAsync(100);
    expect(server.writes).toEqual(["POST /recordings/1/vehicles"]);
    expect(spans()).toHaveLength(3);
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("stay with what was opened while one was being made or brought back", async () => {
    const [first, second] = there as [Vehicle, Vehicle];
    model.passes.mark("first");
    model.passes.mark("last");
    model.open(second);
    await vi.advanceTimersByTimeAsync(100);
    expect(spans()).toHaveLength(3);
    expect(model.vehicleId.value).toBe(second.id);
    expect(first.id).toBe(7);
  });
});
