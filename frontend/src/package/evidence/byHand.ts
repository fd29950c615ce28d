/** What boundaries that a reader placed by hand give, by the plain formula of two lines: speed = baseline / time.
 *  It is the reader's own measurement; the file's numbers come from the server and are not computed here. */
import type { Evidence, Lines } from "./document";

export interface Plain {
  readonly front_mps: number;
  readonly rear_mps: number;
  readonly length_m: number;
}

export type Hand = Readonly<Record<keyof Lines, number | null>>;

/** Null where one is not set yet, where front and rear go different ways or at no speed, or the rear comes first. */
export function plainOf(hand: Hand, baseline_m: number, line_rate_hz: number): Plain | null {
  const lines = allSet(hand);
  return lines && plainOfLines(lines, baseline_m, line_rate_hz);
}

export function allSet(hand: Hand): Lines | null {
  const { front_line_1, rear_line_1, front_line_2, rear_line_2 } = hand;
  if (front_line_1 === null || rear_line_1 === null || front_line_2 === null || rear_line_2 === null)
    return null;
  return { front_line_1, rear_line_1, front_line_2, rear_line_2 };
}

function plainOfLines(lines: Lines, baseline_m: number, line_rate_hz: number): Plain | null {
  // a vehicle that reaches camera 2 first takes its time the other way
  const way = Math.sign(lines.front_line_2 - lines.front_line_1);
  const front = speedOf(way * (lines.front_line_2 - lines.front_line_1), baseline_m, line_rate_hz);
  const rear = speedOf(way * (lines.rear_line_2 - lines.rear_line_1), baseline_m, line_rate_hz);
  const passing_s = (lines.rear_line_1 - lines.front_line_1) / line_rate_hz;
  if (front === null || rear === null || !(passing_s > 0)) return null;
  return { front_mps: front, rear_mps: rear, length_m: ((front + rear) / 2) * passing_s };
}

export function speedOf(shift_lines: number, baseline_m: number, line_rate_hz: number): number | null {
  return shift_lines > 0 ? (baseline_m * line_rate_hz) / shift_lines : null;
}

/** Of a camera's picture: from which line to which it goes, each line's own place in the middle of its column. */
export function spanOf(picture: Evidence["pictures"][number]): { start: number; width: number } {
  return { start: picture.first_line - picture.step_lines / 2, width: picture.columns * picture.step_lines };
}
