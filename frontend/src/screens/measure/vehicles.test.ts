import { describe, expect, it, vi } from "vitest";
import { ApiError } from "../../core/api";
import { Outbox } from "../../core/outbox";
import type { Vehicle } from "../../core/types";
import { type Changes, disputedFields } from "./fields";
import { VEHICLE, vehicleKind } from "./kinds";
import { Vehicles } from "./vehicles";

const start = {
  id: 7,
  recording_id: 1,
  number: 7,
  first_frame: 30,
  last_frame: 50,
  version: 1,
  make: null,
  model: null,
  year: null,
  category: null,
  model_chosen_by: null,
  model_sizes: null,
  manufacturer_height_m: null,
  u_manufacturer_height_m: null,
  height_source: null,
  lighting: "daytime",
  notes: "",
  measurements: [],
} as unknown as Vehicle;

function setUp() {
  let stored = start;
  const sent: Changes[] = [];
  const told: string[] = [];
  const save = async (_id: number, version: number, fields: Changes): Promise<Vehicle> => {
    if (version !== stored.version) {
      throw new ApiError("AB changed this vehicle at 14:02.", 409, null, { current: stored });
    }
    sent.push(fields);
    stored = { ...stored, ...fields, version: version + 1 };
    return stored;
  };
  const page = (): Vehicles => {
    const box = new Outbox("a");
    box.register(VEHICLE, vehicleKind({ save }));
    box.open(1);
    const vehicles = new Vehicles(box, 5, { merged: (message) => told.push(message) }, 1e6);
    vehicles.take(stored);
    return vehicles;
  };
  localStorage.clear();
  const vehicles = page();
  const other = (fields: Changes) => {
    stored = { ...stored, ...fields, version: stored.version + 1 };
  };
  return { vehicles, page, sent, told, other, stored: () => stored };
}

describe("Vehicles", () => {
  it("shows what is typed at once and saves it together", async () => {
    const { vehicles, sent } = setUp();
    vehicles.edit(7, { make: "Peugeot" });
    vehicles.edit(7, { model: "3008" });
    expect(vehicles.shown(7)).toMatchObject({ make: "Peugeot", model: "3008" });
    await vehicles.flush(7);
    expect(sent).toHaveLength(1);
    expect(vehicles.get(7)).toMatchObject({ make: "Peugeot", model: "3008", version: 2 });
    expect(vehicles.drafts.value.size).toBe(0);
  });

  it("keeps what is typed over a closed page, and sends it once from the next", async () => {
    const { vehicles, page, sent, stored } = setUp();
    vehicles.edit(7, { make: "Peugeot" });
    expect(sent).toEqual([]);
    const next = page();
    expect(next.shown(7)).toMatchObject({ make: "Peugeot" });
    await next.flush(7);
    expect(sent).toEqual([{ make: "Peugeot" }]);
    expect(stored()).toMatchObject({ make: "Peugeot", version: 2 });
    expect(localStorage.length).toBe(0);
  });

  it("does not write again what was stored before somebody changed it", async () => {
    const { vehicles, other, sent, stored } = setUp();
    vehicles.edit(7, { make: "Peugeot" });
    const first = vehicles.flush(7);
    vehicles.edit(7, { model: "3008" });
    await first;
    other({ make: "Citroën" });
    await vehicles.flush(7);
    expect(sent.at(-1)).toEqual({ model: "3008" });
    expect(stored()).toMatchObject({ make: "Citroën", model: "3008" });
  });

  it("merges changes to other fields and says so", async () => {
    const { vehicles, told, other, stored } = setUp();
    vehicles.edit(7, { make: "Peugeot" });
    other({ year: 2019 });
    await vehicles.flush(7);
    await vi.waitFor(() => expect(stored()).toMatchObject({ make: "Peugeot", year: 2019 }));
    expect(told[0]).toContain("AB changed this vehicle");
  });

  it("asks where both changed the same field, and loses neither", async () => {
    const { vehicles, other, stored } = setUp();
    vehicles.edit(7, { make: "Peugeot", notes: "roof box" });
    other({ make: "Citroën", year: 2019 });
    await vehicles.flush(7);
    const draft = vehicles.drafts.value.get(7);
    expect(draft).toMatchObject({ state: "conflict", disputed: ["make"], theirs: { make: "Citroën" } });
    expect(vehicles.shown(7)?.make).toBe("Peugeot");
    await vehicles.settle(7, new Map([["make", "theirs"]]));
    expect(stored()).toMatchObject({ make: "Citroën", year: 2019, notes: "roof box" });
  });

  it("asks also when the other change arrived while this one was being typed", async () => {
    const { vehicles, other, stored } = setUp();
    vehicles.hold(7);
    other({ notes: "from the other tab" });
    vehicles.take(stored());
    vehicles.edit(7, { notes: "from this tab" });
    vehicles.release(7);
    await vehicles.flush(7);
    expect(vehicles.drafts.value.get(7)).toMatchObject({ state: "conflict", disputed: ["notes"] });
  });

  it("keeps nothing of a field that was left as it was", () => {
    const { vehicles } = setUp();
    vehicles.hold(7);
    vehicles.release(7);
    expect(vehicles.drafts.value.size).toBe(0);
  });

  it("writes mine over theirs when told to", async () => {
    const { vehicles, other, stored } = setUp();
    vehicles.edit(7, { make: "Peugeot" });
    other({ make: "Citroën" });
    await vehicles.flush(7);
    await vehicles.settle(7, new Map([["make", "mine"]]));
    expect(stored()).toMatchObject({ make: "Peugeot", version: 3 });
  });

  it("does not dispute what both changed alike", () => {
    const theirs = { ...start, make: "Peugeot" };
    expect(disputedFields(start, { make: "Peugeot" }, theirs)).toEqual([]);
  });
});
