/** What the checks send. */
import type { components } from "#schema";
import { wordsOf } from "../../core/messages";
import type { Target } from "../../core/types";

type Schemas = components["schemas"];

export type InsetCheck = Schemas["InsetCheck"];
export type TargetInsets = Schemas["TargetInsets"];
export type Estimate = Schemas["Estimate"];
export type WheelPair = Schemas["WheelPair"];
export type TrafficCheck = Schemas["TrafficCheckBody"];
export type TurnedPose = Schemas["TurnedPose"];

export const TARGET_NAMES: Readonly<Record<Target, string>> = wordsOf({
  roof: "target-roof",
  driver_eye: "checks-eye",
  taillight: "target-taillight",
  headlight: "target-headlight",
  other: "target-other",
});
