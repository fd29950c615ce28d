import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording } from "../../../testing/server";
import { imagePoint } from "../../viewer/points";
import { AgainSession } from "./session";

let server: FakeServer;
let session: AgainSession;
const quiet = () => vi.advanceTimersByTimeAsync(20);

beforeEach(async () => {
  vi.useFakeTimers();
  server = new FakeServer();
  const one = { vehicle_id: 7, vehicle_number: 7, recording_id: 1, target: "roof" };
  server.on("GET", /\/repeats\/sample/, () => [
    { ...one, measurement_id: 51, frame: 40 },
    { ...one, measurement_id: 52, frame: 44 },
    { ...one, measurement_id: 53, frame: 48 },
  ]);
  server.on("GET", /\/recordings$/, () => [recording()]);
  session = new AgainSession(5, true);
  await session.load();
  await quiet();
});

afterEach(() => {
  session.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe("a run of second clicks", () => {
  it("goes on by itself, and takes back and does again what was stored or passed over", async () => {
    session.stage.place(imagePoint(100, 400));
    session.stage.place(imagePoint(101, 250));
    await quiet();
    expect(session.current.value?.measurement_id).toBe(52);
    session.skip();
    expect([session.at.value, session.stored.value]).toEqual([2, 1]);
    await session.history.undo();
    expect([session.at.value, session.stored.value]).toEqual([1, 1]);
    await session.history.undo();
    expect([session.at.value, session.stored.value]).toEqual([0, 0]);
    expect(server.stored.get(1)?.withdrawn).toBe(true);
    await session.history.redo();
    await session.history.undo();
    await session.history.redo();
    expect(session.at.value).toBe(1);
    expect(server.stored.get(1)?.withdrawn).toBe(false);
    await quiet();
    expect(session.reel.seen.value).toBe(44);
  });
});
