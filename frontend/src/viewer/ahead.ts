/** What is worth having before it is asked for, and what stands in until it is here. */
import type { Recording } from "../core/types";

const BYTES_PER_PIXEL = 4;
const AHEAD = 8;
const BEHIND = 2;
const AROUND = 2;
/** Within so many frames the old picture stays until the new one is here: it is nearly the same. */
const JUMP = 12;

/** Frames to fetch, best first: neighbours in the direction of travel, then the expected; all fit into the cache. */
export function worthHaving(
  frame: number,
  direction: 1 | -1,
  recording: Recording | null,
  expected: readonly number[],
  cacheBytes: number,
): number[] {
  const count = recording?.frame_count ?? 0;
  const bytes = (recording?.width_px ?? 0) * (recording?.height_px ?? 0) * BYTES_PER_PIXEL;
  const room = bytes > 0 ? Math.max(2, Math.floor(cacheBytes / bytes) - 2) : AHEAD + BEHIND;
  const near = neighbours(frame, direction, count, Math.min(AHEAD, room), Math.min(BEHIND, room >> 2));
  const known = new Set([frame, ...near]);
  const far = expected.filter((n) => n >= 0 && n < count && !known.has(n));
  return [...near, ...far].slice(0, room);
}

export function around(frame: number): number[] {
  const found = [frame];
  for (let step = 1; step <= AROUND; step += 1) found.push(frame + step, frame - step);
  return found;
}

export type Thumb = Recording["thumbs"][number];

export function nearestThumb(thumbs: readonly Thumb[], frame: number): Thumb | undefined {
  let best = thumbs[0];
  for (const thumb of thumbs) {
    if (best && Math.abs(thumb.frame - frame) < Math.abs(best.frame - frame)) best = thumb;
  }
  return best;
}

/** The thumbnail that stands in for a frame; none for a small step, and none that is further off than the picture shown. */
export function standIn(
  recording: Recording | null,
  frame: number,
  shownFrame: number | null,
): Thumb | undefined {
  const thumb = nearestThumb(recording?.thumbs ?? [], frame);
  if (!thumb || shownFrame === null) return thumb;
  const away = Math.abs(shownFrame - frame);
  return away > JUMP && Math.abs(thumb.frame - frame) < away ? thumb : undefined;
}

/** Frames worth having next: mostly ahead in the direction of travel, a few behind. */
export function neighbours(frame: number, direction: 1 | -1, count: number, ahead = 8, behind = 2): number[] {
  const wanted: number[] = [];
  for (let step = 1; step <= ahead; step += 1) wanted.push(frame + direction * step);
  for (let step = 1; step <= behind; step += 1) wanted.push(frame - direction * step);
  return wanted.filter((n) => n >= 0 && n < count);
}

export function runsOf(frames: readonly number[]): [number, number][] {
  const runs: [number, number][] = [];
  for (const frame of [...frames].sort((a, b) => a - b)) {
    const last = runs.at(-1);
    if (last && last[1] === frame - 1) last[1] = frame;
    else runs.push([frame, frame]);
  }
  return runs;
}
