import { say } from "../../core/messages";
import { fixed } from "../../core/units";

/** "−0.80°"; a missing value is an en dash. */
export function formatDegrees(rad: number | null, digits = 2): string {
  return rad === null ? "–" : `${fixed((rad * 180) / Math.PI, digits)}°`;
}

export function formatHeading(rad: number | null, u_rad: number | null): string {
  if (rad === null) return "–";
  return u_rad === null
    ? formatDegrees(rad)
    : say("with-u", { value: formatDegrees(rad), u: formatDegrees(u_rad) });
}
