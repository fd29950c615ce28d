/** What stands of the open vehicle: its measurements, their points on the frame that is seen, and the targets still missing. */
import type { Target } from "../../core/types";
import { type ImagePoint, samePoint } from "../../viewer/points";
import { type FramePoints, pointsOn } from "../../viewer/values";
import type { Selection } from "./flow";
import { type Entry, isStored } from "./records";
import type { Table } from "./table";

export class Standing {
  constructor(private readonly desk: Table) {}

  /** Points on the frame that is seen; a contact that several measurements share is one point. */
  selectable(): Selection[] {
    const here = this.entriesHere();
    const points: Selection[] = here.map((entry) => ({ key: entry.key, role: "point" }));
    const contacts: Selection[] = [];
    const seen: ImagePoint[] = [];
    for (const entry of here) {
      const { contact } = this.here(entry);
      if (seen.some((one) => samePoint(one, contact))) continue;
      seen.push(contact);
      contacts.push({ key: entry.key, role: "contact" });
    }
    const contact = this.desk.contact.value;
    if (contact && !seen.some((one) => samePoint(one, contact)))
      contacts.push({ key: null, role: "contact" });
    return [...points.reverse(), ...contacts];
  }

  positionOf(selection: Selection): ImagePoint | null {
    if (selection.key === null) return this.desk.contact.value;
    const entry = this.desk.records.find(selection.key);
    return entry ? this.here(entry)[selection.role] : null;
  }

  selectionOf(handle: string): Selection | undefined {
    return this.selectable().find((selection) => idOf(selection) === handle);
  }

  here({ values }: Entry): FramePoints {
    return pointsOn(values, this.desk.seenFrame.value) ?? values;
  }

  entriesHere(): Entry[] {
    const frame = this.desk.seenFrame.value;
    return this.desk.entries.value.filter(
      (entry) => pointsOn(entry.values, frame) !== undefined && !entry.values.withdrawn,
    );
  }

  /** Measurements that move with a point: all that share a contact, or the one. */
  groupOf({ key, role }: Selection): Entry[] {
    const entry = key === null ? undefined : this.desk.records.find(key);
    if (!entry) return [];
    if (role === "point") return [entry];
    const { contact } = this.here(entry);
    return this.entriesHere().filter((other) => samePoint(this.here(other).contact, contact));
  }

  /** Targets that a vehicle has; a rejected one counts as missing, and one whose click was refused. */
  targetsOf(vehicleId: number | null): Set<Target> {
    const stored = this.standingOf(vehicleId).filter(isStored);
    return new Set(stored.map((entry) => entry.values.target));
  }

  /** The contact to go on with on each frame; that of a rejected measurement is not offered again. */
  contactsOf(vehicleId: number): Map<number, ImagePoint> {
    return new Map(this.standingOf(vehicleId).map((entry) => [entry.values.frame, entry.values.contact]));
  }

  missing(): Target[] {
    const have = this.targetsOf(this.desk.vehicleId.value);
    return this.desk.asked().filter((target) => !have.has(target));
  }

  private standingOf(vehicleId: number | null): Entry[] {
    return this.desk.records.of(vehicleId).filter((entry) => !entry.values.withdrawn && !isRejected(entry));
  }

  /** The measurement that a click at this target would revise; "other" always makes a new one. */
  revised(target: Target): Entry | undefined {
    if (target === "other") return undefined;
    return this.desk.entries.value.findLast(
      (entry) => entry.values.target === target && !entry.values.withdrawn && entry.state !== "conflict",
    );
  }

  moreKept(target: Target, frame: number): readonly FramePoints[] {
    const old = this.revised(target)?.values;
    return old?.frame === frame ? old.more : [];
  }
}

export function idOf(selection: Selection): string {
  return `${selection.role}:${selection.key ?? ""}`;
}

/** Rejected by a reviewer and not yet clicked again. */
function isRejected(entry: Entry): boolean {
  return entry.state === "saved" && entry.saved?.review.verdict === "rejected";
}
