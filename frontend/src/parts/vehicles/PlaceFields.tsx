/** Where a survey's site lies, what road it is, and whose clocks are told there. */
import { choices, OptionalField, TextField } from "../../components";
import { fieldsOf } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { TIME_ZONES } from "../../core/times";
import type { Place } from "../../core/types";
import { parseNumber, speedScale } from "../../core/units";
import "./surveyFields.css";

const LAMPS = wordsOf("place-lamps-", "present", "none");

export type TypedPlace = ReturnType<typeof typedPlace>;

export const NO_PLACE: TypedPlace = {
  latitude: "",
  longitude: "",
  road: "",
  lane: "",
  travel: "",
  limit: "",
  lamps: null,
  zone: "",
};

export function typedPlace(place: Place) {
  const limit = place.speed_limit_mps;
  return {
    latitude: place.latitude_deg === null ? "" : String(place.latitude_deg),
    longitude: place.longitude_deg === null ? "" : String(place.longitude_deg),
    road: place.road_class ?? "",
    lane: place.lane ?? "",
    travel: place.travel_direction ?? "",
    limit: limit === null ? "" : String(Number((limit * speedScale()[0]).toFixed(1))),
    lamps: place.street_lamps,
    zone: place.time_zone ?? "",
  };
}

/** What was typed, or the sentence on what is no number. */
export function readPlace(typed: TypedPlace, before: Place | null): Place | string {
  const latitude_deg = optional(typed.latitude);
  const longitude_deg = optional(typed.longitude);
  const limit = optional(typed.limit);
  if (latitude_deg === undefined || longitude_deg === undefined) return say("place-coordinates-problem");
  if (limit === undefined) return say("place-limit-problem", { unit: speedScale()[1] });
  // one that was left as it stood is not rounded by having been shown
  const kept = before !== null && typed.limit === typedPlace(before).limit;
  return {
    latitude_deg,
    longitude_deg,
    road_class: typed.road.trim() || null,
    lane: typed.lane.trim() || null,
    travel_direction: typed.travel.trim() || null,
    speed_limit_mps: kept ? before.speed_limit_mps : limit === null ? null : limit / speedScale()[0],
    street_lamps: typed.lamps,
    time_zone: typed.zone.trim() || null,
  };
}

/** Null for an empty field, undefined for what is no number. */
function optional(text: string): number | null | undefined {
  return text.trim() === "" ? null : (parseNumber(text) ?? undefined);
}

export function PlaceFields({ value, onInput }: { value: TypedPlace; onInput(place: TypedPlace): void }) {
  const field = fieldsOf(value, (part) => onInput({ ...value, ...part }));
  return (
    <fieldset class="survey-fields stack" data-testid="place">
      <legend>{say("place-title")}</legend>
      <div class="row row--wrap">
        <TextField says="place-latitude" numeric {...field("latitude")} placeholder="49.44315" />
        <TextField says="place-longitude" numeric {...field("longitude")} placeholder="1.09932" />
      </div>
      <div class="row row--wrap">
        <TextField says="place-road" {...field("road")} suggestions={say("place-roads").split("; ")} />
        <TextField says="place-limit" unit={speedScale()[1]} {...field("limit")} />
        <OptionalField
          says="place-lamps"
          {...field("lamps")}
          none={say("place-not-said")}
          options={choices(LAMPS)}
        />
      </div>
      <div class="row row--wrap">
        <TextField says="place-lane" {...field("lane")} suggestions={say("place-lanes").split("; ")} />
        <TextField says="place-travel" {...field("travel")} placeholder={say("place-travel-example")} />
      </div>
      <TextField
        says="place-zone"
        hint={say("place-zone-hint")}
        {...field("zone")}
        suggestions={TIME_ZONES}
      />
    </fieldset>
  );
}
