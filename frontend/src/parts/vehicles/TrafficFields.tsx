/** How traffic goes at a site and where the camera stands: from it follows on which side a driver sits. */
import { choices, OptionalField } from "../../components";
import { fieldsOf } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import type { Traffic } from "../../core/types";
import "./surveyFields.css";

const HANDS = wordsOf("traffic-", "right", "left");
const WHEELS = wordsOf("wheel-");
const PLACES = wordsOf("camera-", "verge", "median");

export function TrafficFields({ value, onInput }: { value: Traffic; onInput(traffic: Traffic): void }) {
  const field = fieldsOf(value, (part) => onInput({ ...value, ...part }));
  const none = say("traffic-not-said");
  return (
    <fieldset class="survey-fields" data-testid="traffic">
      <legend>{say("traffic-title")}</legend>
      <p class="field__hint">{say("traffic-help")}</p>
      <div class="row row--wrap">
        <OptionalField says="traffic-side" {...field("traffic_side")} none={none} options={choices(HANDS)} />
        <OptionalField
          says="traffic-steering"
          {...field("steering_side")}
          none={none}
          options={choices(WHEELS)}
        />
        <OptionalField
          says="traffic-camera"
          {...field("camera_place")}
          none={none}
          options={choices(PLACES)}
        />
      </div>
    </fieldset>
  );
}
