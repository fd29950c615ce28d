import { beforeEach, describe, expect, it } from "vitest";
import { ApiError } from "../../core/api";
import { ORPHANED_AFTER_MS } from "../../core/keeping";
import { Outbox } from "../../core/outbox";
import type { Measurement, Vehicle } from "../../core/types";
import { imagePoint } from "../../viewer/points";
import type { Values } from "../../viewer/values";
import { MEASUREMENT, measurementKind, type RecordsPort } from "./kinds";
import { Records } from "./records";

const values: Values = {
  target: "roof",
  frame: 40,
  contact: imagePoint(100, 400),
  point: imagePoint(101, 250),
  inset: null,
  sigma_px: null,
  more: [],
  withdrawn: false,
};

/** A server of one vehicle in memory, which can be cut off or written to by somebody else. */
class Server implements RecordsPort {
  readonly stored = new Map<number, Measurement>();
  readonly keys = new Map<string, number>();
  readonly calls: string[] = [];
  gate: Promise<void> = Promise.resolve();
  loseAnswer = false;

  async create(vehicleId: number, key: string, v: Values): Promise<Measurement> {
    await this.arrive("create");
    const known = this.keys.get(key);
    if (known !== undefined) return this.get(known);
    const standing = [...this.stored.values()].find((m) => m.target === v.target && !m.withdrawn);
    const told = `${standing?.target} is measured already`;
    if (standing) throw new ApiError(told, 409, null, { current: standing });
    const id = this.stored.size + 1;
    this.keys.set(key, id);
    return this.answer(this.save(id, 1, vehicleId, v));
  }
  async revise(id: number, revision: number, v: Values): Promise<Measurement> {
    await this.arrive("revise");
    return this.answer(this.next(id, revision, v));
  }
  async withdraw(id: number, revision: number): Promise<Measurement> {
    await this.arrive("withdraw");
    return this.next(id, revision, null, true);
  }
  async restore(id: number, revision: number): Promise<Measurement> {
    await this.arrive("restore");
    return this.next(id, revision, null, false);
  }
  async read(id: number): Promise<Measurement> {
    return this.get(id);
  }
  /** Somebody else's change. */
  other(id: number, point: [number, number]): void {
    const m = this.get(id);
    this.stored.set(id, { ...m, revision: m.revision + 1, target_point: point });
  }
  vehicle(): Vehicle {
    return { id: 7, measurements: [...this.stored.values()] } as unknown as Vehicle;
  }
  get(id: number): Measurement {
    const m = this.stored.get(id);
    if (!m) throw new ApiError("no such measurement", 404);
    return m;
  }
  private async arrive(call: string): Promise<void> {
    this.calls.push(call);
    await this.gate;
  }
  private answer(m: Measurement): Measurement {
    if (!this.loseAnswer) return m;
    this.loseAnswer = false;
    throw new ApiError("changed by you at 14:02", 409);
  }
  private next(id: number, revision: number, v: Values | null, withdrawn = false): Measurement {
    const now = this.get(id);
    if (now.revision !== revision) throw new ApiError("changed by RV at 14:02", 409);
    if (v) return this.save(id, revision + 1, now.vehicle_id, v);
    const made = { ...now, revision: revision + 1, withdrawn };
    this.stored.set(id, made);
    return made;
  }
  private save(id: number, revision: number, vehicle_id: number, v: Values): Measurement {
    const { target, frame, contact, point, withdrawn } = v;
    const insets = v.inset ?? { inset_m: 0.6, u_inset_m: 0.1 };
    const review = { verdict: "to_review" };
    const clicked = {
      target,
      frame,
      contact,
      target_point: point,
      more_frames: v.more,
      withdrawn,
      flags: [],
      review,
    };
    const made = { id, revision, vehicle_id, ...clicked, ...insets };
    this.stored.set(id, made as unknown as Measurement);
    return this.get(id);
  }
}

function memory(): Storage {
  const map = new Map<string, string>();
  return {
    get length() {
      return map.size;
    },
    key: (i: number) => [...map.keys()][i] ?? null,
    getItem: (k: string) => map.get(k) ?? null,
    setItem: (k: string, v: string) => void map.set(k, v),
    removeItem: (k: string) => void map.delete(k),
    clear: () => map.clear(),
  };
}

let store: Storage;
let clock = 0;
/** A page of a tab that talks to a server, with what it kept before. */
function page(server: Server, tab = "a"): { records: Records; box: Outbox } {
  const box = new Outbox(
    tab,
    () => store,
    () => clock,
    undefined, // no locks: what is told here of a tab that is gone is its age
  );
  box.register(MEASUREMENT, measurementKind(server));
  const records = new Records(box, 5);
  records.take(server.vehicle());
  box.open(1);
  return { records, box };
}

beforeEach(() => {
  store = memory();
  clock = 1e6;
});

describe("Records", () => {
  it("stores a click once and rests", async () => {
    const server = new Server();
    const { records } = page(server);
    const key = records.create(7, values, null);
    expect(records.find(key)?.state).toBe("saving");
    expect(store.length).toBe(1);
    expect((await records.settled(key))?.state).toBe("saved");
    expect(server.calls).toEqual(["create"]);
    expect(store.length).toBe(0);
  });

  it("sends only the last of the changes made while one was on its way", async () => {
    const server = new Server();
    const { records } = page(server);
    let open = () => {};
    server.gate = new Promise((done) => {
      open = done;
    });
    const key = records.create(7, values, null);
    for (const y of [251, 252, 253]) records.change(key, { point: imagePoint(101, y) });
    open();
    const entry = await records.settled(key);
    expect(server.calls).toEqual(["create", "revise"]);
    expect(entry?.saved).toMatchObject({ revision: 2, target_point: [101, 253] });
  });

  it("withdraws and restores, as undo and redo do", async () => {
    const server = new Server();
    const { records } = page(server);
    const key = records.create(7, values, null);
    await records.settled(key);
    records.change(key, { withdrawn: true });
    expect((await records.settled(key))?.saved?.withdrawn).toBe(true);
    records.take({ id: 7, measurements: [] } as unknown as Vehicle);
    records.change(key, { withdrawn: false });
    expect((await records.settled(key))?.saved?.withdrawn).toBe(false);
    expect(server.calls).toEqual(["create", "withdraw", "restore"]);
  });

  it("tells of somebody else's change and keeps both until one is chosen", async () => {
    const server = new Server();
    const { records, box } = page(server);
    const key = records.create(7, values, null);
    await records.settled(key);
    server.other(1, [90, 90]);
    records.change(key, { point: imagePoint(1, 2) });
    const conflict = await records.settled(key);
    expect(conflict).toMatchObject({ state: "conflict", problem: "changed by RV at 14:02" });
    expect([...(conflict?.values.point ?? [])]).toEqual([1, 2]);
    expect(conflict?.theirs?.target_point).toEqual([90, 90]);
    box.resolve(key, "mine");
    expect((await records.settled(key))?.saved).toMatchObject({ revision: 3, target_point: [1, 2] });
  });

  it.each(["mine", "theirs"] as const)(
    "shows a kept click beside what was measured meanwhile, never two of a target: %s",
    async (choice) => {
      const server = new Server();
      const closed = page(server, "closed");
      server.gate = new Promise(() => {});
      const key = closed.records.create(7, values, null); // kept, and not sent before the tab is closed
      closed.box.close();
      server.gate = Promise.resolve();
      const first = page(server, "other");
      await first.records.settled(first.records.create(7, { ...values, point: imagePoint(90, 90) }, null));
      clock += ORPHANED_AFTER_MS + 1;
      const { records, box } = page(server, "third");
      records.resume();
      const conflict = await records.settled(key);
      expect(conflict).toMatchObject({ state: "conflict", problem: "roof is measured already" });
      expect(conflict?.theirs?.target_point).toEqual([90, 90]);
      records.take(server.vehicle());
      expect(records.of(7)).toHaveLength(1);
      box.resolve(key, choice);
      await records.settled(key);
      records.take(server.vehicle());
      expect(records.of(7)).toHaveLength(1);
      expect([...server.stored.values()]).toMatchObject([
        choice === "mine"
          ? { revision: 2, target_point: [101, 250] }
          : { revision: 1, target_point: [90, 90] },
      ]);
      expect(store.length).toBe(0);
    },
  );

  it("takes theirs when told to", async () => {
    const server = new Server();
    const { records, box } = page(server);
    const key = records.create(7, values, null);
    await records.settled(key);
    server.other(1, [90, 90]);
    records.change(key, { point: imagePoint(1, 2) });
    await records.settled(key);
    box.resolve(key, "theirs");
    expect(records.find(key)).toMatchObject({ state: "saved", saved: { target_point: [90, 90] } });
    expect(store.length).toBe(0);
  });

  it("does not mistake its own lost answer for a conflict", async () => {
    const server = new Server();
    const { records } = page(server);
    const key = records.create(7, values, null);
    await records.settled(key);
    server.loseAnswer = true;
    records.change(key, { point: imagePoint(1, 2) });
    expect((await records.settled(key))?.state).toBe("saved");
  });

  it("sends after a crash what was not yet saved, once", async () => {
    const server = new Server();
    server.gate = new Promise(() => {});
    const key = page(server).records.create(7, values, null);
    server.gate = Promise.resolve();

    expect(page(server, "b").box.wishes.value.size).toBe(0);
    clock += ORPHANED_AFTER_MS + 1;
    const { records } = page(server, "c");
    records.resume();
    expect(records.find(key)?.state).toBe("saving");
    await records.settled(key);
    expect(server.stored.size).toBe(1);
    expect(store.length).toBe(0);
  });

  it("finds its own items again after a reload of the tab", () => {
    const server = new Server();
    server.gate = new Promise(() => {});
    page(server).records.create(7, values, null);
    expect(page(server).box.wishes.value.size).toBe(1);
  });

  it("keeps a refused click in sight with the reason", async () => {
    const server = new Server();
    server.create = () => Promise.reject(new ApiError("This recording has no road pose yet.", 409));
    const { records, box } = page(server);
    const key = records.create(7, values, null);
    expect(await records.settled(key)).toMatchObject({
      state: "failed",
      problem: "This recording has no road pose yet.",
    });
    box.discard(key);
    expect(records.of(7)).toEqual([]);
  });
});
