/** What lies on the measure page's desk: as much of the page as what the desk is made of needs. */
import type { ReadonlySignal } from "@preact/signals";
import type { Target } from "../../core/types";
import type { ImagePoint } from "../../viewer/points";
import type { FrameStage } from "../../viewer/stage";
import type { Flow } from "./flow";
import type { Entry, Records } from "./records";
import type { Vehicles } from "./vehicles";

export interface Table {
  readonly stage: FrameStage;
  readonly records: Records;
  readonly flow: ReadonlySignal<Flow>;
  readonly vehicleId: ReadonlySignal<number | null>;
  readonly entries: ReadonlySignal<readonly Entry[]>;
  /** The frame that is seen; -1 while none is. */
  readonly seenFrame: ReadonlySignal<number>;
  readonly contact: ReadonlySignal<ImagePoint | null>;
  /** What is asked for of the open vehicle and was not said to be unseen. */
  asked(): readonly Target[];
}

/** The passes of the survey beside it. */
export interface PassTable extends Table {
  readonly surveyId: number;
  readonly loaded: ReadonlySignal<boolean>;
  readonly vehicles: Vehicles;
}
