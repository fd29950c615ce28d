import { useState } from "preact/hooks";
import { Button, Icon, JobProgress, Loading, Notice, PageHead, Shape } from "../../components";
import { linkTo, Said } from "../../components/Said";
import { isOver } from "../../core/jobs";
import { say, sentencesOf, wordsOf } from "../../core/messages";
import { addressOf, type ScreenProps, titleOf } from "../../core/places";
import { useAsked, useEvery } from "../../core/resource";
import { may } from "../../core/session";
import { survey as openSurvey, refreshSurvey } from "../../core/survey";
import { toastProblem } from "../../core/toasts";
import { beginTour, endTour, isTourNew, tour } from "../../core/tour";
import type { Step, Survey } from "../../core/types";
import { formatCount } from "../../core/units";
import { STATE_WORDS } from "../../core/words";
import { entryOfStep } from "../../core/work";
import { Outdated } from "../../parts/again/Outdated";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { EditSurvey } from "./EditSurvey";
import { askedWords, placeWords, trafficWords } from "./words";
import "./survey.css";

/** What is there and what is missing, as the order of work; each step says what to do next. */
export default function SurveyScreen({ surveyId }: ScreenProps) {
  const [editing, setEditing] = useState(false);
  const jobs = useAsked("GET /jobs", { survey_id: surveyId });
  const running = (jobs.data ?? []).filter((job) => !isOver(job));
  useEvery(running.length > 0 ? 1500 : 10_000, async () => {
    await jobs.reload();
    await refreshSurvey();
  });
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what={say("survey-loading")} />;
  return (
    <div class="page">
      <PageHead
        label={
          <>
            {survey.name}{" "}
            {survey.is_demo && <span class="badge title-badge">{say("survey-demonstration")}</span>}
          </>
        }
        lead={survey.site}
        more={
          <>
            <p class="muted small" data-testid="place-said">
              {placeWords(survey.place)}
            </p>
            {survey.description && <p class="page__lead">{survey.description}</p>}
          </>
        }
      />
      {survey.is_demo && !tour.value && isTourNew() && <TourOffer />}
      {running.map((job) => (
        <div class="panel panel__body" key={job.id}>
          <JobProgress job={job} named />
        </div>
      ))}
      <OutOfDateNotice surveyId={survey.id} />
      <TrafficOf survey={survey} edit={() => setEditing(true)} />
      <ol class="panel">
        {survey.steps.map((step, index) => (
          <StepRow key={step.key} step={step} index={index} survey={survey} />
        ))}
      </ol>
      <LineScans survey={survey} />
      {editing && <EditSurvey survey={survey} close={() => setEditing(false)} />}
    </div>
  );
}

/** How traffic goes here, in words; while nobody has said it, why that matters and one click to say it. */
function TrafficOf({ survey, edit }: { survey: Survey; edit(): void }) {
  const { traffic_side, steering_side, camera_place } = survey.traffic;
  if (traffic_side && steering_side && camera_place)
    return (
      <p class="muted" data-testid="traffic-said">
        {trafficWords(survey.traffic)} {askedWords(survey.asked)}
      </p>
    );
  return (
    <Notice kind="warning">
      {say("survey-traffic-unsaid")}{" "}
      {may("operator") && <Button says="survey-traffic-say" small onClick={edit} />}
    </Notice>
  );
}

/** Line scans are a way of their own, beside the steps that lead to heights; a survey without any says so quietly. */
function LineScans({ survey }: { survey: Survey }) {
  const { scans } = survey;
  const href = `/surveys/${survey.id}/scans`;
  if (scans.state === "none")
    return (
      <p class="muted" data-testid="line-scans">
        <Said
          what="survey-scans-none"
          values={{ summary: sentencesOf(scans.summary) }}
          parts={linkTo(href)}
        />
      </p>
    );
  return (
    <section class="panel" aria-label={say("survey-scans-label")} data-testid="line-scans">
      <div class={`step step--${scans.state === "done" ? "done" : "next"}`}>
        <span class="step__number step__number--plain" aria-hidden="true">
          {scans.state === "done" ? <Shape shape="check" size={24} /> : <Icon name="scan" size={20} />}
        </span>
        <div class="step__words">
          <h2 class="row row--base">
            <a href={href}>{titleOf("scans")}</a>
            <span class="step__state">{scans.state === "done" ? STATE_WORDS.done : STATE_WORDS.to_do}</span>
          </h2>
          <p>{sentencesOf(scans.summary)}</p>
          {scans.accepted > 0 && (
            <p>
              <Said what="survey-scan-results" parts={linkTo(`${href}/results`)} />
            </p>
          )}
        </div>
        <Figures
          figures={[
            [scans.scans, say("survey-count-scans", { count: scans.scans })],
            [scans.vehicles, say("survey-count-vehicles", { count: scans.vehicles })],
            [scans.to_review, STATE_WORDS.to_review],
            [scans.accepted, say("survey-count-scanned-accepted", { count: scans.accepted })],
          ]}
        />
        <Button says="survey-open" href={href} />
      </div>
    </section>
  );
}

const VERBS: Readonly<Record<Step["key"], string>> = wordsOf("survey-go-");

function StepRow({ step, index, survey }: { step: Step; index: number; survey: Survey }) {
  const entry = entryOfStep(step.key);
  const href = addressOf(entry.name, survey.id);
  return (
    <li class={`step step--${step.state}`}>
      <span class="step__number" aria-hidden="true">
        {step.state === "done" ? <Shape shape="check" size={24} /> : index + 1}
      </span>
      <div class="step__words">
        <h2 class="row row--base">
          <a href={href}>{titleOf(entry.name)}</a>
          <span class="step__state">{STATE_WORDS[step.state]}</span>
        </h2>
        <p>{sentencesOf(step.summary)}</p>
        {step.key === "results" && <Outdated since={survey.since_package} />}
        {step.key === "results" && (
          <p>
            <Said what="survey-statistics" parts={linkTo(`/statistics?survey=${survey.id}`)} />
          </p>
        )}
      </div>
      <Counts step={step} survey={survey} />
      <Button kind={step.state === "next" ? "primary" : "plain"} href={href}>
        {step.state === "done" ? say("survey-open") : VERBS[step.key]}
      </Button>
    </li>
  );
}

function Counts({ step, survey }: { step: Step; survey: Survey }) {
  const { counts } = survey;
  const figures: [number, string][] = {
    camera: [],
    recordings: [[counts.recordings, say("survey-count-recordings", { count: counts.recordings })]],
    pose: [],
    vehicles: [
      [counts.vehicles_measured, say("survey-count-measured", { count: counts.vehicles })],
      [counts.measurements, say("survey-count-measurements", { count: counts.measurements })],
    ],
    review: [
      [counts.to_review, STATE_WORDS.to_review],
      [counts.accepted, say("survey-count-accepted", { count: counts.accepted })],
      [counts.rejected, say("survey-count-rejected", { count: counts.rejected })],
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

/** Once for each person: what the demonstration is for is told along its pages. */
function TourOffer() {
  return (
    <Notice
      actions={
        <>
          <Button says="tour-take" small onClick={() => beginTour().catch(toastProblem)} />
          <Button says="tour-not-now" small kind="quiet" onClick={endTour} />
        </>
      }
    >
      {say("tour-offer")}
    </Notice>
  );
}
