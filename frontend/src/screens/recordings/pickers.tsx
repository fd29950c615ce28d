import { OptionalField, Segments } from "../../components";
import { linkTo, Said } from "../../components/Said";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import type { Camera, Lighting, Recording } from "../../core/types";
import { LIGHTING_WORDS } from "../../core/words";

export function CameraPick({
  recording,
  cameras,
  pick,
}: {
  recording: Recording;
  cameras: Camera[];
  pick: (id: number | null) => void;
}) {
  if (cameras.length === 0) {
    return (
      <p class="small">
        <Said what="recordings-no-camera" parts={linkTo(`/surveys/${recording.survey_id}/camera`)} />
      </p>
    );
  }
  return (
    <div class="recording__pick">
      <OptionalField
        says="recordings-camera"
        value={recording.camera_id === null ? null : String(recording.camera_id)}
        disabled={!may("operator")}
        none={say("recordings-camera-unsaid")}
        options={cameras.map((camera) => ({
          value: String(camera.id),
          label:
            camera.current_calibration_id === null
              ? say("recordings-camera-uncalibrated", { camera: camera.name })
              : camera.name,
        }))}
        onInput={(value) => pick(value === null ? null : Number(value))}
      />
    </div>
  );
}

export function LightPick({ recording, pick }: { recording: Recording; pick: (lighting: Lighting) => void }) {
  const proposed = recording.lighting === null && recording.lighting_proposed !== null;
  const words = (light: Lighting): string => {
    const lighting = LIGHTING_WORDS[light];
    const guessed = proposed && recording.lighting_proposed === light;
    return guessed ? say("recordings-lighting-guess", { lighting }) : lighting;
  };
  return (
    <div class="stack stack--dense field">
      <span class="field__label">
        {proposed ? <Said what="recordings-lighting-proposed" /> : say("recordings-lighting")}
      </span>
      <Segments<Lighting | "none">
        label={say(proposed ? "recordings-lighting-of-proposed" : "recordings-lighting-of", {
          recording: recording.name,
        })}
        value={recording.lighting ?? "none"}
        disabled={!may("operator")}
        options={(["daytime", "low_light"] as const).map((value) => ({ value, label: words(value) }))}
        onInput={(next) => next !== "none" && pick(next)}
      />
    </div>
  );
}
