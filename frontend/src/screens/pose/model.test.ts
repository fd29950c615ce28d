import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording } from "../../../testing/server";
import { ApiError } from "../../core/api";
import { lengthUnit } from "../../core/units";
import { PoseModel } from "./model";

let server: FakeServer;
let model: PoseModel;
const quiet = () => vi.advanceTimersByTimeAsync(20);

beforeEach(() => {
  vi.useFakeTimers();
  history.replaceState(null, "", "/surveys/5/pose");
  server = new FakeServer();
  server.on("GET", /\/recordings$/, () => [
    recording({ id: 1, pose_id: 3 }),
    recording({ id: 2, pose_id: null }),
  ]);
  server.on("GET", /\/cameras$/, () => [
    { id: 1, name: "left", current_calibration_id: 4, calibrations: [{ id: 4 }] },
  ]);
  server.on("GET", /\/poses$/, () => []);
  server.on("POST", /\/board$/, (_match, body) => ({ found: true, frame: body["frame"], corners_px: [] }));
  model = new PoseModel(5);
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

describe("the road pose page", () => {
  it("comes up when it is tried again after a failure", async () => {
    server.on("GET", /\/poses$/, () => {
      throw 400;
    });
    await model.load();
    expect(model.problem.value).toBeInstanceOf(ApiError);
    server.on("GET", /\/poses$/, () => []);
    await model.load();
    expect(model.problem.value).toBeNull();
    expect(model.loaded.value).toBe(true);
  });

  it("opens the recording that has no pose yet, with its camera's calibration", async () => {
    await model.load();
    await quiet();
    expect(model.reel.recording.value?.id).toBe(2);
    expect(model.reel.seen.value).toBe(0);
    expect(model.form.value.calibrationId).toBe(4);
  });

  it("marks the board's frames in their order", async () => {
    await model.load();
    await quiet();
    model.reel.player.value?.go(20);
    model.mark("first");
    model.reel.player.value?.go(10);
    model.mark("last");
    expect(model.form.value).toMatchObject({ first: 10, last: 10 });
  });

  it("offers the frames in which a board that was found stands still, until some are marked by hand", async () => {
    server.on("POST", /\/board\/span$/, () => ({ first_frame: 3, last_frame: 60 }));
    await model.load();
    await vi.advanceTimersByTimeAsync(1000);
    expect(model.finding.value?.found).toBe(true);
    expect(model.offered.value).toEqual({ first_frame: 3, last_frame: 60 });
    model.takeOffered();
    expect(model.form.value).toMatchObject({ first: 3, last: 60 });
    expect(model.offered.value).toBeNull();
  });

  it("shows neither pose nor board of a recording that was left before they came", async () => {
    let pose = (_: object) => {};
    let board = (_: object) => {};
    server.on("GET", /\/poses\/3$/, () => new Promise((come) => (pose = come)));
    server.on("POST", /\/recordings\/2\/board$/, () => new Promise((come) => (board = come)));
    await model.load();
    await vi.advanceTimersByTimeAsync(400);
    expect(model.looking.value).toBe(true);
    const found: unknown[] = [];
    model.finding.subscribe((one) => found.push(one));
    const opening = model.openRecording(1);
    board({ found: true, frame: 0, corners_px: [] });
    await quiet();
    expect(found.filter(Boolean)).toEqual([]);
    await model.openRecording(2);
    pose({ id: 3, recording_id: 1, first_frame: 0, last_frame: 9 });
    await opening;
    expect(model.pose.value).toBeNull();
  });

  it("does not show the pose that was found for a recording that was left", async () => {
    const found = vi.fn();
    server.on("GET", /\/poses\/4$/, found);
    server.on("POST", /\/recordings\/2\/poses$/, () => ({ id: 9, state: "queued" }));
    server.on("GET", /\/jobs\/9$/, () => ({ id: 9, state: "done", result: { pose_id: 4 } }));
    server.on("GET", /\/poses\/3$/, () => new Promise(() => {}));
    await model.load();
    model.set({ square: "100", referenceHeight: "0.6", first: 0, last: 9 });
    const run = model.run();
    void model.openRecording(1);
    await vi.advanceTimersByTimeAsync(5000);
    await run;
    expect(server.writes).toContain("POST /recordings/2/poses");
    expect(model.job.value).toBeNull();
    expect(found).not.toHaveBeenCalled();
    expect(model.found.value).toBe(0);
  });

  it("asks for the tape anew in the next recording, and keeps the board", async () => {
    await model.load();
    model.set({ square: "101.6", referenceHeight: "0.4572", uReferenceHeight: "5", uLean: "0.5", uBow: "1" });
    server.on("GET", /\/recordings$/, () => [1, 2].map((id) => recording({ id, pose_id: null })));
    await model.load();
    await model.openRecording(1);
    expect(model.form.value).toMatchObject({ referenceHeight: "", uReferenceHeight: "", uLean: "0.3" });
    expect(model.form.value).toMatchObject({ square: "101.6", uBow: "1" });
  });

  it("keeps what is typed when the unit becomes another: the length stays, its number changes", async () => {
    await model.load();
    model.set({ square: "101.6", referenceHeight: "0.4572", uBow: "" });
    lengthUnit.value = "ft";
    expect(model.form.value).toMatchObject({ square: "4", referenceHeight: "1.5", uBow: "" });
    lengthUnit.value = "m";
    expect(model.form.value).toMatchObject({ square: "101.6", referenceHeight: "0.4572" });
  });
});
