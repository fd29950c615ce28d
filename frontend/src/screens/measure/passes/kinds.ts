/** How the outbox brings passes to the server: made, taken out and brought back, split and joined. */
import { api } from "../../../core/api";
import { say } from "../../../core/messages";
import { type Kind, outbox } from "../../../core/outbox";
import { shapeOf } from "../../../core/shape";
import type { Vehicle } from "../../../core/types";
import { STATE_WORDS } from "../../../core/words";
import { isVehicle } from "../../../viewer/vehicle";

export const PASS_ADDED = "pass-added";
export const PASS_THERE = "pass-there";
export const PASS_SPLIT = "pass-split";
export const PASS_JOINED = "pass-joined";

export interface AddedWant {
  readonly first_frame: number;
  readonly last_frame: number;
  /** The passes of the recording when it was marked: a repeat whose answer was lost is not among them. */
  readonly known: readonly number[];
}

/** One that is the same and was not there before is this one: a repeat makes no second. */
const addedKind: Kind<Vehicle, AddedWant, { recordingId: number; surveyId: number }> = {
  once: true,
  async send({ about: { recordingId, surveyId }, want: { first_frame, last_frame, known } }, signal) {
    const there = await api.ask(
      "GET /surveys/{survey_id}/vehicles",
      { survey_id: surveyId, recording_id: recordingId },
      { signal },
    );
    const same = (one: Vehicle) => one.first_frame === first_frame && one.last_frame === last_frame;
    return (
      there.find((one) => same(one) && !known.includes(one.id)) ??
      api.write(
        "POST /recordings/{recording_id}/vehicles",
        { recording_id: recordingId },
        { body: { first_frame, last_frame }, signal },
      )
    );
  },
  read: async () => null,
  isSaved: isVehicle,
  done: ({ saved }) => saved !== null,
  version: (saved) => saved?.version ?? 0,
  words: (saved) => (saved ? passWords(saved) : say("measure-deleted")),
};

export interface Presence {
  readonly there: boolean;
  /** The version that was seen; null where changes of one's own go out before. */
  readonly version: number | null;
  readonly vehicle: Vehicle | null;
}

const isPresence = shapeOf<Presence>({ there: "boolean", vehicle: "nullable" });

const thereKind: Kind<Presence, boolean, { id: number }> = {
  async send({ about: { id: vehicle_id }, saved, want }, signal) {
    if (want) {
      const vehicle = await api.write(
        "POST /vehicles/{vehicle_id}/restore",
        { vehicle_id },
        { retry: true, signal },
      );
      return { there: true, version: vehicle.version, vehicle };
    }
    const version = saved?.version ?? null;
    await api.write("DELETE /vehicles/{vehicle_id}", { vehicle_id, version }, { signal });
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
};

export interface Parts {
  readonly earlier: Vehicle;
  readonly later: Vehicle | null;
}

const isParts = shapeOf<Parts>({ earlier: "object", later: "nullable" });

const splitKind: Kind<Parts, number, SplitAbout> = {
  once: true,
  async send({ about: { id, version }, want: frame }, signal) {
    const body = { frame, version: await versionOf(id, version, signal) };
    return api.write("POST /vehicles/{vehicle_id}/split", { vehicle_id: id }, { body, signal });
  },
  read: async ({ about: { id } }, _error, signal) => ({
    earlier: await api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id }, { signal }),
    later: null,
  }),
  isSaved: (answer): answer is Parts =>
    isParts(answer) && isVehicle(answer.earlier) && (answer.later === null || isVehicle(answer.later)),
  // the echo of a split whose answer was lost: the vehicle ends or begins at the cut
  done: ({ saved, want }) => saved !== null && (saved.later !== null || endsAt(saved.earlier, want)),
  version: (saved) => saved?.earlier.version ?? 0,
  words: (saved) => (saved ? passWords(saved.earlier) : ""),
};

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

const joinedKind: Kind<Vehicle, readonly [number, number], JoinAbout> = {
  once: true,
  async send({ about: { id, other_id, version, other_version } }, signal) {
    const body = {
      other_id,
      version: await versionOf(id, version, signal),
      other_version: await versionOf(other_id, other_version, signal),
    };
    return api.write("POST /vehicles/{vehicle_id}/join", { vehicle_id: id }, { body, signal });
  },
  read: ({ about: { id } }, _error, signal) =>
    api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id }, { signal }),
  isSaved: isVehicle,
  done: ({ saved, want: [first, last] }) => saved?.first_frame === first && saved.last_frame === last,
  version: (saved) => saved?.version ?? 0,
  words: (saved) => (saved ? passWords(saved) : say("measure-deleted")),
};

function endsAt({ first_frame, last_frame }: Vehicle, frame: number): boolean {
  return last_frame === frame - 1 || first_frame === frame;
}

function passWords({ number, first_frame, last_frame }: Vehicle): string {
  return say("measure-pass-title", {
    vehicle: String(number),
    first_frame: String(first_frame),
    last_frame: String(last_frame),
  });
}

outbox.register(PASS_ADDED, addedKind);
outbox.register(PASS_THERE, thereKind);
outbox.register(PASS_SPLIT, splitKind);
outbox.register(PASS_JOINED, joinedKind);
