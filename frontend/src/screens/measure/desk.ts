/** As much of the measure page as the tools that place points need: they know this, not the page. */
import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Target } from "../../core/types";
import type { UndoStack } from "../../core/undo";
import type { Geometry } from "../../viewer/geometry";
import type { Player } from "../../viewer/player";
import type { ImagePoint } from "../../viewer/points";
import type { Stage } from "../../viewer/stage";
import type { Inset } from "../../viewer/values";
import type { Flow, FlowEvent, Role } from "./flow";
import type { Entry, Records } from "./records";

export interface Desk {
  readonly stage: Stage;
  readonly undo: UndoStack;
  readonly geometry: Geometry;
  readonly records: Records;
  readonly player: Signal<Player | null>;
  readonly flow: ReadonlySignal<Flow>;
  readonly vehicleId: ReadonlySignal<number | null>;
  readonly entries: ReadonlySignal<readonly Entry[]>;
  readonly seenFrame: ReadonlySignal<number>;
  readonly contact: ReadonlySignal<ImagePoint | null>;
  readonly awaiting: ReadonlySignal<Role | null>;
  readonly hasPose: ReadonlySignal<boolean>;
  dispatch(event: FlowEvent): void;
  insetOf(target: Target): Inset | null;
}
