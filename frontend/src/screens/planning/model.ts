import type { components } from "#schema";
import { wordsOf } from "../../core/messages";

type Schemas = components["schemas"];
export type Plan = Schemas["PlanBody"];
export type PlannedTarget = Schemas["PlannedTargetBody"];
export type Passing = Schemas["Passing"];
export type LinePlan = Schemas["LinePlanBody"];
export type Curve = Schemas["Curve"];

const TARGET_WORDS: Readonly<Record<string, string>> = wordsOf({
  roof: "planning-roof",
  driver_eye: "planning-driver_eye",
  driver_eye_far: "planning-driver_eye_far",
  taillight: "planning-taillight",
  headlight: "planning-headlight",
});

export function wordOf(target: string): string {
  return TARGET_WORDS[target] ?? target;
}
