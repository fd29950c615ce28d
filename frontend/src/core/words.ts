/** The words of the domain: what can be measured on a vehicle, and the states that things are in. */
import type { Target } from "./types";

export const TARGETS: readonly Target[] = ["roof", "driver_eye", "taillight", "headlight", "other"];
/** A vehicle is measured when it has these three. */
export const REQUIRED: readonly Target[] = ["roof", "driver_eye", "taillight"];

export const TARGET_WORDS: Record<Target, string> = {
  roof: "Roof",
  driver_eye: "Driver's eye",
  taillight: "Taillight",
  headlight: "Headlight",
  other: "Other",
};

/** Where to click, in the operator's words. */
export const TARGET_HINTS: Record<Target, string> = {
  roof: "the highest point of the roof",
  driver_eye: "the driver's eye",
  taillight: "the lower limit of the lit area of the taillight",
  headlight: "the lower limit of the headlight",
  other: "the point whose height you want",
};

export const STATE_WORDS = {
  // vehicles
  to_do: "to do",
  partial: "partly measured",
  measured: "measured",
  // reviews
  to_review: "to review",
  accepted: "accepted",
  fixed: "fixed",
  rejected: "rejected",
  reopened: "reopened",
  withdrawn: "withdrawn",
  not_measurable: "not measurable",
  // steps
  done: "done",
  next: "next",
  waiting: "waiting",
  // recordings and jobs
  ingesting: "being read",
  ready: "ready",
  failed: "failed",
  queued: "queued",
  running: "running",
  cancelled: "cancelled",
  // calibrations
  trusted: "trusted",
  not_trusted: "not to be trusted",
  used: "used",
  left_out: "left out",
  // people
  active: "active",
  inactive: "switched off",
} as const;

export type StateName = keyof typeof STATE_WORDS;
