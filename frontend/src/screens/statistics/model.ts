/** What the server says of many measurements; lengths in metres. */
import { wordsOf } from "../../core/messages";
import type { Category, ClassSet, Lighting, ReasonBody, StatisticsBody, TargetBody } from "../../core/types";
import { CATEGORY_WORDS, CLASS_SET_WORDS, LIGHTING_WORDS } from "../../core/words";

export type Group = TargetBody["groups"][string]["groups"][number];
export type Lateral = NonNullable<StatisticsBody["lateral"]>;
export type Comparison = NonNullable<StatisticsBody["comparison"]>;

/** Whether a part was computed, or is only the reason why not. */
export function isThere<T extends object>(part: T | ReasonBody): part is T {
  return !("reason" in part) || Object.keys(part).length > 1;
}

export const GROUP_WORDS: Readonly<Record<string, string>> = wordsOf(
  "statistics-group-",
  "daytime",
  "low_light",
  "overall",
  "unknown",
);

const LANE_WORDS: Readonly<Record<string, string>> = wordsOf("statistics-lane-");

export function groupWord(grouping: string, word: string): string {
  if (grouping === "lighting") return LIGHTING_WORDS[word as Lighting] ?? word;
  if (grouping === "category") return CATEGORY_WORDS[word as Category] ?? word;
  if (grouping === "lane") return LANE_WORDS[word] ?? word;
  if (grouping === "class_set") return CLASS_SET_WORDS[word as ClassSet] ?? word;
  return word;
}

export const STANDARD_FOR: Readonly<Record<string, string>> = {
  driver_eye: "eye_car",
  taillight: "object_stopping",
  headlight: "headlight",
};
