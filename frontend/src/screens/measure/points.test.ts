import { signal } from "@preact/signals";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { me } from "../../core/session";
import type { Me, Measurement, Vehicle } from "../../core/types";
import type { Player } from "../../viewer/player";
import { imagePoint, pair } from "../../viewer/points";
import { MeasureModel } from "./model";

/** The least of a server that the page needs to measure: it stores clicks and counts revisions. */
class FakeServer {
  readonly stored = new Map<number, Measurement>();
  readonly writes: string[] = [];
  readonly asked: Record<string, unknown>[] = [];

  readonly fetch = async (url: string, init: RequestInit): Promise<Response> => {
    const path = url.replace("/api", "").split("?")[0] ?? "";
    const method = init.method ?? "GET";
    const body = init.body ? JSON.parse(String(init.body)) : {};
    const write = method !== "GET" && !path.includes("/geometry/");
    if (write) this.writes.push(`${method} ${path}`);
    if (path.endsWith("/geometry/height")) this.asked.push(body);
    return new Response(JSON.stringify(this.answer(method, path, body)), { status: 200 });
  };

  private answer(method: string, path: string, body: Record<string, unknown>): unknown {
    const id = Number(path.split("/")[2]);
    if (path.endsWith("/measurements"))
      return this.save(this.stored.size + 1, { ...body, revision: 1, withdrawn: false });
    if (path.startsWith("/measurements")) {
      const now = this.stored.get(id);
      const revision = (now?.revision ?? 0) + 1;
      if (method === "DELETE") return this.save(id, { ...now, revision, withdrawn: true });
      if (path.endsWith("/restore")) return this.save(id, { ...now, revision, withdrawn: false });
      return this.save(id, { ...now, ...body, revision });
    }
    if (path.startsWith("/vehicles")) return vehicle([...this.stored.values()].filter((m) => !m.withdrawn));
    return {
      status: "ok",
      ok: true,
      height_m: 1.5,
      U95_height_m: 0.02,
      ladder: [],
      axes: null,
      budget: [],
      flags: [],
    };
  }

  private save(id: number, facts: Record<string, unknown>): Measurement {
    const made = {
      inset_m: 0.3,
      u_inset_m: 0.1,
      more_frames: [],
      flags: [],
      budget: [],
      status: "ok",
      height_m: 1.5,
      ...facts,
      id,
      vehicle_id: 7,
    };
    const stored = {
      ...made,
      review: { verdict: "to_review", reason: null, reviewer: null, at: null },
    } as unknown as Measurement;
    this.stored.set(id, stored);
    return stored;
  }
}

const vehicle = (measurements: Measurement[]): Vehicle =>
  ({
    id: 7,
    number: 7,
    recording_id: 1,
    first_frame: 30,
    last_frame: 50,
    best_frame: 40,
    version: 1,
    state: "to_do",
    measurements,
  }) as unknown as Vehicle;

let server: FakeServer;
let model: MeasureModel;
const quiet = () => new Promise((done) => setTimeout(done, 20));

beforeEach(() => {
  localStorage.clear();
  server = new FakeServer();
  vi.stubGlobal("fetch", server.fetch);
  me.value = { person: { id: 1, role: "operator" } } as unknown as Me;
  model = new MeasureModel(1);
  const shown = signal({ frame: 40, picture: {} as ImageBitmap });
  const player = {
    recordingId: 1,
    frame: signal(40),
    shown,
    playing: signal(false),
    go: () => {},
    stop: () => {},
    close: () => {},
  };
  model.player.value = player as unknown as Player;
  model.vehicles.takeAll([vehicle([])]);
  model.open(vehicle([]));
});

afterEach(() => {
  model.close();
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

  it("undoes a target, then the contact, and does both again", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    await model.undo.undo();
    await quiet();
    expect(heights()).toEqual([]);
    expect(model.flow.value.target).toBe("roof");
    expect(server.stored.get(1)?.withdrawn).toBe(true);
    await model.undo.undo();
    expect(model.contact.value).toBeNull();
    await model.undo.redo();
    await model.undo.redo();
    await quiet();
    expect(heights()).toEqual(["roof"]);
    expect(server.stored.get(1)?.withdrawn).toBe(false);
  });

  it("moves a contact for all measurements that stand on it, as one step", async () => {
    for (const point of [at(100, 400), at(101, 250), at(90, 300)]) model.points.place(point);
    await quiet();
    const selection = model.points.selectable().find((one) => one.role === "contact");
    if (!selection) throw new Error("no contact to drag");
    model.points.drag(selection, at(104, 398), "move");
    model.points.drag(selection, at(105, 397), "end");
    await quiet();
    expect([...server.stored.values()].map((m) => m.contact)).toEqual([
      [105, 397],
      [105, 397],
    ]);
    expect(model.contact.value && pair(model.contact.value)).toEqual([105, 397]);
    await model.undo.undo();
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
    expect(server.stored.get(1)?.point[1]).toBeCloseTo(249.5, 9);
  });

  it("measures a target afresh as a revision, and gives the click before back on undo", async () => {
    model.points.place(at(100, 400));
    model.points.place(at(101, 250));
    await quiet();
    model.dispatch({ type: "choose", target: "roof" });
    model.points.place(at(101, 240));
    await quiet();
    expect(server.stored.size).toBe(1);
    expect(server.stored.get(1)?.point).toEqual([101, 240]);
    await model.undo.undo();
    await quiet();
    expect(server.stored.get(1)?.point).toEqual([101, 250]);
  });

  it("shows live what it will store when a target with an inset and sigma of its own is clicked again", async () => {
    const own = { inset_m: 1.15, u_inset_m: 0.15, sigma_px: 0.4 };
    const eye = {
      ...own,
      target: "driver_eye",
      frame: 40,
      contact: [100, 400],
      point: [90, 300],
      more_frames: [],
      revision: 1,
    };
    server.stored.set(3, {
      ...eye,
      id: 3,
      vehicle_id: 7,
      withdrawn: false,
      review: { verdict: "to_review" },
    } as unknown as Measurement);
    const stored = vehicle([...server.stored.values()]);
    model.vehicles.takeAll([stored]);
    model.records.take(stored);
    model.open(stored);
    model.dispatch({ type: "choose", target: "driver_eye" });
    model.points.hover(at(92, 299));
    await quiet();
    expect(server.asked.at(-1)).toMatchObject(own);
    model.points.place(at(92, 299));
    await quiet();
    expect(server.stored.get(3)).toMatchObject({ ...own, point: [92, 299] });
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
});
