/** Long work: poll the server's job table, tell progress, tell the end once. */
import type { Signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { useAction } from "./action";
import { ApiError, api } from "./api";
import { type Said, say, sentenceOf, sentencesOf } from "./messages";
import type { Job } from "./types";

/** "Camera stability check"; a kind that the sentence does not know is "Other job". */
export function jobName(kind: string): string {
  return say("jobs-kind", { kind: kind as "other" });
}

export function isOver(job: Job): boolean {
  return job.state === "done" || job.state === "failed" || job.state === "cancelled";
}

/** Follows one job until it is over. Polls quickly at first, then every two seconds. */
async function followJob(id: number, onChange: (job: Job) => unknown, signal?: AbortSignal): Promise<Job> {
  for (let wait = 250; ; wait = Math.min(2000, wait * 1.3)) {
    const job = await api.ask("GET /jobs/{job_id}", { job_id: id }, { signal });
    onChange(job);
    if (isOver(job)) return job;
    await sleep(wait, signal);
  }
}

/** The same into a signal, from what is known of the job on. */
export function followInto(shown: Signal<Job | null>, job: Job, signal: AbortSignal): Promise<Job> {
  shown.value = job;
  return followJob(job.id, (now) => (shown.value = now), signal);
}

export function lastWords({ result }: Job): string | null {
  const said = result?.["message"] as string | Said[] | undefined;
  if (said === undefined) return null;
  return typeof said === "string" ? said : sentencesOf(said); // a text was stored by an earlier program
}

export function cancelJob(id: number): Promise<Job> {
  return api.write("POST /jobs/{job_id}/cancel", { job_id: id });
}

/** What a job stopped at, as an error that is shown in its own words. */
export function jobProblem(job: Job, otherwise: string): ApiError {
  return new ApiError(sentenceOf(job.error) ?? otherwise, 500);
}

export type JobAction = ReturnType<typeof useJobAction>;

interface Following {
  /** Of one that is known to be under way already. */
  known?: number | null;
  /** Said where it fails without words of its own; left out: its failure is told elsewhere. */
  stopped?: string;
  over: (job: Job) => unknown;
}

/** A job that a person sets going, or that began by itself: followed until it is over and what it made was read. */
export function useJobAction({ known = null, stopped, over }: Following) {
  const action = useAction();
  const { run, setProblem } = action;
  const [id, follow] = useState<number | null>(known);
  /** As it stands now; null: none is under way, or nothing is known of it yet. */
  const [job, setJob] = useState<Job | null>(null);
  useEffect(() => {
    if (known !== null) follow(known);
  }, [known]);
  useEffect(() => {
    setJob(null);
    if (id === null) return;
    const stop = new AbortController();
    const ended = async (job: Job) => {
      if (job.state === "failed" && stopped) setProblem(jobProblem(job, stopped));
      await over(job);
    };
    followJob(id, setJob, stop.signal)
      .then(ended)
      .catch((error) => {
        if (!stop.signal.aborted) setProblem(error);
      })
      .finally(() => {
        if (!stop.signal.aborted) follow(null);
      });
    return () => stop.abort();
  }, [id]);
  const start = (ask: () => Promise<Job>) => run(async () => follow((await ask()).id));
  const cancel = () => {
    if (id !== null) void cancelJob(id).catch(setProblem);
  };
  const underWay = id !== null; // from the press that starts it until what it made was read
  return { ...action, job, underWay, start, follow, cancel };
}

function sleep(ms: number, signal?: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(resolve, ms);
    signal?.addEventListener("abort", () => {
      clearTimeout(timer);
      reject(signal.reason);
    });
  });
}
