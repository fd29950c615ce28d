/** What the checks send. */
import type { components } from "#schema";
import type { Target } from "../../core/types";

type Schemas = components["schemas"];

export type InsetCheck = Schemas["InsetCheck"];
export type TargetInsets = Schemas["TargetInsets"];
export type Estimate = Schemas["Estimate"];
export type WheelPair = Schemas["WheelPair"];
export type TrafficCheck = Schemas["TrafficCheckBody"];
export type TurnedPose = Schemas["TurnedPose"];

export const TARGET_NAMES: Record<Target, string> = {
  roof: "Roof",
  driver_eye: "Driver’s eye",
  taillight: "Taillight",
  headlight: "Headlight",
  other: "Other",
};

/** As in "use 0.34 m for roofs". */
export const TARGETS_MANY: Record<Target, string> = {
  roof: "roofs",
  driver_eye: "drivers’ eyes",
  taillight: "taillights",
  headlight: "headlights",
  other: "other targets",
};
