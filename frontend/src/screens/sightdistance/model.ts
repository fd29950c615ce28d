/** What the sight-distance page asks and shows; all of it is in the address. */
import type { components } from "#schema";
import { apart, say, sentenceOf, wordsOf } from "../../core/messages";
import type { AddressOf } from "../../core/routes";
import type { Standard } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { standardKey } from "../../parts/figures/standards";

type Schemas = components["schemas"];
export type Sight = Schemas["SightDistances"];
export type Case = Schemas["CaseOfHeights"];
export type Bounded = Schemas["Bounded"];
export type Kind = keyof typeof KIND_WORDS;

export const CASE_WORDS = wordsOf("sight-case-");

export const KIND_WORDS = wordsOf("sight-kind-");

export const STANDARDS_OBJECT = "standard";

const PLAIN = [
  "lighting",
  "state",
  "eye_m",
  "object_m",
  "eye_what",
  "eye_percent",
  "object_percent",
  "kind",
  "speed_mps",
  "difference_percent",
  "headlight_m",
  "radius_m",
] as const;

export function sightQuery(query: URLSearchParams): AddressOf<"GET /sightdistance"> {
  const asked: AddressOf<"GET /sightdistance"> = {
    survey: query.getAll("survey"),
    share: query.getAll("share"),
    category: query.getAll("category"),
    class_set: query.getAll("class_set"),
  };
  for (const name of PLAIN) asked[name] = query.get(name) || undefined;
  const target = query.get("object_target") ?? usualObject(query.get("kind"));
  asked.object_target = target === STANDARDS_OBJECT ? undefined : target;
  asked.unit = lengthUnit.value;
  return asked;
}

/** Where the address has what is said of an eye and of an object. */
const SAID = {
  eye_m: { percent: "eye_percent", standard: "eye_standard" },
  object_m: { percent: "object_percent", standard: "object_standard" },
} as const;

export type OfStandard = keyof typeof SAID;

/** The standard of an address: that which was chosen, while its height stands, else the first of this height, of the same eyes. */
export function standardAt(
  at: URLSearchParams,
  name: OfStandard,
  height_m: number,
  options: readonly Standard[],
): Standard | undefined {
  const whose = name === "eye_m" ? (at.get("eye_what") ?? "eye_car") : null;
  const alike = options.filter((one) => one.height_m === height_m && (whose ?? one.what) === one.what);
  return alike.find((one) => standardKey(one) === at.get(SAID[name].standard)) ?? alike[0];
}

/** What a chosen standard changes of the address: the survey is read by its rule, where one is known. */
export function ofStandard(name: OfStandard, one: Standard): Record<string, string | number> {
  return {
    [name]: one.height_m,
    [SAID[name].standard]: standardKey(one),
    ...(one.percent === null ? {} : { [SAID[name].percent]: one.percent }),
    ...(name === "eye_m" ? { eye_what: one.what } : {}), // whose eyes: of cars, of trucks
  };
}

/** The same of a typed height: that of a standard is read as its eyes, any other as usual. */
export function ofHeight(
  name: OfStandard,
  height_m: number | null,
  options: readonly Standard[],
): Record<string, string | number | null> {
  const alike = options.filter((one) => one.height_m === height_m).map((one) => one.what);
  const whose = alike.includes("eye_car") ? null : (alike[0] ?? null);
  return { [name]: height_m, [SAID[name].standard]: null, ...(name === "eye_m" ? { eye_what: whose } : {}) };
}

/** A vehicle that stands is seen by its taillights; one that comes, by as much as an eye sees of another. */
export function usualObject(kind: string | null): string {
  if (kind === "passing" || kind?.startsWith("intersection")) return "driver_eye";
  return "taillight";
}

/** Why a case has no crest: what nobody measured, else what has too few heights for its percentile. */
export function withoutCrest(one: Case): string {
  if (one.missing.length > 0)
    return say("sight-missing", { targets: apart(one.missing.map((target) => HEIGHT_WORDS[target])) });
  const each = one.too_few.map(({ target, reason }) =>
    say("sight-too-few-of", { target: HEIGHT_WORDS[target], reason: sentenceOf(reason) }),
  );
  return say("sight-too-few", { targets: apart(each) });
}

/** The fleet of an address: percent by class; empty where none is asked for. */
export function sharesOf(query: URLSearchParams): Map<string, number> {
  const pairs = query.getAll("share").map((one) => one.split(":"));
  return new Map(pairs.map(([name, percent]) => [name ?? "", Number(percent)]));
}
