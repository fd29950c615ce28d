import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { tryAgainNow } from "../../core/api";
import { outbox } from "../../core/outbox";
import type { LineHeight } from "../../core/types";
import { ScanModel } from "./model";

const LINES = { front_line_1: 200, rear_line_1: 500, front_line_2: 220, rear_line_2: 520 };
const CLICKS = { contact: { line: 300, row: 150 }, point: { line: 310, row: 40 }, inset: null };

let server: FakeServer;
let model: ScanModel;
let heights: LineHeight[];
let vehicle: Record<string, unknown>;
const quiet = () => vi.advanceTimersByTimeAsync(20);
const written = () => server.writes.filter((write) => !write.includes("line-height"));

/** The page, opened: what an earlier one kept is sent meanwhile. */
async function page(): Promise<void> {
  model?.close();
  outbox.open(1);
  model = new ScanModel(3);
  await model.load();
  model.choose(9);
  await quiet();
}

beforeEach(async () => {
  vi.useFakeTimers();
  heights = [];
  vehicle = { id: 9, number: 1, version: 1, deleted: false, make: null };
  vehicle["measurement"] = { id: 1, ...LINES, front_wheel_line: null, rear_wheel_line: null, status: "ok" };
  server = new FakeServer();
  const change = (part: Record<string, unknown>) => {
    vehicle = { ...vehicle, ...part, version: (vehicle["version"] as number) + 1 };
    return vehicle;
  };
  const checked = (version: unknown) => {
    if (version !== vehicle["version"]) throw 409;
  };
  server.on("GET", /^\/scans\/3$/, () => ({
    id: 3,
    survey_id: 5,
    state: "ready",
    lines: 1000,
    rows_px: 200,
  }));
  server.on("GET", /^\/scans\/3\/vehicles$/, () => (vehicle["deleted"] ? [] : [vehicle]));
  server.on("GET", /^\/scan-vehicles\/9$/, () => ({ vehicle }));
  server.on("GET", /\/line-pose$/, () => ({ current: { revision: 1, marks: [] }, history: [] }));
  server.on("GET", /\/heights$/, () => heights);
  server.on("PUT", /\/boundaries$/, (_match, { version, ...lines }) => {
    checked(version);
    return change({ measurement: { ...(vehicle["measurement"] as object), ...lines } });
  });
  server.on("PUT", /\/facts$/, (_match, { version, ...facts }) => {
    checked(version);
    return change(facts);
  });
  server.on("DELETE", /^\/scan-vehicles\/9\?/, () => change({ deleted: true }));
  server.on("POST", /^\/scan-vehicles\/9\/restore$/, () => change({ deleted: false }));
  server.on("POST", /^\/scan-vehicles\/9\/heights$/, (_match, { revision, ...clicks }) => {
    if (revision !== heights.length) throw 409;
    const figures = { height_m: 1.5, U95_height_m: 0.02, status: "ok", flags: [], budget: [] };
    const points = {
      contact: [clicks["contact_line"], clicks["contact_row_px"]],
      target_point: [clicks["target_line"], clicks["target_row_px"]],
    };
    const made = {
      ...clicks,
      ...points,
      ...figures,
      revision_id: heights.length + 1,
      id: 1,
      vehicle_id: 9,
      withdrawn: false,
    };
    heights = [...heights, { ...made, revision: heights.length + 1 } as unknown as LineHeight];
    return heights.at(-1);
  });
  await page();
});

afterEach(() => {
  model.close();
  outbox.open(null);
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

async function click(): Promise<void> {
  model.heights.begin("roof");
  model.heights.click(CLICKS.contact);
  model.heights.click(CLICKS.point);
  await quiet();
}

describe("the inset of a height", () => {
  const OTHER = { id: 10, number: 2, version: 1, deleted: false, make: null };
  const [near, own] = [{ side: "near" } as const, { inset_m: 0.4, u_inset_m: 0.1 }];

  it("is chosen of one vehicle, not of the next", async () => {
    server.on("GET", /^\/scans\/3\/vehicles$/, () => [vehicle, OTHER]);
    server.on("GET", /^\/scan-vehicles\/10$/, () => ({ vehicle: OTHER }));
    await page();
    await model.heights.setInset("driver_eye", near);
    expect(model.heights.insetOf("driver_eye")).toEqual(near);
    model.choose(10);
    expect(model.heights.insetOf("driver_eye")).toBeNull();
    model.choose(9);
    expect(model.heights.insetOf("driver_eye")).toEqual(near);
  });

  it("is that which is stored once there is one, also while it waits and after an undo", async () => {
    server.on("POST", /^\/scan-vehicles\/9\/heights$/, (_match, { revision, ...clicks }) => {
      heights = [...heights, stored(clicks, (revision as number) + 1)];
      return heights.at(-1);
    });
    await model.heights.setInset("roof", own);
    await click();
    expect(model.heights.insetOf("roof")).toEqual(own);
    const change = model.heights.setInset("roof", { inset_m: 0.1, u_inset_m: 0.05 });
    expect(model.heights.insetOf("roof")).toEqual({ inset_m: 0.1, u_inset_m: 0.05 });
    await change;
    await quiet();
    await model.history.undo();
    await quiet();
    expect(heights.at(-1)?.inset_m).toBe(0.4);
    expect(model.heights.insetOf("roof")).toEqual(own);
  });

  function stored(clicks: Record<string, unknown>, revision: number): LineHeight {
    const points = {
      contact: [clicks["contact_line"], clicks["contact_row_px"]],
      target_point: [clicks["target_line"], clicks["target_row_px"]],
    };
    const said = {
      inset_m: clicks["inset_m"],
      u_inset_m: clicks["u_inset_m"],
      inset_from: "own",
      side: null,
    };
    const rest = { target: clicks["target"], flags: [], budget: [], status: "ok", withdrawn: false };
    return { ...points, ...said, ...rest, id: 1, vehicle_id: 9, revision, revision_id: revision } as never;
  }
});

describe("what is done on the strips without a connection", () => {
  it("shows at once, is kept over a closed page, and is sent once and in order from the next", async () => {
    server.down = true;
    void model.edits.fillIn({ make: "Fiat" });
    await quiet();
    model.boundaries.move("front_line_1", 210);
    void model.boundaries.store();
    await quiet();
    await click();
    expect(model.chosen.value?.make).toBe("Fiat");
    expect(model.boundaries.crossings.value?.front_line_1).toBe(210);
    expect(model.heights.of("roof")?.contact[0]).toBe(300);
    expect(written()).toEqual([]);

    model.close();
    outbox.open(null);
    server.down = false;
    await page();
    await quiet();
    expect(written()).toEqual([
      "PUT /scan-vehicles/9/facts",
      "PUT /scan-vehicles/9/boundaries",
      "POST /scan-vehicles/9/heights",
    ]);
    expect(vehicle).toMatchObject({ make: "Fiat", version: 3, measurement: { front_line_1: 210 } });
    expect(heights).toHaveLength(1);
    expect(model.heights.of("roof")).toMatchObject({ revision: 1, height_m: 1.5 });
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("can be taken back before it is sent", async () => {
    server.down = true;
    void model.edits.fillIn({ make: "Fiat" });
    await quiet();
    await model.history.undo();
    expect(model.chosen.value?.make).toBeNull();
    server.down = false;
    tryAgainNow();
    await quiet();
    expect(vehicle["make"]).toBeNull();
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("takes the echo of a lost answer for what it is", async () => {
    server.on("DELETE", /^\/scan-vehicles\/9\?/, () => {
      vehicle = { ...vehicle, deleted: true, version: 2 };
      throw 409;
    });
    await model.edits.remove();
    expect(model.vehicles.value).toEqual([]);
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("is asked about where somebody else clicked meanwhile, with both values", async () => {
    server.down = true;
    await click();
    const theirs = { target: "roof", contact: [1, 2], target_point: [3, 4], revision_id: 8 };
    const figures = { height_m: 1.62, U95_height_m: 0.03, status: "ok", withdrawn: false };
    heights = [{ ...theirs, ...figures, id: 1, vehicle_id: 9, revision: 1 } as unknown as LineHeight];
    server.down = false;
    tryAgainNow();
    await quiet();
    const wish = outbox.get("height.9.roof");
    expect(wish).toMatchObject({
      state: "conflict",
      what: "roof of vehicle 1",
      mine: "clicked at line 310, row 40",
    });
    expect(wish && outbox.theirs(wish)).toContain("1.62");
    expect(heights).toHaveLength(1);
    outbox.resolve("height.9.roof", "mine");
    await quiet();
    expect(heights.at(-1)).toMatchObject({ revision: 2, contact: [300, 150] });
  });
});
