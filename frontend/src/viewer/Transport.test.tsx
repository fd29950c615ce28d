import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer, recording } from "../../testing/server";
import { Player } from "./player";
import { FrameStage } from "./stage";
import { frameCommands } from "./stageCommands";
import { Transport } from "./Transport";

let player: Player;
const stage = new FrameStage();
const run = (id: string) => frameCommands(stage, player).find((one) => one.id === id);

beforeEach(() => {
  new FakeServer();
  player = new Player(1, 40);
  render(<Transport player={player} stage={stage} />, document.body);
});

afterEach(() => {
  render(null, document.body);
  player.close();
  vi.unstubAllGlobals();
});

it("takes its key as soon as it is there, before the browser has painted", () => {
  run("frameGo")?.run(true);
  expect(document.activeElement?.getAttribute("data-testid")).toBe("frame-box");
});

it("goes to the last frame once it is known which that is", () => {
  expect(run("frameLast")?.enabled?.()).toBe(false);
  player.describe(recording({ frame_count: 100 }));
  expect(run("frameLast")?.enabled?.()).toBe(true);
  run("frameLast")?.run(true);
  expect(player.frame.value).toBe(99);
});
