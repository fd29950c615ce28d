/** The pages of the app: name, path, title, layout. What is shown at each is `app/screens.ts`. */

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
  | "repeats"
  | "click-again"
  | "scans"
  | "scan-results"
  | "scan"
  | "export"
  | "statistics"
  | "audit"
  | "people"
  | "account";

export interface Place {
  name: PlaceName;
  /** "/surveys/:id/camera" */
  pattern: string;
  title: string;
  /** "bench": the order of work beside it; "full": the whole window; "alone": a page by itself; "bare": without the top bar */
  layout: "bench" | "full" | "alone" | "bare";
}

export const PLACES: readonly Place[] = [
  {
    name: "sign-in",
    pattern: "/sign-in",
    title: "Sign in",
    layout: "bare",
  },
  {
    name: "surveys",
    pattern: "/",
    title: "Surveys",
    layout: "alone",
  },
  {
    name: "survey",
    pattern: "/surveys/:id",
    title: "Overview",
    layout: "bench",
  },
  {
    name: "planning",
    pattern: "/surveys/:id/planning",
    title: "Planning",
    layout: "bench",
  },
  {
    name: "camera",
    pattern: "/surveys/:id/camera",
    title: "Camera",
    layout: "bench",
  },
  {
    name: "recordings",
    pattern: "/surveys/:id/recordings",
    title: "Recordings",
    layout: "bench",
  },
  {
    name: "pose",
    pattern: "/surveys/:id/pose",
    title: "Road pose",
    layout: "full",
  },
  {
    name: "measure",
    pattern: "/surveys/:id/measure",
    title: "Measure",
    layout: "full",
  },
  {
    name: "checks",
    pattern: "/surveys/:id/checks",
    title: "Checks",
    layout: "bench",
  },
  {
    name: "review",
    pattern: "/surveys/:id/review",
    title: "Review",
    layout: "full",
  },
  {
    name: "repeats",
    pattern: "/surveys/:id/repeats",
    title: "Repeats",
    layout: "bench",
  },
  {
    name: "click-again",
    pattern: "/surveys/:id/repeats/click",
    title: "Click again",
    layout: "full",
  },
  {
    name: "scans",
    pattern: "/surveys/:id/scans",
    title: "Line scans",
    layout: "bench",
  },
  {
    name: "scan-results",
    pattern: "/surveys/:id/scans/results",
    title: "Motion",
    layout: "bench",
  },
  {
    name: "scan",
    pattern: "/surveys/:id/scan",
    title: "Line scan",
    layout: "full",
  },
  {
    name: "export",
    pattern: "/surveys/:id/export",
    title: "Export",
    layout: "bench",
  },
  {
    name: "statistics",
    pattern: "/statistics",
    title: "Statistics",
    layout: "alone",
  },
  {
    name: "audit",
    pattern: "/audit",
    title: "Audit",
    layout: "alone",
  },
  {
    name: "people",
    pattern: "/people",
    title: "People",
    layout: "alone",
  },
  {
    name: "account",
    pattern: "/account",
    title: "Account",
    layout: "alone",
  },
];

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
