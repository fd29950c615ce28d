/** What the operator decides about a measurement; everything else in it is the server's. */
import type { BodyOf } from "../core/routes";
import { sameValue } from "../core/same";
import { shapeOf } from "../core/shape";
import type { Made, Measurement, Target } from "../core/types";
import { fromServer, type ImagePoint, imagePoint, pair, samePoint } from "./points";

export interface Inset {
  readonly inset_m: number;
  readonly u_inset_m: number;
}

export interface FramePoints {
  readonly frame: number;
  readonly contact: ImagePoint;
  readonly point: ImagePoint;
}

/** A contact that went from a click to the tyre found there. */
export interface Snapped {
  readonly from: ImagePoint;
  readonly to: ImagePoint;
}

export interface Values extends FramePoints {
  readonly target: Target;
  /** The same two points on further frames; with any, the server solves for the inset. */
  readonly more: readonly FramePoints[];
  /** An inset of its own; null for the survey's. */
  readonly inset: Inset | null;
  /** The click's own uncertainty, kept from one revision to the next; null for the survey's. */
  readonly sigma_px: number | null;
  readonly withdrawn: boolean;
  /** Where Sightline proposed the points that these began from; left out: they were clicked. */
  readonly proposed?: FramePoints;
  /** Of a whole pass: followed from these points, and from the other tyre where that is known. Left out: it is none. */
  readonly follow?: { readonly second: ImagePoint | null } | undefined;
  /** Left out: the contact stands where it was clicked. It counts only while the contact is at its `to`. */
  readonly snapped?: Snapped | undefined;
}

/** Null for an eye of which nobody knows on which side the driver sits. */
export function insetOf({ inset_m, u_inset_m }: Pick<Measurement, "inset_m" | "u_inset_m">): Inset | null {
  return inset_m === null || u_inset_m === null ? null : { inset_m, u_inset_m };
}

/** Whether an answer is a measurement: what else it holds is only shown. */
export const isMeasurement = shapeOf<Measurement>({
  id: "number",
  revision: "number",
  vehicle_id: "number",
  target: "string",
  frame: "number",
  contact: "list",
  target_point: "list",
  more_frames: "list",
  flags: "list",
  withdrawn: "boolean",
  review: "object",
});

export function valuesOf(m: Measurement): Values {
  return {
    target: m.target,
    frame: m.frame,
    contact: fromServer(m.contact),
    point: fromServer(m.target_point),
    more: m.more_frames.map((one) => ({
      frame: one.frame,
      contact: fromServer(one.contact),
      point: fromServer(one.target_point),
    })),
    inset: insetOf(m),
    sigma_px: m.sigma_px,
    withdrawn: m.withdrawn,
    snapped: snappedOf(m),
    follow: followOf(m),
  };
}

/** The other tyre is what was followed of it on the first frame. */
function followOf({ followed, frame }: Measurement): Values["follow"] {
  if (!followed) return undefined;
  const { points } = JSON.parse(followed) as { points: [number, number, string, number, number][] };
  const other = points.find(([n, , point]) => n === frame && point === "second_contact");
  return { second: other ? imagePoint(other[3], other[4]) : null };
}

function snappedOf({
  snapped_from_x_px: x,
  snapped_from_y_px: y,
  contact,
}: Measurement): Snapped | undefined {
  if (typeof x !== "number" || typeof y !== "number") return undefined;
  return { from: imagePoint(x, y), to: fromServer(contact) };
}

/** Where the contact was clicked, for the server to hold against where it takes such a click. */
export function snappedFrom({ snapped, contact }: Values): { snapped_from?: [number, number] } {
  return snapped && samePoint(snapped.to, contact) ? { snapped_from: pair(snapped.from) } : {};
}

export function framesOf(values: Values): readonly FramePoints[] {
  return [{ frame: values.frame, contact: values.contact, point: values.point }, ...values.more];
}

/** The points on one frame; undefined where the measurement has none there. */
export function pointsOn(values: Values, frame: number): FramePoints | undefined {
  return framesOf(values).find((one) => one.frame === frame);
}

/** A measurement of these frames; the first of them is the first again. */
export function ofFrames(frames: readonly FramePoints[]): Partial<Values> {
  const [first, ...more] = frames;
  return first ? { ...first, more } : {};
}

export function movedOn(values: Values, frame: number, change: Partial<FramePoints>): Partial<Values> {
  return ofFrames(framesOf(values).map((one) => (one.frame === frame ? { ...one, ...change } : one)));
}

/** Whether both say the same: target, points, inset, and whether it stands. */
export function sameValues(a: Values, b: Values): boolean {
  const told = (one: Values) => [one.withdrawn, one.target, !one.follow, framesOf(one)];
  // no inset means "as the survey has it", which the server has filled in: never a difference to send
  return sameValue(told(a), told(b)) && (!a.inset || !b.inset || sameValue(a.inset, b.inset));
}

/** How the points came about: by hand, as proposed, or begun from a proposal and put elsewhere. */
export function madeOf({ proposed, frame, contact, point }: Values): Exclude<Made, "snapped"> {
  if (!proposed || proposed.frame !== frame) return "clicked";
  const same = samePoint(proposed.contact, contact) && samePoint(proposed.point, point);
  return same ? "confirmed" : "moved";
}

export type ClickBody = Omit<BodyOf<"PUT /measurements/{measurement_id}">, "revision"> & { target: Target };

export function clickBody({
  target,
  inset,
  sigma_px,
  more,
  follow,
  ...first
}: Omit<Values, "proposed" | "snapped">): ClickBody {
  const sigma = sigma_px === null ? {} : { sigma_px };
  const clicks = { target, ...frameBody(first), ...(inset ?? {}), ...sigma };
  const pass = follow ? { follow: { second_contact: follow.second ? pair(follow.second) : null } } : {};
  return { ...clicks, ...pass, more_frames: more.map(frameBody) };
}

export function frameBody({ frame, contact, point }: FramePoints): FrameBody {
  return { frame, contact: pair(contact), target_point: pair(point) };
}

type FrameBody = NonNullable<ClickBody["more_frames"]>[number];
