/** The pages of the app: name, path, title, layout. What is shown at each is `app/screens.ts`. */
import { say } from "./messages";

export interface ScreenProps {
  surveyId: number;
}

export type PlaceName =
  | "sign-in"
  | "surveys"
  | "survey"
  | "planning"
  | "camera"
  | "recordings"
  | "pose"
  | "measure"
  | "checks"
  | "review"
  | "lots"
  | "repeats"
  | "click-again"
  | "scans"
  | "scan-results"
  | "live"
  | "scan"
  | "export"
  | "statistics"
  | "sight-distance"
  | "studies"
  | "study"
  | "catalogue"
  | "audit"
  | "history"
  | "settings"
  | "jobs"
  | "system"
  | "people"
  | "account"
  | "guide";

export interface Place {
  name: PlaceName;
  /** "/surveys/:id/camera" */
  pattern: string;
  /** "bench": the order of work beside it; "full": the whole window; "alone": a page by itself; "bare": without the top bar */
  layout: "bench" | "full" | "alone" | "bare";
}

export const PLACES: readonly Place[] = [
  {
    name: "sign-in",
    pattern: "/sign-in",
    layout: "bare",
  },
  {
    name: "surveys",
    pattern: "/",
    layout: "alone",
  },
  {
    name: "survey",
    pattern: "/surveys/:id",
    layout: "bench",
  },
  {
    name: "planning",
    pattern: "/surveys/:id/planning",
    layout: "bench",
  },
  {
    name: "camera",
    pattern: "/surveys/:id/camera",
    layout: "bench",
  },
  {
    name: "recordings",
    pattern: "/surveys/:id/recordings",
    layout: "bench",
  },
  {
    name: "pose",
    pattern: "/surveys/:id/pose",
    layout: "full",
  },
  {
    name: "measure",
    pattern: "/surveys/:id/measure",
    layout: "full",
  },
  {
    name: "checks",
    pattern: "/surveys/:id/checks",
    layout: "bench",
  },
  {
    name: "review",
    pattern: "/surveys/:id/review",
    layout: "full",
  },
  {
    name: "lots",
    pattern: "/surveys/:id/lots",
    layout: "bench",
  },
  {
    name: "repeats",
    pattern: "/surveys/:id/repeats",
    layout: "bench",
  },
  {
    name: "click-again",
    pattern: "/surveys/:id/repeats/click",
    layout: "full",
  },
  {
    name: "scans",
    pattern: "/surveys/:id/scans",
    layout: "bench",
  },
  {
    name: "scan-results",
    pattern: "/surveys/:id/scans/results",
    layout: "bench",
  },
  {
    name: "live",
    pattern: "/surveys/:id/live",
    layout: "bench",
  },
  {
    name: "scan",
    pattern: "/surveys/:id/scan",
    layout: "full",
  },
  {
    name: "export",
    pattern: "/surveys/:id/export",
    layout: "bench",
  },
  {
    name: "history",
    pattern: "/surveys/:id/history",
    layout: "bench",
  },
  {
    name: "settings",
    pattern: "/surveys/:id/settings",
    layout: "bench",
  },
  {
    name: "statistics",
    pattern: "/statistics",
    layout: "alone",
  },
  {
    name: "sight-distance",
    pattern: "/sight-distance",
    layout: "alone",
  },
  {
    name: "studies",
    pattern: "/studies",
    layout: "alone",
  },
  {
    name: "study",
    pattern: "/study",
    layout: "alone",
  },
  {
    name: "catalogue",
    pattern: "/catalogue",
    layout: "alone",
  },
  {
    name: "audit",
    pattern: "/audit",
    layout: "alone",
  },
  {
    name: "jobs",
    pattern: "/jobs",
    layout: "alone",
  },
  {
    name: "system",
    pattern: "/system",
    layout: "alone",
  },
  {
    name: "people",
    pattern: "/people",
    layout: "alone",
  },
  {
    name: "account",
    pattern: "/account",
    layout: "alone",
  },
  {
    name: "guide",
    pattern: "/guide",
    layout: "alone",
  },
];

/** What a page is called. */
export function titleOf(name: PlaceName): string {
  return say(`page-${name}`);
}

const COMPILED = PLACES.map((place) => ({
  place,
  path: new RegExp(`^${place.pattern.replace(":id", "([1-9][0-9]{0,15})")}$`),
}));

export interface Match {
  place: Place;
  surveyId: number;
}

/** The place of a path, or null. An id is a positive integer; a trailing slash does not matter. */
export function match(pathname: string): Match | null {
  const bare = pathname.length > 1 ? pathname.replace(/\/+$/, "") : pathname;
  for (const { place, path } of COMPILED) {
    const parts = path.exec(bare);
    if (parts) return { place, surveyId: Number(parts[1] ?? 0) };
  }
  return null;
}
