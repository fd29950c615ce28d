import type { components } from "#schema";

type Schemas = components["schemas"];
export type Plan = Schemas["PlanBody"];
export type PlannedTarget = Schemas["PlannedTargetBody"];
export type LinePlan = Schemas["LinePlanBody"];
export type Curve = Schemas["CurveBody"];

const TARGET_WORDS: Record<string, string> = {
  roof: "Roof",
  driver_eye: "Driver’s eye, near side",
  driver_eye_far: "Driver’s eye, far side",
  taillight: "Taillight",
  headlight: "Headlight",
};

export function wordOf(target: string): string {
  return TARGET_WORDS[target] ?? target;
}
