/** Targets as the checks call them: an eye is near or far beside it. */
import { targetWords } from "../../core/words";

export const TARGET_NAMES = targetWords({ driver_eye: "checks-eye" });
