/** Figures of a line scan in words and units; every number is the server's. */
import { say } from "../../core/messages";
import type { ScanMotion, ScanVehicle } from "../../core/types";
import { formatHeight } from "../../core/units";
import type { StateName } from "../../core/words";

/** "4.660 ± 0.008 m"; of an uncertain length no more decimals than its uncertainty has to say. */
export function formatMeasured(metres: number | null, U95_m: number | null): string {
  const coarse = U95_m ?? 0;
  return formatHeight(metres, U95_m, coarse >= 1 ? 1 : coarse >= 0.1 ? 2 : 3);
}

export function stateOf(vehicle: ScanVehicle): StateName {
  const measured = vehicle.measurement;
  if (!measured) return "to_do";
  if (measured.status !== "ok") return "not_measurable";
  return measured.review.verdict;
}

export function causeWords(one: ScanMotion): string {
  return say(one.placed_by_person ? "scan-cause-by-hand" : "scan-cause", { method: one.method });
}
