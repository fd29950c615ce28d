/** The filter as the page's address holds it: the server's own names, so that a link tells all. */
import { query, setQuery } from "../../core/address";
import type { AddressOf } from "../../core/routes";

export const CORRECTIONS = ["inset", "shift", "none", "regression", "deconvolution"] as const;

/** Names that the server takes, some of them more than once. */
const WHICH = [
  "target",
  "lighting",
  "operator",
  "first_day",
  "last_day",
  "filmed_from",
  "filmed_to",
  "hour_from",
  "hour_to",
  "state",
] as const;
const SINGLE = [...WHICH, "rounding", "correction", "u_reference_m"] as const;
const REPEATED = ["survey", "category", "class_set", "eye_limit_m", "object_limit_m"] as const;
export type SingleName = (typeof SINGLE)[number];
type RepeatedName = (typeof REPEATED)[number] | "off" | "paper";

/** What the server is asked for an address: what only the page knows is left out. */
export function statisticsQuery(query: URLSearchParams): AddressOf<"GET /statistics"> {
  const asked: AddressOf<"GET /statistics"> = {};
  for (const name of REPEATED) asked[name] = query.getAll(name);
  for (const name of SINGLE) asked[name] = query.get(name) || undefined;
  return asked;
}

type Changes = Partial<Record<SingleName | RepeatedName, string | readonly string[] | null>>;

export const setFilter: (changes: Changes) => void = setQuery;

const NARROWING = [...WHICH, "category", "class_set"] as const;

export const WIDE: Changes = Object.fromEntries(NARROWING.map((name) => [name, null]));

export function narrowed(query: URLSearchParams): boolean {
  return NARROWING.some((name) => query.get(name));
}

/** Whether what Dupuis et al. show stands beside the true heights. */
export function asInPaper(): boolean {
  return query.value.has("paper");
}
