import { signal } from "@preact/signals";
import { beforeEach, describe, expect, it } from "vitest";
import { toasts } from "../core/toasts";
import { type GestureOptions, Gestures } from "./gestures";
import { type ImagePoint, imagePoint, pair, screenPoint } from "./points";
import { FrameStage } from "./stage";
import type { DragPhase, Tool } from "./tool";

const at = (x: number, y: number) => screenPoint(x, y);

/** A stage on which one screen pixel is one picture pixel, and screen x is picture x + 0.5. */
function stageOf(tools: (stage: FrameStage) => readonly Tool<ImagePoint>[]) {
  const stage: FrameStage = new FrameStage(() => tools(stage));
  stage.setImage({ width: 640, height: 480 });
  stage.view.value = stage.view.value.resized({ width: 640, height: 480 });
  return stage;
}

/** Places points, and lets one handle be dragged. */
class Recorder implements Tool<ImagePoint> {
  readonly placing = signal(true);
  readonly handle = signal<ImagePoint>(imagePoint(100, 100));
  readonly handles = signal([{ id: "roof", at: this.handle.value }]);
  readonly placed: (readonly number[])[] = [];
  readonly drags: [DragPhase, readonly number[]][] = [];
  readonly picked: string[] = [];
  readonly hovers: (ImagePoint | null)[] = [];

  place(point: ImagePoint): boolean {
    this.placed.push(pair(point));
    return true;
  }
  hover(point: ImagePoint | null): boolean {
    this.hovers.push(point);
    return true;
  }
  pick(handle: string): void {
    this.picked.push(handle);
  }
  drag(_handle: string, point: ImagePoint, phase: DragPhase): void {
    this.drags.push([phase, pair(point)]);
  }
}

function hand(options: GestureOptions = {}) {
  const tool = new Recorder();
  const stage = stageOf((self) => [self.keyboard, tool]);
  const gestures = new Gestures(stage);
  gestures.options = options;
  return { tool, stage, gestures };
}

beforeEach(() => {
  toasts.value = [];
});

describe("a click on a picture", () => {
  it("places the point where the button was pressed, though the hand slides", () => {
    const { tool, gestures } = hand();
    gestures.down(at(200.5, 150.5), 0, false);
    gestures.move(at(205.5, 153.5));
    gestures.up(at(205.5, 153.5));
    expect(tool.placed).toEqual([[200, 150]]);
  });

  it("that goes far says that nothing was placed", () => {
    const { tool, gestures } = hand();
    gestures.down(at(200, 150), 0, false);
    gestures.move(at(260, 150));
    gestures.up(at(260, 150));
    expect(tool.placed).toEqual([]);
    expect(toasts.value[0]?.text).toContain("Nothing was placed");
  });

  it("counts only on the picture that was seen when the button went down", () => {
    let frame = 40;
    const { tool, gestures } = hand({ subject: () => frame });
    gestures.down(at(200, 150), 0, false);
    frame = 41;
    gestures.up(at(200, 150));
    expect(tool.placed).toEqual([]);
    expect(toasts.value[0]?.text).toContain("the image changed");
  });

  it("keeps its place when the picture or its window moves before the button is up", () => {
    const { tool, stage, gestures } = hand();
    const element = document.createElement("div");
    let width = 640;
    Object.defineProperty(element, "clientWidth", { get: () => width });
    Object.defineProperty(element, "clientHeight", { get: () => 480 });
    const detach = stage.attach(element);
    gestures.down(at(200.5, 150.5), 0, false);
    width = 320;
    stage.hold(true);
    expect(stage.view.value.screen.width).toBe(640);
    stage.view.value = stage.view.value.pan(40, 0);
    gestures.up(at(200.5, 150.5));
    expect(tool.placed).toEqual([[200, 150]]);
    expect(stage.view.value.screen.width).toBe(320);
    detach();
  });

  it("beside the picture, with a stand-in shown or with another button places nothing", () => {
    const { tool, stage, gestures } = hand({ blocked: () => blocked });
    let blocked = false;
    const click = (x: number, button = 0): void => {
      gestures.down(at(x, 150), button, false);
      gestures.up(at(x, 150));
    };
    stage.view.value = stage.view.value.pan(100, 0);
    click(50);
    click(300, 2);
    blocked = true;
    click(300);
    expect(tool.placed).toEqual([]);
  });

  it("on a handle picks it, unless points are placed", () => {
    const { tool, gestures } = hand();
    const click = (): void => {
      gestures.down(at(102, 101), 0, false);
      gestures.up(at(102, 101));
    };
    click();
    tool.placing.value = false;
    click();
    expect(tool.placed).toHaveLength(1);
    expect(tool.picked).toEqual(["roof"]);
  });
});

describe("a drag", () => {
  it("begins after a few pixels and does not jump under the pointer", () => {
    const { tool, stage, gestures } = hand();
    gestures.down(at(102.5, 101.5), 0, false);
    gestures.move(at(104.5, 101.5));
    expect(tool.drags).toEqual([]);
    gestures.move(at(112.5, 101.5));
    expect(stage.dragging.value).toBe(true);
    gestures.up(at(122.5, 111.5));
    expect(tool.drags).toEqual([
      ["move", [110, 100]],
      ["end", [120, 110]],
    ]);
    expect(stage.dragging.value).toBe(false);
    expect(tool.placed).toEqual([]);
  });

  it("is put back by Esc and when the browser takes the pointer away", () => {
    const { tool, stage, gestures } = hand();
    for (const giveUp of [() => void stage.cancel(), () => gestures.cancel()]) {
      gestures.down(at(100, 100), 0, false);
      gestures.move(at(150, 100));
      giveUp();
      gestures.up(at(150, 100));
      expect(tool.drags.at(-1)).toEqual(["cancel", [100, 100]]);
      expect(stage.dragging.value).toBe(false);
    }
    expect(tool.drags.filter(([phase]) => phase === "end")).toEqual([]);
  });

  it("with Space or the middle button moves the picture and nothing else", () => {
    for (const [button, space] of [
      [0, true],
      [1, false],
    ] as const) {
      const { tool, stage, gestures } = hand();
      const { left } = stage.view.value;
      gestures.down(at(100, 100), button, space);
      gestures.move(at(130, 100));
      gestures.up(at(130, 100));
      expect(stage.view.value.left - left).toBe(30);
      expect(stage.panned).toBe(true);
      expect([...tool.drags, ...tool.placed]).toEqual([]);
    }
  });

  it("of the picture itself leaves room for a slide while points are placed", () => {
    const { tool, stage, gestures } = hand({ panByDrag: true });
    const { left } = stage.view.value;
    const drag = (to: number): void => {
      gestures.down(at(300.5, 200.5), 0, false);
      gestures.move(at(to, 200.5));
      gestures.up(at(to, 200.5));
    };
    drag(306.5);
    expect(tool.placed).toEqual([[300, 200]]);
    expect(stage.view.value.left).toBe(left);
    drag(340.5);
    expect(tool.placed).toHaveLength(1);
    expect(stage.view.value.left).toBe(left + 40);
  });
});

describe("the wheel", () => {
  it("zooms at the pointer", () => {
    const { stage, gestures } = hand();
    const before = stage.view.value.toPicture(at(200, 100));
    gestures.wheel(at(200, 100), { deltaX: 0, deltaY: -300, deltaMode: 0, shiftKey: false });
    const after = stage.view.value.toPicture(at(200, 100));
    expect(stage.view.value.scale).toBeGreaterThan(1.5);
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
  });
});

describe("the keyboard's cursor", () => {
  it("stays on the picture, is kept in sight and previews what the pointer would", () => {
    const { tool, stage } = hand();
    stage.view.value = stage.view.value.zoom(at(0, 0), 4);
    expect(stage.keyboard.toggle()).toBe(true);
    for (let i = 0; i < 70; i += 1) stage.nudge(10, 0);
    const cursor = stage.cursor.value;
    expect(cursor?.[0]).toBe(639);
    const [x] = stage.view.value.toScreen(cursor ?? imagePoint(0, 0));
    expect(x).toBeLessThanOrEqual(640 - 40);
    expect(tool.hovers.at(-1)).toEqual(cursor);
    stage.nudge(0, -1000);
    expect(stage.cursor.value?.[1]).toBe(0);
  });

  it("places with Enter, and goes with Esc or as soon as the mouse moves", () => {
    const { tool, stage, gestures } = hand();
    expect(stage.confirm()).toBe(false);
    stage.pointer.value = imagePoint(20, 30);
    stage.keyboard.toggle();
    expect(stage.confirm()).toBe(true);
    expect(tool.placed).toEqual([[20, 30]]);
    expect(stage.cancel()).toBe(true);
    expect(stage.cursor.value).toBeNull();
    expect(tool.hovers.at(-1)).toBeNull();
    gestures.move(at(300, 300));
    stage.keyboard.toggle();
    gestures.move(at(300, 300)); // the layout changed under a pointer that rests
    expect(stage.cursor.value).not.toBeNull();
    gestures.move(at(301, 300));
    expect(stage.cursor.value).toBeNull();
  });

  it("does not come where nothing can be placed", () => {
    const stage = stageOf((self) => [self.keyboard, { nudge: () => true }]);
    expect(stage.keyboard.toggle()).toBe(false);
    expect(stage.cursor.value).toBeNull();
  });
});

describe("the tools of a stage", () => {
  it("are asked from the top, and the first that answers has it", () => {
    const calls: string[] = [];
    const takes = signal(true);
    const top: Tool<ImagePoint> = {
      hint: signal(null),
      place: () => {
        calls.push("top");
        return takes.value;
      },
      cancel: () => takes.value,
    };
    const below: Tool<ImagePoint> = {
      hint: signal("click the roof"),
      placing: signal(true),
      place: () => {
        calls.push("below");
        return true;
      },
      cancel: () => true,
    };
    const stage = stageOf(() => [top, below]);
    stage.place(imagePoint(1, 1));
    takes.value = false;
    stage.place(imagePoint(1, 1));
    expect(calls).toEqual(["top", "top", "below"]);
    expect(stage.hint.value).toBe("click the roof");
    expect(stage.placing.value).toBe(true);
  });

  it("change with what is going on", () => {
    const blind = signal(true);
    const stage = stageOf(() => [{ hint: signal(blind.value ? "blind" : "fix") }]);
    expect(stage.hint.value).toBe("blind");
    blind.value = false;
    expect(stage.hint.value).toBe("fix");
  });
});

describe("fingers on a picture", () => {
  it("tap a place, which is adjusted and confirmed before anything is stored", () => {
    const { tool, stage, gestures } = hand();
    tool.handles.value = [];
    gestures.fingerDown(1, at(200.5, 150.5));
    gestures.fingerMove(1, at(201.5, 150.5));
    gestures.fingerUp(1, at(201.5, 150.5));
    expect(tool.placed).toEqual([]);
    expect(stage.cursor.value).toEqual([200, 150]);
    expect(tool.hovers.at(-1)).toEqual([200, 150]);
    gestures.fingerDown(1, at(210.5, 150.5));
    gestures.fingerMove(1, at(230.5, 140.5));
    gestures.fingerUp(1, at(230.5, 140.5));
    expect(stage.cursor.value).toEqual([220, 140]);
    stage.keyboard.confirm();
    expect(tool.placed).toEqual([[220, 140]]);
    expect(stage.cursor.value).toBeNull();
  });

  it("zoom and move the picture when there are two, and place nothing", () => {
    const { tool, stage, gestures } = hand();
    tool.handles.value = [];
    const under = stage.fromWindow(300, 200);
    gestures.fingerDown(1, at(200, 200));
    gestures.fingerDown(2, at(400, 200));
    gestures.fingerMove(1, at(100, 200));
    gestures.fingerMove(2, at(500, 200));
    expect(stage.view.value.scale).toBeCloseTo(2);
    const [x, y] = stage.view.value.toScreen(under);
    expect([x, y]).toEqual([expect.closeTo(300), expect.closeTo(200)]);
    gestures.fingerUp(1, at(100, 200));
    gestures.fingerUp(2, at(500, 200));
    expect(tool.placed).toEqual([]);
    expect(stage.cursor.value).toBeNull();
  });
});
