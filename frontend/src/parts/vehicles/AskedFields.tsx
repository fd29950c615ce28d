import { Check } from "../../components";
import { say } from "../../core/messages";
import type { Asked, AskedTarget, Lighting } from "../../core/types";
import { ASKABLE, LIGHTING_WORDS, TARGET_WORDS } from "../../core/words";
import "./surveyFields.css";

export const USUALLY_ASKED: Asked = { daytime: ["roof", "driver_eye"], low_light: ["roof", "taillight"] };

export function AskedFields({ value: asked, onInput }: { value: Asked; onInput(asked: Asked): void }) {
  const change = (lighting: Lighting, target: AskedTarget, wanted: boolean): void => {
    const now = asked[lighting];
    const next = ASKABLE.filter((one) => (one === target ? wanted : now.includes(one)));
    onInput({ ...asked, [lighting]: next });
  };
  return (
    <fieldset class="survey-fields" data-testid="asked">
      <legend>{say("asked-title")}</legend>
      <p class="field__hint">{say("asked-help")}</p>
      {(Object.keys(LIGHTING_WORDS) as Lighting[]).map((lighting) => (
        <div class="row row--wrap" key={lighting}>
          <span class="survey-fields__lighting">{LIGHTING_WORDS[lighting]}</span>
          {ASKABLE.map((target) => (
            <Check
              key={target}
              label={TARGET_WORDS[target]}
              checked={asked[lighting].includes(target)}
              onInput={(on) => change(lighting, target, on)}
            />
          ))}
        </div>
      ))}
      {(asked.daytime.length === 0 || asked.low_light.length === 0) && (
        <p class="field__problem">{say("asked-none")}</p>
      )}
    </fieldset>
  );
}
