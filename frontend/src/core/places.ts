/** The pages of the app: name, path, title, layout. What is shown at each is `app/screens.ts`. */
import { say, sayInEach } from "./messages";

export interface ScreenProps {
  surveyId: number;
}

/** "bench": the order of work beside it; "full": the whole window; "alone": a page by itself; "bare": without the top bar */
type Layout = "bench" | "full" | "alone" | "bare";

/** Each place's path, ":id" for the survey's, and its layout. */
const TABLE = {
  "sign-in": ["/sign-in", "bare"],
  surveys: ["/", "alone"],
  survey: ["/surveys/:id", "bench"],
  planning: ["/surveys/:id/planning", "bench"],
  camera: ["/surveys/:id/camera", "bench"],
  recordings: ["/surveys/:id/recordings", "bench"],
  pose: ["/surveys/:id/pose", "full"],
  measure: ["/surveys/:id/measure", "full"],
  checks: ["/surveys/:id/checks", "bench"],
  review: ["/surveys/:id/review", "full"],
  lots: ["/surveys/:id/lots", "bench"],
  repeats: ["/surveys/:id/repeats", "bench"],
  "click-again": ["/surveys/:id/repeats/click", "full"],
  scans: ["/surveys/:id/scans", "bench"],
  "scan-results": ["/surveys/:id/scans/results", "bench"],
  live: ["/surveys/:id/live", "bench"],
  scan: ["/surveys/:id/scan", "full"],
  export: ["/surveys/:id/export", "bench"],
  history: ["/surveys/:id/history", "bench"],
  settings: ["/surveys/:id/settings", "bench"],
  statistics: ["/statistics", "alone"],
  "sight-distance": ["/sight-distance", "alone"],
  studies: ["/studies", "alone"],
  study: ["/study", "alone"],
  catalogue: ["/catalogue", "alone"],
  audit: ["/audit", "alone"],
  jobs: ["/jobs", "alone"],
  system: ["/system", "alone"],
  people: ["/people", "alone"],
  account: ["/account", "alone"],
  guide: ["/guide", "alone"],
} as const satisfies Record<string, readonly [pattern: string, layout: Layout]>;

export type PlaceName = keyof typeof TABLE;

export interface Place {
  name: PlaceName;
  /** "/surveys/:id/camera" */
  pattern: string;
  layout: Layout;
}

export const PLACES: readonly Place[] = (Object.keys(TABLE) as PlaceName[]).map((name) => {
  const [pattern, layout] = TABLE[name];
  return { name, pattern, layout };
});

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
  if (!id) return place.pattern;
  return RESULTS.includes(place.name) ? `${place.pattern}?survey=${id}` : place.pattern.replace(":id", id);
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
