/** The order of work in a survey, as the rail and the menu list it. */
import type { IconName } from "../components";
import type { StepKey, Survey } from "../types";

export interface WorkEntry {
  name: string;
  title: string;
  path: string;
  icon: IconName;
  step: StepKey | null;
}

export const WORK: readonly WorkEntry[] = [
  { name: "survey", title: "Overview", path: "", icon: "overview", step: null },
  { name: "planning", title: "Plan the site", path: "/planning", icon: "search", step: null },
  { name: "camera", title: "Camera", path: "/camera", icon: "camera", step: "camera" },
  { name: "recordings", title: "Recordings", path: "/recordings", icon: "film", step: "recordings" },
  { name: "pose", title: "Road pose", path: "/pose", icon: "road", step: "pose" },
  { name: "measure", title: "Measure", path: "/measure", icon: "ruler", step: "vehicles" },
  { name: "checks", title: "Checks", path: "/checks", icon: "check", step: null },
  { name: "review", title: "Review", path: "/review", icon: "review", step: "review" },
  { name: "repeats", title: "Repeats", path: "/repeats", icon: "retry", step: null },
  { name: "scans", title: "Line scans", path: "/scans", icon: "scan", step: null },
  { name: "export", title: "Export", path: "/export", icon: "package", step: "results" },
];

/** Where a step of the survey is done. */
export function entryOfStep(key: StepKey): WorkEntry | undefined {
  return WORK.find((entry) => entry.step === key);
}

export function stepState(survey: Survey | null, key: StepKey | null) {
  return survey?.steps.find((step) => step.key === key)?.state ?? null;
}
