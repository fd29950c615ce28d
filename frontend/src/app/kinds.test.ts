/**
 * Whatever the server answers, no kind of wish stops the outbox: after any answer a wish is stored, or waits with a timer for
 * the connection, or rests with its reason and can be taken back; and what was wished after it goes out.
 */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import english from "../../../backend/sightline/messages/en.ftl?raw";
import { api, connection, PATIENCE_MS, tryAgainNow } from "../core/api";
import { type Kind, outbox, type Wanted, type Wish } from "../core/outbox";
import { imagePoint } from "../viewer/points";
import { loadKinds } from "./kinds";

await loadKinds();

// every code that the server may name stands in the catalogue
const CODES = [...english.matchAll(/^([a-z][\w-]*) =/gm)].map(([, code]) => code);

type Json = Record<string, unknown>;
type Sample = Omit<Wanted<unknown, unknown, unknown>, "key" | "lane" | "what" | "mine" | "page">;

const MEASUREMENT: Json = {
  ...{ id: 5, revision: 3, vehicle_id: 7, target: "roof", frame: 40, contact: [1, 2], target_point: [3, 4] },
  ...{ more_frames: [], flags: [], withdrawn: false, review: { verdict: "to_review", reviewer: null } },
  ...{ inset_m: 0.3, u_inset_m: 0.1, sigma_px: 0.5, status: "ok", height_m: 1.48, U95_height_m: 0.03 },
};
const VEHICLE: Json = {
  ...{ id: 7, version: 2, recording_id: 1, number: 22, first_frame: 30, last_frame: 50, best_frame: 40 },
  ...{ measurements: [], make: null },
};
const LINE_HEIGHT: Json = {
  ...{ id: 5, revision: 3, vehicle_id: 9, target: "roof", withdrawn: false, contact: [1, 2] },
  ...{ revision_id: 8, target_point: [3, 4], inset_from: "own", inset_m: 0.1, u_inset_m: 0.1, side: null },
  ...{ review: { verdict: "to_review", reviewer: null }, status: "ok", height_m: 1.5, U95_height_m: 0.02 },
};
const SCANNED: Json = { id: 9, version: 2, deleted: false, number: 1, make: null, measurement: null };
const ROD: Json = { revision: 2, marks: [], sigma_px: 1, u_distance_m: 0.1, u_lean_rad: 0.1 };
const PAIR: Json = { id: 3, vehicle_id: 7, frame: 40, first: [1, 2], second: [3, 4], withdrawn: false };
const CLICKS = { contact: { line: 300, row: 150 }, point: { line: 310, row: 40 }, inset: null };
const CLICK = {
  ...{ target: "roof", frame: 40, contact: imagePoint(100, 400), point: imagePoint(101, 250), inset: null },
  ...{ sigma_px: null, more: [], withdrawn: false },
};
const VERDICT = { verdict: "accepted", reason: null };

/** Wishes of every kind, and what the server has of such a thing. */
const SAMPLES: readonly (Sample & { theirs: Json })[] = [
  { kind: "measurement", about: { vehicleId: 7 }, saved: null, want: CLICK, theirs: MEASUREMENT },
  { kind: "measurement", about: { vehicleId: 7 }, saved: MEASUREMENT, want: CLICK, theirs: MEASUREMENT },
  {
    ...{ kind: "measurement", about: { vehicleId: 7 }, saved: MEASUREMENT },
    ...{ want: { ...CLICK, withdrawn: true }, theirs: MEASUREMENT },
  },
  { kind: "vehicle", about: { id: 7 }, saved: VEHICLE, want: { make: "Saab" }, theirs: VEHICLE },
  {
    ...{ kind: "pass-added", about: { recordingId: 1 }, saved: null, theirs: VEHICLE },
    ...{ want: { first_frame: 1, last_frame: 9 } },
  },
  {
    ...{ kind: "pass-there", about: { id: 7 }, want: false, theirs: VEHICLE },
    ...{ saved: { there: true, version: 2, vehicle: VEHICLE } },
  },
  {
    ...{ kind: "pass-there", about: { id: 7 }, want: true, theirs: VEHICLE },
    ...{ saved: { there: false, version: null, vehicle: VEHICLE } },
  },
  {
    ...{ kind: "pass-split", about: { id: 7, version: null }, want: 40, theirs: VEHICLE },
    ...{ saved: { earlier: VEHICLE, later: null } },
  },
  {
    ...{ kind: "pass-joined", saved: VEHICLE, want: [30, 90], theirs: VEHICLE },
    ...{ about: { id: 7, other_id: 8, version: 2, other_version: null } },
  },
  {
    ...{ kind: "line-height", about: { id: 9, scanId: 3, target: "roof", answer: null }, saved: null },
    ...{ want: { clicks: CLICKS }, theirs: LINE_HEIGHT },
  },
  {
    ...{ kind: "line-height", about: { id: 9, scanId: 3, target: "roof", answer: null }, saved: LINE_HEIGHT },
    ...{ want: { clicks: null }, theirs: LINE_HEIGHT },
  },
  {
    ...{ kind: "rod", about: { scanId: 3 }, saved: ROD, theirs: ROD },
    ...{ want: { marks: [{ distance_m: 5 }], sigma_px: 1, u_distance_m: 0.1, u_lean_rad: 0.1 } },
  },
  {
    ...{ kind: "scanned", about: { id: 9, scanId: 3 }, saved: SCANNED },
    ...{ want: { facts: { make: "Fiat" }, there: true }, theirs: SCANNED },
  },
  {
    ...{ kind: "added", about: { scanId: 3 }, saved: null, want: { front_line_1: 1, rear_line_1: 9 } },
    ...{ theirs: SCANNED },
  },
  {
    ...{ kind: "scan-verdict", about: { id: 9, measurementId: 5, by: 1 }, saved: SCANNED, want: VERDICT },
    ...{ theirs: SCANNED },
  },
  {
    ...{ kind: "verdict", about: { id: 5, revision: 3, by: 1 }, saved: LINE_HEIGHT, theirs: LINE_HEIGHT },
    ...{ want: { ...VERDICT, points: null } },
  },
  {
    ...{ kind: "wheel-pair", about: { id: 7, surveyId: 5 }, saved: null, theirs: PAIR },
    ...{ want: { frame: 41, first: [1, 1], second: [2, 2] } },
  },
  {
    ...{ kind: "verdict", about: { id: 5, revision: 3, by: 1 }, saved: MEASUREMENT, theirs: MEASUREMENT },
    ...{ want: { ...VERDICT, points: null } },
  },
  {
    ...{ kind: "repeat", about: { vehicleId: 7 }, saved: null, theirs: MEASUREMENT },
    ...{ want: { clicks: { ...CLICK, repeat_of: 4 }, withdrawn: false } },
  },
];

/** What comes of a request. */
type Answer = { status: number; text: string } | "no connection" | "no answer" | "broken off";

let seed = 28;
/** A number from 0 up to `below`, the same ones in every run. */
function any(below: number): number {
  seed = (seed * 1664525 + 1013904223) >>> 0;
  return Math.floor((seed / 2 ** 32) * below);
}
function one<T>(of: readonly T[]): T {
  return of[any(of.length)] as T;
}

const error = (code: unknown, more: Json = {}): Json => ({
  error: {
    kind: "conflict",
    code,
    values: one<unknown>([{}, { name: "Olga", number: 22 }, null]),
    message: "Refused.",
  },
  ...more,
});
const anything = (): unknown =>
  one<unknown>([null, 7, "roof", true, [], {}, [[]], { id: 5 }, { id: "5", revision: {} }]);

/** Theirs with one of its parts left out, of another sort, or a level deeper, as a measurement in a conflict once was. */
function spoiled(theirs: Json): unknown {
  const name = one(Object.keys(theirs));
  if (any(3) === 0) return { id: theirs["id"], revision: theirs["revision"], values: theirs };
  return any(2) ? { ...theirs, [name]: anything() } : { ...theirs, [name]: undefined };
}

function body(theirs: Json): string {
  return one([
    () => "",
    () => "<!doctype html><title>Sign in to this network</title>",
    () => JSON.stringify(error(one(CODES))).slice(0, 20),
    () => JSON.stringify(anything()),
    () => JSON.stringify(error(one(CODES))),
    () => JSON.stringify(error(one<unknown>(["no-such-code", 7, null, {}, ""]))),
    () => JSON.stringify(error("measurements-already-measured", { current: theirs })),
    () => JSON.stringify(error("measurements-already-measured", { current: spoiled(theirs) })),
    () => JSON.stringify(error("measurements-already-measured", { current: anything() })),
    () => JSON.stringify({ error: anything(), current: anything() }),
    () => JSON.stringify(spoiled(theirs)),
    () => JSON.stringify([spoiled(theirs)]),
    () => JSON.stringify({ vehicle: spoiled(theirs), current: spoiled(theirs), pairs: anything() }),
  ])();
}

/** Requests that nothing comes of: the page gives them up after a while. */
let open = 0;

function respond(answer: Answer, signal: AbortSignal | null | undefined): Promise<Response> {
  if (answer === "no connection") return Promise.reject(new TypeError("failed to fetch"));
  if (answer === "no answer") {
    open += 1;
    return new Promise((_, reject) =>
      signal?.addEventListener("abort", () => {
        open -= 1;
        reject(signal.reason);
      }),
    );
  }
  const { status, text } = answer === "broken off" ? { status: 200, text: "" } : answer;
  const made = new Response([204, 205, 304].includes(status) ? null : text, { status });
  if (answer === "broken off") made.text = () => Promise.reject(new TypeError("network error"));
  return Promise.resolve(made);
}

/** A kind of the test's own, always answered as it should be: "later wishes are sent". */
const later: Kind<{ id: number }, string, null> = {
  once: true,
  send: async (_wish, sending) =>
    (await api.write("POST /surveys", {}, { body: { name: "later" }, ...sending })) as unknown as {
      id: number;
    },
  read: async () => null,
  isSaved: (answer): answer is { id: number } => answer !== null,
  version: () => 0,
  words: () => "",
};
outbox.register("later", later as never);

let hostile: () => Answer;
let sent: string[];
const thrown: unknown[] = [];
const onThrown = (event: unknown): void => void thrown.push(event);

function wish(sample: Sample, key: string): Wanted<unknown, unknown, unknown> {
  const { kind, about, saved, want } = sample;
  return { key, lane: "lane", what: "roof", mine: "1.460 m", page: "/", kind, about, saved, want };
}

async function quiet(): Promise<void> {
  await vi.advanceTimersByTimeAsync(1);
}

/** It will be sent again without anybody's doing. */
function waits(): boolean {
  const { lost, nextTryAt } = connection.value;
  return outbox.get("first")?.state === "saving" && ((lost && nextTryAt !== null) || open > 0);
}

function fail(sample: Sample, answers: readonly Answer[], why: string, found?: Wish): never {
  throw new Error(`${sample.kind}: ${why}. ${JSON.stringify({ answers: answers.slice(-6), found })}`);
}

/** One wish whose requests are all answered so, another behind it, and what must hold of both. */
async function holds(sample: Sample, answer: () => Answer): Promise<string> {
  const answers: Answer[] = [];
  hostile = () => {
    const next = answer();
    answers.push(next);
    return next;
  };
  sent = [];
  outbox.open(1);
  outbox.want(wish(sample, "first"));
  outbox.want(wish({ kind: "later", about: null, saved: null, want: "" }, "second"));
  await quiet();
  if (open > 0) await vi.advanceTimersByTimeAsync(PATIENCE_MS + 1);
  const found = outbox.get("first");
  const state = found?.state ?? "done";
  if (state === "saving" ? !waits() : outbox.get("second") || sent.length === 0)
    fail(sample, answers, "it neither waits nor lets the next one go", found);
  if (found && state !== "saving") await rests(sample, answers, found);
  outbox.discard("first");
  await quiet();
  if (outbox.wishes.value.size > 0) fail(sample, answers, "it could not be taken back", outbox.get("first"));
  const kept = Object.keys(localStorage).filter((name) => name.includes("outbox"));
  if (kept.length > 0) fail(sample, answers, "something stays kept");
  if (thrown.length > 0) fail(sample, answers, `thrown: ${thrown}`);
  return state;
}

/** It says why, and can be tried again, as a person may: it comes to rest again, or waits. */
async function rests(sample: Sample, answers: readonly Answer[], found: Wish): Promise<void> {
  if (!["failed", "conflict"].includes(found.state)) fail(sample, answers, "it hangs", found);
  if (!found.problem?.trim()) fail(sample, answers, "no reason is told", found);
  if (typeof outbox.theirs(found) !== "string") fail(sample, answers, "no words for theirs", found);
  if (found.state === "conflict") outbox.resolve("first", "mine");
  else outbox.send("first");
  await quiet();
  const again = outbox.get("first");
  if (again?.state === "saving" && !waits()) fail(sample, answers, "tried again, it is stuck", again);
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.spyOn(console, "error").mockImplementation(() => {});
  process.on("unhandledRejection", onThrown);
  localStorage.clear();
  vi.stubGlobal("fetch", (_url: string, init: RequestInit = {}) => {
    if (String(init.body).includes('"later"')) {
      sent.push("later");
      return Promise.resolve(new Response('{"id":1}', { status: 201 }));
    }
    return respond(hostile(), init.signal);
  });
});

afterEach(() => {
  outbox.open(null);
  tryAgainNow();
  process.off("unhandledRejection", onThrown);
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

it("asks which of two heights of one target counts", async () => {
  const [click] = SAMPLES;
  if (!click) return;
  const text = JSON.stringify(error("measurements-already-measured", { current: MEASUREMENT }));
  hostile = () => ({ status: 409, text });
  outbox.open(1);
  outbox.want(wish(click, "first"));
  await quiet();
  const found = outbox.get("first") as Wish;
  expect(found).toMatchObject({ state: "conflict", mine: "1.460 m", theirs: { id: 5, revision: 3 } });
  expect(outbox.theirs(found)).toBe("1.480\u00a0±\u00a00.030\u00a0m");
  outbox.discard("first");
});

describe.each(SAMPLES.map((sample, at) => ({ sample, name: `${at} ${sample.kind}` })))(
  "$name",
  ({ sample }) => {
    const { theirs } = sample;

    it("outlives every status, with any body", async () => {
      for (let status = 200; status <= 599; status += 1) {
        const text = body(theirs);
        await holds(sample, () => ({ status, text }));
      }
    });

    it("outlives answers that differ from one to the next, and none", async () => {
      for (let run = 0; run < 60; run += 1)
        await holds(sample, () =>
          any(4) === 0
            ? one<Answer>(["no connection", "no answer", "broken off"])
            : {
                status: one([200, 201, 204, 400, 401, 403, 404, 409, 409, 409, 422, 429, 500, 503, 507]),
                text: body(theirs),
              },
        );
    });

    it.each<Answer>(["no connection", "no answer", "broken off"])(
      "waits where there is %s",
      async (answer) => {
        const state = await holds(sample, () => answer);
        expect(["saving", "failed"]).toContain(state);
      },
    );

    it("is never taken for stored because of an answer that says nothing of it", async () => {
      const nothing = ["", "<html>"];
      // what is taken out is answered with 204: there is no more to read in it
      const little = ["{}", "[]", "7", '"ok"', '{"id":5}', '{"detail":"ok"}'];
      for (const text of sample.want === false ? nothing : [...nothing, ...little])
        expect([text, await holds(sample, () => ({ status: 200, text }))]).not.toEqual([text, "done"]);
    });
  },
);
