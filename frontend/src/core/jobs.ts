/** Long work: poll the server's job table, tell progress, tell the end once. */
import { useEffect, useState } from "preact/hooks";
import { ApiError, api } from "./api";
import { say } from "./messages";
import type { Job } from "./types";

const KINDS = [
  "ingest",
  "passes",
  "proposals",
  "pose",
  "calibrate",
  "drift",
  "export",
  "scan_read",
  "scan_find",
  "scan_tidy",
  "demonstration",
  "demonstration_study",
  "study",
] as const;

/** "Camera stability check" */
export function jobName(kind: string): string {
  return say("jobs-kind", { kind: KINDS.find((one) => one === kind) ?? "other" });
}

export function isOver(job: Job): boolean {
  return job.state === "done" || job.state === "failed" || job.state === "cancelled";
}

/** What a job stopped at, as an error that is shown in its own words. */
export function jobProblem(job: Job, otherwise: string): ApiError {
  return new ApiError(job.error ?? otherwise, 500);
}

/** Follows one job until it is over. Polls quickly at first, then every two seconds. */
export async function followJob(
  id: number,
  onChange: (job: Job) => void,
  signal?: AbortSignal,
): Promise<Job> {
  for (let wait = 250; ; wait = Math.min(2000, wait * 1.3)) {
    const job = await api.ask("GET /jobs/{job_id}", { job_id: id }, { signal });
    onChange(job);
    if (isOver(job)) return job;
    await sleep(wait, signal);
  }
}

export function cancelJob(id: number): Promise<Job> {
  return api.write("POST /jobs/{job_id}/cancel", { job_id: id }, { retry: true });
}

/** A job as it stands now; `onOver` is called once when it ends. */
export function useJob(
  id: number | null,
  onOver: (job: Job) => void,
  onProblem: (error: unknown) => void,
): Job | null {
  const [job, setJob] = useState<Job | null>(null);
  useEffect(() => {
    setJob(null);
    if (id === null) return;
    const stop = new AbortController();
    followJob(id, setJob, stop.signal).then(onOver, (error) => {
      if (!stop.signal.aborted) onProblem(error);
    });
    return () => stop.abort();
  }, [id]);
  return job;
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
