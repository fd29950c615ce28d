/** What is wanted of a scanned vehicle and of the rod, and in words for whoever has to choose. */
import { apart, say } from "../../core/messages";
import type { RodMark, ScanVehicle } from "../../core/types";
import { fixed, formatLength } from "../../core/units";
import { CATEGORY_WORDS } from "../../core/words";
import { type Crossings, EDGES } from "../../parts/strips/draw";

export type Facts = Partial<
  Pick<
    ScanVehicle,
    "make" | "model" | "category" | "true_length_m" | "true_wheelbase_m" | "facts_source" | "run_of"
  >
>;
/** Lines of all hubs as a person says; null: as the program finds them. */
type Axles = readonly number[] | null;
export type Hubs = readonly [front: number | null, rear: number | null];

/** What a scanned vehicle is to become; what is left out stays. */
export interface ScannedWanted {
  readonly boundaries?: Crossings;
  readonly hubs?: Hubs;
  readonly axles?: Axles;
  /** Null: as the program tells it. */
  readonly lane?: string | null;
  readonly facts?: Facts;
  readonly there?: boolean;
}

export function rodWords(marks: readonly RodMark[]): string {
  const distances = [...new Set(marks.map((mark) => formatLength(mark.distance_m, 2)))];
  return say("scan-wish-marks", { count: marks.length, distances: distances.join(", ") });
}

export function scannedWords({ there, boundaries, hubs, axles, lane, facts }: ScannedWanted): string {
  const told = [
    there === undefined ? "" : say(there ? "scan-wish-there" : "scan-wish-taken-out"),
    boundaries
      ? say("scan-wish-boundaries", { lines: linesWords(EDGES.map((edge) => boundaries[edge])) })
      : "",
    hubs ? say("scan-wish-hubs", { lines: linesWords(hubs) }) : "",
    axles ? say("scan-wish-axles", { count: axles.length }) : "",
    lane === undefined ? "" : say("scan-wish-lane", { lane: lane ?? say("scan-lane-by-program") }),
    facts ? factsWords(facts) : "",
  ];
  return apart(told.filter(Boolean));
}

function linesWords(lines: readonly (number | null)[]): string {
  return lines.map((one) => (one === null ? say("scan-wish-no-line") : fixed(one, 1))).join(", ");
}

function factsWords(facts: Facts): string {
  const { category, true_length_m: length, true_wheelbase_m: wheelbase } = facts;
  const sized = (name: string, metres: number) => `${name}: ${formatLength(metres)}`;
  const known = Object.values({
    ...facts,
    ...(category ? { category: CATEGORY_WORDS[category] } : {}),
    ...(length ? { true_length_m: sized(say("scan-known-length"), length) } : {}),
    ...(wheelbase ? { true_wheelbase_m: sized(say("scan-known-wheelbase"), wheelbase) } : {}),
  });
  return known.filter((value) => value !== null).join(", ") || say("scan-wish-nothing-known");
}
