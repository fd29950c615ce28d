/** How the outbox brings second clicks to the server: made once under their key, withdrawn and brought back after that. */
import { api } from "../core/api";
import { outbox, type Wanted } from "../core/outbox";
import type { Measurement, Target } from "../core/types";
import { heightWords, STATE_WORDS, TARGET_WORDS } from "../core/words";
import { pair } from "./points";
import { type FramePoints, isMeasurement } from "./values";

/** What was clicked again; nothing of the first clicks is in it. */
export interface Repeat extends FramePoints {
  readonly target: Target;
  readonly repeat_of: number;
}

export interface RepeatWanted {
  /** Null for one that the server has: only whether it stands can still change. */
  readonly clicks: Repeat | null;
  readonly withdrawn: boolean;
}

interface About {
  readonly vehicleId: number;
}

export const REPEAT = outbox.register<Measurement, RepeatWanted, About>("repeat", {
  send({ key, about, saved, want: { clicks, withdrawn } }, sending) {
    if (saved) {
      const { id: measurement_id, revision } = saved;
      return withdrawn
        ? api.write("DELETE /measurements/{measurement_id}", { measurement_id, revision }, sending)
        : api.write(
            "POST /measurements/{measurement_id}/restore",
            { measurement_id },
            { body: { revision }, ...sending },
          );
    }
    if (!clicks) return Promise.resolve(null);
    const { target, frame, contact, point, repeat_of } = clicks;
    const clicked = { target, frame, contact: pair(contact), target_point: pair(point), repeat_of };
    return api.write(
      "POST /vehicles/{vehicle_id}/measurements",
      { vehicle_id: about.vehicleId },
      { body: { client_key: key, ...clicked }, ...sending },
    );
  },
  read: async ({ saved }, _error, signal) =>
    saved && api.ask("GET /measurements/{measurement_id}", { measurement_id: saved.id }, { signal }),
  isSaved: isMeasurement,
  done: ({ saved, want }) => (saved ? saved.withdrawn === want.withdrawn : want.withdrawn),
  version: (saved) => (saved ? `${saved.id} ${saved.revision}` : 0),
  words: heightWords,
});

/** The second click of a target, as it is to be: brought in its lane, behind what was wished before it there. */
export function repeatWish(
  key: string,
  lane: string,
  about: About,
  saved: Measurement | null,
  want: RepeatWanted,
): Wanted<Measurement, RepeatWanted, About> {
  const target = want.clicks?.target ?? saved?.target ?? "other";
  return {
    key,
    kind: REPEAT,
    lane,
    about,
    what: TARGET_WORDS[target],
    mine: want.withdrawn ? STATE_WORDS.withdrawn : TARGET_WORDS[target],
    page: location.pathname + location.search,
    saved,
    want,
  };
}
