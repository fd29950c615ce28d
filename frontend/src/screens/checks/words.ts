/** Targets as the checks call them: an eye is near or far beside it. */
import { wordsOf } from "../../core/messages";
import type { Target } from "../../core/types";

export const TARGET_NAMES: Readonly<Record<Target, string>> = wordsOf({
  roof: "target-roof",
  driver_eye: "checks-eye",
  taillight: "target-taillight",
  headlight: "target-headlight",
  other: "target-other",
});
