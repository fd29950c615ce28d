/** What undo puts back on the measure page: clicks as they are wanted, contacts of frames, facts of vehicles. */
import type { Ledger } from "../../core/history";
import type { ImagePoint } from "../../viewer/points";
import type { Values } from "../../viewer/values";
import type { Desk } from "./desk";
import type { Changes } from "./fields";
import type { Entry } from "./records";
import type { Vehicles } from "./vehicles";

/** By the measurement's key; undefined: there is none, or it is withdrawn before it was ever there. */
export type ClickLedger = Ledger<string, Values | undefined>;

/** What is wanted is set at once; the server follows in order, so that undo works without a connection too. */
export function clickLedger(
  desk: Desk,
  rest: (key: string) => Promise<void>,
  turned: (entry: Entry, withdrawn: boolean) => void,
): ClickLedger {
  return {
    read: (key) => desk.records.find(key)?.values,
    write: (key, values) => {
      const entry = desk.records.find(key);
      if (!entry) return;
      const wanted = values ?? { ...entry.values, withdrawn: true };
      desk.records.change(key, wanted, { preview: null });
      void rest(key);
      if (wanted.withdrawn !== entry.values.withdrawn) turned(entry, wanted.withdrawn);
    },
  };
}

/** The contact in use on a frame of the vehicle that is open; that of another one follows from its measurements. */
export function contactLedger(
  desk: Desk,
): Ledger<{ vehicleId: number | null; frame: number }, ImagePoint | null> {
  return {
    nameOf: ({ vehicleId, frame }) => `${vehicleId}:${frame}`,
    read: ({ frame }) => desk.flow.value.contacts.get(frame) ?? null,
    write: ({ vehicleId, frame }, point) => {
      if (vehicleId === desk.vehicleId.value) desk.dispatch({ type: "set-contact", frame, point });
    },
  };
}

export function factLedger(vehicles: Vehicles): Ledger<{ id: number; field: keyof Changes }, unknown> {
  return {
    nameOf: ({ id, field }) => `${id}:${field}`,
    read: ({ id, field }) => vehicles.shown(id)?.[field],
    write: ({ id, field }, value) => vehicles.edit(id, { [field]: value } as Changes),
  };
}
