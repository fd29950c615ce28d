/**
 * The clicking itself as a pure state machine: contact, target, next target, next vehicle.
 * It knows no server and no screen; what has to happen in the world comes out as effects.
 */
import type { Target } from "../../core/types";
import type { ImagePoint } from "../../viewer/points";

export type Role = "contact" | "point";

export interface Selection {
  /** Key of the measurement (see `store`), or null for a contact not yet used by any. */
  readonly key: string | null;
  readonly role: Role;
}

export interface Flow {
  readonly vehicleId: number | null;
  readonly target: Target | null;
  /** The contact in use on each frame of this vehicle: a contact is worth nothing on another frame. */
  readonly contacts: ReadonlyMap<number, ImagePoint>;
  /** The next click places a new contact though there is one. */
  readonly renew: boolean;
  readonly selection: Selection | null;
}

export type FlowEvent =
  | {
      type: "open";
      vehicleId: number | null;
      target: Target | null;
      contacts?: ReadonlyMap<number, ImagePoint>;
    }
  | { type: "choose"; target: Target | null }
  | { type: "click"; frame: number; point: ImagePoint }
  | { type: "set-contact"; frame: number; point: ImagePoint | null }
  | { type: "new-contact" }
  | { type: "select"; selection: Selection | null }
  | { type: "stored"; missing: readonly Target[] }
  | { type: "escape"; frame: number; used: boolean };

export type Effect =
  | { type: "contact"; frame: number; before: ImagePoint | null; point: ImagePoint }
  | {
      type: "store";
      vehicleId: number;
      target: Target;
      frame: number;
      contact: ImagePoint;
      point: ImagePoint;
    };

export interface Outcome {
  readonly flow: Flow;
  readonly effect: Effect | null;
}

export const START: Flow = {
  vehicleId: null,
  target: null,
  contacts: new Map(),
  renew: false,
  selection: null,
};

export function awaiting(flow: Flow, frame: number): Role | null {
  if (flow.vehicleId === null || flow.target === null) return null;
  return flow.renew || !flow.contacts.has(frame) ? "contact" : "point";
}

/** The first target that is asked for and not in `have`, in the order in which operators click. */
export function firstMissing(have: ReadonlySet<Target>, asked: readonly Target[]): Target | null {
  return asked.find((target) => !have.has(target)) ?? null;
}

export function step(flow: Flow, event: FlowEvent): Outcome {
  switch (event.type) {
    case "open":
      return only({
        ...START,
        vehicleId: event.vehicleId,
        target: event.target,
        contacts: event.contacts ?? START.contacts,
      });
    case "choose":
      return only({ ...flow, target: event.target, renew: false, selection: null });
    case "click":
      return click(flow, event.frame, event.point);
    case "set-contact":
      return only({ ...flow, contacts: withContact(flow.contacts, event.frame, event.point) });
    case "new-contact":
      return only({ ...flow, renew: flow.target !== null, selection: null });
    case "select":
      return only({ ...flow, selection: event.selection });
    case "stored":
      return only({ ...flow, target: event.missing[0] ?? null });
    case "escape":
      return only(takeBackOne(flow, event.frame, event.used));
  }
}

function click(flow: Flow, frame: number, point: ImagePoint): Outcome {
  const role = awaiting(flow, frame);
  if (role === "contact") {
    const before = flow.contacts.get(frame) ?? null;
    const contacts = withContact(flow.contacts, frame, point);
    return {
      flow: { ...flow, contacts, renew: false, selection: null },
      effect: { type: "contact", frame, before, point },
    };
  }
  const contact = flow.contacts.get(frame);
  if (role === null || !contact || flow.vehicleId === null || flow.target === null) {
    return only({ ...flow, selection: null });
  }
  const { vehicleId, target } = flow;
  return {
    flow: { ...flow, selection: null },
    effect: { type: "store", vehicleId, target, frame, contact, point },
  };
}

/** Esc takes back one thing at a time: selection, wish for a new contact, an unused contact, the target. */
function takeBackOne(flow: Flow, frame: number, used: boolean): Flow {
  if (flow.selection) return { ...flow, selection: null };
  if (flow.renew) return { ...flow, renew: false };
  if (flow.contacts.has(frame) && !used) {
    return { ...flow, contacts: withContact(flow.contacts, frame, null) };
  }
  return { ...flow, target: null };
}

function withContact(
  contacts: ReadonlyMap<number, ImagePoint>,
  frame: number,
  point: ImagePoint | null,
): ReadonlyMap<number, ImagePoint> {
  const next = new Map(contacts);
  if (point) next.set(frame, point);
  else next.delete(frame);
  return next;
}

function only(flow: Flow): Outcome {
  return { flow, effect: null };
}
