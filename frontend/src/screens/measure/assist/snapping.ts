/**
 * A contact click goes to the tyre: the server says where, the click is shown, one undo puts it back. A click with Shift
 * held stays where it is, and so does one on which something was measured before the server had answered.
 */
import { signal } from "@preact/signals";
import { api } from "../../../core/api";
import { fromServer, type ImagePoint, pair, samePoint, screenDistance } from "../../../viewer/points";
import type { Snapped } from "../../../viewer/values";
import type { Table } from "../table";

/** A pointer this near to the contact is at it. */
const AT_CONTACT_PX = 12;

interface ShownSnap extends Snapped {
  readonly vehicleId: number;
  readonly frame: number;
  readonly expected_px: number | null;
}

interface Click {
  readonly vehicleId: number;
  readonly frame: number;
  readonly at: ImagePoint;
}

export class Snapping {
  private readonly known = signal<readonly ShownSnap[]>([]);

  constructor(private readonly desk: Table) {}

  /** What the contact in use on the frame that is seen was snapped from. */
  shown(): ShownSnap | null {
    const { vehicleId, seenFrame, contact } = this.desk;
    return (
      this.known.value.find(
        (one) =>
          one.vehicleId === vehicleId.value &&
          one.frame === seenFrame.value &&
          samePoint(one.to, contact.value),
      ) ?? null
    );
  }

  /** Where a contact was clicked before it went to the tyre; undefined: it stands where it was clicked. */
  of(frame: number, contact: ImagePoint): Snapped | undefined {
    const id = this.desk.vehicleId.value;
    const now = this.known.value.find(
      (one) => one.vehicleId === id && one.frame === frame && samePoint(one.to, contact),
    );
    if (now) return { from: now.from, to: now.to };
    const stored = this.desk.entries.value.find(
      ({ values }) => values.frame === frame && samePoint(values.snapped?.to ?? null, contact),
    );
    return stored?.values.snapped;
  }

  /** Whether a pointer rests where the contact was clicked, or where that went: no height is asked for there. */
  isAtContact(pointer: ImagePoint): boolean {
    const contact = this.desk.contact.value;
    if (!contact) return false;
    const view = this.desk.stage.view.value;
    const clicked = this.of(this.desk.seenFrame.value, contact)?.from ?? contact;
    return [contact, clicked].some(
      (at) => screenDistance(view.toScreen(at), view.toScreen(pointer)) <= AT_CONTACT_PX,
    );
  }

  /** A proposal of the contact assistant was taken: the server is told where it was asked for. */
  taken(from: ImagePoint, to: ImagePoint): void {
    const vehicleId = this.desk.vehicleId.value;
    if (vehicleId !== null)
      this.note({ vehicleId, frame: this.desk.seenFrame.value, from, to, expected_px: null });
  }

  /** Asks where a contact click goes; `move` takes the contact there, as long as it still stands where it was clicked. */
  async ask(frame: number, at: ImagePoint, move: (to: ImagePoint) => void): Promise<void> {
    const vehicleId = this.desk.vehicleId.value;
    const { stage } = this.desk;
    const exact = stage.exact;
    stage.exact = false;
    if (vehicleId === null || exact || this.of(frame, at)) return;
    const found = await this.answer({ vehicleId, frame, at });
    const contact =
      this.desk.vehicleId.value === vehicleId ? this.desk.flow.value.contacts.get(frame) : undefined;
    if (!found?.contact || !contact || !samePoint(contact, at) || this.isUsed(frame, at)) return;
    const to = fromServer(found.contact);
    this.note({ vehicleId, frame, from: at, to, expected_px: found.expected_px });
    move(to);
  }

  private note(one: ShownSnap): void {
    const others = this.known.value.filter((other) => other.vehicleId === one.vehicleId);
    this.known.value = [one, ...others];
  }

  private isUsed(frame: number, contact: ImagePoint): boolean {
    return this.desk.entries.value.some(
      ({ values }) => !values.withdrawn && values.frame === frame && samePoint(values.contact, contact),
    );
  }

  private async answer({ vehicleId, frame, at }: Click) {
    try {
      return await api.ask(
        "POST /vehicles/{vehicle_id}/frames/{n}/snap",
        { vehicle_id: vehicleId, n: frame },
        { body: { click: pair(at) }, retry: true },
      );
    } catch {
      // without an answer the click stays where a person put it
      return null;
    }
  }
}
