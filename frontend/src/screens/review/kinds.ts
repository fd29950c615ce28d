/** How the outbox brings a verdict on a measurement to the server. */
import { api } from "../../core/api";
import { outbox } from "../../core/outbox";
import { shapeOf } from "../../core/shape";
import type { LineHeight, Measurement, ReviewItem } from "../../core/types";
import { type Verdict, verdictKind } from "../../parts/verdicts/kind";

/** A height of a frame, or of a line of a line scan. */
export type Height = ReviewItem["measurement"];

export function isOfFrame(m: Height): m is Measurement {
  return "recording_id" in m;
}

export function isOfLine(m: Height): m is LineHeight {
  return !isOfFrame(m);
}

const isHeight = shapeOf<Height>({
  id: "number",
  revision: "number",
  target: "string",
  contact: "list",
  target_point: "list",
  review: "object",
});

export interface GivenVerdict extends Verdict {
  readonly points: {
    readonly contact: [number, number];
    readonly target_point: [number, number];
    readonly frame: number;
  } | null;
}

export interface VerdictAbout {
  readonly id: number;
  /** The revision that was seen: a verdict never holds for points that nobody has looked at. */
  readonly revision: number;
  readonly by: number;
}

const heightVerdict = verdictKind<Height, GivenVerdict, VerdictAbout>({
  send({ about: { id, revision }, want: { points } }, verdict, sending) {
    const body = { ...verdict, revision, ...points };
    const route = "POST /measurements/{measurement_id}/reviews";
    return api.write(route, { measurement_id: id }, { body, ...sending });
  },
  read: ({ about: { id } }, _error, signal) => readHeight(id, signal),
  isSaved: isHeight,
  review: ({ revision, review }) => ({ of: revision, review }),
  isOn: (saved, { want: { points } }) => !points || fits(saved, points),
});

export async function readHeight(measurement_id: number, signal?: AbortSignal): Promise<Height | null> {
  const route = "GET /measurements/{measurement_id}/history";
  const { revisions } = await api.ask(route, { measurement_id }, signal ? { signal } : {});
  return revisions.at(-1) ?? null;
}

function fits(saved: Height, points: NonNullable<GivenVerdict["points"]>): boolean {
  const { contact, target_point } = points;
  return `${saved.contact} ${saved.target_point}` === `${contact} ${target_point}`;
}

export const VERDICT = outbox.register("verdict", heightVerdict);
