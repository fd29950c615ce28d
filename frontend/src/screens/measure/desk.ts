/** As much of the measure page as the tools that place points need: they know this, not the page. */
import type { ReadonlySignal } from "@preact/signals";
import type { History } from "../../core/history";
import type { Target, Vehicle } from "../../core/types";
import type { Geometry } from "../../viewer/geometry";
import type { ImagePoint } from "../../viewer/points";
import type { Reel } from "../../viewer/reel";
import type { Tool } from "../../viewer/tool";
import type { Inset } from "../../viewer/values";
import type { Snapping } from "./assist/snapping";
import type { Changes } from "./fields";
import type { Effect, FlowEvent, Role } from "./flow";
import type { Reading } from "./reading";
import type { Standing } from "./standing";
import type { PassTable, Table } from "./table";

export interface Desk extends Table {
  readonly reel: Reel;
  readonly history: History;
  readonly snapping: Snapping;
  /** Whether contact clicks go to the tyre now. */
  readonly snaps: ReadonlySignal<boolean>;
  readonly geometry: Geometry;
  readonly standing: Standing;
  readonly awaiting: ReadonlySignal<Role | null>;
  readonly hasPose: ReadonlySignal<boolean>;
  /** What a click comes to is carried out by the tool that dispatched it. */
  dispatch(event: FlowEvent): Effect | null;
  insetOf(target: Target): Inset | null;
  stepName(step: string): string;
  answered(): void;
}

export interface PassDesk extends Desk, PassTable {
  readonly vehicle: ReadonlySignal<Vehicle | undefined>;
  readonly reading: Reading;
  readonly list: ReadonlySignal<readonly Vehicle[]>;
  open(vehicle: Vehicle, frame?: number): void;
  edit(changes: Changes): void;
}

/** A tool whose clicks make measurements. The first of them that is active says which contact counts, and what is awaited. */
export interface ClickTool extends Tool<ImagePoint> {
  readonly active: ReadonlySignal<boolean>;
  readonly contact: ReadonlySignal<ImagePoint | null>;
  readonly awaiting: ReadonlySignal<Role | null>;
}
