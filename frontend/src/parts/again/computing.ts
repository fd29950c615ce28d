/** Heights computed again by a job: one at a time; when it ends, what it made is said. */
import { useState } from "preact/hooks";
import { jobProblem, useJob } from "../../core/jobs";
import { say } from "../../core/messages";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { Job } from "../../core/types";

/** `readAgain`: what shows heights reads them anew, once a job is over. */
export function useComputing(readAgain: (job: Job) => Promise<unknown> | unknown) {
  const [id, setId] = useState<number | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const over = async (job: Job) => {
    setId(null);
    if (job.state === "failed") setProblem(jobProblem(job, say("computing-job")));
    if (job.state === "done") {
      const heights = Number(job.result?.["heights"] ?? 0);
      toast(heights > 0 ? say("computing-done", { count: heights }) : say("computing-nothing-changed"));
    }
    await Promise.all([readAgain(job), refreshSurvey()]);
  };
  const job = useJob(id, (ended) => void over(ended), setProblem);
  const run = async (ask: () => Promise<Job>) => {
    setProblem(null);
    try {
      setId((await ask()).id);
    } catch (error) {
      setProblem(error);
    }
  };
  return { job: id === null ? null : job, busy: id !== null, problem, run };
}
