/** Long work of the server: what waits, what is under way, what came of it; stopped and done once more here. */
import {
  Button,
  choices,
  Empty,
  Loaded,
  OptionalField,
  PageHead,
  Problem,
  Progress,
  StateMark,
  Table,
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
/** How often the list is read again. */
const EVERY_MS = 2000;

export default function JobsScreen() {
  const state = query.value.get("state");
  const jobs = useAsked("GET /jobs", fromAddress<"GET /jobs">({ state: state ?? undefined }), { keep: true });
  const surveys = useAsked("GET /surveys");
  const { problem, run: attempt } = useAction();
  useEvery(EVERY_MS, jobs.reload);
  const run = async (work: () => Promise<unknown>) => {
    await attempt(work);
    await jobs.reload();
  };
  const nameOf = (id: number | null): string => surveys.data?.find((survey) => survey.id === id)?.name ?? "–";
  return (
    <div class="page page--alone">
      <PageHead title={say("page-jobs")} lead={say("jobs-lead")}>
        <OptionalField
          label={say("jobs-show")}
          value={state}
          none={say("jobs-all")}
          options={choices<string>(STATE_WORDS, STATES)}
          onInput={(state) => setQuery({ state })}
        />
      </PageHead>
      <Problem error={problem} />
      <Loaded of={jobs} what={say("jobs-loading")} />
      {jobs.data?.length === 0 && (
        <div class="panel">
          <Empty title={say("jobs-none-title")}>
            <p>{say("jobs-none")}</p>
          </Empty>
        </div>
      )}
      {jobs.data && jobs.data.length > 0 && (
        <Table
          label={say("page-jobs")}
          scroll="panel"
          heads={[
            say("jobs-column-what"),
            say("jobs-column-for"),
            say("jobs-column-state"),
            say("jobs-column-said"),
            say("jobs-column-begun"),
            <span class="visually-hidden">{say("people-actions")}</span>,
          ]}
        >
          {jobs.data.map((job) => (
            <Row key={job.id} job={job} survey={nameOf(job.survey_id)} run={run} />
          ))}
        </Table>
      )}
    </div>
  );
}

interface RowProps {
  job: Job;
  survey: string;
  run(work: () => Promise<unknown>): Promise<void>;
}

function Row({ job, survey, run }: RowProps) {
  const page = pageOf(job);
  return (
    <tr data-testid={`job-${job.id}`}>
      <td>{jobName(job.kind)}</td>
      <td>{page ? <a href={page}>{survey}</a> : survey}</td>
      <td>
        <StateMark state={job.state} />
      </td>
      <td>
        {isOver(job) ? toldOf(job) : <Progress value={job.progress} label={sentenceOf(job.message) ?? "…"} />}
      </td>
      <td class="muted nowrap" title={formatMoment(job.created_at)}>
        {formatAgo(job.created_at)}
      </td>
      <td class="num">
        <Actions job={job} run={run} />
      </td>
    </tr>
  );
}

function Actions({ job, run }: Omit<RowProps, "survey">) {
  if (!may("operator")) return null;
  if (!isOver(job)) {
    return (
      <Button small kind="quiet" onClick={() => void run(() => cancelJob(job.id))}>
        {say("action-cancel")}
      </Button>
    );
  }
  if (job.state === "done") return null;
  const again = async () => {
    await api.write("POST /jobs/{job_id}/again", { job_id: job.id });
    toast(say("jobs-begun-again"));
  };
  return (
    <Button small kind="quiet" icon="retry" onClick={() => void run(again)}>
      {say("jobs-again")}
    </Button>
  );
}

/** The sentence that it ended with; of one that is done, what it did last is none. */
function toldOf(job: Job): string {
  return (
    lastWords(job) ?? sentenceOf(job.error) ?? (job.state === "done" ? "" : (sentenceOf(job.message) ?? ""))
  );
}

/** Where its work is looked at. */
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
