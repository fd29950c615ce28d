/** "Find the passes": starts the search in a recording, follows it, says what came of it. */
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { RecordingJob, type RecordingJobProps } from "./RecordingJob";

interface Props {
  recording: RecordingJobProps["recording"];
  found: () => void | Promise<void>;
}

export function FindPasses({ recording, found }: Props) {
  const named = { recording: recording.name };
  return (
    <RecordingJob
      recording={recording}
      kind="passes"
      start={() => api.write("POST /recordings/{recording_id}/find-passes", { recording_id: recording.id })}
      words={{
        action: say("passes-find"),
        title: say("passes-find-title"),
        failed: say("passes-failed"),
        cancelled: say("passes-cancelled", named),
        over: (message) =>
          message === null ? say("passes-over", named) : say("passes-found", { ...named, message }),
      }}
      over={found}
    />
  );
}
