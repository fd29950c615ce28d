import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../testing/server";
import { ApiError } from "../../core/api";
import { outbox } from "../../core/outbox";
import { survey } from "../../core/survey";
import type { Survey, WheelPair } from "../../core/types";
import { imagePoint } from "../../viewer/points";
import { TrafficModel } from "./model";

let server: FakeServer;
let model: TrafficModel;
let pairs: WheelPair[];
let made_ids = 0;
const quiet = () => vi.advanceTimersByTimeAsync(20);

beforeEach(() => {
  vi.useFakeTimers();
  pairs = [];
  server = new FakeServer();
  server.on("GET", /\/recordings$/, () => [recording()]);
  server.on("GET", /\/surveys\/5\/vehicles$/, () => [vehicle(), vehicle([], { id: 8, number: 8 })]);
  server.on("GET", /\/checks\/traffic$/, () => ({ poses: [], pairs }));
  server.on("POST", /^\/vehicles\/(\d+)\/wheel-pair$/, (match, body) => {
    const vehicle_id = Number(match[1]);
    if (body["seen"] !== (pairs.find((one) => one.vehicle_id === vehicle_id)?.id ?? 0)) throw 409;
    const made = { ...body, vehicle_id, id: ++made_ids, withdrawn: false } as unknown as WheelPair;
    pairs = [...pairs.filter((one) => one.vehicle_id !== vehicle_id), made];
    return made;
  });
  server.on("DELETE", /^\/vehicles\/(\d+)\/wheel-pair\?seen=\d+$/, (match) => {
    const gone = pairs.find((one) => one.vehicle_id === Number(match[1]));
    pairs = pairs.filter((one) => one !== gone);
    return { ...gone, withdrawn: true };
  });
  model = new TrafficModel(5);
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const both = async (): Promise<void> => {
  model.stage.place(imagePoint(100, 300));
  model.stage.place(imagePoint(180, 302));
  await quiet();
};

describe("the direction of travel", () => {
  it("comes up when it is tried again after a failure", async () => {
    server.on("GET", /\/checks\/traffic$/, () => {
      throw 400;
    });
    await model.load(null);
    expect(model.problem.value).toBeInstanceOf(ApiError);
    server.on("GET", /\/checks\/traffic$/, () => ({ poses: [], pairs }));
    await model.load(null);
    expect(model.problem.value).toBeNull();
    expect(model.loaded.value).toBe(true);
  });

  it("reads the survey again after a turn was taken back", async () => {
    const pose = { pose_id: 1, turned_from: 9, recordings: [{ id: 1 }] };
    server.on("GET", /\/checks\/traffic$/, () => ({ poses: [pose], pairs }));
    const read = vi.fn(() => survey.value);
    server.on("GET", /^\/surveys\/5$/, read);
    survey.value = { id: 5 } as unknown as Survey;
    await model.load(null);
    await quiet();
    await model.turnBack();
    await quiet();
    expect(server.writes).toEqual(["PUT /recordings/1"]);
    expect(read).toHaveBeenCalledOnce();
    survey.value = null;
  });

  it("shows no turn of a pose whose recording was left before it came", async () => {
    let turned = (_: object) => {};
    server.on("GET", /\/recordings$/, () => [1, 2].map((id) => recording({ id, pose_id: id })));
    server.on("GET", /\/checks\/traffic$/, () => ({ poses: [{ pose_id: 1 }, { pose_id: 2 }], pairs }));
    server.on("GET", /\/poses\/1\/turn$/, () => new Promise((come) => (turned = come)));
    await model.load(7);
    const looked = model.previewTurn();
    await quiet();
    model.chooseRecording(2);
    turned({ pose_id: 1, turn_rad: 0.01 });
    await looked;
    expect(model.preview.value).toBeNull();
  });

  it("takes two clicks on one frame, and undo and redo take the pair out and in where it was clicked", async () => {
    await model.load(7);
    await quiet();
    await both();
    expect(pairs).toMatchObject([{ vehicle_id: 7, frame: 40, first: [100, 300], second: [180, 302] }]);
    expect(model.clicks.first.value).toBeNull();
    model.openNext(1);
    await model.history.undo();
    expect(pairs).toEqual([]);
    expect(model.vehicleId.value).toBe(7);
    await model.history.redo();
    expect(pairs).toHaveLength(1);
    await model.withdraw();
    await model.history.undo();
    expect(pairs).toHaveLength(1);
  });

  it("says why a pair was refused, and keeps no step of it", async () => {
    server.on("POST", /wheel-pair$/, () => {
      throw 422;
    });
    await model.load(7);
    await quiet();
    await both();
    expect(model.refused.value).toBeInstanceOf(ApiError);
    expect(model.history.undoLabel.value).toBeNull();
    expect(model.clicks.first.value).toBeNull();
  });

  it("keeps a pair over a closed page without a connection, and sends it once from the next", async () => {
    await model.load(7);
    await quiet();
    server.down = true;
    await both();
    expect(model.pair.value).toMatchObject({ frame: 40, first: [100, 300] });
    expect(model.history.undoLabel.value).toContain("tyres");
    model.close();
    outbox.open(null);
    server.down = false;
    outbox.open(1);
    await quiet();
    expect(server.writes).toEqual(["POST /vehicles/7/wheel-pair"]);
    expect(pairs).toHaveLength(1);
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("asks where somebody else clicked meanwhile, with both values", async () => {
    await model.load(7);
    await quiet();
    const theirs = { id: 99, vehicle_id: 7, frame: 41, first: [1, 2], second: [3, 4], withdrawn: false };
    pairs = [theirs as unknown as WheelPair];
    await both();
    const wish = outbox.get("wheel-pair.7");
    expect(wish).toMatchObject({
      state: "conflict",
      mine: "frame 40, at 100.0, 300.0 and 180.0, 302.0\u00a0px",
    });
    expect(wish && outbox.theirs(wish)).toContain("frame 41");
    expect(pairs).toEqual([theirs]);
    outbox.resolve("wheel-pair.7", "mine");
    await quiet();
    expect(pairs).toMatchObject([{ frame: 40 }]);
  });

  it("forgets the first tyre on another frame, and lets Esc and Ctrl+Z take it back", async () => {
    await model.load(7);
    await quiet();
    model.stage.place(imagePoint(100, 300));
    expect(model.stage.hint.value).toContain("other tyre");
    model.reel.player.value?.step(1);
    await quiet();
    expect(model.clicks.first.value).toBeNull();
    for (const takeBack of [() => model.stage.back(), () => model.stage.cancel()]) {
      model.stage.place(imagePoint(100, 300));
      expect(takeBack()).toBe(true);
      expect(model.clicks.first.value).toBeNull();
    }
    expect(server.writes.filter((write) => write.includes("wheel-pair"))).toEqual([]);
  });

  it("keeps the keyboard's cursor on the picture and in sight", async () => {
    await model.load(7);
    await quiet();
    const { stage } = model;
    stage.view.value = stage.view.value.resized({ width: 640, height: 480 }).zoom([0, 0] as never, 4);
    stage.keyboard.toggle();
    for (let i = 0; i < 100; i += 1) stage.nudge(10, 0);
    const cursor = stage.cursor.value ?? imagePoint(0, 0);
    expect(cursor[0]).toBe(639);
    expect(stage.view.value.toScreen(cursor)[0]).toBeLessThanOrEqual(640);
  });
});
