/** The list of passes as the operator wants to see it: filter, order, next and previous. */
import { wordsOf } from "../../core/messages";
import type { Vehicle } from "../../core/types";
import { beside, nextThat } from "../worklist";

export const FILTER_WORDS = wordsOf("passes-show-");
export type Filter = keyof typeof FILTER_WORDS;
export const ORDER_WORDS = wordsOf("passes-by-");
export type Order = keyof typeof ORDER_WORDS;

const RANK: Record<Vehicle["state"], number> = {
  rejected: 0,
  partial: 1,
  to_do: 2,
  measured: 3,
  not_visible: 4,
  accepted: 5,
  out_of_sample: 6,
  discarded: 7,
};

export function isOpen(vehicle: Vehicle): boolean {
  return RANK[vehicle.state] <= RANK.to_do;
}

export function listed(vehicles: readonly Vehicle[], filter: Filter, order: Order): Vehicle[] {
  return vehicles.filter((vehicle) => passesFilter(vehicle, filter)).sort(COMPARE[order]);
}

function passesFilter(vehicle: Vehicle, filter: Filter): boolean {
  if (filter === "all") return true;
  if (filter === "to_do") return isOpen(vehicle);
  if (filter === "rejected") return vehicle.state === "rejected";
  if (filter === "doubtful") return vehicle.doubts.length > 0;
  if (filter === "no_class") return lacksClass(vehicle);
  const isLeftOut = RANK[vehicle.state] >= RANK.out_of_sample;
  return filter === "left_out" ? isLeftOut : !isOpen(vehicle) && !isLeftOut;
}

const byTime = (a: Vehicle, b: Vehicle): number =>
  a.recording_id - b.recording_id || a.first_frame - b.first_frame || a.number - b.number;

const COMPARE: Record<Order, (a: Vehicle, b: Vehicle) => number> = {
  number: (a, b) => a.number - b.number,
  time: byTime,
  state: (a, b) => RANK[a.state] - RANK[b.state] || a.number - b.number,
};

/** Of a measured vehicle nobody has said the class: its roof and every figure of a class depend on it. */
export function lacksClass(vehicle: Vehicle): boolean {
  return vehicle.category === null && !vehicle.check_target && vehicle.measurements.length > 0;
}

/** The pass after (or before) one, in the order of the list; from one that is not listed, by number. */
export function neighbour(
  list: readonly Vehicle[],
  from: Vehicle | undefined,
  step: 1 | -1,
): Vehicle | undefined {
  if (!from || list.some((vehicle) => vehicle.id === from.id)) return beside(list, from?.id ?? null, step);
  return step === 1
    ? list.find((vehicle) => vehicle.number > from.number)
    : list.findLast((vehicle) => vehicle.number < from.number);
}

/** The next pass with something to do, searching on from one and then from the start. */
export function nextOpen(list: readonly Vehicle[], from: Vehicle | undefined): Vehicle | undefined {
  return nextThat(list, from?.id ?? null, isOpen);
}

/** Where to begin: a pass that nobody has begun, else one begun or sent back. */
export function firstOpen(list: readonly Vehicle[]): Vehicle | undefined {
  return list.find((vehicle) => vehicle.state === "to_do") ?? nextOpen(list, undefined);
}

export function bestFrame(vehicle: Vehicle): number {
  return vehicle.best_frame ?? Math.round((vehicle.first_frame + vehicle.last_frame) / 2);
}

/** True for a pass that the search found and nobody has touched yet. */
export function isUnconfirmed(vehicle: Vehicle): boolean {
  return vehicle.origin === "found" && vehicle.version === 1 && vehicle.measurements.length === 0;
}

/** What the search proposes from the luminance of the best frame. */
export function lightingProposed(vehicle: Vehicle): Vehicle["lighting"] {
  const proposed = vehicle.detection?.lighting_proposed;
  return proposed === "daytime" || proposed === "low_light" ? proposed : null;
}
