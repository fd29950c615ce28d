/** The pages of a survey in their groups, as the rail and the menu list them. */
import type { PlaceName } from "./places";
import type { StepKey, Survey } from "./types";

export interface WorkEntry {
  name: PlaceName;
  step: StepKey | null;
  tabs?: readonly PlaceName[];
}

export const GROUPS = [
  { key: "overview", entries: [{ name: "survey", step: null }] },
  {
    key: "setup",
    entries: [
      { name: "camera", step: "camera" },
      { name: "recordings", step: "recordings" },
      { name: "pose", step: "pose" },
    ],
  },
  {
    key: "measure",
    entries: [
      { name: "measure", step: "vehicles" },
      { name: "review", step: "review", tabs: ["lots", "click-again"] },
      { name: "scans", step: null, tabs: ["scan", "live"] },
    ],
  },
  { key: "quality", entries: [{ name: "checks", step: null, tabs: ["repeats"] }] },
  {
    key: "results",
    entries: [
      { name: "statistics", step: null, tabs: ["sight-distance", "scan-results"] },
      { name: "export", step: "results" },
      { name: "history", step: null },
    ],
  },
  {
    key: "aside",
    entries: [
      { name: "planning", step: null },
      { name: "settings", step: null },
    ],
  },
] as const satisfies readonly { key: string; entries: readonly WorkEntry[] }[];

export type EntryName = (typeof GROUPS)[number]["entries"][number]["name"];

/** The groups of a survey; line scans are listed where there are any, or where their page is open. */
export function groupsOf(survey: Survey | null, here: PlaceName) {
  const scanned = survey !== null && survey.scans.state !== "none";
  return GROUPS.map((group) => ({
    key: group.key,
    entries: group.entries.filter((entry) => entry.name !== "scans" || scanned || holds(entry, here)),
  }));
}

export function holds(entry: WorkEntry, page: PlaceName): boolean {
  return entry.name === page || (entry.tabs ?? []).includes(page);
}

export function entryOfStep(key: StepKey): WorkEntry {
  const entries = GROUPS.flatMap((group): readonly WorkEntry[] => group.entries);
  const found = entries.find((entry) => entry.step === key);
  if (!found) throw new Error(`no page for the step ${key}`);
  return found;
}

export function stepState(survey: Survey | null, key: StepKey | null) {
  return survey?.steps.find((step) => step.key === key)?.state ?? null;
}
