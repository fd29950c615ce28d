/** The pages of the app: name, path, title, layout. What is shown at each is `app/screens.ts`. */
import { say, sayInEach } from "./messages";

export interface ScreenProps {
  surveyId: number;
}

/** "bench": the order of work beside it; "full": the whole window; "alone": a page by itself; "bare": without the top bar */
type Layout = "bench" | "full" | "alone" | "bare";

/** Each place's path, ":id" for the survey's, its layout, and where the guide speaks of it: "page#section". */
const TABLE = {
  "sign-in": ["/sign-in", "bare", "administrator#people"],
  surveys: ["/", "alone", "first-survey"],
  survey: ["/surveys/:id", "bench", "first-survey#1-create-the-survey"],
  planning: ["/surveys/:id/planning", "bench", "field-protocol#before-the-day"],
  camera: ["/surveys/:id/camera", "bench", "operator#camera"],
  recordings: ["/surveys/:id/recordings", "bench", "operator#recordings"],
  pose: ["/surveys/:id/pose", "full", "operator#road"],
  measure: ["/surveys/:id/measure", "full", "operator#measure"],
  checks: ["/surveys/:id/checks", "bench", "operator#checks"],
  review: ["/surveys/:id/review", "full", "reviewer#review"],
  lots: ["/surveys/:id/lots", "bench", "reviewer#lots"],
  repeats: ["/surveys/:id/repeats", "bench", "operator#repeatability"],
  "click-again": ["/surveys/:id/repeats/click", "full", "operator#repeatability"],
  scans: ["/surveys/:id/scans", "bench", "operator#line-scans"],
  "scan-results": ["/surveys/:id/scans/results", "bench", "operator#line-scans"],
  live: ["/surveys/:id/live", "bench", "operator#live-line-scans"],
  scan: ["/surveys/:id/scan", "full", "operator#line-scans"],
  export: ["/surveys/:id/export", "bench", "standards-engineer#tracing-a-value"],
  history: ["/surveys/:id/history", "bench", "administrator#jobs-and-the-audit-trail"],
  settings: ["/surveys/:id/settings", "bench", "first-survey#1-create-the-survey"],
  statistics: ["/statistics", "alone", "standards-engineer#statistics"],
  "sight-distance": ["/sight-distance", "alone", "standards-engineer#sight-distance"],
  studies: ["/studies", "alone", "standards-engineer#studies"],
  study: ["/study", "alone", "standards-engineer#studies"],
  catalogue: ["/catalogue", "alone", "operator#catalogue"],
  audit: ["/audit", "alone", "administrator#jobs-and-the-audit-trail"],
  jobs: ["/jobs", "alone", "administrator#jobs-and-the-audit-trail"],
  system: ["/system", "alone", "administrator#watch"],
  people: ["/people", "alone", "administrator#people"],
  account: ["/account", "alone", "administrator#people"],
  guide: ["/guide", "alone", "first-survey"],
} as const satisfies Record<string, readonly [pattern: string, layout: Layout, guide: string]>;

export type PlaceName = keyof typeof TABLE;

export interface Place {
  name: PlaceName;
  pattern: string;
  layout: Layout;
  guide: string;
}

export const PLACES: readonly Place[] = (Object.keys(TABLE) as PlaceName[]).map((name) => {
  const [pattern, layout, guide] = TABLE[name];
  return { name, pattern, layout, guide };
});

export function guideAddress(place: string): string {
  const [page, section] = place.split("#");
  return `/guide?page=${page}${section ? `&section=${section}` : ""}`;
}

export function titleOf(name: PlaceName): string {
  return say(`page-${name}`);
}

const COMPILED = PLACES.map((place) => ({
  place,
  path: new RegExp(`^${place.pattern.replace(":id", "([1-9][0-9]{0,15})")}$`),
}));

export type Match = NonNullable<ReturnType<typeof match>>;

/** The place of a path, or null. An id is a positive integer; a trailing slash does not matter. */
export function match(pathname: string) {
  const bare = pathname.length > 1 ? pathname.replace(/\/+$/, "") : pathname;
  for (const { place, path } of COMPILED) {
    const parts = path.exec(bare);
    if (parts) return { place, surveyId: Number(parts[1] ?? 0) };
  }
  return null;
}

/** The pages of results are asked for surveys in their query, and so are of a survey too. */
const RESULTS: readonly PlaceName[] = ["statistics", "sight-distance"];

/** The address of the page that a path names by what the page is called, as people type it; null where none is called so. */
export function addressCalled(pathname: string): string | null {
  const [, id, word] = /^(?:\/surveys\/([1-9][0-9]{0,15}))?\/([^/]+)\/*$/.exec(pathname) ?? [];
  if (word === undefined) return null;
  const ofSurvey = ({ name, pattern }: Place) => pattern.includes(":id") || RESULTS.includes(name);
  const called = plainWord(decoded(word));
  const place = PLACES.filter((one) => (id ? ofSurvey(one) : !one.pattern.includes(":id"))).find(({ name }) =>
    [name, ...sayInEach(`page-${name}`)].some((known) => plainWord(known) === called),
  );
  if (!place) return null;
  return id ? addressOf(place.name, id) : place.pattern;
}

export function addressOf(name: PlaceName, surveyId: number | string): string {
  const [pattern] = TABLE[name];
  return RESULTS.includes(name) ? `${pattern}?survey=${surveyId}` : pattern.replace(":id", String(surveyId));
}

/** "Vue d’ensemble" is vue-d-ensemble: small letters without accents, and nothing else between them than hyphens. */
function plainWord(text: string): string {
  const letters = text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  return letters.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
}

function decoded(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part; // a stray % is no letter of a name
  }
}
