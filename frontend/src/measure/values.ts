/** What the operator decides about a measurement; everything else in it is the server's. */
import type { Measurement, Target } from "../types";
import { fromServer, type ImagePoint, samePoint } from "../viewer/points";

export interface Inset {
  readonly inset_m: number;
  readonly u_inset_m: number;
}

export interface Values {
  readonly target: Target;
  readonly frame: number;
  readonly contact: ImagePoint;
  readonly point: ImagePoint;
  /** An inset of its own; null for the survey's. */
  readonly inset: Inset | null;
  /** The click's own uncertainty, kept from one revision to the next; null for the survey's. */
  readonly sigma_px: number | null;
  readonly withdrawn: boolean;
}

export function valuesOf(m: Measurement): Values {
  return {
    target: m.target,
    frame: m.frame,
    contact: fromServer(m.contact),
    point: fromServer(m.point),
    inset: { inset_m: m.inset_m, u_inset_m: m.u_inset_m },
    sigma_px: m.sigma_px,
    withdrawn: m.withdrawn,
  };
}

function sameInset(a: Inset | null, b: Inset | null): boolean {
  // null means "as the survey has it", which the server has filled in: never a difference to send
  if (a === null || b === null) return true;
  return a.inset_m === b.inset_m && a.u_inset_m === b.u_inset_m;
}

/** True if both say the same about target, frame, points and inset (withdrawal aside). */
export function sameClick(a: Values, b: Values): boolean {
  return (
    a.target === b.target &&
    a.frame === b.frame &&
    samePoint(a.contact, b.contact) &&
    samePoint(a.point, b.point) &&
    sameInset(a.inset, b.inset)
  );
}

export function sameValues(a: Values, b: Values): boolean {
  return a.withdrawn === b.withdrawn && sameClick(a, b);
}

/** The body of a POST or PUT. */
export function clickBody(values: Values): Record<string, unknown> {
  const { target, frame, contact, point, inset, sigma_px } = values;
  const sigma = sigma_px === null ? {} : { sigma_px };
  return { target, frame, contact: [...contact], point: [...point], ...(inset ?? {}), ...sigma };
}
