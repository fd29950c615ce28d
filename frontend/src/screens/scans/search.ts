/** The search for the vehicles of a line scan, which runs on the server. */
import { signal } from "@preact/signals";
import { api } from "../../core/api";
import { followInto, jobProblem } from "../../core/jobs";
import { say } from "../../core/messages";
import { toastProblem } from "../../core/toasts";
import type { Job, ScanMethod } from "../../core/types";
import type { Bench } from "./bench";

export class Search {
  readonly job = signal<Job | null>(null);

  /** `over`: reads what the search has changed. */
  constructor(
    private readonly bench: Bench,
    private readonly over: () => Promise<void>,
    private readonly stop: AbortSignal,
  ) {}

  /** Looks for vehicles, or (without `search`) measures those that are known again. */
  async find(method: ScanMethod, search: boolean): Promise<void> {
    await this.bench.tell(async () =>
      this.follow(
        await api.write(
          "POST /scans/{scan_id}/find",
          { scan_id: this.bench.id },
          { body: { method, search } },
        ),
      ),
    );
  }

  async follow(job: Job): Promise<void> {
    try {
      const ended = await followInto(this.job, job, this.stop);
      this.job.value = null;
      if (ended.state === "failed") toastProblem(jobProblem(ended, say("scan-search-stopped")));
      await this.over();
    } catch (error) {
      this.job.value = null;
      if (!this.stop.aborted) toastProblem(error);
    }
  }
}
