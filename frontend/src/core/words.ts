/** The words of the domain: what can be measured on a vehicle, and the states that things are in. */
import { type PlainKey, wordsOf } from "./messages";
import type {
  AskedTarget,
  Category,
  ClassSet,
  Direction,
  Discarded,
  DriverSide,
  InsetName,
  InsetPlace,
  Lighting,
  NotVisible,
  Survey,
  Target,
} from "./types";
import { formatHeight } from "./units";

export const TARGETS = ["roof", "driver_eye", "taillight", "headlight", "other"] as const satisfies Target[];
/** What is clicked of a scanned vehicle, in this order. */
export const REQUIRED: readonly Target[] = ["roof", "driver_eye", "taillight"];

/** What a survey can ask for, and what results are of. */
export const ASKABLE: readonly AskedTarget[] = TARGETS.filter((target) => target !== "other");

export const TARGET_WORDS = wordsOf("target-", ...TARGETS);

/** What results are heights of: of a taillight, its lower edge. */
export const HEIGHT_WORDS = targetWords({ taillight: "statistics-taillight" });

/** The words of targets, some of them other ones. */
export function targetWords(other: Partial<Record<Target, PlainKey>>): Readonly<Record<Target, string>> {
  const keys = TARGETS.map((target) => [target, other[target] ?? `target-${target}`]);
  return wordsOf(Object.fromEntries(keys) as Record<Target, PlainKey>);
}

const BUDGET_WORDS: Readonly<Record<string, string>> = wordsOf("budget-of-");

/** A source of uncertainty as it is stored, in words: "board bow" is "Board flatness". */
export function budgetSource(source: string): string {
  return BUDGET_WORDS[source.replace(/[^a-z]+/g, "-")] ?? source;
}

/** A target within a list, beside a point, after a colon. */
export const TARGET_NOUNS: Readonly<Record<Target, string>> = wordsOf("target-noun-");

export const LIGHTING_WORDS: Readonly<Record<Lighting, string>> = wordsOf(
  "lighting-",
  "daytime",
  "low_light",
);

export const LIGHTING_NOUNS: Readonly<Record<Lighting, string>> = wordsOf("lighting-noun-");

export const LIVE_WORDS = wordsOf("live-state-");

export const NOT_VISIBLE_WORDS: Readonly<Record<NotVisible, string>> = wordsOf("not-visible-");

export const DISCARDED_WORDS: Readonly<Record<Discarded, string>> = wordsOf("discarded-");

export const DIRECTION_WORDS: Readonly<Record<Direction, string>> = wordsOf("direction-");

export const SIDE_WORDS: Readonly<Record<DriverSide, string>> = wordsOf("side-");

/** What can be told apart by looking at a vehicle: the spot of a roof, the side of a driver. */
export const INSET_PLACE_WORDS: Readonly<Record<InsetPlace, string>> = wordsOf({
  near_edge: "inset-near-edge",
  crown: "inset-crown",
  near: "side-near",
  far: "side-far",
});

/** What an inset is for: a target, of an eye with the driver's side. */
export const INSET_WORDS: Readonly<Record<InsetName, string>> = wordsOf({
  roof: "inset-roof_car",
  roof_van: "inset-roof_van",
  roof_box: "inset-roof_box",
  roof_unknown: "inset-roof_unknown",
  driver_eye_near: "inset-driver_eye_near",
  driver_eye_far: "inset-driver_eye_far",
  taillight: "target-taillight",
  headlight: "target-headlight",
  other: "target-other",
});

export const INSET_NAMES = Object.keys(INSET_WORDS) as InsetName[];

const INSET_NOTES: Readonly<Record<string, string>> = wordsOf("inset-note-");

/** Where an inset comes from: what the program says of its own, or what a person wrote. */
export function insetNote({ code, note }: Pick<Survey["insets"][InsetName], "code" | "note">): string {
  return (code && INSET_NOTES[code]) || note;
}

export const CATEGORY_WORDS: Readonly<Record<Category, string>> = wordsOf("category-");

export const CLASS_SET_WORDS: Readonly<Record<ClassSet, string>> = wordsOf(
  "class-set-",
  ...(["passenger_cars", "light_trucks", "heavy"] as const),
);

export const STATE_WORDS = wordsOf("state-");

export type StateName = keyof typeof STATE_WORDS;

/** A height as it stands, however it came about: "1.172 ± 0.018 m", or why there is none. */
export function heightWords(
  height: {
    status: string;
    height_m: number | null;
    U95_height_m: number | null;
    withdrawn?: boolean;
  } | null,
): string {
  if (!height || height.withdrawn) return STATE_WORDS.withdrawn;
  return height.status === "ok"
    ? formatHeight(height.height_m, height.U95_height_m)
    : STATE_WORDS.not_measurable;
}

export function vehicleName(number: number): string {
  return String(number).padStart(2, "0");
}
