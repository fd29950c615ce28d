import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../testing/server";
import { toasts } from "../../core/toasts";
import { MeasureModel } from "./model";

let model: MeasureModel;

beforeEach(() => {
  vi.useFakeTimers();
  toasts.value = [];
  const server = new FakeServer();
  server.on("GET", /\/recordings$/, () => [recording()]);
  server.on("GET", /\/vehicles$/, () => [vehicle(), vehicle([], { id: 8, number: 8 })]);
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

async function open(address: string): Promise<void> {
  history.replaceState(null, "", `/surveys/1/measure${address}`);
  model = new MeasureModel(1);
  await model.load();
  await vi.advanceTimersByTimeAsync(20);
}

const said = () => toasts.value.map((one) => one.text);

describe("an address of the measure page", () => {
  it("opens the pass that it names, and the first to do where it names none", async () => {
    await open("?vehicle=8");
    expect(model.vehicleId.value).toBe(8);
    model.close();
    await open("");
    expect(model.vehicleId.value).toBe(7);
    expect(said()).toEqual([]);
  });

  it.each([
    ["?vehicle=77", "vehicle"],
    ["?vehicle=x", "vehicle"],
    ["?recording=5&frame=3", "recording"],
    ["?recording=5", "recording"],
    ["?recording=1&frame=3&vehicle=77", "vehicle"],
  ])("%s: no other pass is opened in its place, and it is said", async (address, what) => {
    await open(address);
    expect(model.vehicleId.value).toBeNull();
    expect(said()).toEqual([expect.stringContaining(what)]);
    expect(model.reel.player.value?.recordingId).toBe(1);
  });
});
