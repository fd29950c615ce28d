import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, describe, expect, it, vi } from "vitest";
import { Picture } from "./Picture";
import { type ImagePoint, pair } from "./points";
import { FrameStage } from "./stage";
import type { Tool } from "./tool";

afterEach(() => {
  render(null, document.body);
});

function shown(tool: Tool<ImagePoint>) {
  const stage: FrameStage = new FrameStage(() => [stage.keyboard, tool]);
  const drawn: number[] = [];
  act(() =>
    render(
      <Picture
        stage={stage}
        class="frame-view"
        testId="frame-view"
        what="frame"
        label="Frame 1"
        draw={(_canvas, view) => void drawn.push(view.scale)}
      />,
      document.body,
    ),
  );
  stage.view.value = stage.view.value.resized({ width: 640, height: 480 });
  const element = document.querySelector("[data-testid=frame-view]") as HTMLElement;
  const send = (type: string, x: number, y: number) =>
    act(() => {
      element.dispatchEvent(
        new PointerEvent(type, { bubbles: true, button: 0, clientX: x, clientY: y, pointerId: 1 }),
      );
    });
  return { stage, element, send, drawn };
}

describe("a picture in the page", () => {
  it("gives presses, slides and the wheel to its tools and its view, and is drawn again", async () => {
    const placed: number[][] = [];
    const { stage, element, send, drawn } = shown({
      place: (at) => {
        placed.push(pair(at));
        return true;
      },
      layers: () => <circle class="mark" />,
    });
    expect(element.querySelector("svg .mark")).not.toBeNull();
    send("pointerdown", 100.5, 50.5);
    send("pointermove", 104.5, 50.5);
    send("pointerup", 104.5, 50.5);
    expect(placed).toEqual([[100, 50]]);
    const { scale } = stage.view.value;
    element.dispatchEvent(
      new WheelEvent("wheel", { deltaY: -100, clientX: 5, clientY: 5, cancelable: true }),
    );
    expect(stage.view.value.scale).toBeGreaterThan(scale);
    await vi.waitFor(() => expect(drawn.at(-1)).toBe(stage.view.value.scale));
  });

  it("can be focused and clicked on as soon as it is there, before the browser has painted", () => {
    const stage = new FrameStage();
    render(
      <Picture stage={stage} class="frame-view" testId="frame-view" what="frame" label="" draw={() => {}} />,
      document.body,
    );
    stage.focus();
    expect(document.activeElement?.getAttribute("data-testid")).toBe("frame-view");
  });

  it("draws the keyboard's cursor", () => {
    const { stage } = shown({ place: () => true });
    act(() => void stage.keyboard.toggle());
    expect(document.querySelector("[data-testid=keyboard-cursor]")).not.toBeNull();
  });
});
