/** What is done on the strips: a rod's marks, heights, two lines of a vehicle, and its boundaries when nothing else is taken up. */
import { computed, signal } from "@preact/signals";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { toast } from "../../core/toasts";
import { formatLength } from "../../core/units";
import { EDGES, type Edge } from "../../parts/strips/draw";
import { type Place, type StripPoint, type StripsView, xOf } from "../../parts/strips/view";
import { type ScreenPoint, screenPoint } from "../../viewer/points";
import type { DragPhase, Handle, Tool } from "../../viewer/tool";
import type { Strips } from "./bench";
import type { LineHeights } from "./heights";
import type { RodDraft } from "./rod";

const always = computed(() => true);

/** Points are clicked on camera 1; a click elsewhere says so. */
function onCamera1(view: StripsView, at: StripPoint, use: (at: Place) => void): boolean {
  if (isOnCamera1(view, at)) use(at);
  else toast(say("scan-click-camera-1"));
  return true;
}

function isOnCamera1(view: StripsView, { camera, row }: StripPoint): boolean {
  return camera === 1 && row >= -0.5 && row <= view.strips.rows - 0.5;
}

export class RodTool implements Tool<StripPoint> {
  readonly placing = always;
  readonly hint = computed(() => {
    const { distance_m, height_m } = this.rod.next.value;
    if (distance_m === null) return say("scan-click-rod-distance");
    return say("scan-click-rod", {
      distance: formatLength(distance_m, 2),
      height: formatLength(height_m, 2),
    });
  });

  constructor(
    private readonly model: Strips,
    private readonly rod: RodDraft,
  ) {}

  place(at: StripPoint): boolean {
    return onCamera1(this.model.view.value, at, (place) => this.rod.click(place));
  }
}

export class HeightTool implements Tool<StripPoint> {
  readonly placing = always;
  readonly hint = computed(() => {
    if (!this.heights.contact.value) return say("scan-click-tyre");
    const target = this.heights.target.value;
    return target ? say("scan-click-target", { target }) : say("scan-click-any-target");
  });

  constructor(
    private readonly model: Strips,
    private readonly heights: LineHeights,
  ) {}

  place(at: StripPoint): boolean {
    return onCamera1(this.model.view.value, at, (place) => void this.heights.click(place));
  }

  hover(at: StripPoint | null): boolean {
    this.heights.point(at && isOnCamera1(this.model.view.value, at) ? at : null);
    return true;
  }
}

/** Two lines clicked one after the other: both hubs, or front and rear. */
export class TwoLines implements Tool<StripPoint> {
  readonly first = signal<number | null>(null);
  readonly placing = always;
  readonly hint = computed(() => {
    const second = this.first.value !== null;
    return this.model.mode.value === "wheels"
      ? say(second ? "scan-click-rear-wheel" : "scan-click-front-wheel")
      : say(second ? "scan-click-rear" : "scan-click-front");
  });

  constructor(
    private readonly model: Strips,
    private readonly both: (low: number, high: number) => void,
  ) {}

  place(at: StripPoint): boolean {
    return onCamera1(this.model.view.value, at, ({ line }) => {
      const first = this.first.value;
      this.first.value = first === null ? line : null;
      if (first !== null) this.both(Math.min(first, line), Math.max(first, line));
    });
  }

  back(): boolean {
    const begun = this.first.value !== null;
    this.first.value = null;
    return begun;
  }
}

/** How near a click must be to an axle's line to take it away, px. */
const NEAR_PX = 8;

/** All wheels of a vehicle: a click adds a hub's line, a click on a line takes it away. */
export class AxlesTool implements Tool<StripPoint> {
  readonly placing = always;
  readonly hint = computed(() => say("scan-click-axle"));

  constructor(
    private readonly model: Strips,
    private readonly lines: () => readonly number[],
    private readonly store: (lines: readonly number[]) => void,
  ) {}

  place(at: StripPoint): boolean {
    const view = this.model.view.value;
    return onCamera1(view, at, ({ line }) => {
      const near = (one: number) => Math.abs(xOf(view, one) - xOf(view, line)) <= NEAR_PX;
      const now = this.lines();
      const kept = now.filter((one) => !near(one));
      this.store(kept.length < now.length ? kept : [...now, line].sort((a, b) => a - b));
    });
  }
}

/** The vehicles: a click chooses one, its boundaries are dragged and nudged, and so are the points of its heights. */
export class Boundaries implements Tool<StripPoint> {
  readonly handles = computed<readonly Handle<StripPoint>[]>(() => {
    const lines = this.model.boundaries.crossings.value;
    if (!lines || !canWork.value || this.model.mode.value !== "look") return [];
    return EDGES.map((edge) => this.handleOf(edge, lines[edge]));
  });

  constructor(
    private readonly model: Strips,
    private readonly heights: LineHeights,
  ) {}

  place(at: StripPoint): boolean {
    const id = vehicleAt(this.model, at);
    if (id !== this.model.chosenId.value) this.model.choose(id);
    return true;
  }

  pick(handle: string): void {
    this.model.boundaries.edge.value = handle as Edge;
    this.heights.selected.value = null;
  }

  drag(handle: string, at: StripPoint, phase: DragPhase): void {
    if (phase === "cancel") this.model.boundaries.draft.value = null;
    else this.model.boundaries.move(handle as Edge, at.line);
    if (phase === "end") void this.model.boundaries.store();
  }

  nudge(dx: number, dy: number): boolean {
    if (!canWork.value) return false;
    return this.heights.nudge(dx, dy) || (dy === 0 && this.model.boundaries.nudge(dx));
  }

  cancel(): boolean {
    return this.model.cancel();
  }

  /** An upright line: how far the pointer is beside it counts, on its own strip. */
  private handleOf(edge: Edge, line: number): Handle<StripPoint> {
    const camera = edge.endsWith("1") ? 1 : 2;
    const at: StripPoint = { camera, line, row: 0 };
    const distance = (pointer: ScreenPoint): number => {
      const view = this.model.view.value;
      const here = view.toPicture(screenPoint(pointer[0], pointer[1])).camera === camera;
      return here ? Math.abs(xOf(view, line) - pointer[0]) : Number.POSITIVE_INFINITY;
    };
    return { id: edge, at, distance };
  }
}

function vehicleAt(model: Strips, { camera, line }: StripPoint): number | null {
  const found = model.vehicles.value.find(({ measurement }) => {
    if (!measurement) return false;
    const from = camera === 2 ? measurement.front_line_2 : measurement.front_line_1;
    const to = camera === 2 ? measurement.rear_line_2 : measurement.rear_line_1;
    return line >= from && line <= to;
  });
  return found?.id ?? null;
}
