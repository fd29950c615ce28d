import { useState } from "preact/hooks";
import { Button, choices, Segments, SelectField, TextField } from "../../components";
import { linkTo, Said } from "../../components/Said";
import { useForm } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { BoardIn, CalibrationWish } from "../../core/types";
import { parseNumber } from "../../core/units";

export type Recipe = Omit<CalibrationWish, keyof BoardIn>;

/** Where the boards are: in single pictures, or in the frames of a recording. */
export type Source = "images" | "clip";

interface Props {
  surveyId: number;
  source: Source;
  usable: number;
  ready: boolean;
  busy: boolean;
  calibrate: (recipe: Recipe) => void;
}

/** Which frames of a recording if it is one, which lens model; then the button. */
export function CalibrateForm({ surveyId, source, usable, ready, busy, calibrate }: Props) {
  const form = useForm({
    model: "brown" as NonNullable<Recipe["model"]>,
    shape: "flat" as "flat" | "bent",
    every: "10",
    first: "",
    last: "",
  });
  const { model, shape, every, first, last } = form.values;
  const [recordingId, setRecordingId] = useState("");
  const recordings = useAsked("GET /surveys/{survey_id}/recordings", { survey_id: surveyId });
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
              says="field-recording"
              value={String(clip.id)}
              options={usableClips.map((recording) => ({
                value: String(recording.id),
                label: say("camera-recording-frames", {
                  recording: recording.name,
                  count: recording.frame_count ?? 0,
                }),
              }))}
              onInput={setRecordingId}
            />
            <TextField says="camera-every" numeric {...form.field("every")} />
            <TextField says="camera-first-frame" numeric {...form.field("first")} placeholder="0" />
            <TextField
              says="camera-last-frame"
              numeric
              {...form.field("last")}
              placeholder={String((clip.frame_count ?? 1) - 1)}
            />
            {wrong && <p class="field__problem across">{wrong}</p>}
          </div>
        ) : (
          <p class="muted">
            <Said what="camera-no-recording" parts={linkTo(`/surveys/${surveyId}/recordings`)} />
          </p>
        ))}
      <div class="row row--wrap row--far">
        <Segments
          says="camera-lens"
          {...form.field("model")}
          options={choices(wordsOf("camera-lens-", "brown", "fisheye"))}
        />
        <span class="muted small grow">{say(`camera-lens-${model}-hint`)}</span>
      </div>
      <div class="row row--wrap row--far">
        <Segments
          says="camera-board"
          {...form.field("shape")}
          options={choices(wordsOf("camera-board-", "flat", "bent"))}
        />
        <span class="muted small grow">{say(`camera-board-${shape}-hint`)}</span>
        <Button says="camera-calibrate" kind="primary" busy={busy} disabled={!possible} onClick={go} />
      </div>
      {source === "images" && usable < 3 && <p class="muted small">{say("camera-three-images")}</p>}
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
  if (!whole(step) || step < 1) return say("camera-every-problem");
  if (!whole(from) || !whole(to)) return say("camera-frames-problem");
  if (to < from) return say("camera-frames-order");
  if (to >= frames) return say("camera-frames-end", { last_frame: String(frames - 1) });
  return { every: step, first_frame: from, last_frame: to };
}
