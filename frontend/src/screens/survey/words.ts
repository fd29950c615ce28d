/** What was said of a survey, as it is read: on its overview and among its settings. */
import { allOf, say } from "../../core/messages";
import type { Place, Survey, Target } from "../../core/types";
import { fixed, formatSpeed } from "../../core/units";
import { TARGET_NOUNS } from "../../core/words";

export function placeWords(place: Place): string {
  const { latitude_deg, longitude_deg, road_class, lane, travel_direction } = place;
  const { speed_limit_mps, street_lamps, time_zone } = place;
  const words = [
    latitude_deg !== null &&
      longitude_deg !== null &&
      `${fixed(latitude_deg, 5)}, ${fixed(longitude_deg, 5)}`,
    road_class,
    lane,
    travel_direction,
    speed_limit_mps !== null && say("place-limit-is", { limit: formatSpeed(speed_limit_mps, null, 0) }),
    street_lamps && say("place-lamps-are", { lamps: street_lamps }),
    time_zone,
  ];
  return words.filter(Boolean).join("  ·  ");
}

/** How traffic goes there; empty while that is not all said. */
export function trafficWords({ traffic_side, steering_side, camera_place }: Survey["traffic"]): string {
  if (!traffic_side || !steering_side || !camera_place) return "";
  return say("survey-traffic", { traffic: traffic_side, steering: steering_side, camera: camera_place });
}

export function askedWords(asked: Survey["asked"]): string {
  const named = (targets: readonly Target[]) => allOf(targets.map((target) => TARGET_NOUNS[target]));
  return say("survey-asked", { daytime: named(asked.daytime), low_light: named(asked.low_light) });
}
