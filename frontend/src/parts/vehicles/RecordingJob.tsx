/** A button that starts work on a recording, follows it, and says what came of it. */
import { useEffect, useState } from "preact/hooks";
import { Button, JobProgress, Problem } from "../../components";
import type { IconName } from "../../components/Icon";
import { useAction } from "../../core/action";
import { cancelJob, isOver, jobProblem, useJob } from "../../core/jobs";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { Job, Recording } from "../../core/types";
import "./passes.css";

export interface RecordingJobProps {
  recording: Pick<Recording, "id" | "name" | "state" | "job">;
  kind: string;
  icon: IconName;
  start(): Promise<Job>;
  words: {
    action: string;
    title: string;
    failed: string;
    cancelled: string;
    /** `message`: what the work says of itself. */
    over(message: string | null): string;
  };
  /** Called once when something may have come of it. */
  over(): void | Promise<void>;
}

export function RecordingJob({ recording, kind, icon, start, words, over }: RecordingJobProps) {
  const known = recording.job;
  const underWay = known?.kind === kind && !isOver(known) ? known.id : null;
  const [jobId, setJobId] = useState<number | null>(underWay);
  // work that began by itself when the video was read
  useEffect(() => {
    if (underWay !== null) setJobId(underWay);
  }, [underWay]);
  const { problem, setProblem, run } = useAction();
  const job = useJob(
    jobId,
    (done) => {
      setJobId(null);
      if (done.state === "failed") setProblem(jobProblem(done, words.failed));
      else toast(told(words, done));
      void over();
    },
    (error) => {
      setJobId(null);
      setProblem(error);
    },
  );
  if (!may("operator") || recording.state !== "ready") return null;
  const begin = () =>
    run(async () => {
      setJobId((await start()).id);
    });
  const stop = () => void cancelJob(jobId ?? 0).catch(setProblem);
  return (
    <div class="find-passes">
      {jobId !== null && job ? (
        <JobProgress job={job} onCancel={stop} />
      ) : (
        <Button
          kind="plain"
          icon={icon}
          disabled={jobId !== null}
          title={words.title}
          onClick={() => void begin()}
        >
          {words.action}
        </Button>
      )}
      <Problem error={problem} />
    </div>
  );
}

function told(words: RecordingJobProps["words"], job: Job): string {
  const message = job.result?.message;
  if (job.state === "cancelled") return words.cancelled;
  return words.over(typeof message === "string" ? message : null);
}
