/** What is planned with, as the address of the page holds it: the same names and units as the server's, so that a link tells all. */
import { api, fromAddress } from "../../core/api";
import { language, wordsOf } from "../../core/messages";
import type { Camera, Scan } from "../../core/types";
import { type LengthUnit, lengthScale, lengthUnit, parseNumber, speedScale } from "../../core/units";
import type { LinePlan, Plan } from "./model";

const NAMES = [
  "calibration_id",
  "width_px",
  "height_px",
  "field_of_view_deg",
  "camera_height_m",
  "distance_m",
  "board_distance_m",
  "travel_m",
  "sigma_px",
  "direction_deg",
] as const;
export const LINE_NAMES = [
  "speed_mps",
  "error",
  "baseline_m",
  "u_baseline_m",
  "line_rate_hz",
  "length_m",
  "time_gap_s",
  "pixel_width_um",
  "pixel_height_um",
  "focal_mm",
  "distance_m",
  "exposure_us",
] as const;
export type Name = (typeof NAMES)[number] | (typeof LINE_NAMES)[number];
export type Values = Partial<Record<Name, string>>;

const USUAL: Values = {
  camera_height_m: "1.5",
  distance_m: "3",
  sigma_px: "1",
  direction_deg: "0",
  travel_m: "2",
};
const PLAIN: Values = { width_px: "1920", height_px: "1080", field_of_view_deg: "65" };

export function valuesOf(query: URLSearchParams, names: readonly Name[] = NAMES): Values {
  const values: Values = {};
  for (const name of names) {
    const value = query.get(name);
    if (value) values[name] = value;
  }
  return values;
}

/** What the address leaves open: usual places, and the calibration in use of the first camera that has one. */
export function completed(values: Values, cameras: readonly Camera[]): Values {
  const chosen = values.calibration_id || values.field_of_view_deg;
  const calibrated = cameras.find((camera) => camera.current_calibration_id !== null);
  const camera: Values = chosen
    ? {}
    : calibrated
      ? { calibration_id: String(calibrated.current_calibration_id) }
      : PLAIN;
  return { ...USUAL, ...camera, ...values };
}

/** The change of the address that takes another camera: a calibration's id, or "plain". */
export function withCamera(choice: string): Record<string, string | null> {
  if (choice !== "plain") {
    return { calibration_id: choice, width_px: null, height_px: null, field_of_view_deg: null };
  }
  return { calibration_id: null, ...(PLAIN as Record<string, string>) };
}

export function askPlan(survey_id: number, values: Values, signal?: AbortSignal): Promise<Plan> {
  const query = fromAddress<"GET /surveys/{survey_id}/plan">(values);
  return api.ask("GET /surveys/{survey_id}/plan", { ...query, survey_id }, { signal });
}

/** Where the set-up sheet of a plan is, in the language spoken. */
export function sheetAddress(survey_id: number, values: Values): string {
  return `/api/surveys/${survey_id}/plan.pdf?${new URLSearchParams({ ...values, language: language.value })}`;
}

const USUAL_LINES: Values = {
  error: "0.01",
  length_m: "4.5",
  time_gap_s: "1.5",
  pixel_width_um: "10",
  pixel_height_um: "10",
  focal_mm: "16",
  distance_m: "3",
};

/** What the address leaves open of a line rate: the newest rig of the survey, else usual values. */
export function completedLines(values: Values, scans: readonly Pick<Scan, "rig">[]): Values {
  const rig = scans.at(-1)?.rig;
  const known: Values = rig
    ? {
        baseline_m: String(rig.baseline_m),
        u_baseline_m: String(rig.u_baseline_m),
        line_rate_hz: String(rig.line_rate_hz),
        ...(rig.distance_m === null ? {} : { distance_m: String(rig.distance_m) }),
      }
    : { baseline_m: "1", u_baseline_m: "0.002" };
  // a rig of the address is not mixed with another one's line rate
  const own = values.baseline_m !== undefined || values.speed_mps !== undefined;
  const usual = { ...USUAL_LINES, speed_mps: String(120 / speedScale("m")[0]) };
  return { ...usual, ...(own ? {} : known), ...values };
}

export function askLinePlan(values: Values, signal?: AbortSignal): Promise<LinePlan> {
  return api.ask("GET /line-rate-plan", fromAddress<"GET /line-rate-plan">(values), { signal });
}

/** Shown over stored: feet, km/h or mph, per cent. */
function factorOf(name: Name, unit: LengthUnit): number {
  if (name.endsWith("_m")) return lengthScale(unit)[0];
  if (name === "speed_mps") return speedScale(unit)[0];
  return name === "error" ? 100 : 1;
}

const UNITS: Readonly<Record<string, string>> = wordsOf("unit-", "px", "hz", "um", "mm", "us");

/** The unit that a value is shown in, told by the end of its name. */
export function unitOf(name: Name): string {
  const end = name.slice(name.lastIndexOf("_") + 1);
  if (end === "m") return lengthUnit.value;
  if (end === "mps") return speedScale()[1];
  if (end === "deg") return "°";
  return end === "error" ? "%" : (UNITS[end] ?? end);
}

/** A value as it stands in its field: lengths and speeds in the unit shown, shares in per cent. */
export function shown(name: Name, value: string | undefined, unit = lengthUnit.value): string {
  const factor = factorOf(name, unit);
  if (!value || factor === 1) return value ?? "";
  const stored = Number(value);
  const decimals = name.startsWith("u_") ? 5 : 3;
  return Number.isFinite(stored) ? String(Number((stored * factor).toFixed(decimals))) : value;
}

/** What was typed, for the address; null where it is no number. An empty field is "". */
export function typed(name: Name, text: string, unit = lengthUnit.value): string | null {
  if (!text.trim()) return "";
  const value = parseNumber(text);
  if (value === null) return null;
  const factor = factorOf(name, unit);
  return String(factor === 1 ? value : Number((value / factor).toFixed(6)));
}
