/** A button that starts work on a recording, follows it, and says what came of it. */
import { Button, JobProgress, Problem } from "../../components";
import { isOver, lastWords, useJobAction } from "../../core/jobs";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { Job, Recording } from "../../core/types";
import "./passes.css";

export interface RecordingJobProps {
  recording: Pick<Recording, "id" | "name" | "state" | "job">;
  kind: string;
  start(): Promise<Job>;
  words: {
    action: string;
    title: string;
    failed: string;
    cancelled: string;
    /** `message`: what the work says of itself. */
    over(message: string | null): string;
  };
  over(): void | Promise<void>;
}

export function RecordingJob({ recording, kind, start, words, over }: RecordingJobProps) {
  const known = recording.job;
  const work = useJobAction({
    // work that began by itself when the video was read, too
    known: known?.kind === kind && !isOver(known) ? known.id : null,
    stopped: words.failed,
    over: (done) => {
      if (done.state !== "failed") toast(told(words, done));
      return over();
    },
  });
  if (!may("operator") || recording.state !== "ready") return null;
  return (
    <div class="stack stack--dense find-passes">
      {work.job ? (
        <JobProgress job={work.job} onCancel={work.cancel} />
      ) : (
        <Button
          kind="plain"
          icon="search"
          disabled={work.underWay}
          title={words.title}
          onClick={() => void work.start(start)}
        >
          {words.action}
        </Button>
      )}
      <Problem error={work.problem} />
    </div>
  );
}

function told(words: RecordingJobProps["words"], job: Job): string {
  return job.state === "cancelled" ? words.cancelled : words.over(lastWords(job));
}
