import { useState } from "preact/hooks";
import { FormDialog, Loading, Notice, named, Problem, SelectField } from "../../components";
import { api } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { AddProps } from "./AddCamera";

/** A camera of another survey, with its calibration, for this one too. */
export function TakeCamera({ surveyId, close, added }: Omit<AddProps, "count">) {
  const surveys = useAsked("GET /surveys");
  const others = (surveys.data ?? []).filter((one) => one.id !== surveyId);
  const [from, setFrom] = useState<number | null>(null);
  const there = from ?? others[0]?.id ?? null;
  const cameras = useAsked(there === null ? null : "GET /surveys/{survey_id}/cameras", {
    survey_id: there ?? 0,
  });
  const calibrated = (cameras.data ?? []).filter((one) => one.current_calibration_id !== null);
  const [picked, setPicked] = useState<number | null>(null);
  const camera = calibrated.find((one) => one.id === picked) ?? calibrated[0] ?? null;
  const now = camera?.calibrations.find((one) => one.id === camera.current_calibration_id);
  const send = async () => {
    if (camera) {
      const place = { survey_id: surveyId, camera_id: camera.id };
      await added(await api.write("POST /surveys/{survey_id}/cameras/from/{camera_id}", place, {}));
    }
  };
  return (
    <FormDialog
      says="camera-take-title"
      action={say("camera-take")}
      onClose={close}
      submit={send}
      disabled={camera === null}
    >
      <p class="muted">{say("camera-take-lead")}</p>
      <Problem error={surveys.error ?? cameras.error} />
      {!surveys.data && surveys.loading && <Loading what={say("camera-loading-all")} />}
      {surveys.data && others.length === 0 && <Notice kind="info">{say("camera-take-no-other")}</Notice>}
      {others.length > 0 && (
        <SelectField
          says="camera-take-survey"
          value={String(there)}
          onInput={(value) => setFrom(Number(value))}
          options={named(others)}
        />
      )}
      {cameras.data && there !== null && calibrated.length === 0 && (
        <Notice kind="info">{say("camera-take-none")}</Notice>
      )}
      {calibrated.length > 0 && (
        <SelectField
          says="camera-take-camera"
          value={String(camera?.id)}
          onInput={(value) => setPicked(Number(value))}
          options={named(calibrated)}
          hint={sentenceOf(now?.summary) ?? undefined}
        />
      )}
    </FormDialog>
  );
}
