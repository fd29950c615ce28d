/** Heights computed again by a job: one at a time; when it ends, what it made is said. */
import { type JobAction, useJobAction } from "../../core/jobs";
import { say } from "../../core/messages";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { Job } from "../../core/types";

/** `readAgain`: what shows heights reads them anew, once a job is over. */
export function useComputing(readAgain: (job: Job) => Promise<unknown> | unknown): JobAction {
  return useJobAction({
    stopped: say("computing-job"),
    over: (job) => {
      if (job.state === "done") {
        const heights = Number(job.result?.["heights"] ?? 0);
        toast(heights > 0 ? say("computing-done", { count: heights }) : say("computing-nothing-changed"));
      }
      return Promise.all([readAgain(job), refreshSurvey()]);
    },
  });
}
