import { Segments, SelectField } from "../../components";
import { may } from "../../core/session";
import type { Camera, Lighting, Recording } from "../../core/types";

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
        No camera yet: <a href={`/surveys/${recording.survey_id}/camera`}>calibrate one</a>.
      </p>
    );
  }
  return (
    <div class="recording__pick">
      <SelectField
        label="Camera"
        value={String(recording.camera_id ?? "")}
        disabled={!may("operator")}
        options={[
          { value: "", label: "not said yet" },
          ...cameras.map((camera) => ({
            value: String(camera.id),
            label: camera.current_calibration_id === null ? `${camera.name} (not calibrated)` : camera.name,
          })),
        ]}
        onChange={(value) => pick(value === "" ? null : Number(value))}
      />
    </div>
  );
}

export function LightPick({ recording, pick }: { recording: Recording; pick: (lighting: Lighting) => void }) {
  const proposed = recording.lighting === null && recording.lighting_proposed !== null;
  const value = recording.lighting ?? recording.lighting_proposed;
  return (
    <div class="field">
      <span class="field__label">Lighting{proposed && <span class="muted"> (proposed)</span>}</span>
      <Segments<Lighting | "none">
        label={`Lighting of ${recording.name}${proposed ? ", proposed by the machine" : ""}`}
        value={recording.lighting ?? "none"}
        disabled={!may("operator")}
        options={[
          { value: "daytime", label: value === "daytime" && proposed ? "Daytime ?" : "Daytime" },
          { value: "low_light", label: value === "low_light" && proposed ? "Low light ?" : "Low light" },
        ]}
        onChange={(next) => next !== "none" && pick(next)}
      />
    </div>
  );
}
