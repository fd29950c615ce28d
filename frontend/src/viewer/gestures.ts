/** The pointer on a picture, once for frames and strips: press, slide, drag of a handle, pan, wheel. */
import { say } from "../core/messages";
import { toast } from "../core/toasts";
import { type ScreenPoint, screenDistance, screenPoint } from "./points";
import type { Grabbed, PictureStage } from "./stage";
import type { View } from "./view";

/** A handle, or a picture that is panned by dragging, follows the pointer from here on. */
const DRAG_PX = 3;
/** A hand slides while it clicks: so far the click still counts, at the place where the button was pressed. */
const SLIDE_PX = 8;
const PICK_PX = 11;
/** A finger is that much broader than a pointer. */
const FINGER_PX = 28;
const WHEEL_LINE = 0.05;
const WHEEL_PX = 0.0016;

export interface GestureOptions {
  /** Nothing is clicked or dragged while it answers true: a stand-in is shown. */
  blocked?(): boolean;
  /** What is shown; a click counts only on what was shown when the button was pressed. */
  subject?(): unknown;
  /** Dragging with the first button moves the picture where it holds no handle. */
  readonly panByDrag?: boolean;
}

interface Press<P> {
  readonly start: ScreenPoint;
  last: ScreenPoint;
  /** Where the button was pressed in the picture, whatever moves afterwards. */
  readonly at: P;
  readonly subject: unknown;
  readonly grabbed: Grabbed<P> | null;
  /** Where in the handle it was gripped, so that it does not jump under the pointer. */
  readonly grip: readonly [number, number];
  readonly pan: boolean;
  doing: "nothing" | "panning" | "dragging";
  /** By a finger, which hides what it points at: a tap is adjusted and confirmed. */
  readonly touch: boolean;
}

/** Fingers on the picture, by the browser's number of each. */
type Fingers = Map<number, ScreenPoint>;

/** Places of events are the browser's client pixels: the window of the picture may itself move between two of them. */
export class Gestures<P, V extends View<P, V>> {
  options: GestureOptions = {};
  private readonly fingers: Fingers = new Map();
  private press: Press<P> | null = null;
  private lastMove: ScreenPoint | null = null;

  constructor(private readonly stage: PictureStage<P, V>) {}

  get pressed(): boolean {
    return this.press !== null;
  }

  /** Whether a drag from here would move a handle: the pointer says so. */
  overHandle(client: ScreenPoint): boolean {
    const { stage } = this;
    return !stage.placing.value && stage.grab(stage.fromClient(client[0], client[1]), PICK_PX) !== null;
  }

  /** One more finger; two of them zoom and move the picture, and what the first began has not happened. */
  fingerDown(id: number, client: ScreenPoint): void {
    this.fingers.set(id, client);
    if (this.fingers.size === 1) this.down(client, 0, false, true);
    else this.cancel();
  }

  fingerMove(id: number, client: ScreenPoint): void {
    const before = this.fingers.get(id);
    if (!before) return;
    const other = [...this.fingers].find(([one]) => one !== id)?.[1];
    this.fingers.set(id, client);
    if (!other) {
      // a finger does not hover: what it put down stays
      if (this.press) this.follow(this.press, client);
      return;
    }
    const { stage } = this;
    const middle = (one: ScreenPoint) => screenPoint((one[0] + other[0]) / 2, (one[1] + other[1]) / 2);
    const [was, is] = [middle(before), middle(client)];
    const factor = screenDistance(client, other) / Math.max(screenDistance(before, other), 1);
    const at = stage.fromClient(was[0], was[1]);
    stage.view.value = stage.view.value.zoom(at, factor).pan(is[0] - was[0], is[1] - was[1]);
  }

  /** The last finger ends what one finger began; after two, nothing. */
  fingerUp(id: number, client: ScreenPoint): void {
    this.fingers.delete(id);
    this.up(client);
    if (this.stage.cursor.value === null) this.stage.hover(null);
  }

  down(client: ScreenPoint, button: number, space: boolean, touch = false): void {
    if (button > 1) return;
    this.cancel();
    const { stage } = this;
    const inside = stage.fromClient(client[0], client[1]);
    const pan = button === 1 || space;
    const grabbed = pan ? null : stage.grab(inside, touch ? FINGER_PX : PICK_PX);
    const centre = grabbed ? stage.view.value.toScreen(grabbed.handle.at) : inside;
    this.press = {
      start: client,
      last: client,
      at: stage.view.value.toPicture(inside),
      subject: this.options.subject?.(),
      grabbed,
      grip: [centre[0] - inside[0], centre[1] - inside[1]],
      pan,
      doing: "nothing",
      touch,
    };
    stage.hold(true);
    stage.letGo = () => this.cancel();
  }

  move(client: ScreenPoint): void {
    const { press, stage } = this;
    // a browser repeats the last move when the layout changes under a pointer that rests
    const rests = this.lastMove !== null && screenDistance(this.lastMove, client) === 0;
    this.lastMove = client;
    if (press) this.follow(press, client);
    if (stage.dragging.value || rests) return;
    stage.keyboard.off();
    this.hover(client);
  }

  up(client: ScreenPoint): void {
    const { press, stage } = this;
    if (!press) return;
    const tapped = press.grabbed && !stage.placing.value;
    if (press.doing === "dragging" && !this.blocked) {
      const at = this.gripped(press, client);
      this.end();
      press.grabbed?.tool.drag?.(press.grabbed.handle.id, at, "end");
    } else if (press.doing !== "nothing" || press.pan || this.blocked) this.cancel();
    else {
      this.end();
      const slid = screenDistance(press.start, client) > SLIDE_PX;
      if (tapped) press.grabbed?.tool.pick?.(press.grabbed.handle.id);
      else this.click(press, slid);
    }
  }

  /** The browser took the pointer away, or Esc: what was dragged goes back. */
  cancel(): void {
    const { press } = this;
    this.end();
    if (press?.doing === "dragging")
      press.grabbed?.tool.drag?.(press.grabbed.handle.id, press.grabbed.handle.at, "cancel");
  }

  leave(): void {
    this.lastMove = null;
    if (!this.press) this.stage.hover(null);
  }

  wheel(client: ScreenPoint, event: Pick<WheelEvent, "deltaX" | "deltaY" | "deltaMode" | "shiftKey">): void {
    const { stage } = this;
    const turn = Math.abs(event.deltaY) >= Math.abs(event.deltaX) ? event.deltaY : event.deltaX;
    const factor = Math.exp(-turn * (event.deltaMode === 1 ? WHEEL_LINE : WHEEL_PX));
    stage.view.value = stage.view.value.zoom(stage.fromClient(client[0], client[1]), factor, event.shiftKey);
    this.hover(client);
  }

  private get blocked(): boolean {
    return this.options.blocked?.() === true;
  }

  private hover(client: ScreenPoint): void {
    const view = this.stage.view.value;
    const at = view.toPicture(this.stage.fromClient(client[0], client[1]));
    this.stage.hover(view.contains(at) ? at : null);
  }

  private follow(press: Press<P>, client: ScreenPoint): void {
    const { stage } = this;
    if (press.doing === "nothing") press.doing = this.begun(press, screenDistance(press.start, client));
    if (press.doing === "panning") {
      stage.panned = true;
      stage.view.value = stage.view.value.pan(client[0] - press.last[0], client[1] - press.last[1]);
    } else if (press.doing === "dragging" && press.grabbed && !this.blocked) {
      const at = this.gripped(press, client);
      stage.dragging.value = true;
      stage.pointer.value = at;
      press.grabbed.tool.drag?.(press.grabbed.handle.id, at, "move");
    }
    press.last = client;
  }

  private begun(press: Press<P>, distance: number): Press<P>["doing"] {
    if (distance <= DRAG_PX) return "nothing";
    if (press.pan) return "panning";
    if (press.grabbed?.tool.drag) return this.blocked ? "nothing" : "dragging";
    // while points are placed a short slide is still a click
    const far = this.stage.placing.value ? SLIDE_PX : DRAG_PX;
    const pans = this.options.panByDrag === true || press.touch;
    return pans && distance > far ? "panning" : "nothing";
  }

  private gripped(press: Press<P>, client: ScreenPoint): P {
    const [x, y] = this.stage.fromClient(client[0], client[1]);
    return this.stage.view.value.toPicture(screenPoint(x + press.grip[0], y + press.grip[1]));
  }

  private click(press: Press<P>, slid: boolean): void {
    const { stage } = this;
    if (!stage.view.value.contains(press.at)) return;
    if (slid || press.subject !== this.options.subject?.()) {
      if (stage.placing.value) toast(say(slid ? "viewer-slid" : "viewer-changed"));
      return;
    }
    if (press.touch && stage.placing.value) stage.keyboard.begin(press.at);
    else stage.place(press.at);
  }

  private end(): void {
    if (!this.press) return;
    this.press = null;
    this.stage.letGo = null;
    this.stage.dragging.value = false;
    this.stage.hold(false);
  }
}
