import { wordsOf } from "../../core/messages";
import type { LinePlanBody, PlanBody, PlannedTargetBody } from "../../core/types";

export type Plan = PlanBody;
export type PlannedTarget = PlannedTargetBody;
export type LinePlan = LinePlanBody;

const TARGET_WORDS: Readonly<Record<string, string>> = wordsOf("planning-target-");

export function wordOf(target: string): string {
  return TARGET_WORDS[target] ?? target;
}
