/** As much of the bench as heights and the rod's marks need: they know this, not the page. */
import type { ReadonlySignal, Signal } from "@preact/signals";
import type { ChangeSet, History } from "../../core/history";
import type { ScanVehicle } from "../../core/types";
import type { StripsView } from "../../parts/strips/view";
import type { HeldBoundaries } from "./held";

/** The tool that is taken up; "look": none, boundaries are dragged and vehicles chosen. */
export type Mode = "look" | "wheels" | "axles" | "new" | "rod" | "height";

export interface Bench {
  readonly id: number;
  readonly chosenId: ReadonlySignal<number | null>;
  readonly chosen: ReadonlySignal<ScanVehicle | null>;
  readonly mode: Signal<Mode>;
  readonly view: Signal<StripsView>;
  readonly history: History;
  start(mode: Mode): void;
  cancel(): boolean;
  /** One change after the other, as a step; what goes wrong is told in words. */
  change(label: string, work: (changes: ChangeSet) => Promise<void> | void): Promise<void>;
  numberOf(vehicleId: number): number;
  /** The address of a vehicle on the bench. */
  page(vehicleId?: number): string;
  tell(work: () => Promise<void> | void): Promise<void>;
}

/** What the tools on the strips need beside that: the vehicles and the boundaries in hand. */
export interface Strips extends Bench {
  readonly vehicles: ReadonlySignal<readonly ScanVehicle[]>;
  readonly boundaries: HeldBoundaries;
  choose(id: number | null): void;
}
