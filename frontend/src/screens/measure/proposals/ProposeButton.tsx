/** Asks for proposals of the recording that is open, follows the work, and reads what came of it. */
import { api } from "../../../core/api";
import { say } from "../../../core/messages";
import { RecordingJob } from "../../../parts/vehicles/RecordingJob";
import type { MeasureModel } from "../model";
import "./proposals.css";

export function ProposeButton({ model }: { model: MeasureModel }) {
  const recording = model.reel.recording.value;
  const found = model.vehicles.list.value.some(
    (one) => one.recording_id === recording?.id && one.origin === "found",
  );
  if (!recording || recording.pose_id === null || !found) return null;
  return (
    <div class="propose">
      <RecordingJob
        key={recording.id}
        recording={recording}
        kind="proposals"
        start={() => api.write("POST /recordings/{recording_id}/propose", { recording_id: recording.id })}
        words={{
          action: say("measure-propose"),
          title: say("measure-propose-title"),
          failed: say("measure-propose-failed"),
          cancelled: say("measure-propose-cancelled", { recording: recording.name }),
          over: (message) =>
            message === null
              ? say("measure-propose-over", { recording: recording.name })
              : say("passes-found", { recording: recording.name, message }),
        }}
        over={() => model.readProposals()}
      />
    </div>
  );
}
