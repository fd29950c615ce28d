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
  uDistance: string;
  /** Of the errors of baseline and divergence; empty: none. */
  correlation: string;
  /** Empty: estimated from the traffic. */
  misalignment: string;
  uMisalignment: string;
  /** % of the rows; empty: as usual. */
  shadow: string;
}

/** Lanes are typed in a list of their own. */
export type RigValues = Omit<Scan["rig"], "lanes">;
export type RigProblems = Partial<Record<keyof RigTyped, string>>;

export const NEW_RIG: RigTyped = {
  baseline: "",
  uBaseline: "",
  rate: "",
  ratePpm: "",
  divergence: "",
  uDivergence: "",
  distance: "",
  uDistance: "",
  correlation: "",
  misalignment: "",
  uMisalignment: "",
  shadow: "",
};

const PER_M_RAD = 1000;
/** %, and the most that can be left out. */
const USUAL_SHADOW = 15;
const MOST_SHADOW = 60;
export const isShadow = (value: number) => value >= 0 && value <= MOST_SHADOW;
export const positive = (value: number) => value > 0;
export const notNegative = (value: number) => value >= 0;

/** Reads typed fields one by one: null and a sentence among the problems for one that is wrong; `empty`: of a field
 * that may be left empty. */
export function readerOf<Name extends string>(
  typed: Readonly<Record<Name, string>>,
  problems: Partial<Record<Name, string>>,
) {
  return (
    name: Name,
    parse: (text: string) => number | null,
    fine: (value: number) => boolean,
    sentence: string,
    empty?: number | null,
  ): number | null => {
    if (typed[name].trim() === "" && empty !== undefined) return empty;
    const value = parse(typed[name]);
    if (value !== null && fine(value)) return value;
    problems[name] = sentence;
    return null;
  };
}

/** A length as it is typed, in the shown unit. */
export function typedLength(metres: number, digits = 4): string {
  return fixed(metres * lengthScale()[0], digits);
}

export function typedOf({ rig }: { rig: RigValues }): RigTyped {
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
    uDistance: unlessZero(rig.u_distance_m, typedLength(rig.u_distance_m)),
    correlation: unlessZero(rig.baseline_correlation, plain(rig.baseline_correlation)),
    misalignment: rig.misalignment_px === null ? "" : plain(rig.misalignment_px),
    uMisalignment: unlessZero(rig.u_misalignment_px, plain(rig.u_misalignment_px)),
    shadow: plain(100 * rig.shadow_share),
  };
}

/** The values in SI units, or for each field that is wrong a sentence. `lanes`: distances are told lane by lane. */
export function valuesOf(typed: RigTyped, lanes = false): RigValues | RigProblems {
  const wrong: RigProblems = {};
  const read = readerOf(typed, wrong);
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
    u_distance_m: read("uDistance", parseLength, notNegative, length, 0),
    baseline_correlation: read(
      "correlation",
      parseNumber,
      (value) => Math.abs(value) <= 1,
      say("scans-rig-problem-correlation"),
      0,
    ),
    misalignment_px: read(
      "misalignment",
      parseNumber,
      () => true,
      say("scans-rig-problem-misalignment"),
      null,
    ),
    u_misalignment_px: read("uMisalignment", parseNumber, notNegative, number, 0),
    shadow: read("shadow", parseNumber, isShadow, say("scans-rig-problem-shadow"), USUAL_SHADOW),
  };
  const { ppm, divergence, uDivergence, shadow, ...rest } = values;
  if ((divergence || uDivergence) && rest.distance_m === null && !lanes && !wrong.distance)
    wrong.distance = say("scans-rig-problem-distance");
  if (rest.misalignment_px === null && rest.u_misalignment_px && !wrong.misalignment)
    wrong.misalignment = say("scans-rig-problem-misalignment-u");
  if (Object.keys(wrong).length > 0) return wrong;
  return {
    ...rest,
    u_line_rate_ratio: (ppm ?? 0) / 1e6,
    divergence_rad: (divergence ?? 0) / PER_M_RAD,
    u_divergence_rad: (uDivergence ?? 0) / PER_M_RAD,
    shadow_share: (shadow ?? USUAL_SHADOW) / 100,
  } as RigValues;
}

/** What a calibration gives; the correlation is that of these values' errors. */
const CALIBRATED = ["baseline_m", "u_baseline_m", "divergence_rad", "u_divergence_rad"] as const;
const CALIBRATED_TYPED = ["baseline", "uBaseline", "divergence", "uDivergence"] as const;

/** Who types another baseline or divergence says nothing of how their errors go together. */
export function withoutCorrelation(part: Partial<RigTyped>): Partial<RigTyped> {
  return CALIBRATED_TYPED.some((name) => name in part) ? { correlation: "", ...part } : part;
}

/** What is sent of a change: the correlation goes along with the values that it is of. */
export function sentOf(values: RigValues, moved: readonly (keyof RigValues)[]): Partial<RigValues> {
  const along = moved.some((name) => (CALIBRATED as readonly string[]).includes(name));
  const names = new Set([...moved, ...(along ? (["baseline_correlation"] as const) : [])]);
  return Object.fromEntries([...names].map((name) => [name, values[name]]));
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
