/** How the outbox brings passes to the server: made, taken out and brought back, split and joined. */
import { api } from "../../../core/api";
import { say } from "../../../core/messages";
import { outbox } from "../../../core/outbox";
import { shapeOf } from "../../../core/shape";
import type { Vehicle } from "../../../core/types";
import { STATE_WORDS } from "../../../core/words";
import { isVehicle } from "../../../viewer/vehicle";

export interface AddedWant {
  readonly first_frame: number;
  readonly last_frame: number;
}

export const PASS_ADDED = outbox.register<Vehicle, AddedWant, { recordingId: number }>("pass-added", {
  once: true,
  send: ({ about: { recordingId: recording_id }, want: { first_frame, last_frame } }, sending) =>
    api.write(
      "POST /recordings/{recording_id}/vehicles",
      { recording_id },
      { body: { first_frame, last_frame }, ...sending },
    ),
  read: async () => null,
  isSaved: isVehicle,
  version: (saved) => saved?.version ?? 0,
  words: (saved) => (saved ? passWords(saved) : say("measure-deleted")),
});

export interface Presence {
  readonly there: boolean;
  /** The version that was seen; null where changes of one's own go out before. */
  readonly version: number | null;
  readonly vehicle: Vehicle | null;
}

const isPresence = shapeOf<Presence>({ there: "boolean", vehicle: "nullable" });

export const PASS_THERE = outbox.register<Presence, boolean, { id: number }>("pass-there", {
  async send({ about: { id: vehicle_id }, saved, want }, sending) {
    if (want) {
      const vehicle = await api.write("POST /vehicles/{vehicle_id}/restore", { vehicle_id }, sending);
      return { there: true, version: vehicle.version, vehicle };
    }
    const version = saved?.version ?? null;
    await api.write("DELETE /vehicles/{vehicle_id}", { vehicle_id, version }, sending);
    return { there: false, version: null, vehicle: saved?.vehicle ?? null };
  },
  async read({ about: { id } }, _error, signal) {
    const vehicle = await api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id }, { signal });
    return { there: true, version: vehicle.version, vehicle };
  },
  isSaved: (answer): answer is Presence =>
    isPresence(answer) && (answer.vehicle === null || isVehicle(answer.vehicle)),
  done: ({ saved, want }) => saved?.there === want,
  version: (saved) => (saved ? `${saved.there} ${saved.version}` : ""),
  words: (saved) => (saved?.there && saved.vehicle ? passWords(saved.vehicle) : STATE_WORDS.withdrawn),
});

export interface Parts {
  readonly earlier: Vehicle;
  readonly later: Vehicle | null;
}

const isParts = shapeOf<Parts>({ earlier: "object", later: "nullable" });

export const PASS_SPLIT = outbox.register<Parts, number, SplitAbout>("pass-split", {
  once: true,
  async send({ about: { id, version }, want: frame }, sending) {
    const body = { frame, version: await versionOf(id, version, sending.signal) };
    return api.write("POST /vehicles/{vehicle_id}/split", { vehicle_id: id }, { body, ...sending });
  },
  read: async ({ about: { id } }, _error, signal) => ({
    earlier: await api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id }, { signal }),
    later: null,
  }),
  isSaved: (answer): answer is Parts =>
    isParts(answer) && isVehicle(answer.earlier) && (answer.later === null || isVehicle(answer.later)),
  version: (saved) => saved?.earlier.version ?? 0,
  words: (saved) => (saved ? passWords(saved.earlier) : ""),
});

export interface SplitAbout {
  readonly id: number;
  /** The version that was seen; null where changes of one's own go out before and make another. */
  readonly version: number | null;
}

export interface JoinAbout extends SplitAbout {
  readonly other_id: number;
  readonly other_version: number | null;
}

async function versionOf(id: number, seen: number | null, signal: AbortSignal): Promise<number> {
  return seen ?? (await api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id }, { signal })).version;
}

export const PASS_JOINED = outbox.register<Vehicle, readonly [number, number], JoinAbout>("pass-joined", {
  once: true,
  async send({ about: { id, other_id, version, other_version } }, sending) {
    const body = {
      other_id,
      version: await versionOf(id, version, sending.signal),
      other_version: await versionOf(other_id, other_version, sending.signal),
    };
    return api.write("POST /vehicles/{vehicle_id}/join", { vehicle_id: id }, { body, ...sending });
  },
  read: ({ about: { id } }, _error, signal) =>
    api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id }, { signal }),
  isSaved: isVehicle,
  version: (saved) => saved?.version ?? 0,
  words: (saved) => (saved ? passWords(saved) : say("measure-deleted")),
});

function passWords({ number, first_frame, last_frame }: Vehicle): string {
  return say("measure-pass-title", {
    vehicle: String(number),
    first_frame: String(first_frame),
    last_frame: String(last_frame),
  });
}
