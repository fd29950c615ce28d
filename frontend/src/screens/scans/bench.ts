/** As much of the bench as heights and the rod's marks need: they know this, not the page. */
import type { ReadonlySignal, Signal } from "@preact/signals";
import type { ScanVehicle } from "../../core/types";
import type { View } from "./view";

export type Mode = "look" | "wheels" | "new" | "rod" | "height";

export interface Bench {
  readonly id: number;
  readonly chosenId: ReadonlySignal<number | null>;
  readonly chosen: ReadonlySignal<ScanVehicle | null>;
  readonly mode: Signal<Mode>;
  readonly view: Signal<View | null>;
  start(mode: Mode): void;
  cancel(): boolean;
  pushUndo(label: string, undo: () => Promise<void>, redo: () => Promise<void>): void;
  tell(work: () => Promise<void>): Promise<void>;
}
