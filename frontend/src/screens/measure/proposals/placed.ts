/** What is proposed to be clicked of a vehicle, and on which frame. */
import type { PointProposal, Target } from "../../../core/types";
import type { ImagePoint } from "../../../viewer/points";

export type Role = "contact" | Target;

export interface InHand {
  readonly role: Role;
  readonly at: ImagePoint;
  readonly proposed: ImagePoint;
  readonly expected_px: number;
}

/** What is proposed on the frame that is seen. `contact` may be one that was clicked before: that stays. */
export interface Shown {
  readonly vehicleId: number;
  readonly frame: number;
  readonly contact: ImagePoint;
  readonly proposedContact: ImagePoint;
  /** Null where the contact was clicked before. */
  readonly contactInHand: InHand | null;
  readonly targets: readonly (InHand & { readonly role: Target })[];
}

export interface Placed extends PointProposal {
  readonly frame: number;
  readonly point_px: [number, number];
  readonly expected_px: number;
}

/** The frame on which something is proposed that is asked for; null where nothing is. */
export function frameOf(all: readonly PointProposal[], missing: readonly Target[]): number | null {
  const wanted = ({ point }: PointProposal) => (missing as readonly string[]).includes(point);
  // what is measured free is clicked on the same frame, so that the two can be compared
  const free = all.find((one) => one.reason === "proposals-withheld" && wanted(one));
  if (free) return free.frame;
  const placed = placedOf(all);
  const useful = placed.some(wanted) || (missing.length > 0 && !placed.some(isTarget));
  return useful ? (bestContact(placed)?.frame ?? null) : null;
}

export function placedOf(some: readonly PointProposal[]): readonly Placed[] {
  return some.filter(
    (one): one is Placed => one.point_px !== null && one.frame !== null && one.expected_px !== null,
  );
}

function isTarget({ point }: PointProposal): boolean {
  return point !== "contact_rear" && point !== "contact_front";
}

/** The contact that is surest. */
export function bestContact(placed: readonly Placed[]): Placed | null {
  const contacts = placed.filter((one) => !isTarget(one));
  return contacts.sort((a, b) => a.expected_px - b.expected_px)[0] ?? null;
}
