/** What the sight-distance page asks and shows; all of it is in the address. */
import type { components } from "#schema";
import { apart, say, sentenceOf, wordsOf } from "../../core/messages";
import type { AddressOf } from "../../core/routes";
import { lengthUnit } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";

type Schemas = components["schemas"];
export type Sight = Schemas["SightDistances"];
export type Case = Schemas["CaseOfHeights"];
export type Bounded = Schemas["Bounded"];
export type Kind = keyof typeof KIND_WORDS;

export const CASE_WORDS = wordsOf("sight-case-");

export const KIND_WORDS = wordsOf("sight-kind-");

/** What stands for the object where the address does not say. */
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

/** What the server is asked for an address. */
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
