import { useEffect, useState } from "preact/hooks";
import { Button, Empty, JobProgress, Loading, Notice, Problem, TableScroll } from "../../components";
import { api } from "../../core/api";
import { cancelJob, isOver, useJob } from "../../core/jobs";
import type { ScreenProps } from "../../core/places";
import { useResource } from "../../core/resource";
import { survey } from "../../core/survey";
import { formatMoment } from "../../core/times";
import { toast } from "../../core/toasts";
import type { ExportPackage } from "../../core/types";
import { formatBytes, plural } from "../../core/units";
import "./export.css";

const CONTENTS: [file: string, what: string][] = [
  ["report.pdf", "a few pages for people: set-up, calibration, method, errors, figures, exclusions"],
  ["measurements.csv", "each measurement as it stands: vehicle, target, frame, height and its uncertainty"],
  ["exclusions.csv", "what counts for no result, and why"],
  ["statistics, figures", "error table, percentiles, distributions and corrections as CSV; figures as SVG"],
  ["crops", "the picture that each click was made on, unmarked, and with its points beside it"],
  ["revisions.csv, budget.csv", "every revision with its clicks, and where its uncertainty comes from"],
  ["clicks/pose-N.csv", "the clicks alone: “sightline height” computes the same heights from them"],
  ["vehicles.csv", "make, model, year, manufacturer height and its source, lighting"],
  ["recordings.csv, frames.csv", "file hashes, and the time stamp and checksum of each frame measured on"],
  ["poses, calibrations", "where the camera stood and what its lens does, as tables and as JSON"],
  ["insets.csv, wheel_pairs.csv", "insets in force; both tyres of a vehicle, for its direction of travel"],
  ["reviews.csv, repeats.csv", "who accepted, fixed or rejected what, and why; what was clicked again"],
  ["audit.csv", "each change with its hash; the chain can be checked"],
  ["datapackage.json", "name, unit and meaning of every column (Frictionless Data)"],
];

/** One button writes the package that a standards body needs; every package made stays listed with its hash. */
export default function ExportScreen({ surveyId }: ScreenProps) {
  const packages = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/exports", { survey_id: surveyId }, { signal }),
    [surveyId],
  );
  const [jobId, setJobId] = useState<number | null>(null);
  const [starting, setStarting] = useState(false);
  const [problem, setProblem] = useState<unknown>(null);
  const [failed, setFailed] = useState<string | null>(null);
  const [crops, setCrops] = useState(true);
  useRunning(Number(surveyId), setJobId);
  const job = useJob(
    jobId,
    (over) => {
      setJobId(null);
      if (over.state === "done") toast("The package is ready.");
      setFailed(
        over.state === "failed" ? (over.error ?? "The package could not be built; try again.") : null,
      );
      void packages.reload();
    },
    setProblem,
  );
  const build = async () => {
    setStarting(true);
    setProblem(null);
    setFailed(null);
    try {
      setJobId(
        (await api.write("POST /surveys/{survey_id}/exports", { survey_id: surveyId }, { body: { crops } }))
          .id,
      );
    } catch (error) {
      setProblem(error);
    }
    setStarting(false);
  };
  const counts = survey.value?.counts;
  const open = counts ? counts.to_review + counts.rejected : 0;
  return (
    <div class="page">
      <header class="page__head">
        <div>
          <h1>Export</h1>
          <p class="page__lead">
            A zip file with everything needed to check each height, and to compute it again.
          </p>
        </div>
        <div class="row row--wrap">
          <label class="row">
            <input
              type="checkbox"
              checked={crops}
              disabled={jobId !== null}
              onChange={(event) => setCrops(event.currentTarget.checked)}
            />
            <span>with pictures of the clicks</span>
          </label>
          <Button
            kind="primary"
            icon="package"
            busy={starting || jobId !== null}
            onClick={() => void build()}
          >
            Build the package
          </Button>
        </div>
      </header>
      {counts && open > 0 && (
        <Notice kind="warning">
          {[
            counts.to_review > 0 && `${plural(counts.to_review, "measurement")} not yet reviewed`,
            counts.rejected > 0 && `${plural(counts.rejected, "measurement")} rejected and not clicked again`,
          ]
            .filter(Boolean)
            .join(", ")}
          . The package says so, row by row; <a href={`/surveys/${surveyId}/review`}>review first</a> if it is
          to be final.
        </Notice>
      )}
      {job && (
        <div class="panel panel__body">
          <JobProgress job={job} onCancel={() => void cancelJob(job.id).catch(setProblem)} />
        </div>
      )}
      {failed && <Notice kind="problem">{failed}</Notice>}
      <Problem error={problem} again={() => void build()} />
      <section class="panel">
        <header class="panel__head">
          <h2>Packages</h2>
        </header>
        <Problem error={packages.error} again={packages.reload} />
        {!packages.data && packages.loading && <Loading what="packages" />}
        {packages.data?.length === 0 && (
          <Empty title="No package yet">
            <p>
              Press “Build the package”. It takes from seconds to minutes, with the number of pictures, and
              you can go on working meanwhile.
            </p>
          </Empty>
        )}
        {packages.data && packages.data.length > 0 && <Packages list={packages.data} />}
      </section>
      {packages.data?.[0] && <Checking newest={packages.data[0]} />}
      <section class="panel">
        <header class="panel__head">
          <h2>What is in a package</h2>
        </header>
        <table class="table">
          <tbody>
            {CONTENTS.map(([file, what]) => (
              <tr key={file}>
                <td class="nowrap">
                  <code>{file}</code>
                </td>
                <td class="muted">{what}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
    </div>
  );
}

/** A package that is being built when the page is opened is followed as if it had been started here. */
function useRunning(surveyId: number, found: (jobId: number) => void) {
  useEffect(() => {
    const stop = new AbortController();
    api
      .ask("GET /jobs", { survey_id: surveyId }, { signal: stop.signal })
      .then((jobs) => {
        const running = jobs.find((job) => job.kind === "export" && !isOver(job));
        if (running) found(running.id);
      })
      .catch(() => undefined); // the list of packages tells what is wrong
    return () => stop.abort();
  }, [surveyId]);
}

async function copy(text: string, said: string) {
  await navigator.clipboard.writeText(text);
  toast(said);
}

function Packages({ list }: { list: ExportPackage[] }) {
  return (
    <TableScroll label="Packages">
      <table class="table table--hover">
        <thead>
          <tr>
            <th>made</th>
            <th>by</th>
            <th class="num">size</th>
            <th>SHA-256</th>
            <th>head of the audit chain</th>
            <th>
              <span class="visually-hidden">download</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {list.map((entry) => (
            <tr key={entry.id}>
              <td class="nowrap">{formatMoment(entry.created_at)}</td>
              <td class="nowrap">{entry.created_by?.name ?? "–"}</td>
              <td class="num nowrap">{formatBytes(entry.size_bytes)}</td>
              <Hash text={entry.sha256} what="SHA-256" />
              <Hash text={entry.audit_head} what="head of the audit chain" />
              <td class="num">
                <Button small icon="download" href={entry.url} download>
                  Download
                </Button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

function Hash({ text, what }: { text: string; what: string }) {
  return (
    <td class="export__hash">
      <code title={text}>{text.slice(0, 16)}…</code>
      <Button
        small
        kind="quiet"
        icon="copy"
        label={`Copy the ${what}`}
        onClick={() => void copy(text, `The ${what} is on the clipboard.`)}
      />
    </td>
  );
}

/** How the one who receives a package checks it, ready to be copied. */
function Checking({ newest }: { newest: ExportPackage }) {
  const command = `sightline verify ${newest.filename} --head ${newest.audit_head}`;
  return (
    <section class="panel">
      <header class="panel__head">
        <h2>Checking a package</h2>
      </header>
      <div class="panel__body stack stack--tight">
        <p>
          This checks every file, the audit chain and each row against it, and computes every height and every
          statistic again. Send the head of the audit chain and the SHA-256 by another way than the package:
          they find a package that was written anew from end to end.
        </p>
        <p class="export__command">
          <code>{command}</code>
          <Button
            small
            kind="quiet"
            icon="copy"
            label="Copy the command"
            onClick={() => void copy(command, "The command is on the clipboard.")}
          />
        </p>
      </div>
    </section>
  );
}
