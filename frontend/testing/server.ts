/** The least of a server that screens need in tests: it serves frames, stores clicks, counts revisions and notes what was written. */
import { vi } from "vitest";
import { outbox } from "../src/core/outbox";
import { me } from "../src/core/session";
import type { Me, Measurement, Recording, Vehicle } from "../src/core/types";

export type Body = Record<string, unknown>;
type Answer = (match: RegExpMatchArray, body: Body) => unknown;

const HEIGHT = {
  status: "ok",
  ok: true,
  height_m: 1.5,
  U95_height_m: 0.02,
  ladder: [],
  axes: null,
  budget: [],
  flags: [],
};
const PICTURE = { width: 640, height: 480, close: () => {} };

export class FakeServer {
  readonly stored = new Map<number, Measurement>();
  /** Writes in order: "POST /vehicles/7/measurements". */
  readonly writes: string[] = [];
  /** What each of them said. */
  readonly bodies: Body[] = [];
  /** Bodies of the questions for a height. */
  readonly heights: Body[] = [];
  /** No connection. */
  down = false;
  private readonly answers: { method: string; path: RegExp; answer: Answer }[] = [];

  /** Stands in for the network and for the browser's decoder until the test is over. */
  constructor(role = "operator") {
    vi.stubGlobal("fetch", this.fetch);
    vi.stubGlobal("createImageBitmap", async () => PICTURE);
    for (const name of Object.keys(localStorage)) if (name.includes("outbox")) localStorage.removeItem(name);
    me.value = { person: { id: 1, role } } as unknown as Me;
    outbox.open(1);
    this.on("GET", /\/frames\?/, () => ({ first: 0, time_s: [], crc: [] }));
    this.on("GET", /\/frames\/ready$/, () => ({ runs: [] }));
    this.on("POST", /\/snap$/, () => ({ contact: null, expected_px: null, reason: "snap-no-tyre" }));
    this.on("POST", /\/geometry\//, () => HEIGHT);
    this.on("POST", /\/geometry\/height$/, (_match, body) => {
      this.heights.push(body);
      return HEIGHT;
    });
    this.on("POST", /^\/vehicles\/\d+\/measurements$/, (_match, body) =>
      this.save(this.stored.size + 1, { ...body, revision: 1, withdrawn: false }),
    );
    this.on("PUT", /^\/measurements\/(\d+)$/, (match, body) => this.revise(match, body));
    this.on("DELETE", /^\/measurements\/(\d+)\?/, (match) => this.revise(match, { withdrawn: true }));
    this.on("POST", /^\/measurements\/(\d+)\/restore$/, (match) => this.revise(match, { withdrawn: false }));
    this.on("GET", /^\/measurements\/(\d+)\/history$/, (match) => {
      const now = this.stored.get(Number(match[1]));
      return { revisions: now ? [now] : [], reviews: [] };
    });
    this.on("GET", /^\/vehicles\/(\d+)$/, () =>
      vehicle([...this.stored.values()].filter((m) => !m.withdrawn)),
    );
  }

  /** The newest answer to a path counts. Throw a number to refuse with that status. */
  on(method: string, path: RegExp, answer: Answer): void {
    this.answers.unshift({ method, path, answer });
  }

  /** Notes a measurement as if it had been stored. */
  save(id: number, facts: Body): Measurement {
    const made = {
      inset_m: 0.3,
      u_inset_m: 0.1,
      sigma_px: 0.5,
      more_frames: [],
      flags: [],
      budget: [],
      status: "ok",
      height_m: 1.5,
      repeat_of: null,
      review: { verdict: "to_review", reason: null, reviewer: null, at: null },
      vehicle_id: 7,
      recording_id: 1,
      ...facts,
      followed: facts["follow"] ? '{"points":[]}' : null,
      id,
    } as unknown as Measurement;
    this.stored.set(id, made);
    return made;
  }

  private revise(match: RegExpMatchArray, change: Body): Measurement {
    const id = Number(match[1]);
    const now = this.stored.get(id);
    return this.save(id, { ...now, ...change, revision: (now?.revision ?? 0) + 1 });
  }

  private readonly fetch = async (url: string, init: RequestInit = {}): Promise<Response> => {
    if (this.down) throw new TypeError("no connection");
    const path = url.replace("/api", "");
    const frame = path.match(/\/frames\/(\d+)\.jpg/);
    if (frame) return new Response("jpg", { headers: { "Sightline-Frame": String(frame[1]) } });
    const method = init.method ?? "GET";
    const body = init.body ? (JSON.parse(String(init.body)) as Body) : {};
    const known = this.answers.find((one) => one.method === method && one.path.test(path));
    if (method !== "GET" && !/\/geometry\/|\/snap$/.test(path)) {
      this.writes.push(`${method} ${path.split("?")[0]}`);
      this.bodies.push(body);
    }
    try {
      const match = known && path.match(known.path);
      return new Response(JSON.stringify(match ? await known.answer(match, body) : []), { status: 200 });
    } catch (status) {
      if (typeof status !== "number") throw status;
      return new Response(JSON.stringify({ code: "refused", message: "Refused." }), { status });
    }
  };
}

export function vehicle(measurements: Measurement[] = [], facts: Partial<Vehicle> = {}): Vehicle {
  return {
    id: 7,
    number: 7,
    recording_id: 1,
    first_frame: 30,
    last_frame: 50,
    best_frame: 40,
    version: 1,
    state: "to_do",
    measurements,
    asked: ["roof", "driver_eye", "taillight"],
    roof_not_visible: null,
    driver_eye_not_visible: null,
    taillight_not_visible: null,
    headlight_not_visible: null,
    discarded: null,
    in_sample: true,
    notes: "",
    ...facts,
  } as unknown as Vehicle;
}

export function recording(facts: Partial<Recording> = {}): Recording {
  return {
    id: 1,
    name: "day",
    state: "ready",
    pose_id: 1,
    camera_id: 1,
    frame_count: 100,
    width_px: 640,
    height_px: 480,
    thumbs: [],
    ...facts,
  } as unknown as Recording;
}
