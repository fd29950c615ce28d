/** "Find the passes": starts the search in a recording, follows it, says what came of it. */
import { useEffect, useState } from "preact/hooks";
import { Button, JobProgress, Problem } from "../../components";
import { api } from "../../core/api";
import { cancelJob, isOver, jobProblem, useJob } from "../../core/jobs";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { Job, Recording } from "../../core/types";
import "./passes.css";

interface Props {
  recording: Pick<Recording, "id" | "name" | "state" | "job">;
  /** Called once when passes may have been added. */
  found: () => void | Promise<void>;
}

export function FindPasses({ recording, found }: Props) {
  const known = recording.job;
  const underWay = known?.kind === "passes" && !isOver(known) ? known.id : null;
  const [jobId, setJobId] = useState<number | null>(underWay);
  // a search that began by itself when the video was read
  useEffect(() => {
    if (underWay !== null) setJobId(underWay);
  }, [underWay]);
  const [problem, setProblem] = useState<unknown>(null);
  const job = useJob(
    jobId,
    (over) => {
      setJobId(null);
      if (over.state === "failed") setProblem(jobProblem(over, say("passes-failed")));
      else toast(told(recording.name, over));
      void found();
    },
    (error) => {
      setJobId(null);
      setProblem(error);
    },
  );
  if (!may("operator") || recording.state !== "ready") return null;
  const start = async () => {
    setProblem(null);
    try {
      setJobId(
        (await api.write("POST /recordings/{recording_id}/find-passes", { recording_id: recording.id })).id,
      );
    } catch (error) {
      setProblem(error);
    }
  };
  const stop = () => void cancelJob(jobId ?? 0).catch(setProblem);
  return (
    <div class="find-passes">
      {jobId !== null && job ? (
        <JobProgress job={job} onCancel={stop} />
      ) : (
        <Button
          kind="plain"
          icon="search"
          disabled={jobId !== null}
          title={say("passes-find-title")}
          onClick={() => void start()}
        >
          {say("passes-find")}
        </Button>
      )}
      <Problem error={problem} />
    </div>
  );
}

function told(recording: string, job: Job): string {
  const message = job.result?.message;
  if (job.state === "cancelled") return say("passes-cancelled", { recording });
  return typeof message === "string"
    ? say("passes-found", { recording, message })
    : say("passes-over", { recording });
}
