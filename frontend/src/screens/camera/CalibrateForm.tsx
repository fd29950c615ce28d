import { useState } from "preact/hooks";
import { Button, Segments, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import { useResource } from "../../core/resource";
import { parseNumber, plural } from "../../core/units";

export interface Recipe {
  model: "brown" | "fisheye";
  bent_board: boolean;
  recording_id?: number;
  every?: number;
  first_frame?: number;
  last_frame?: number;
}

/** Where the boards are: in single pictures, or in the frames of a recording. */
export type Source = "images" | "clip";

interface Props {
  surveyId: number;
  source: Source;
  /** images in which the board was found */
  usable: number;
  /** the board is told and no image is on its way */
  ready: boolean;
  busy: boolean;
  calibrate: (recipe: Recipe) => void;
}

/** Which frames of a recording if it is one, which lens model; then the button. */
export function CalibrateForm({ surveyId, source, usable, ready, busy, calibrate }: Props) {
  const [model, setModel] = useState<Recipe["model"]>("brown");
  const [shape, setShape] = useState<"flat" | "bent">("flat");
  const [recordingId, setRecordingId] = useState("");
  const [every, setEvery] = useState("10");
  const [first, setFirst] = useState("");
  const [last, setLast] = useState("");
  const recordings = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/recordings", { survey_id: surveyId }, { signal }),
    [surveyId],
  );
  const usableClips = (recordings.data ?? []).filter((recording) => recording.state === "ready");
  const clip = usableClips.find((recording) => String(recording.id) === recordingId) ?? usableClips[0];
  const span = readSpan(first, last, every, clip?.frame_count ?? 0);
  const wrong = source === "clip" && typeof span === "string" ? span : null;
  const possible = ready && (source === "images" ? usable >= 3 : clip !== undefined && wrong === null);
  const go = () => {
    const how = { model, bent_board: shape === "bent" };
    if (source === "images") calibrate(how);
    else if (clip && typeof span !== "string") calibrate({ ...how, recording_id: clip.id, ...span });
  };
  return (
    <div class="stack calibrate">
      {source === "clip" &&
        (clip ? (
          <div class="calibrate__clip">
            <SelectField
              label="Recording"
              value={String(clip.id)}
              options={usableClips.map((recording) => ({
                value: String(recording.id),
                label: `${recording.name} (${plural(recording.frame_count ?? 0, "frame")})`,
              }))}
              onChange={setRecordingId}
            />
            <TextField label="Every n-th frame" numeric value={every} onInput={setEvery} />
            <TextField label="First frame" numeric value={first} onInput={setFirst} placeholder="0" />
            <TextField
              label="Last frame"
              numeric
              value={last}
              onInput={setLast}
              placeholder={String((clip.frame_count ?? 1) - 1)}
            />
            {wrong && <p class="field__problem">{wrong}</p>}
          </div>
        ) : (
          <p class="muted">
            No recording is ready; <a href={`/surveys/${surveyId}/recordings`}>bring in the clip</a> in which
            the board is moved about.
          </p>
        ))}
      <div class="row row--wrap calibrate__choices">
        <Segments
          label="Lens"
          value={model}
          onChange={setModel}
          options={[
            { value: "brown", label: "Ordinary lens" },
            { value: "fisheye", label: "Fisheye" },
          ]}
        />
        <span class="muted small grow">
          {model === "brown"
            ? "Pinhole with Brown distortion: up to about 100° of view."
            : "Equidistant with four terms: for lenses that see more than about 100°."}
        </span>
      </div>
      <div class="row row--wrap calibrate__choices">
        <Segments
          label="Board"
          value={shape}
          onChange={setShape}
          options={[
            { value: "flat", label: "Flat board" },
            { value: "bent", label: "May be bent" },
          ]}
        />
        <span class="muted small grow">
          {shape === "flat"
            ? "On a stiff plate. The result says how flat it was."
            : "Paper on a wall or thin sheet: its shape is solved for too. Needs six views, better 15."}
        </span>
        <Button kind="primary" busy={busy} disabled={!possible} onClick={go}>
          Calibrate
        </Button>
      </div>
      {source === "images" && usable < 3 && (
        <p class="muted small">Three images with the board are the least; the button wakes up then.</p>
      )}
    </div>
  );
}

/** The frames to look at, or what is wrong with them. */
export function readSpan(first: string, last: string, every: string, frames: number) {
  const number = (text: string, empty: number) => (text.trim() === "" ? empty : parseNumber(text));
  const step = number(every, 10);
  const from = number(first, 0);
  const to = number(last, frames - 1);
  const whole = (value: number | null): value is number =>
    value !== null && Number.isInteger(value) && value >= 0;
  if (!whole(step) || step < 1) return "Take every n-th frame, with n a whole number from 1.";
  if (!whole(from) || !whole(to)) return "Give the first and last frame as whole numbers.";
  if (to < from) return "The last frame lies before the first.";
  if (to >= frames) return `The recording ends with frame ${frames - 1}.`;
  return { every: step, first_frame: from, last_frame: to };
}
