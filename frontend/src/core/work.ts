/** The order of work in a survey, as the rail, the menu and the overview list it. */
import type { PlaceName } from "./places";
import type { StepKey, Survey } from "./types";

export interface WorkEntry {
  name: PlaceName;
  title: string;
  path: string;
  step: StepKey | null;
}

export const WORK = [
  { name: "survey", title: "Overview", path: "", step: null },
  { name: "planning", title: "Plan the site", path: "/planning", step: null },
  { name: "camera", title: "Camera", path: "/camera", step: "camera" },
  { name: "recordings", title: "Recordings", path: "/recordings", step: "recordings" },
  { name: "pose", title: "Road pose", path: "/pose", step: "pose" },
  { name: "measure", title: "Measure", path: "/measure", step: "vehicles" },
  { name: "checks", title: "Checks", path: "/checks", step: null },
  { name: "review", title: "Review", path: "/review", step: "review" },
  { name: "repeats", title: "Repeats", path: "/repeats", step: null },
  { name: "scans", title: "Line scans", path: "/scans", step: null },
  { name: "export", title: "Export", path: "/export", step: "results" },
] as const satisfies readonly WorkEntry[];

/** Where a step of the survey is done. */
export function entryOfStep(key: StepKey): WorkEntry | undefined {
  return WORK.find((entry) => entry.step === key);
}

export function stepState(survey: Survey | null, key: StepKey | null) {
  return survey?.steps.find((step) => step.key === key)?.state ?? null;
}
