import { useState } from "preact/hooks";
import { Button, Icon, JobProgress, Loading, Shape } from "../../components";
import { api } from "../../core/api";
import { isOver } from "../../core/jobs";
import type { ScreenProps } from "../../core/places";
import { useEvery, useResource } from "../../core/resource";
import { may } from "../../core/session";
import { survey as openSurvey, refreshSurvey } from "../../core/survey";
import type { Step, Survey } from "../../core/types";
import { formatCount } from "../../core/units";
import { entryOfStep } from "../../core/work";
import { EditSurvey } from "./EditSurvey";
import { Photographs } from "./Photographs";
import "./survey.css";

/** What is there and what is missing, as the order of work; each step says what to do next. */
export default function SurveyScreen({ surveyId }: ScreenProps) {
  const [editing, setEditing] = useState(false);
  const jobs = useResource((signal) => api.ask("GET /jobs", { survey_id: surveyId }, { signal }), [surveyId]);
  const running = (jobs.data ?? []).filter((job) => !isOver(job));
  useEvery(running.length > 0 ? 1500 : 10_000, async () => {
    await jobs.reload();
    await refreshSurvey();
  });
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what="the survey" />;
  return (
    <div class="page">
      <header class="page__head">
        <div>
          <h1>
            {survey.name} {survey.is_demo && <span class="badge title-badge">demonstration</span>}
          </h1>
          {survey.site && <p class="page__lead">{survey.site}</p>}
          {survey.description && <p class="page__lead">{survey.description}</p>}
        </div>
        <Button href={`/surveys/${survey.id}/planning`}>Plan the site</Button>
        <Button href={`/surveys/${survey.id}/checks`}>Checks</Button>
        <Button href={`/surveys/${survey.id}/repeats`}>Repeats</Button>
        {may("operator") && <Button onClick={() => setEditing(true)}>Edit</Button>}
      </header>
      {running.map((job) => (
        <div class="panel panel__body" key={job.id}>
          <JobProgress job={job} />
        </div>
      ))}
      <ol class="steps">
        {survey.steps.map((step, index) => (
          <StepRow key={step.key} step={step} index={index} survey={survey} />
        ))}
      </ol>
      <LineScans survey={survey} />
      <Photographs surveyId={survey.id} />
      {editing && <EditSurvey survey={survey} close={() => setEditing(false)} />}
    </div>
  );
}

/** Line scans are a way of their own, beside the steps that lead to heights; a survey without any says so quietly. */
function LineScans({ survey }: { survey: Survey }) {
  const { scans } = survey;
  const href = `/surveys/${survey.id}/scans`;
  if (scans.state === "none")
    return (
      <p class="muted" data-testid="line-scans">
        <a href={href}>Line scans</a>: {scans.summary}
      </p>
    );
  return (
    <section
      class="steps"
      aria-label="Line scans, a way of their own beside these steps"
      data-testid="line-scans"
    >
      <div class={`step step--${scans.state === "done" ? "done" : "next"}`}>
        <span class="step__number step__number--plain" aria-hidden="true">
          {scans.state === "done" ? <Shape shape="check" size={24} /> : <Icon name="scan" size={20} />}
        </span>
        <div class="step__words">
          <h2>
            <a href={href}>Line scans</a>
            <span class="step__state">{scans.state === "done" ? "done" : "to do"}</span>
          </h2>
          <p>{scans.summary}</p>
          {scans.accepted > 0 && (
            <p>
              <a href={`${href}/results`}>Results</a>: speeds, gaps, lengths against the makers’.
            </p>
          )}
        </div>
        <Figures
          figures={[
            [scans.scans, scans.scans === 1 ? "line scan" : "line scans"],
            [scans.vehicles, "vehicles"],
            [scans.to_review, "to review"],
            [scans.accepted, "accepted"],
          ]}
        />
        <Button href={href}>Open</Button>
      </div>
    </section>
  );
}

const TITLES: Record<Step["key"], string> = {
  camera: "Calibrate the camera",
  recordings: "Bring in the recordings",
  pose: "Find the road",
  vehicles: "Measure the vehicles",
  review: "Review the measurements",
  results: "Export the results",
};

const VERBS: Record<Step["key"], string> = {
  camera: "Calibrate",
  recordings: "Add recordings",
  pose: "Find the road",
  vehicles: "Measure",
  review: "Review",
  results: "Export",
};

function StepRow({ step, index, survey }: { step: Step; index: number; survey: Survey }) {
  const entry = entryOfStep(step.key);
  const href = `/surveys/${survey.id}${entry?.path ?? ""}`;
  const word = { done: "done", next: "next", waiting: "waiting" }[step.state];
  return (
    <li class={`step step--${step.state}`}>
      <span class="step__number" aria-hidden="true">
        {step.state === "done" ? <Shape shape="check" size={24} /> : index + 1}
      </span>
      <div class="step__words">
        <h2>
          <a href={href}>{TITLES[step.key]}</a>
          <span class="step__state">{word}</span>
        </h2>
        <p>{step.summary}</p>
        {step.key === "results" && (
          <p>
            <a href={`/statistics?survey=${survey.id}`}>Statistics</a>: errors, distributions, percentiles.
          </p>
        )}
      </div>
      <Counts step={step} survey={survey} />
      <Button kind={step.state === "next" ? "primary" : "plain"} href={href}>
        {step.state === "done" ? "Open" : VERBS[step.key]}
      </Button>
    </li>
  );
}

function Counts({ step, survey }: { step: Step; survey: Survey }) {
  const { counts } = survey;
  const figures: [number, string][] = {
    camera: [],
    recordings: [[counts.recordings, "recordings"]],
    pose: [],
    vehicles: [
      [counts.vehicles_measured, `of ${formatCount(counts.vehicles)} measured`],
      [counts.measurements, "measurements"],
    ],
    review: [
      [counts.to_review, "to review"],
      [counts.accepted, "accepted"],
      [counts.rejected, "rejected"],
    ],
    results: [],
  }[step.key] as [number, string][];
  return <Figures figures={figures} />;
}

function Figures({ figures }: { figures: readonly [number, string][] }) {
  return (
    <dl class="step__counts">
      {figures.map(([value, word]) => (
        <div key={word}>
          <dd>{formatCount(value)}</dd>
          <dt>{word}</dt>
        </div>
      ))}
    </dl>
  );
}
