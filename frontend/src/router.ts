/** Paths to screens. Links are plain `<a href>`; a click on one is taken here. */
import { computed, signal } from "@preact/signals";
import type { ComponentType } from "preact";

export interface ScreenProps {
  surveyId: number;
}

type Loader = () => Promise<{ default: ComponentType<ScreenProps> }>;

export interface Route {
  name: string;
  /** "/surveys/:id/camera" */
  pattern: string;
  title: string;
  /** "bench": the order of work beside it; "full": the whole window; "alone": a page by itself; "bare": without the top bar */
  layout: "bench" | "full" | "alone" | "bare";
  load: Loader;
}

export const ROUTES: readonly Route[] = [
  {
    name: "sign-in",
    pattern: "/sign-in",
    title: "Sign in",
    layout: "bare",
    load: () => import("./screens/signin/SignInScreen"),
  },
  {
    name: "surveys",
    pattern: "/",
    title: "Surveys",
    layout: "alone",
    load: () => import("./screens/surveys/SurveysScreen"),
  },
  {
    name: "survey",
    pattern: "/surveys/:id",
    title: "Overview",
    layout: "bench",
    load: () => import("./screens/survey/SurveyScreen"),
  },
  {
    name: "planning",
    pattern: "/surveys/:id/planning",
    title: "Planning",
    layout: "bench",
    load: () => import("./screens/planning/PlanningScreen"),
  },
  {
    name: "camera",
    pattern: "/surveys/:id/camera",
    title: "Camera",
    layout: "bench",
    load: () => import("./screens/camera/CameraScreen"),
  },
  {
    name: "recordings",
    pattern: "/surveys/:id/recordings",
    title: "Recordings",
    layout: "bench",
    load: () => import("./screens/recordings/RecordingsScreen"),
  },
  {
    name: "pose",
    pattern: "/surveys/:id/pose",
    title: "Road pose",
    layout: "full",
    load: () => import("./pose/PoseScreen"),
  },
  {
    name: "measure",
    pattern: "/surveys/:id/measure",
    title: "Measure",
    layout: "full",
    load: () => import("./measure/MeasureScreen"),
  },
  {
    name: "checks",
    pattern: "/surveys/:id/checks",
    title: "Checks",
    layout: "bench",
    load: () => import("./screens/checks/ChecksScreen"),
  },
  {
    name: "review",
    pattern: "/surveys/:id/review",
    title: "Review",
    layout: "full",
    load: () => import("./review/ReviewScreen"),
  },
  {
    name: "repeats",
    pattern: "/surveys/:id/repeats",
    title: "Repeats",
    layout: "bench",
    load: () => import("./screens/repeats/RepeatsScreen"),
  },
  {
    name: "click-again",
    pattern: "/surveys/:id/repeats/click",
    title: "Click again",
    layout: "full",
    load: () => import("./screens/repeats/ClickAgainScreen"),
  },
  {
    name: "scans",
    pattern: "/surveys/:id/scans",
    title: "Line scans",
    layout: "bench",
    load: () => import("./scan/ScansScreen"),
  },
  {
    name: "scan-results",
    pattern: "/surveys/:id/scans/results",
    title: "Motion",
    layout: "bench",
    load: () => import("./scan/ResultsScreen"),
  },
  {
    name: "scan",
    pattern: "/surveys/:id/scan",
    title: "Line scan",
    layout: "full",
    load: () => import("./scan/BenchScreen"),
  },
  {
    name: "export",
    pattern: "/surveys/:id/export",
    title: "Export",
    layout: "bench",
    load: () => import("./screens/export/ExportScreen"),
  },
  {
    name: "statistics",
    pattern: "/statistics",
    title: "Statistics",
    layout: "alone",
    load: () => import("./screens/statistics/StatisticsScreen"),
  },
  {
    name: "audit",
    pattern: "/audit",
    title: "Audit",
    layout: "alone",
    load: () => import("./screens/audit/AuditScreen"),
  },
  {
    name: "people",
    pattern: "/people",
    title: "People",
    layout: "alone",
    load: () => import("./screens/people/PeopleScreen"),
  },
  {
    name: "account",
    pattern: "/account",
    title: "Account",
    layout: "alone",
    load: () => import("./screens/account/AccountScreen"),
  },
];

export interface Match {
  route: Route;
  surveyId: number;
}

/** The route of a path, or null. An id is a positive integer; a trailing slash does not matter. */
export function match(pathname: string): Match | null {
  const path = pathname.length > 1 ? pathname.replace(/\/+$/, "") : pathname;
  for (const route of ROUTES) {
    const pattern = new RegExp(`^${route.pattern.replace(":id", "([1-9][0-9]{0,15})")}$`);
    const found = pattern.exec(path);
    if (found) return { route, surveyId: Number(found[1] ?? 0) };
  }
  return null;
}

const here = signal(location.pathname + location.search);

export const pathname = computed(() => here.value.split("?")[0] ?? "/");
export const query = computed(() => new URLSearchParams(here.value.split("?")[1] ?? ""));
export const current = computed(() => match(pathname.value));

/** Goes to a path of this app; `replace` leaves no step to go back to. */
export function navigate(to: string, options: { replace?: boolean } = {}): void {
  if (to === location.pathname + location.search) return;
  history[options.replace ? "replaceState" : "pushState"](null, "", to);
  const samePage = to.split("?")[0] === pathname.value;
  here.value = location.pathname + location.search;
  if (!samePage) document.getElementById("main")?.scrollTo(0, 0);
}

/** Changes query parameters in place, for deep links; null removes one. */
export function setQuery(changes: Record<string, string | number | null>): void {
  const params = new URLSearchParams(location.search);
  for (const [key, value] of Object.entries(changes)) {
    if (value === null) params.delete(key);
    else params.set(key, String(value));
  }
  const text = params.toString();
  navigate(location.pathname + (text ? `?${text}` : ""), { replace: true });
}

window.addEventListener("popstate", () => {
  here.value = location.pathname + location.search;
});

/** True for a click that should stay a click: a new tab, a download, another site, the API. */
export function isOurs(anchor: HTMLAnchorElement, event: MouseEvent): boolean {
  if (
    event.defaultPrevented ||
    event.button !== 0 ||
    event.metaKey ||
    event.ctrlKey ||
    event.shiftKey ||
    event.altKey
  )
    return false;
  if (anchor.target || anchor.hasAttribute("download") || anchor.origin !== location.origin) return false;
  if (anchor.hash && anchor.pathname === location.pathname) return false;
  return match(anchor.pathname) !== null;
}

document.addEventListener("click", (event) => {
  const anchor = event.target instanceof Element ? event.target.closest("a") : null;
  if (!anchor || !isOurs(anchor, event)) return;
  event.preventDefault();
  navigate(anchor.pathname + anchor.search);
});
