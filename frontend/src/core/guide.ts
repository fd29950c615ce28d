/** Where the guide speaks of each page of the app: "page#section". */
import type { PlaceName } from "./places";

export const GUIDE_OF: Record<PlaceName, string> = {
  "sign-in": "administrator#people",
  surveys: "first-survey",
  survey: "first-survey#1-create-the-survey",
  planning: "field-protocol#before-the-day",
  camera: "operator#camera",
  recordings: "operator#recordings",
  pose: "operator#road",
  measure: "operator#measure",
  checks: "operator#checks",
  review: "reviewer#review",
  lots: "reviewer#lots",
  repeats: "operator#repeatability",
  "click-again": "operator#repeatability",
  scans: "operator#line-scans",
  "scan-results": "operator#line-scans",
  live: "operator#live-line-scans",
  scan: "operator#line-scans",
  export: "standards-engineer#tracing-a-value",
  statistics: "standards-engineer#statistics",
  "sight-distance": "standards-engineer#sight-distance",
  studies: "standards-engineer#studies",
  study: "standards-engineer#studies",
  catalogue: "operator#catalogue",
  audit: "administrator#jobs-and-the-audit-trail",
  history: "administrator#jobs-and-the-audit-trail",
  settings: "first-survey#1-create-the-survey",
  jobs: "administrator#jobs-and-the-audit-trail",
  system: "administrator#watch",
  people: "administrator#people",
  account: "administrator#people",
  guide: "first-survey",
};

/** The address of a place in the guide, "page" or "page#section". */
export function guideAddress(place: string): string {
  const [page, section] = place.split("#");
  return `/guide?page=${page}${section ? `&section=${section}` : ""}`;
}
