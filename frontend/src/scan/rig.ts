/** The rig's values as they are typed, and what is wrong with them. */
import type { Scan } from "../types";
import { fixed, lengthUnit, parseLength, parseNumber } from "../units";

export interface RigTyped {
  baseline: string;
  uBaseline: string;
  rate: string;
  ratePpm: string;
}

export interface RigValues {
  baseline_m: number;
  u_baseline_m: number;
  line_rate_hz: number;
  u_line_rate_ratio: number;
}

export const NEW_RIG: RigTyped = { baseline: "", uBaseline: "", rate: "", ratePpm: "" };

export function typedOf({ rig }: Scan): RigTyped {
  const metres = (value: number) => fixed(lengthUnit.value === "ft" ? value / 0.3048 : value, 4);
  return {
    baseline: metres(rig.baseline_m),
    uBaseline: rig.u_baseline_m === 0 ? "" : metres(rig.u_baseline_m),
    rate: String(rig.line_rate_hz),
    ratePpm: rig.u_line_rate_ratio === 0 ? "" : String(rig.u_line_rate_ratio * 1e6),
  };
}

/** The values in SI units, or for each field that is wrong a sentence. */
export function valuesOf(typed: RigTyped): RigValues | Partial<Record<keyof RigTyped, string>> {
  const baseline_m = parseLength(typed.baseline);
  const u_baseline_m = typed.uBaseline.trim() === "" ? 0 : parseLength(typed.uBaseline);
  const line_rate_hz = parseNumber(typed.rate);
  const ppm = typed.ratePpm.trim() === "" ? 0 : parseNumber(typed.ratePpm);
  const wrong: Partial<Record<keyof RigTyped, string>> = {};
  if (baseline_m === null || baseline_m <= 0)
    wrong.baseline = "Enter the distance between the two scanning planes.";
  if (u_baseline_m === null || u_baseline_m < 0) wrong.uBaseline = "Enter a length, or leave it empty.";
  if (line_rate_hz === null || line_rate_hz <= 0)
    wrong.rate = "Enter how many lines the cameras make a second.";
  if (ppm === null || ppm < 0) wrong.ratePpm = "Enter a number, or leave it empty.";
  if (baseline_m === null || u_baseline_m === null || line_rate_hz === null || ppm === null) return wrong;
  if (Object.keys(wrong).length > 0) return wrong;
  return { baseline_m, u_baseline_m, line_rate_hz, u_line_rate_ratio: ppm / 1e6 };
}

export function isValues(value: ReturnType<typeof valuesOf>): value is RigValues {
  return "baseline_m" in value;
}
