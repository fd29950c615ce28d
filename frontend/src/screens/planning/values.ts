/** What is planned with, as the address of the page holds it: the same names and units as the server's, so that a link tells all. */
import type { Camera } from "../../types";
import { lengthUnit, METRES_PER_FOOT, parseNumber } from "../../units";

export const LENGTHS = ["camera_height_m", "distance_m", "board_distance_m", "travel_m"] as const;
export const NAMES = [
  "calibration_id",
  "width_px",
  "height_px",
  "field_of_view_deg",
  ...LENGTHS,
  "sigma_px",
  "direction_deg",
] as const;
export type Name = (typeof NAMES)[number];
export type Values = Partial<Record<Name, string>>;

const USUAL: Values = {
  camera_height_m: "1.5",
  distance_m: "3",
  sigma_px: "1",
  direction_deg: "0",
  travel_m: "2",
};
const PLAIN: Values = { width_px: "1920", height_px: "1080", field_of_view_deg: "65" };

/** The values of an address. */
export function valuesOf(query: URLSearchParams): Values {
  const values: Values = {};
  for (const name of NAMES) {
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

export function planPath(surveyId: number, values: Values): string {
  return `/surveys/${surveyId}/plan?${new URLSearchParams(values as Record<string, string>)}`;
}

const isLength = (name: Name) => (LENGTHS as readonly string[]).includes(name);

/** A value as it stands in its field: lengths in the unit shown. */
export function shown(name: Name, value: string | undefined, unit = lengthUnit.value): string {
  if (!value || !isLength(name) || unit === "m") return value ?? "";
  const metres = Number(value);
  return Number.isFinite(metres) ? String(Number((metres / METRES_PER_FOOT).toFixed(3))) : value;
}

/** What was typed, for the address; null where it is no number. An empty field is "". */
export function typed(name: Name, text: string, unit = lengthUnit.value): string | null {
  if (!text.trim()) return "";
  const value = parseNumber(text);
  if (value === null) return null;
  return String(isLength(name) && unit === "ft" ? Number((value * METRES_PER_FOOT).toFixed(6)) : value);
}
