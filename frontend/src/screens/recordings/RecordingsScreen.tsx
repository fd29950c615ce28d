import { useRef } from "preact/hooks";
import { DropFiles, Empty, Loaded, PageHead, Problem } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useEvery } from "../../core/resource";
import { may } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toastProblem } from "../../core/toasts";
import { SampleLink } from "../../parts/samples/SampleLink";
import { RecordingCard } from "./RecordingCard";
import "./recordings.css";
import { UnfinishedRow, UploadRow } from "../../parts/uploads/UploadRow";
import { startUpload, uploads } from "../../parts/uploads/uploads";

/** Video in: drop files, watch them arrive and be read, say which camera and which light. */
export default function RecordingsScreen({ surveyId }: ScreenProps) {
  const recordings = useAsked("GET /surveys/{survey_id}/recordings", { survey_id: surveyId });
  const cameras = useAsked("GET /surveys/{survey_id}/cameras", { survey_id: surveyId });
  const counts = useAsked("GET /surveys/{survey_id}/pass-counts", { survey_id: surveyId }, { keep: true });
  const unfinished = useAsked("GET /surveys/{survey_id}/uploads", { survey_id: surveyId });
  const busy = recordings.data?.some((recording) => recording.state === "ingesting") ?? false;
  const wasBusy = useRef(false);
  useEvery(busy ? 1000 : null, async () => {
    await recordings.reload();
  });
  if (wasBusy.current && !busy) void refreshSurvey();
  wasBusy.current = busy;

  /** Where there is one camera, it is the one; the card shows it, and it can be changed there. */
  const pickOnlyCamera = async (recordingId: number | null) => {
    const [only, another] = cameras.data ?? [];
    if (recordingId === null || !only || another) return;
    await api
      .write(
        "PUT /recordings/{recording_id}",
        { recording_id: recordingId },
        { body: { camera_id: only.id } },
      )
      .catch(toastProblem);
  };
  const add = (files: File[]) => {
    for (const file of files) {
      void startUpload(surveyId, file, (recordingId) => {
        void pickOnlyCamera(recordingId).then(recordings.reload);
        void unfinished.reload();
        void refreshSurvey();
      });
    }
  };
  const mine = uploads.value.filter((item) => item.surveyId === surveyId && item.purpose === "video");
  const left = (unfinished.data ?? []).filter((old) => !mine.some((item) => item.name === old.filename));
  const canWork = may("operator");
  return (
    <div class="page">
      <PageHead says="page-recordings" lead={say("recordings-lead")} />
      {canWork && (
        <DropFiles
          label={say("recordings-choose")}
          title={say("recordings-drop")}
          hint={say("recordings-drop-hint")}
          accept="video/*,.3gp,.asf,.avi,.m2ts,.mkv,.mpeg,.mpg,.mts,.mxf,.ts,.wmv"
          add={add}
        />
      )}
      {(mine.length > 0 || left.length > 0) && (
        <section class="panel uploads" aria-label={say("recordings-uploads")}>
          {mine.map((item) => (
            <UploadRow key={item.key} item={item} />
          ))}
          {left.map((old) => (
            <UnfinishedRow key={old.id} upload={old} gone={unfinished.reload} />
          ))}
        </section>
      )}
      <Problem error={counts.error} again={counts.reload} />
      <Loaded of={recordings} what={say("recordings-loading")} />
      {recordings.data?.length === 0 && mine.length === 0 && (
        <Empty panel says="recordings-none-title">
          <p>{say(canWork ? "recordings-none" : "recordings-none-look")}</p>
          {canWork && <SampleLink kind="clip" />}
        </Empty>
      )}
      <div class="stack">
        {recordings.data?.map((recording) => (
          <RecordingCard
            key={recording.id}
            recording={recording}
            passes={counts.data?.find((one) => one.recording_id === recording.id)?.passes}
            cameras={cameras.data ?? []}
            changed={(next) =>
              recordings.set((recordings.data ?? []).map((old) => (old.id === next.id ? next : old)))
            }
            reload={async () => {
              await Promise.all([recordings.reload(), counts.reload()]);
              await refreshSurvey();
            }}
          />
        ))}
      </div>
    </div>
  );
}
