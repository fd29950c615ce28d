/** The rig's values as they are typed, and what is wrong with them. */
import type { components } from "#schema";
import { say } from "../../core/messages";
import type { BodyOf } from "../../core/routes";
import type { Scan } from "../../core/types";
import { fixed, lengthScale, parseLength, parseNumber } from "../../core/units";

export type RigOfTraffic = components["schemas"]["RigOfTraffic"];

export interface RigTyped {
  baseline: string;
  uBaseline: string;
  rate: string;
  ratePpm: string;
  /** mrad */
  divergence: string;
  uDivergence: string;
  distance: string;
  /** Empty: estimated from the traffic. */
  misalignment: string;
  uMisalignment: string;
}

export type RigValues = Scan["rig"];
export type RigProblems = Partial<Record<keyof RigTyped, string>>;

export const NEW_RIG: RigTyped = {
  baseline: "",
  uBaseline: "",
  rate: "",
  ratePpm: "",
  divergence: "",
  uDivergence: "",
  distance: "",
  misalignment: "",
  uMisalignment: "",
};

const PER_M_RAD = 1000;

/** A length as it is typed, in the shown unit. */
export function typedLength(metres: number, digits = 4): string {
  return fixed(metres * lengthScale()[0], digits);
}

export function typedOf({ rig }: Pick<Scan, "rig">): RigTyped {
  const unlessZero = (value: number, text: string) => (value === 0 ? "" : text);
  const plain = (value: number) => String(Number(value.toPrecision(9)));
  return {
    baseline: typedLength(rig.baseline_m),
    uBaseline: unlessZero(rig.u_baseline_m, typedLength(rig.u_baseline_m)),
    rate: String(rig.line_rate_hz),
    ratePpm: unlessZero(rig.u_line_rate_ratio, plain(rig.u_line_rate_ratio * 1e6)),
    divergence: unlessZero(rig.divergence_rad, plain(rig.divergence_rad * PER_M_RAD)),
    uDivergence: unlessZero(rig.u_divergence_rad, plain(rig.u_divergence_rad * PER_M_RAD)),
    distance: rig.distance_m === null ? "" : typedLength(rig.distance_m, 2),
    misalignment: rig.misalignment_px === null ? "" : plain(rig.misalignment_px),
    uMisalignment: unlessZero(rig.u_misalignment_px, plain(rig.u_misalignment_px)),
  };
}

/** The values in SI units, or for each field that is wrong a sentence. */
export function valuesOf(typed: RigTyped): RigValues | RigProblems {
  const wrong: RigProblems = {};
  const read = (
    name: keyof RigTyped,
    parse: (text: string) => number | null,
    fine: (value: number) => boolean,
    sentence: string,
    empty?: number | null,
  ): number | null => {
    if (typed[name].trim() === "" && empty !== undefined) return empty;
    const value = parse(typed[name]);
    if (value !== null && fine(value)) return value;
    wrong[name] = sentence;
    return null;
  };
  const positive = (value: number) => value > 0;
  const notNegative = (value: number) => value >= 0;
  const small = (value: number) => Math.abs(value) <= 200;
  const number = say("scans-rig-problem-number");
  const length = say("scans-rig-problem-length");
  const angle = say("scans-rig-problem-angle");
  const values = {
    baseline_m: read("baseline", parseLength, positive, say("scans-rig-problem-baseline")),
    u_baseline_m: read("uBaseline", parseLength, notNegative, length, 0),
    line_rate_hz: read("rate", parseNumber, positive, say("scans-rig-problem-rate")),
    ppm: read("ratePpm", parseNumber, notNegative, number, 0),
    divergence: read("divergence", parseNumber, small, angle, 0),
    uDivergence: read("uDivergence", parseNumber, (value) => value >= 0 && small(value), angle, 0),
    distance_m: read("distance", parseLength, positive, length, null),
    misalignment_px: read(
      "misalignment",
      parseNumber,
      () => true,
      say("scans-rig-problem-misalignment"),
      null,
    ),
    u_misalignment_px: read("uMisalignment", parseNumber, notNegative, number, 0),
  };
  const { ppm, divergence, uDivergence, ...rest } = values;
  if ((divergence || uDivergence) && rest.distance_m === null && !wrong.distance)
    wrong.distance = say("scans-rig-problem-distance");
  if (rest.misalignment_px === null && rest.u_misalignment_px && !wrong.misalignment)
    wrong.misalignment = say("scans-rig-problem-misalignment-u");
  if (Object.keys(wrong).length > 0) return wrong;
  return {
    ...rest,
    u_line_rate_ratio: (ppm ?? 0) / 1e6,
    divergence_rad: (divergence ?? 0) / PER_M_RAD,
    u_divergence_rad: (uDivergence ?? 0) / PER_M_RAD,
  } as RigValues;
}

export function isValues(value: RigValues | RigProblems): value is RigValues {
  return "baseline_m" in value;
}

export type RigChange = Omit<BodyOf<"PATCH /scans/{scan_id}">, "version">;
export type RigName = keyof RigChange;

/** Some of a scan's values as they stand: what an undo puts back. */
export function rigValues({ rig, name }: Scan, names: readonly RigName[]): RigChange {
  const all: RigChange = { ...rig, name };
  return Object.fromEntries(names.map((one) => [one, all[one]]));
}
