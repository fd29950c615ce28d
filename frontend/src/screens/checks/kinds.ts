/** How the outbox brings both tyres of a vehicle to the server. */
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { shapeOf } from "../../core/shape";
import type { WheelPair } from "../../core/types";
import { fixed } from "../../core/units";
import type { Clicks } from "./wheelPair";

export interface PairAbout {
  readonly id: number;
  readonly surveyId: number;
}

export const WHEEL_PAIR = outbox.register<WheelPair, Clicks | null, PairAbout>("wheel-pair", {
  once: true,
  send({ about: { id: vehicle_id }, saved, want }, sending) {
    const seen = idOf(saved);
    if (!want) return api.write("DELETE /vehicles/{vehicle_id}/wheel-pair", { vehicle_id, seen }, sending);
    const body = { ...want, seen };
    return api.write("POST /vehicles/{vehicle_id}/wheel-pair", { vehicle_id }, { body, ...sending });
  },
  async read({ about: { id, surveyId } }, _error, signal) {
    const found = await api.ask(
      "GET /surveys/{survey_id}/checks/traffic",
      { survey_id: surveyId },
      { signal },
    );
    return found.pairs.find((one) => one.vehicle_id === id) ?? null;
  },
  isSaved: shapeOf<WheelPair>({
    id: "number",
    vehicle_id: "number",
    frame: "number",
    first: "list",
    second: "list",
    withdrawn: "boolean",
  }),
  done({ saved, want }) {
    if (!want || !saved || saved.withdrawn) return !want && idOf(saved) === 0;
    return saved.frame === want.frame && `${saved.first} ${saved.second}` === `${want.first} ${want.second}`;
  },
  version: idOf,
  words: (saved) => (saved && !saved.withdrawn ? pairWords(saved) : say("checks-tyres-none")),
});

function idOf(saved: WheelPair | null): number {
  return saved && !saved.withdrawn ? saved.id : 0;
}

export function pairWords({ frame, first, second }: Clicks): string {
  const at = (point: readonly number[]): string => point.map((one) => fixed(one, 1)).join(", ");
  return say("checks-tyres-at", { frame: String(frame), first: at(first), second: at(second) });
}
