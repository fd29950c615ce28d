/** The code and the words of each place; they come when the place is first shown. */
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { learn } from "../core/messages";
import type { PlaceName, ScreenProps } from "../core/places";

type Screen = ComponentType<ScreenProps>;

const LOADERS: Record<PlaceName, () => Promise<{ default: Screen }>> = {
  "sign-in": () => import("../screens/signin/SignInScreen"),
  surveys: () => import("../screens/surveys/SurveysScreen"),
  survey: () => import("../screens/survey/SurveyScreen"),
  planning: () => import("../screens/planning/PlanningScreen"),
  camera: () => import("../screens/camera/CameraScreen"),
  recordings: () => import("../screens/recordings/RecordingsScreen"),
  pose: () => import("../screens/pose/PoseScreen"),
  measure: () => import("../screens/measure/MeasureScreen"),
  checks: () => import("../screens/checks/ChecksScreen"),
  review: () => import("../screens/review/ReviewScreen"),
  lots: () => import("../screens/checks/LotsScreen"),
  repeats: () => import("../screens/repeats/RepeatsScreen"),
  "click-again": () => import("../screens/repeats/ClickAgainScreen"),
  scans: () => import("../screens/scans/ScansScreen"),
  "scan-results": () => import("../screens/scans/ResultsScreen"),
  live: () => import("../screens/live/LiveScreen"),
  scan: () => import("../screens/scans/BenchScreen"),
  export: () => import("../screens/export/ExportScreen"),
  statistics: () => import("../screens/statistics/StatisticsScreen"),
  "sight-distance": () => import("../screens/sightdistance/SightScreen"),
  studies: () => import("../screens/studies/StudiesScreen"),
  study: () => import("../screens/study/StudyScreen"),
  catalogue: () => import("../screens/catalogue/CatalogueScreen"),
  audit: () => import("../screens/audit/AuditScreen"),
  history: () => import("../screens/audit/AuditScreen"),
  settings: () => import("../screens/survey/SettingsScreen"),
  jobs: () => import("../screens/jobs/JobsScreen"),
  system: () => import("../screens/system/SystemScreen"),
  people: () => import("../screens/people/PeopleScreen"),
  account: () => import("../screens/account/AccountScreen"),
  guide: () => import("../screens/guide/GuideScreen"),
};

/** Whose words a place says, where that is not the folder of its own name. */
const ROOMS: Partial<Record<PlaceName, string>> = {
  "sign-in": "signin",
  lots: "checks",
  history: "audit",
  settings: "survey",
  "click-again": "repeats",
  "scan-results": "scans",
  scan: "scans",
  "sight-distance": "sightdistance",
};

// a signal: the code may come while a page is between being drawn and being looked after
const loaded = signal<ReadonlyMap<PlaceName, Screen>>(new Map());

export function roomOf(name: PlaceName): string {
  return ROOMS[name] ?? name;
}

export function loadedScreen(name: PlaceName): Screen | undefined {
  return loaded.value.get(name);
}

export async function loadScreen(name: PlaceName): Promise<void> {
  const [{ default: screen }] = await Promise.all([LOADERS[name](), learn(roomOf(name))]);
  loaded.value = new Map(loaded.value).set(name, screen);
}
