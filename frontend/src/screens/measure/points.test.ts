import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../testing/server";
import { connection, tryAgainNow } from "../../core/api";
import { toasts } from "../../core/toasts";
import type { Target } from "../../core/types";
import { imagePoint, pair } from "../../viewer/points";
import { MeasureModel } from "./model";
import { idOf } from "./standing";

let server: FakeServer;
let model: MeasureModel;
const quiet = () => vi.advanceTimersByTimeAsync(20);

beforeEach(async () => {
  vi.useFakeTimers();
  localStorage.clear();
  toasts.value = [];
  server = new FakeServer();
  model = new MeasureModel(1);
  model.reel.recordings.value = [recording()];
  model.vehicles.takeAll([vehicle([])]);
  model.open(vehicle([]));
  await quiet();
  // a window as large as the picture
  model.stage.view.value = model.stage.view.value.resized({ width: 640, height: 480 });
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const at = (x: number, y: number) => imagePoint(x, y);
const heights = () =>
  model.entries.value.filter((entry) => !entry.values.withdrawn).map((entry) => entry.values.target);

describe("measuring with clicks", () => {
  it("stores three targets from four clicks, each in one request", async () => {
    for (const point of [at(100, 400), at(101, 250), at(90, 300), at(20, 330)]) {
      model.points.place(point);
      await quiet();
    }
    expect(heights()).toEqual(["roof", "driver_eye", "taillight"]);
    expect(server.writes).toEqual(Array(3).fill("POST /vehicles/7/measurements"));
    expect(model.flow.value.target).toBeNull();
    expect([...server.stored.values()].every((m) => m.contact[0] === 100 && m.contact[1] === 400)).toBe(true);
  });

  it("keeps what was stored while the vehicle was being read, and stores the next click of the next target", async () => {
    model.loaded.value = true;
    const reads: (() => void)[] = [];
    server.on("GET", /^\/vehicles\/7$/, async () => {
      const now = vehicle([...server.stored.values()]);
      await new Promise<void>((answered) => reads.push(answered));
      return now;
    });
    for (const point of [at(100, 400), at(101, 250)]) {
      model.points.place(point);
      await quiet();
    }
    await vi.advanceTimersByTimeAsync(300); // the vehicle is asked for, which has a roof
    expect(reads).toHaveLength(1);
    model.points.place(at(90, 300));
    await quiet();
    reads[0]?.(); // a slow answer, of before the eye was stored
    await quiet();
    expect(heights()).toEqual(["roof", "driver_eye"]);
    model.points.place(at(20, 330));
    await quiet();
    expect([...server.stored.values()].map((m) => m.target)).toEqual(["roof", "driver_eye", "taillight"]);
    await vi.advanceTimersByTimeAsync(300);
    for (const answer of reads) answer();
    await quiet();
    expect(heights()).toEqual(["roof", "driver_eye", "taillight"]);
    expect(model.flow.value.target).toBeNull();
  });

  describe("a contact click that snaps to the tyre", () => {
    beforeEach(() =>
      server.on("POST", /^\/vehicles\/7\/frames\/40\/snap$/, () => ({
        contact: [103.25, 412.5],
        expected_px: 0.4,
        reason: null,
      })),
    );

    it("goes to where the server says, and says where it was clicked when it is stored", async () => {
      model.points.place(at(100, 400));
      expect(model.contact.value).toEqual([100, 400]);
      await quiet();
      expect(model.contact.value).toEqual([103.25, 412.5]);
      expect(model.snapping.shown()?.from).toEqual([100, 400]);
      for (const point of [at(101, 250), at(90, 300)]) {
        model.points.place(point);
        await quiet();
      }
      for (const body of server.stored.values())
        expect(body).toMatchObject({ contact: [103.25, 412.5], snapped_from: [100, 400], made: "clicked" });
    });

    it("is put back by one undo, and then stored as clicked", async () => {
      model.points.place(at(100, 400));
      await quiet();
      await model.history.undo();
      expect([model.contact.value, model.snapping.shown()]).toEqual([at(100, 400), null]);
      model.points.place(at(101, 250));
      await quiet();
      expect(server.stored.get(1)).toMatchObject({ contact: [100, 400], made: "clicked" });
      expect(server.stored.get(1)).not.toHaveProperty("snapped_from");
    });

    it("stays where it is with Shift held, and where something was measured on it first", async () => {
      model.stage.exact = true;
      model.points.place(at(100, 400));
      await quiet();
      expect(model.contact.value).toEqual([100, 400]);
      model.dispatch({ type: "new-contact" });
      model.points.place(at(110, 400));
      model.points.place(at(101, 250));
      await quiet();
      expect(model.contact.value).toEqual([110, 400]);
      expect(server.stored.get(1)).toMatchObject({ contact: [110, 400] });
    });

    it("is no longer said of a contact that was dragged away", async () => {
      model.points.place(at(100, 400));
      await quiet();
      model.points.place(at(101, 250));
      await quiet();
      const key = model.entries.value[0]?.key ?? "";
      model.points.drag(idOf({ key, role: "contact" }), at(120, 410), "move");
      model.points.drag(idOf({ key, role: "contact" }), at(120, 410), "end");
      await quiet();
      expect(server.bodies.at(-1)).toMatchObject({ contact: [120, 410] });
      expect(server.bodies.at(-1)).not.toHaveProperty("snapped_from");
    });
  });

  it("asks for all three on a second frame by one key, in order, with the contact clicked once", async () => {
    const spot = { frame: 52, contact: [140, 400], target_point: [141, 250], assumed_kmh: null, travel_m: 1 };
    const there = { ok: true, frame: 52, spots: [spot] };
    server.on("POST", /second-frame$/, () => ({ ...there, source: "followed", others: [there, there] }));
    for (const point of [at(100, 400), at(101, 250), at(90, 300), at(20, 330)]) {
      model.points.place(point);
      await quiet();
    }
    await model.second.start();
    await quiet();
    model.second.place(at(140, 400));
    for (const target of ["roof", "driver_eye", "taillight"]) {
      expect([model.second.now.value?.target, model.second.awaiting.value]).toEqual([target, "point"]);
      expect(model.second.spots.value).toEqual([spot]);
      model.second.place(at(141, 250));
      await quiet();
    }
    expect(model.second.now.value).toBeNull();
    expect(model.entries.value.map(({ values }) => values.more.map((one) => one.frame))).toEqual([
      [52],
      [52],
      [52],
    ]);
  });

  it("goes on to the next target when one is not visible, and comes back to it when it is", async () => {
    let facts = vehicle([]);
    server.on("PUT", /^\/vehicles\/7$/, (_match, body) => {
      facts = { ...facts, ...body, version: facts.version + 1 };
      return facts;
    });
    server.on("GET", /^\/vehicles\/7$/, () => facts);
    model.askWhyUnseen();
    expect(model.whyUnseen.value).toBe("roof");
    model.setUnseen("roof", "glare");
    await quiet();
    expect(model.vehicle.value?.roof_not_visible).toBe("glare");
    expect([model.flow.value.target, model.whyUnseen.value]).toEqual(["driver_eye", null]);
    model.setUnseen("roof", null);
    expect([model.vehicle.value?.roof_not_visible, model.flow.value.target]).toEqual([null, "roof"]);
    await model.history.undo();
    expect(model.vehicle.value?.roof_not_visible).toBe("glare");
  });

  it("undoes a target, then the contact, and does both again", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    await model.history.undo();
    await quiet();
    expect(heights()).toEqual([]);
    expect(model.flow.value.target).toBe("roof");
    expect(server.stored.get(1)?.withdrawn).toBe(true);
    await model.history.undo();
    expect(model.contact.value).toBeNull();
    await model.history.redo();
    await model.history.redo();
    await quiet();
    expect(heights()).toEqual(["roof"]);
    expect(server.stored.get(1)?.withdrawn).toBe(false);
  });

  it("undoes on the vehicle that it changes: goes there, names it, and brings its contact back", async () => {
    const other = vehicle([], { id: 9, number: 9, best_frame: 80 });
    model.vehicles.take(other);
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    model.open(other);
    await quiet();
    expect(await model.history.undo()).toBe("roof, vehicle 7");
    expect(model.vehicleId.value).toBe(7);
    expect(model.reel.player.value?.frame.value).toBe(40);
    await model.history.undo();
    expect(model.contact.value).toBeNull();
    model.open(other);
    await quiet();
    expect(await model.history.redo()).toBe("contact point, vehicle 7");
    expect(model.vehicleId.value).toBe(7);
    expect(model.contact.value).toEqual([100, 400]);
  });

  it("shows no height of another target, frame or contact under a resting pointer, and asks anew", async () => {
    const live = () => model.geometry.live.value;
    const rest = () => vi.advanceTimersByTimeAsync(200);
    model.points.place(at(100, 400));
    await rest();
    model.stage.hover(at(101, 250));
    await quiet();
    expect(live()?.wish.target).toBe("roof");
    model.points.place(at(101, 250));
    expect(live()).toBeNull();
    await rest();
    expect(live()?.wish).toMatchObject({ target: "driver_eye", point: [101, 250] });
    model.dispatch({ type: "choose", target: "headlight" });
    expect(live()).toBeNull();
    await rest();
    expect(live()?.wish.target).toBe("headlight");
    model.reel.show(1, 41);
    await rest();
    expect(live()).toBeNull();
  });

  it("asks for no height where the contact was clicked, and shows none when the pointer comes back to it", async () => {
    const live = () => model.geometry.live.value;
    model.stage.hover(at(100, 400));
    model.stage.place(at(100, 400));
    // the pointer rests where it clicked, then leaves by a hair
    await vi.advanceTimersByTimeAsync(1000);
    model.stage.hover(at(103, 396));
    await vi.advanceTimersByTimeAsync(1000);
    expect(server.heights).toEqual([]);
    expect(live()).toBeNull();
    model.stage.hover(at(100, 380));
    await quiet();
    expect(live()?.answer?.height_m).toBe(1.5);
    model.stage.hover(at(101, 401));
    expect(live()).toBeNull();
    // an answer that was on its way says nothing there either
    model.stage.hover(at(100, 370));
    model.stage.hover(at(101, 401));
    await quiet();
    expect(live()).toBeNull();
    expect(model.awaiting.value).toBe("point");
  });

  it("asks for no height where the contact was clicked before it went to the tyre", async () => {
    server.on("POST", /\/snap$/, () => ({ contact: [140, 430], expected_px: 0.4, reason: null }));
    model.stage.hover(at(100, 400));
    model.stage.place(at(100, 400));
    await quiet();
    await vi.advanceTimersByTimeAsync(1000);
    expect(model.contact.value).toEqual([140, 430]);
    expect(server.heights).toEqual([]);
    model.stage.hover(at(140, 428));
    await quiet();
    expect(server.heights).toEqual([]);
    model.stage.hover(at(120, 300));
    await quiet();
    expect(server.heights.map((one) => one["target_point"])).toEqual([[120, 300]]);
  });

  it("takes a second frame once for all of a vehicle: one contact, then one click for each target", async () => {
    const there = { ok: true, frame: 44, spots: [] };
    server.on("POST", /second-frame$/, () => ({
      ...there,
      source: "measured",
      words: null,
      others: [there, there],
    }));
    for (const point of [at(100, 400), at(101, 250), at(90, 300), at(20, 330)]) model.points.place(point);
    await quiet();
    await model.second.start();
    await quiet();
    expect(model.reel.player.value?.frame.value).toBe(44);
    expect(model.second.awaiting.value).toBe("contact");
    const asked = server.heights.length;
    model.stage.place(at(140, 400));
    model.stage.hover(at(140, 401));
    await vi.advanceTimersByTimeAsync(1000);
    // at the tyre no height of the frames together is asked for
    expect(server.heights.length).toBe(asked);
    for (const point of [at(141, 250), at(130, 300), at(60, 330)]) {
      expect(model.second.awaiting.value).toBe("point");
      model.stage.place(point);
    }
    await quiet();
    expect(model.second.now.value).toBeNull();
    const stored = [...server.stored.values()].map((m) => [m.target, m.more_frames]);
    expect(stored).toEqual([
      ["roof", [{ frame: 44, contact: [140, 400], target_point: [141, 250] }]],
      ["driver_eye", [{ frame: 44, contact: [140, 400], target_point: [130, 300] }]],
      ["taillight", [{ frame: 44, contact: [140, 400], target_point: [60, 330] }]],
    ]);
  });

  /** All three on frame 40; what is answered to a wish for a second frame, and what was asked with it. */
  async function secondOf(
    first: object,
    ...others: object[]
  ): Promise<{ target: string; others: unknown[] }> {
    let wanted = { target: "", others: [] as unknown[] };
    server.on("POST", /second-frame$/, (_match, body) => {
      wanted = body as typeof wanted;
      return { ...first, source: "measured", words: null, others };
    });
    for (const point of [at(100, 400), at(101, 250), at(90, 300), at(20, 330)]) model.points.place(point);
    await quiet();
    await model.second.start();
    await quiet();
    return wanted;
  }
  const on = (target: Target, frame: number) => ({ target, ok: true, frame, spots: [] });
  const aim = () => [
    model.second.now.value?.target,
    model.reel.player.value?.frame.value,
    model.second.awaiting.value,
  ];

  it("goes to the frame of each target, and clicks the contact once on each of them", async () => {
    const wanted = await secondOf(on("roof", 44), on("driver_eye", 36), on("taillight", 44));
    expect(wanted).toMatchObject({
      target: "roof",
      others: [
        { target: "driver_eye", target_point: [90, 300], more_frames: [] },
        { target: "taillight", target_point: [20, 330], more_frames: [] },
      ],
    });
    expect(aim()).toEqual(["roof", 44, "contact"]);
    model.stage.place(at(140, 400));
    model.stage.place(at(141, 250));
    // the taillight comes first: it is on the frame that is seen, with the contact that stands there
    expect(aim()).toEqual(["taillight", 44, "point"]);
    model.stage.place(at(60, 330));
    await quiet();
    expect(aim()).toEqual(["driver_eye", 36, "contact"]);
    model.stage.place(at(70, 400));
    model.stage.place(at(60, 300));
    await quiet();
    expect(model.second.now.value).toBeNull();
    expect([...server.stored.values()].map((m) => [m.target, m.more_frames])).toEqual([
      ["roof", [{ frame: 44, contact: [140, 400], target_point: [141, 250] }]],
      ["driver_eye", [{ frame: 36, contact: [70, 400], target_point: [60, 300] }]],
      ["taillight", [{ frame: 44, contact: [140, 400], target_point: [60, 330] }]],
    ]);
  });

  it("says which target has no second frame and asks for the others only", async () => {
    const message = "No other frame of the pass shows both points; use a single frame.";
    const none = {
      ok: false,
      frame: null,
      reason: { code: "second-frame-not-shown", values: {}, message },
      spots: [],
    };
    await secondOf({ ...none, target: "roof" }, on("driver_eye", 44), { ...none, target: "taillight" });
    expect(toasts.value.map((one) => one.text)).toEqual([`Roof: ${message} Taillight: ${message}`]);
    expect(aim()).toEqual(["driver_eye", 44, "contact"]);
    model.stage.place(at(140, 400));
    model.stage.place(at(130, 300));
    await quiet();
    expect(model.second.now.value).toBeNull();
    expect([...server.stored.values()].map((m) => m.more_frames?.length)).toEqual([0, 1, 0]);
  });

  it("goes on where somebody went by hand if the next target is seen there, else to its own frame", async () => {
    const spots = [{ frame: 47, contact: [1, 2], target_point: [3, 4], assumed_kmh: null, travel_m: 1 }];
    await secondOf(on("roof", 44), { ...on("driver_eye", 44), spots }, on("taillight", 44));
    model.reel.player.value?.go(47);
    await quiet();
    model.stage.place(at(140, 400));
    model.stage.place(at(141, 250));
    expect(aim()).toEqual(["driver_eye", 47, "point"]);
    model.stage.place(at(130, 300));
    await quiet();
    expect(aim()).toEqual(["taillight", 44, "contact"]);
  });

  it("turns the driver to the other side by one key, and keeps it with the vehicle", async () => {
    let version = 1;
    server.on("PUT", /^\/vehicles\/7$/, (_match, body) => {
      version += 1;
      return vehicle([], { ...body, version });
    });
    expect(model.insets.side.value).toBeNull();
    model.insets.turnSide();
    expect(model.insets.side.value).toBe("near");
    model.insets.turnSide();
    expect(model.insets.side.value).toBe("far");
    await vi.advanceTimersByTimeAsync(1000);
    expect(server.writes.filter((one) => one === "PUT /vehicles/7").length).toBeGreaterThan(0);
    model.open(vehicle([], { id: 9, number: 9 }));
    model.open(model.vehicles.get(7) ?? vehicle());
    expect(model.insets.side.value).toBe("far");
  });

  it("says nothing of its own while the server is away, and asks again when it is back", async () => {
    server.down = true;
    model.points.place(at(100, 400));
    await quiet();
    model.points.hover(at(101, 250));
    await quiet();
    expect(connection.value.lost).toBe(true);
    expect(model.geometry.problem.value).toBeNull();
    expect(model.geometry.live.value).toBeNull();
    server.down = false;
    tryAgainNow();
    await quiet();
    expect(model.geometry.axes.value?.ok).toBe(true);
    expect(model.geometry.live.value?.answer?.height_m).toBe(1.5);
  });

  it("moves a contact for all measurements that stand on it, as one step", async () => {
    for (const point of [at(100, 400), at(101, 250), at(90, 300)]) model.points.place(point);
    await quiet();
    const selection = model.standing.selectable().find((one) => one.role === "contact");
    if (!selection) throw new Error("no contact to drag");
    model.points.drag(idOf(selection), at(104, 398), "move");
    model.points.drag(idOf(selection), at(105, 397), "end");
    await quiet();
    expect([...server.stored.values()].map((m) => m.contact)).toEqual([
      [105, 397],
      [105, 397],
    ]);
    expect(model.contact.value && pair(model.contact.value)).toEqual([105, 397]);
    await model.history.undo();
    await quiet();
    expect([...server.stored.values()].map((m) => m.contact)).toEqual([
      [100, 400],
      [100, 400],
    ]);
  });

  it("makes one revision of a run of nudges", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    model.points.selectNext();
    for (let i = 0; i < 5; i += 1) model.points.nudge(0, -0.1);
    model.points.endBurst();
    await quiet();
    expect(server.writes).toEqual(["POST /vehicles/7/measurements", "PUT /measurements/1"]);
    expect(server.stored.get(1)?.target_point[1]).toBeCloseTo(249.5, 9);
  });

  it("measures a target afresh as a revision, and gives the click before back on undo", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    model.dispatch({ type: "choose", target: "roof" });
    model.points.place(at(101, 240));
    await quiet();
    expect(server.stored.size).toBe(1);
    expect(server.stored.get(1)?.target_point).toEqual([101, 240]);
    await model.history.undo();
    await quiet();
    expect(server.stored.get(1)?.target_point).toEqual([101, 250]);
  });

  it("shows live what it will store when a target with an inset and sigma of its own is clicked again", async () => {
    const own = { inset_m: 1.15, u_inset_m: 0.15, sigma_px: 0.4 };
    const eye = {
      ...own,
      target: "driver_eye",
      frame: 40,
      contact: [100, 400],
      target_point: [90, 300],
      more_frames: [],
      revision: 1,
    };
    server.save(3, { ...eye, withdrawn: false });
    const stored = vehicle([...server.stored.values()]);
    model.vehicles.takeAll([stored]);
    model.records.take(stored);
    model.open(stored);
    model.dispatch({ type: "choose", target: "driver_eye" });
    model.points.hover(at(92, 299));
    await quiet();
    expect(server.heights.at(-1)).toMatchObject(own);
    model.points.place(at(92, 299));
    await quiet();
    expect(server.stored.get(3)).toMatchObject({ ...own, target_point: [92, 299] });
  });

  it("withdraws the selected measurement and asks for it again", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    model.points.selectNext();
    model.points.removeSelected();
    await quiet();
    expect(heights()).toEqual([]);
    expect(model.flow.value.target).toBe("roof");
    expect(server.writes.at(-1)).toBe("DELETE /measurements/1");
  });

  it("leaves neither a step nor a write behind when a drag is cancelled, or a point is nudged forth and back", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    const label = model.history.undoLabel.value;
    const writes = [...server.writes];
    for (const role of ["contact", "point"] as const) {
      const selection = model.standing.selectable().find((one) => one.role === role);
      if (!selection) throw new Error("nothing to drag");
      model.points.drag(idOf(selection), at(140, 380), "move");
      model.points.drag(idOf(selection), at(0, 0), "cancel");
    }
    model.points.select({ key: model.entries.value[0]?.key ?? "", role: "point" });
    model.stage.nudge(0.1, 0);
    model.stage.nudge(-0.1, 0);
    await vi.advanceTimersByTimeAsync(1000);
    expect(model.entries.value.map(({ state, values }) => [state, values.contact, values.point])).toEqual([
      ["saved", [100, 400], [101, 250]],
    ]);
    expect(model.contact.value && pair(model.contact.value)).toEqual([100, 400]);
    expect(model.history.undoLabel.value).toBe(label);
    expect(server.writes).toEqual(writes);
  });

  it("takes one thing at a time back with Esc, from the top of the tools", async () => {
    model.points.place(at(100, 400));
    model.passes.from.value = 38;
    model.stage.keyboard.toggle();
    model.stage.cancel();
    expect(model.stage.cursor.value).toBeNull();
    expect(model.passes.from.value).toBe(38);
    model.stage.cancel();
    expect(model.passes.from.value).toBeNull();
    expect(model.contact.value).not.toBeNull();
    model.stage.cancel();
    expect(model.contact.value).toBeNull();
  });

  it("changes facts of a vehicle as one step", async () => {
    model.vehicles.takeAll([vehicle([], { make: "Opel", year: null })]);
    model.edit({ make: "Ford", year: 2019 });
    expect(model.vehicle.value).toMatchObject({ make: "Ford", year: 2019 });
    await model.history.undo();
    expect(model.vehicle.value).toMatchObject({ make: "Opel", year: null });
    await model.history.redo();
    expect(model.vehicle.value).toMatchObject({ make: "Ford", year: 2019 });
  });
});
