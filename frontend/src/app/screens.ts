/** The code of each place; it comes when the place is first shown. */
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
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

// a signal: the code may come while a page is between being drawn and being looked after
const loaded = signal<ReadonlyMap<PlaceName, Screen>>(new Map());

/** The screen of a place whose code is here. */
export function loadedScreen(name: PlaceName): Screen | undefined {
  return loaded.value.get(name);
}

export async function loadScreen(name: PlaceName): Promise<void> {
  const screen = (await LOADERS[name]()).default;
  loaded.value = new Map(loaded.value).set(name, screen);
}
