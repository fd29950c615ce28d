/** What the server says of many measurements; lengths in metres. */

import type { components } from "#schema";
import type { Category, Lighting, Target } from "../../core/types";
import type { Standard } from "../../parts/figures/types";

type Schemas = components["schemas"];
export type Statistics = Schemas["StatisticsBody"];
export type Errors = Schemas["ErrorsBody"];
export type ErrorGroup = Schemas["ErrorGroupBody"];
export type Trend = Schemas["TrendBody"];
export type Reason = Schemas["ReasonBody"];
export type OfTarget = Schemas["TargetBody"];
export type Percentile = Schemas["PercentileBody"];
export type SampleSize = Schemas["SampleSizeBody"];

/** Whether a part was computed, or is only the reason why not. */
export function isThere<T extends object>(part: T | Reason): part is T {
  return !("reason" in part) || Object.keys(part).length > 1;
}

export const GROUP_WORDS: Record<string, string> = {
  daytime: "daytime",
  low_light: "low light",
  overall: "overall",
  unknown: "lighting unknown",
};

export const LIGHTING_WORDS: Record<Lighting, string> = { daytime: "Daytime", low_light: "Low light" };

export const CATEGORY_WORDS: Record<Category, string> = {
  hatchback: "Hatchback",
  saloon: "Saloon",
  estate: "Estate",
  suv: "SUV",
  van: "Van",
  lorry: "Lorry",
  other: "Other",
};

export const TARGET_TITLES: Record<Exclude<Target, "other">, string> = {
  driver_eye: "Driver’s eye",
  taillight: "Taillight, lower limit",
  headlight: "Headlight",
  roof: "Roof",
};

/** The word of a group in a grouping, for people. */
export function groupWord(grouping: string, word: string): string {
  if (grouping === "lighting") return LIGHTING_WORDS[word as Lighting] ?? word;
  if (grouping === "category") return CATEGORY_WORDS[word as Category] ?? word;
  return word;
}

/** What a standard speaks of. */
export const STANDARD_OF = { driver_eye: "driver’s eye", object: "object (taillight, headlight)" } as const;

/** A standard's own address in the link: what and name. */
export function standardKey(one: Standard): string {
  return `${one.what}:${one.name}:${one.height_m}`;
}
