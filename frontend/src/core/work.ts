/** The order of work in a survey, as the rail, the menu and the overview list it. */
import type { PlaceName } from "./places";
import type { StepKey, Survey } from "./types";

export interface WorkEntry {
  name: PlaceName;
  path: string;
  step: StepKey | null;
}

export const WORK = [
  { name: "survey", path: "", step: null },
  { name: "planning", path: "/planning", step: null },
  { name: "camera", path: "/camera", step: "camera" },
  { name: "recordings", path: "/recordings", step: "recordings" },
  { name: "pose", path: "/pose", step: "pose" },
  { name: "measure", path: "/measure", step: "vehicles" },
  { name: "checks", path: "/checks", step: null },
  { name: "review", path: "/review", step: "review" },
  { name: "repeats", path: "/repeats", step: null },
  { name: "scans", path: "/scans", step: null },
  { name: "export", path: "/export", step: "results" },
] as const satisfies readonly WorkEntry[];

/** What comes of the work: pages that may be of several surveys. */
export const RESULTS = [
  { name: "statistics", query: "survey" },
  { name: "sight-distance", query: "survey" },
  { name: "studies", query: null },
  { name: "catalogue", query: null },
  { name: "audit", query: "survey_id" },
] as const satisfies readonly { name: PlaceName; query: string | null }[];

export function resultAddress({ name, query }: (typeof RESULTS)[number], surveyId: number): string {
  return query ? `/${name}?${query}=${surveyId}` : `/${name}`;
}

/** Where a step of the survey is done. */
export function entryOfStep(key: StepKey): WorkEntry | undefined {
  return WORK.find((entry) => entry.step === key);
}

export function stepState(survey: Survey | null, key: StepKey | null) {
  return survey?.steps.find((step) => step.key === key)?.state ?? null;
}
