/** The rig's values, each described once: how it is typed, read, shown, and what is wrong with it. */
import { type PlainKey, say } from "../../core/messages";
import type { BodyOf } from "../../core/routes";
import type { Scan } from "../../core/types";
import { fixed, lengthScale, lengthUnit, parseLength, parseNumber } from "../../core/units";

/** Lanes are typed in a list of their own. */
export type RigValues = Omit<Scan["rig"], "lanes">;

/** %, and the most that can be left out. */
const USUAL_SHADOW = 15;
const MOST_SHADOW = 60;
export const isShadow = (value: number) => value >= 0 && value <= MOST_SHADOW;
export const positive = (value: number) => value > 0;
export const notNegative = (value: number) => value >= 0;
export const DISTANCE_DIGITS = 2;
const isAngle = (mrad: number) => Math.abs(mrad) <= 200;

interface RigField {
  value: keyof RigValues;
  /** What is typed over the value in SI units; left out: it is a length in the shown unit. */
  per?: number;
  /** Decimals of a length, digits of anything else. */
  digits?: number;
  fine: (typed: number) => boolean;
  problem: PlainKey;
  /** As what an empty field is read; left out: it may not be empty. */
  empty?: number | null;
  label: PlainKey;
  unit: () => string;
  hint?: PlainKey;
  placeholder?: () => string;
}

const [length, px, mrad] = [() => lengthUnit.value, () => say("unit-px"), () => say("unit-mrad")];
const u = { fine: notNegative, empty: 0, label: "scans-rig-u", problem: "scans-rig-problem-length" } as const;
const angle = { per: 1000, unit: mrad, empty: 0, problem: "scans-rig-problem-angle" } as const;

const DESCRIBED = {
  baseline: {
    value: "baseline_m",
    unit: length,
    fine: positive,
    problem: "scans-rig-problem-baseline",
    label: "scans-rig-baseline",
    hint: "scans-rig-baseline-hint",
  },
  uBaseline: { ...u, value: "u_baseline_m", unit: length, hint: "scans-rig-baseline-u-hint" },
  rate: {
    value: "line_rate_hz",
    per: 1,
    digits: 17,
    unit: () => say("unit-hz"),
    fine: positive,
    label: "scans-rig-rate",
    problem: "scans-rig-problem-rate",
  },
  ratePpm: {
    ...u,
    value: "u_line_rate_ratio",
    per: 1e6,
    unit: () => say("unit-ppm"),
    label: "scans-rig-clock",
    hint: "scans-rig-clock-hint",
    problem: "scans-rig-problem-number",
  },
  // empty: estimated from the traffic
  misalignment: {
    value: "misalignment_px",
    per: 1,
    unit: px,
    fine: () => true,
    empty: null,
    problem: "scans-rig-problem-misalignment",
    label: "scans-rig-misalignment",
    placeholder: () => say("scans-rig-from-traffic"),
    hint: "scans-rig-misalignment-hint",
  },
  uMisalignment: { ...u, value: "u_misalignment_px", per: 1, unit: px, problem: "scans-rig-problem-number" },
  divergence: {
    ...angle,
    value: "divergence_rad",
    fine: isAngle,
    label: "scans-rig-divergence",
    hint: "scans-rig-divergence-hint",
  },
  uDivergence: {
    ...u,
    ...angle,
    value: "u_divergence_rad",
    hint: "scans-rig-divergence-u-hint",
    fine: (value: number) => value >= 0 && isAngle(value),
  },
  distance: {
    value: "distance_m",
    digits: DISTANCE_DIGITS,
    unit: length,
    fine: positive,
    empty: null,
    problem: "scans-rig-problem-length",
    label: "scans-rig-distance",
    hint: "scans-rig-distance-hint",
  },
  uDistance: { ...u, value: "u_distance_m", unit: length, hint: "scans-rig-distance-u-hint" },
  // of the errors of baseline and divergence; empty: none
  correlation: {
    value: "baseline_correlation",
    per: 1,
    unit: () => "",
    empty: 0,
    fine: (value: number) => Math.abs(value) <= 1,
    problem: "scans-rig-problem-correlation",
    label: "scans-rig-correlation",
    hint: "scans-rig-correlation-hint",
  },
  // of the rows; empty: as usual
  shadow: {
    value: "shadow_share",
    per: 100,
    unit: () => "%",
    fine: isShadow,
    empty: USUAL_SHADOW,
    problem: "scans-rig-problem-shadow",
    label: "scans-rig-shadow",
    hint: "scans-rig-shadow-hint",
    placeholder: () => String(USUAL_SHADOW),
  },
} as const satisfies Record<string, RigField>;

export type RigFieldName = keyof typeof DESCRIBED;
export type RigTyped = Record<RigFieldName, string>;
export type RigProblems = Partial<RigTyped>;
export const RIG_FIELDS: Readonly<Record<RigFieldName, RigField>> = DESCRIBED;

function ofEach<T>(what: (field: RigField, name: RigFieldName) => T): Record<RigFieldName, T> {
  const names = Object.keys(DESCRIBED) as RigFieldName[];
  return Object.fromEntries(names.map((name) => [name, what(DESCRIBED[name], name)])) as Record<
    RigFieldName,
    T
  >;
}

export const NEW_RIG: RigTyped = ofEach(() => "");

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

export function typedLength(metres: number, digits = 4): string {
  return fixed(metres * lengthScale()[0], digits);
}

export function typedOf({ rig }: { rig: RigValues }): RigTyped {
  return ofEach(({ value: name, per, digits, empty }) => {
    const value = rig[name];
    if (value === null || (value === 0 && empty === 0)) return "";
    return per === undefined
      ? typedLength(value, digits)
      : String(Number((value * per).toPrecision(digits ?? 9)));
  });
}

/** The values in SI units, or for each field that is wrong a sentence. `lanes`: distances are told lane by lane. */
export function valuesOf(typed: RigTyped, lanes = false): RigValues | RigProblems {
  const wrong: RigProblems = {};
  const read = readerOf(typed, wrong);
  const each = ofEach(({ value, per, fine, problem, empty }, name) => {
    const found = read(name, per === undefined ? parseLength : parseNumber, fine, say(problem), empty);
    return [value, found === null ? null : found / (per ?? 1)] as const;
  });
  const values = Object.fromEntries(Object.values(each)) as RigValues;
  const angled = values.divergence_rad || values.u_divergence_rad;
  if (angled && values.distance_m === null && !lanes && !wrong.distance)
    wrong.distance = say("scans-rig-problem-distance");
  if (values.misalignment_px === null && values.u_misalignment_px && !wrong.misalignment)
    wrong.misalignment = say("scans-rig-problem-misalignment-u");
  return Object.keys(wrong).length > 0 ? wrong : values;
}

const CORRELATED = ["baseline_m", "u_baseline_m", "divergence_rad", "u_divergence_rad"] as const;
/** What a calibration gives; the correlation is that of the values' errors. */
export const CALIBRATED = [...CORRELATED, "baseline_correlation"] as const;
/** All that is stored with a calibration: where the vehicles drive, too. */
export const OF_CALIBRATION = [...CALIBRATED, "distance_m", "u_distance_m"] as const;
const CALIBRATED_TYPED = ["baseline", "uBaseline", "divergence", "uDivergence"] as const;

/** Who types another baseline or divergence says nothing of how their errors go together. */
export function withoutCorrelation(part: Partial<RigTyped>): Partial<RigTyped> {
  return CALIBRATED_TYPED.some((name) => name in part) ? { correlation: "", ...part } : part;
}

/** What is sent of a change: the correlation goes along with the values that it is of. */
export function sentOf(values: RigValues, moved: readonly (keyof RigValues)[]): Partial<RigValues> {
  const along = moved.some((name) => (CORRELATED as readonly string[]).includes(name));
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
