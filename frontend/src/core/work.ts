/** The pages of a survey in their four groups, as the rail and the menu list them. */
import type { PlaceName } from "./places";
import type { StepKey, Survey } from "./types";

export interface WorkEntry {
  name: PlaceName;
  address: (surveyId: number) => string;
  step: StepKey | null;
}

const within = (path: string) => (surveyId: number) => `/surveys/${surveyId}${path}`;
const about = (page: string, query: string) => (surveyId: number) => `/${page}?${query}=${surveyId}`;

export const GROUPS = [
  {
    key: "setup",
    entries: [
      { name: "survey", address: within(""), step: null },
      { name: "planning", address: within("/planning"), step: null },
      { name: "camera", address: within("/camera"), step: "camera" },
      { name: "recordings", address: within("/recordings"), step: "recordings" },
      { name: "pose", address: within("/pose"), step: "pose" },
    ],
  },
  {
    key: "measure",
    entries: [
      { name: "measure", address: within("/measure"), step: "vehicles" },
      { name: "scans", address: within("/scans"), step: null },
      { name: "review", address: within("/review"), step: "review" },
    ],
  },
  {
    key: "quality",
    entries: [
      { name: "checks", address: within("/checks"), step: null },
      { name: "repeats", address: within("/repeats"), step: null },
    ],
  },
  {
    key: "results",
    entries: [
      { name: "statistics", address: about("statistics", "survey"), step: null },
      { name: "sight-distance", address: about("sight-distance", "survey"), step: null },
      { name: "studies", address: () => "/studies", step: null },
      { name: "catalogue", address: () => "/catalogue", step: null },
      { name: "export", address: within("/export"), step: "results" },
      { name: "audit", address: about("audit", "survey_id"), step: null },
    ],
  },
] as const satisfies readonly { key: string; entries: readonly WorkEntry[] }[];

export type EntryName = (typeof GROUPS)[number]["entries"][number]["name"];

/** Where a step of the survey is done. */
export function entryOfStep(key: StepKey): WorkEntry | undefined {
  return GROUPS.flatMap((group): readonly WorkEntry[] => group.entries).find((entry) => entry.step === key);
}

export function stepState(survey: Survey | null, key: StepKey | null) {
  return survey?.steps.find((step) => step.key === key)?.state ?? null;
}
