/** Long work of the server: what waits, what is under way, what came of it; stopped and done once more here. */
import {
  Button,
  choices,
  DataTable,
  Empty,
  Loaded,
  OptionalField,
  PageHead,
  Problem,
  Progress,
  StateMark,
} from "../../components";
import { useAction } from "../../core/action";
import { query, setQuery } from "../../core/address";
import { api, fromAddress } from "../../core/api";
import { cancelJob, isOver, jobName, lastWords } from "../../core/jobs";
import { say, sentenceOf } from "../../core/messages";
import { useAsked, useEvery } from "../../core/resource";
import { may } from "../../core/session";
import { formatAgo, formatMoment } from "../../core/times";
import { toast } from "../../core/toasts";
import type { Job } from "../../core/types";
import { STATE_WORDS } from "../../core/words";

const STATES = ["queued", "running", "failed", "cancelled", "done"] as const;
const EVERY_MS = 2000;

export default function JobsScreen() {
  const state = query.value.get("state");
  const jobs = useAsked("GET /jobs", fromAddress<"GET /jobs">({ state: state ?? undefined }), { keep: true });
  const surveys = useAsked("GET /surveys");
  const { problem, run } = useAction(jobs.reload);
  useEvery(EVERY_MS, jobs.reload);
  const nameOf = (id: number | null): string => surveys.data?.find((survey) => survey.id === id)?.name ?? "–";
  return (
    <div class="page page--alone">
      <PageHead says="page-jobs" lead={say("jobs-lead")}>
        <OptionalField
          says="jobs-show"
          value={state}
          none={say("jobs-all")}
          options={choices<string>(STATE_WORDS, STATES)}
          onInput={(state) => setQuery({ state })}
        />
      </PageHead>
      <Problem error={problem} />
      <Loaded of={jobs} what={say("jobs-loading")} />
      {jobs.data?.length === 0 && <Empty panel says="jobs-none-title" why="jobs-none" />}
      {jobs.data && jobs.data.length > 0 && (
        <DataTable
          label={say("page-jobs")}
          scroll="panel"
          rows={jobs.data}
          keyOf={(job) => job.id}
          rowAttributes={(job) => ({ "data-testid": `job-${job.id}` })}
          columns={({ col, actions }) => [
            col(say("jobs-column-what"), (job) => jobName(job.kind)),
            col(say("jobs-column-for"), (job) => pageLink(job, nameOf(job.survey_id))),
            col(say("jobs-column-state"), (job) => <StateMark state={job.state} />),
            col(say("jobs-column-said"), (job) =>
              isOver(job) ? (
                toldOf(job)
              ) : (
                <Progress value={job.progress} label={sentenceOf(job.message) ?? "…"} />
              ),
            ),
            col(say("jobs-column-begun"), ({ created_at }) => (
              <span class="muted nowrap" title={formatMoment(created_at)}>
                {formatAgo(created_at)}
              </span>
            )),
            actions(say("people-actions"), (job) => <Actions job={job} run={run} />, "num"),
          ]}
        />
      )}
    </div>
  );
}

function pageLink(job: Job, survey: string) {
  const page = pageOf(job);
  return page ? <a href={page}>{survey}</a> : survey;
}

function Actions({ job, run }: { job: Job; run(work: () => Promise<unknown>): Promise<unknown> }) {
  if (!may("operator")) return null;
  if (job.cancellable) {
    return (
      <Button says="action-cancel" small kind="quiet" onClick={() => void run(() => cancelJob(job.id))} />
    );
  }
  if (!isOver(job) || job.state === "done") return null;
  const again = async () => {
    await api.write("POST /jobs/{job_id}/again", { job_id: job.id });
    toast(say("jobs-begun-again"));
  };
  return <Button says="jobs-again" small kind="quiet" icon="retry" onClick={() => void run(again)} />;
}

/** The sentence that it ended with; of one that is done, what it did last is none. */
function toldOf(job: Job): string {
  return (
    lastWords(job) ?? sentenceOf(job.error) ?? (job.state === "done" ? "" : (sentenceOf(job.message) ?? ""))
  );
}

function pageOf({ kind, survey_id, recording_id, scan_id }: Job): string | null {
  if (survey_id === null) return null;
  const survey = `/surveys/${survey_id}`;
  if (scan_id) return `${survey}/scan?scan=${scan_id}`;
  if (kind === "pose" && recording_id) return `${survey}/pose?recording=${recording_id}`;
  if ((kind === "passes" || kind === "proposals") && recording_id)
    return `${survey}/measure?recording=${recording_id}`;
  if (recording_id) return `${survey}/recordings`;
  return kind === "export" ? `${survey}/export` : survey;
}
