/** Keys that are pressed while the page's questions are still on their way: what comes later undoes none of them. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../testing/server";
import { addCommands } from "../../core/commands";
import type { PointProposal } from "../../core/types";
import { frameCommands } from "../../viewer/stageCommands";
import { MeasureModel } from "./model";

const BEST = 40;
const PROPOSED = 45;

let model: MeasureModel;
let removeCommands: () => void;
/** Lets go what is held back, by what its address ends with. */
let held: Map<string, () => void>;

function hold(...ends: readonly string[]): void {
  const answer = globalThis.fetch;
  vi.stubGlobal("fetch", async (url: string, init: RequestInit) => {
    const end = ends.find((one) => url.endsWith(one));
    if (end) await new Promise<void>((done) => held.set(end, done));
    return answer(url, init);
  });
}

const settle = () => vi.advanceTimersByTimeAsync(20);

async function letGo(end: string): Promise<void> {
  held.get(end)?.();
  await settle();
}

async function open(): Promise<void> {
  model = new MeasureModel(1);
  removeCommands = addCommands(() => frameCommands(model.stage, model.reel.player.value));
  void model.load();
  await settle();
}

function press(key: string): void {
  window.dispatchEvent(new KeyboardEvent("keydown", { key }));
  window.dispatchEvent(new KeyboardEvent("keyup", { key }));
}

const frame = () => model.reel.player.value?.frame.value;

function proposed(vehicle_id: number, at: number): Partial<PointProposal>[] {
  const point = { vehicle_id, frame: at, point_px: [100, 200] as [number, number], expected_px: 0.5 };
  return [
    { ...point, point: "contact_rear" },
    { ...point, point: "roof" },
  ];
}

beforeEach(() => {
  vi.useFakeTimers();
  held = new Map();
  history.replaceState(null, "", `/surveys/1/measure?recording=1&vehicle=7&frame=${BEST}`);
  const server = new FakeServer();
  server.on("GET", /\/surveys\/1\/recordings$/, () => [recording(), recording({ id: 2 })]);
  server.on("GET", /\/vehicles$/, () => [
    vehicle([], { best_frame: BEST }),
    vehicle([], { id: 8, number: 8, recording_id: 2, best_frame: BEST }),
  ]);
  server.on("GET", /\/recordings\/1\/proposals$/, () => proposed(7, PROPOSED));
  server.on("GET", /\/recordings\/2\/proposals$/, () => proposed(8, PROPOSED));
});

afterEach(() => {
  removeCommands();
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

it("goes to what is proposed while nobody has pressed anything", async () => {
  hold("/recordings/1/proposals");
  await open();
  expect(frame()).toBe(BEST);
  await letGo("/recordings/1/proposals");
  expect(frame()).toBe(PROPOSED);
});

it("stays on a frame that was stepped to, though its picture is not here yet when the proposals come", async () => {
  hold("/recordings/1/proposals", `/frames/${BEST + 1}.jpg`);
  await open();
  expect(model.vehicleId.value).toBe(7);
  expect(model.seenFrame.value).toBe(BEST);
  press("f");
  expect(frame()).toBe(BEST + 1);
  await letGo("/recordings/1/proposals");
  expect(frame()).toBe(BEST + 1);
  await letGo(`/frames/${BEST + 1}.jpg`);
  expect(model.seenFrame.value).toBe(BEST + 1);
});

it("stays on the best frame if somebody has come back to it", async () => {
  hold("/recordings/1/proposals");
  await open();
  press("f");
  press("d");
  await letGo("/recordings/1/proposals");
  expect(frame()).toBe(BEST);
});

it("takes what was pressed on the frame of the address while the passes were on their way", async () => {
  hold("/vehicles");
  await open();
  expect(model.vehicleId.value).toBeNull();
  press("f");
  press("m");
  press(" ");
  await letGo("/vehicles");
  expect(model.vehicleId.value).toBe(7);
  expect(frame()).toBeGreaterThan(BEST);
  expect(model.stage.cursor.value).not.toBeNull();
  expect(model.reel.player.value?.playing.value).toBe(true);
});

it("keeps the proposals of the recording that is open when those of the one before come later", async () => {
  hold("/recordings/1/proposals");
  await open();
  model.go(1);
  await settle();
  expect(frame()).toBe(PROPOSED);
  await letGo("/recordings/1/proposals");
  expect(model.proposals.all.value).toHaveLength(2);
});

it("keeps what a key means where the proposals come after it, and offers them", async () => {
  hold("/recordings/1/proposals");
  await open();
  model.reel.player.value?.go(PROPOSED);
  await settle();
  press("1");
  await letGo("/recordings/1/proposals");
  expect(model.seenFrame.value).toBe(PROPOSED);
  expect(model.proposals.late.value).toBe(7);
  expect(model.proposals.shown.value).toBeNull();
  model.proposals.showLate();
  expect(model.proposals.shown.value?.targets.map(({ role }) => role)).toEqual(["roof"]);
});
