/** What the operator decides about a measurement; everything else in it is the server's. */
import type { BodyOf } from "../core/routes";
import type { Made, Measurement, Target } from "../core/types";
import { fromServer, type ImagePoint, pair, samePoint } from "./points";

export interface Inset {
  readonly inset_m: number;
  readonly u_inset_m: number;
}

/** The two points on one frame. */
export interface FramePoints {
  readonly frame: number;
  readonly contact: ImagePoint;
  readonly point: ImagePoint;
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
}

/** Null for an eye of which nobody knows on which side the driver sits. */
export function insetOf({ inset_m, u_inset_m }: Pick<Measurement, "inset_m" | "u_inset_m">): Inset | null {
  return inset_m === null || u_inset_m === null ? null : { inset_m, u_inset_m };
}

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
  };
}

/** Every frame of a measurement, the first one first. */
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

/** What changes when a point moves on one of the frames. */
export function movedOn(values: Values, frame: number, change: Partial<FramePoints>): Partial<Values> {
  return ofFrames(framesOf(values).map((one) => (one.frame === frame ? { ...one, ...change } : one)));
}

function sameFrames(a: readonly FramePoints[], b: readonly FramePoints[]): boolean {
  return (
    a.length === b.length &&
    a.every((one, i) => {
      const other = b[i];
      return (
        other !== undefined &&
        one.frame === other.frame &&
        samePoint(one.contact, other.contact) &&
        samePoint(one.point, other.point)
      );
    })
  );
}

function sameInset(a: Inset | null, b: Inset | null): boolean {
  // null means "as the survey has it", which the server has filled in: never a difference to send
  if (a === null || b === null) return true;
  return a.inset_m === b.inset_m && a.u_inset_m === b.u_inset_m;
}

/** True if both say the same about target, frames, points and inset (withdrawal aside). */
function sameClick(a: Values, b: Values): boolean {
  return a.target === b.target && sameFrames(framesOf(a), framesOf(b)) && sameInset(a.inset, b.inset);
}

export function sameValues(a: Values, b: Values): boolean {
  return a.withdrawn === b.withdrawn && sameClick(a, b);
}

/** How the points came about: by hand, as proposed, or begun from a proposal and put elsewhere. */
export function madeOf({ proposed, frame, contact, point }: Values): Made {
  if (!proposed || proposed.frame !== frame) return "clicked";
  const same = samePoint(proposed.contact, contact) && samePoint(proposed.point, point);
  return same ? "confirmed" : "moved";
}

export type ClickBody = Omit<BodyOf<"PUT /measurements/{measurement_id}">, "revision"> & { target: Target };

/** The body of a POST or PUT. */
export function clickBody({ target, inset, sigma_px, more, ...first }: Omit<Values, "proposed">): ClickBody {
  const sigma = sigma_px === null ? {} : { sigma_px };
  return { target, ...frameBody(first), ...(inset ?? {}), ...sigma, more_frames: more.map(frameBody) };
}

export function frameBody({ frame, contact, point }: FramePoints): FrameBody {
  return { frame, contact: pair(contact), target_point: pair(point) };
}

type FrameBody = NonNullable<ClickBody["more_frames"]>[number];
