/** Lanes of a rig as they are typed, and what is wrong with them. */
import { say } from "../../core/messages";
import type { Scan } from "../../core/types";
import { kept, parseLength, parseNumber } from "../../core/units";
import { DISTANCE_DIGITS, isShadow, notNegative, positive, readerOf, typedLength } from "./rig";

export type RigLane = Scan["rig"]["lanes"][number];
export type LaneWay = NonNullable<RigLane["direction"]> | "either";

export interface LaneTyped {
  readonly name: string;
  readonly distance: string;
  readonly uDistance: string;
  readonly direction: LaneWay;
  /** Rows of strip 1 between which tyres meet the road; both empty: any. */
  readonly from: string;
  readonly to: string;
  /** % of the rows; empty: the rig's. */
  readonly shadow: string;
  /** The lane as it is stored, of which a distance that nobody types stays; null: a new one. */
  readonly stored: RigLane | null;
}

export type LaneProblems = Partial<Record<Exclude<keyof LaneTyped, "stored">, string>>;

export const NEW_LANE: LaneTyped = {
  name: "",
  distance: "",
  uDistance: "",
  direction: "either",
  from: "",
  to: "",
  shadow: "",
  stored: null,
};
export const MOST_LANES = 8;

export function typedLanes(lanes: readonly RigLane[]): LaneTyped[] {
  const plain = (value: number | null) => (value === null ? "" : String(Number(value.toPrecision(9))));
  return lanes.map((one) => ({
    name: one.name,
    distance: typedLength(one.distance_m, DISTANCE_DIGITS),
    uDistance: one.u_distance_m === 0 ? "" : typedLength(one.u_distance_m),
    direction: one.direction ?? "either",
    from: plain(one.tyres_from_px),
    to: plain(one.tyres_to_px),
    shadow: one.shadow_share === null ? "" : plain(100 * one.shadow_share),
    stored: one,
  }));
}

/** The lanes in SI units, or what is wrong with each. */
export function lanesOf(typed: readonly LaneTyped[]): { lanes: RigLane[]; problems: LaneProblems[] } {
  const found = typed.map((one, at) => laneOf(one, typed.slice(0, at)));
  return {
    lanes: found.flatMap(({ lane }) => (lane ? [lane] : [])),
    problems: found.map(({ problems }) => problems),
  };
}

function laneOf(
  typed: LaneTyped,
  before: readonly LaneTyped[],
): { lane: RigLane | null; problems: LaneProblems } {
  const problems: LaneProblems = {};
  const read = readerOf(typed, problems);
  const name = typed.name.trim();
  if (!name || name.length > 40) problems.name = say("scans-lane-problem-name");
  else if (before.some((one) => one.name.trim() === name)) problems.name = say("scans-lane-problem-twice");
  const rows = say("scans-lane-problem-rows");
  const then = typed.stored;
  const [shown] = then ? typedLanes([then]) : [];
  const keep = (field: "distance" | "uDistance", value: number | undefined) => (text: string) =>
    kept(text, shown?.[field] ?? "", value, parseLength);
  const distance = read(
    "distance",
    keep("distance", then?.distance_m),
    positive,
    say("scans-lane-problem-distance"),
  );
  const uDistance = read(
    "uDistance",
    keep("uDistance", then?.u_distance_m),
    notNegative,
    say("scans-rig-problem-length"),
    0,
  );
  const from = read("from", parseNumber, notNegative, rows, null);
  const to = read("to", parseNumber, (value) => value > (from ?? 0), rows, null);
  const shadow = read("shadow", parseNumber, isShadow, say("scans-rig-problem-shadow"), null);
  if ((from === null) !== (to === null) && !problems.from && !problems.to) problems.to = rows;
  if (Object.keys(problems).length > 0 || distance === null) return { lane: null, problems };
  return {
    lane: {
      name,
      distance_m: distance,
      u_distance_m: uDistance ?? 0,
      direction: typed.direction === "either" ? null : typed.direction,
      tyres_from_px: from,
      tyres_to_px: to,
      shadow_share: shadow === null ? null : shadow / 100,
    },
    problems,
  };
}

export function sameLanes(typed: readonly LaneTyped[], lanes: readonly RigLane[]): boolean {
  return JSON.stringify(typed) === JSON.stringify(typedLanes(lanes));
}
