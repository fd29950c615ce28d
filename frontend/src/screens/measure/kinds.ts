/** How the outbox brings clicks and facts of vehicles to the server: addresses, bodies, and when two of them are the same. */
import { type ApiError, api } from "../../core/api";
import { allOf, say } from "../../core/messages";
import { type Kind, outbox, type Sending } from "../../core/outbox";
import type {
  Category,
  Direction,
  Discarded,
  DriverSide,
  Lighting,
  Measurement,
  ModelChosenBy,
  NotVisible,
  Vehicle,
} from "../../core/types";
import { formatLength } from "../../core/units";
import {
  CATEGORY_WORDS,
  DIRECTION_WORDS,
  DISCARDED_WORDS,
  heightWords,
  LIGHTING_NOUNS,
  NOT_VISIBLE_WORDS,
  SIDE_WORDS,
} from "../../core/words";
import {
  clickBody,
  isMeasurement,
  madeOf,
  sameValues,
  snappedFrom,
  type Values,
  valuesOf,
} from "../../viewer/values";
import { isVehicle } from "../../viewer/vehicle";
import { type Changes, disputedFields, FIELD_WORDS, type Field } from "./fields";
import { CHOSEN_BY_WORDS, sizesWords } from "./sizes";

export const MEASUREMENT = "measurement";
export const VEHICLE = "vehicle";

export interface MeasurementAbout {
  readonly vehicleId: number;
}

/** The server's side, so that the kinds can be tested without one. */
const recordsPort = {
  create: (vehicle_id: number, client_key: string, values: Values, sending: Sending) =>
    api.write(
      "POST /vehicles/{vehicle_id}/measurements",
      { vehicle_id },
      {
        body: { client_key, made: madeOf(values), ...snappedFrom(values), ...clickBody(values) },
        ...sending,
      },
    ),
  revise: (measurement_id: number, revision: number, values: Values, sending: Sending) =>
    api.write(
      "PUT /measurements/{measurement_id}",
      { measurement_id },
      { body: { revision, ...snappedFrom(values), ...clickBody(values) }, ...sending },
    ),
  withdraw: (measurement_id: number, revision: number, sending: Sending) =>
    api.write("DELETE /measurements/{measurement_id}", { measurement_id, revision }, sending),
  restore: (measurement_id: number, revision: number, sending: Sending) =>
    api.write(
      "POST /measurements/{measurement_id}/restore",
      { measurement_id },
      { body: { revision }, ...sending },
    ),
  read: (measurement_id: number, signal: AbortSignal) =>
    api.ask("GET /measurements/{measurement_id}", { measurement_id }, { signal }),
};

const vehiclesPort = {
  /** Fields left out stay as they are. */
  save: (vehicle_id: number, version: number, changes: Changes, sending: Sending) =>
    api.write("PUT /vehicles/{vehicle_id}", { vehicle_id }, { body: { version, ...changes }, ...sending }),
};

export type RecordsPort = typeof recordsPort;

export const measurementKind = (port: RecordsPort): Kind<Measurement, Values, MeasurementAbout> => ({
  send({ key, about, saved, want }, sending) {
    if (!saved) return port.create(about.vehicleId, key, want, sending);
    if (want.withdrawn) return port.withdraw(saved.id, saved.revision, sending);
    if (saved.withdrawn) return port.restore(saved.id, saved.revision, sending);
    return port.revise(saved.id, saved.revision, want, sending);
  },
  // a new one is refused where the target stands measured: the refusal brings what stands
  read: async ({ saved }, error, signal) =>
    saved ? port.read(saved.id, signal) : (currentOf<Measurement>(error) ?? null),
  isSaved: isMeasurement,
  // what was withdrawn before it was ever stored is nothing to store
  done: ({ saved, want }) => (saved ? sameValues(valuesOf(saved), want) : want.withdrawn),
  version: (saved) => (saved ? `${saved.id} ${saved.revision}` : 0),
  words: heightWords,
});

export const vehicleKind = (port: typeof vehiclesPort): Kind<Vehicle, Changes, { id: number }> => ({
  send: ({ about, saved, want }, sending) => port.save(about.id, saved?.version ?? 0, want, sending),
  async read(_wish, error) {
    const found = currentOf<Vehicle>(error);
    if (!found) throw error;
    return found;
  },
  isSaved: isVehicle,
  done: ({ saved, want }) =>
    saved !== null && (Object.keys(want) as Field[]).every((field) => saved[field] === want[field]),
  version: (saved) => saved?.version ?? 0,
  words: (saved) => (saved ? factWords(saved) : say("measure-deleted")),
  fits: ({ saved, want }, theirs) => saved !== null && disputedFields(saved, want, theirs).length === 0,
  left: (sent, want) =>
    Object.fromEntries(Object.entries(want).filter(([field, value]) => sent[field as Field] !== value)),
});

/** "make Peugeot and year 2019", with lengths in the chosen unit. */
export function factWords(changes: Changes): string {
  const told = (Object.keys(FIELD_WORDS) as Field[]).filter((field) => field in changes);
  return allOf(told.map((field) => say("measure-fact", { field, value: showFact(field, changes[field]) })));
}

export function showFact(field: Field, value: unknown): string {
  if (value === null || value === undefined || value === "") return say("measure-fact-empty");
  if (field === "category") return CATEGORY_WORDS[value as Category];
  if (field === "model_chosen_by") return CHOSEN_BY_WORDS[value as ModelChosenBy];
  if (field === "model_sizes") return sizesWords(String(value));
  if (field === "lighting") return LIGHTING_NOUNS[value as Lighting];
  if (field === "direction") return DIRECTION_WORDS[value as Direction];
  if (field === "driver_side") return SIDE_WORDS[value as DriverSide];
  if (field === "discarded") return DISCARDED_WORDS[value as Discarded];
  if (field === "check_target") return say(value ? "measure-check-target-yes" : "measure-check-target-no");
  if (field.endsWith("_not_visible")) return NOT_VISIBLE_WORDS[value as NotVisible];
  return field.endsWith("_m") ? formatLength(Number(value)) : String(value);
}

function currentOf<T>(error: ApiError): T | undefined {
  return (error.body as { current?: T } | null)?.current;
}

outbox.register(MEASUREMENT, measurementKind(recordsPort));
outbox.register(VEHICLE, vehicleKind(vehiclesPort));
