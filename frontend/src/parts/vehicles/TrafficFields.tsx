/** How traffic goes at a site and where the camera stands: from it follows on which side a driver sits. */
import { SelectField } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { Traffic } from "../../core/types";
import "./surveyFields.css";

const HANDS = wordsOf("traffic-", "right", "left");
const WHEELS = wordsOf("wheel-");
const PLACES = wordsOf("camera-", "verge", "median");

interface Props {
  traffic: Traffic;
  onChange(traffic: Traffic): void;
}

export function TrafficFields({ traffic, onChange }: Props) {
  return (
    <fieldset class="survey-fields" data-testid="traffic">
      <legend>{say("traffic-title")}</legend>
      <p class="field__hint">{say("traffic-help")}</p>
      <div class="row row--wrap">
        <SelectField
          label={say("traffic-side")}
          value={traffic.traffic_side ?? ""}
          options={optional(HANDS)}
          onChange={(side) => onChange({ ...traffic, traffic_side: side || null })}
        />
        <SelectField
          label={say("traffic-steering")}
          value={traffic.steering_side ?? ""}
          options={optional(WHEELS)}
          onChange={(side) => onChange({ ...traffic, steering_side: side || null })}
        />
        <SelectField
          label={say("traffic-camera")}
          value={traffic.camera_place ?? ""}
          options={optional(PLACES)}
          onChange={(place) => onChange({ ...traffic, camera_place: place || null })}
        />
      </div>
    </fieldset>
  );
}

function optional<W extends string>(words: Readonly<Record<W, string>>): { value: W | ""; label: string }[] {
  const named = (Object.keys(words) as W[]).map((value) => ({ value, label: words[value] }));
  return [{ value: "", label: say("traffic-not-said") }, ...named];
}
