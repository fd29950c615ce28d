import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import {
  Button,
  Empty,
  JobProgress,
  Loading,
  Notice,
  PageHead,
  Problem,
  Progress,
  StateMark,
} from "../../components";
import { linkTo, Said } from "../../components/Said";
import { isOver } from "../../core/jobs";
import { say, sentenceOf, sentencesOf } from "../../core/messages";
import { useAsked, useEvery } from "../../core/resource";
import { may, me } from "../../core/session";
import { formatDay } from "../../core/times";
import type { Job, Survey } from "../../core/types";
import { NewSurvey } from "./NewSurvey";
import { OwnName } from "./OwnName";
import "./surveys.css";

/** Home: every survey with its progress. While the demonstration survey is being made, its card shows how far it is. */
export default function SurveysScreen() {
  const surveys = useAsked("GET /surveys");
  const jobs = useAsked("GET /jobs");
  // newest first: the last try to make the demonstration survey is the one that counts
  const lastDemo = jobs.data?.find((job) => job.kind === "demonstration") ?? null;
  const underWay = lastDemo !== null && !isOver(lastDemo);
  useEvery(underWay ? 1000 : null, async () => {
    await jobs.reload();
    await surveys.reload(); // after the job, so that its survey is not missed when it ends
  });

  if (surveys.error && !surveys.data) {
    return (
      <div class="page page--alone">
        <Problem error={surveys.error} again={surveys.reload} />
      </div>
    );
  }
  if (!surveys.data) return <Loading what={say("surveys-loading")} />;
  return (
    <SurveyList surveys={surveys.data} lastDemo={lastDemo}>
      <Problem error={surveys.error} again={surveys.reload} />
    </SurveyList>
  );
}

interface SurveyListProps {
  surveys: readonly Survey[];
  lastDemo: Job | null;
  children: ComponentChildren;
}

function SurveyList({ surveys, lastDemo, children }: SurveyListProps) {
  const [making, setMaking] = useState(false);
  const make = () => setMaking(true);
  const demoJob = lastDemo && !isOver(lastDemo) ? lastDemo : null;
  const demo = surveys.find((survey) => survey.is_demo) ?? null;
  const simulated = surveys.filter((survey) => survey.simulated && !survey.is_demo);
  const listed = surveys.filter((survey) => !simulated.includes(survey) && !(demoJob && survey.is_demo));
  const nothing = surveys.length === 0 && !demoJob;
  const onlyDemo = surveys.every((survey) => survey.is_demo);
  return (
    <div class="page page--alone">
      <PageHead says="page-surveys" lead={!nothing && say("surveys-lead")}>
        {!nothing && may("operator") && <AddSurvey primary={!onlyDemo} make={make} />}
      </PageHead>
      <OwnName />
      {me.value?.needs_password && <ChoosePassword />}
      {children}
      {lastDemo?.state === "failed" && !demo && (
        <Notice kind="problem">{sentenceOf(lastDemo.error) ?? say("surveys-demo-failed")}</Notice>
      )}
      {nothing ? <NoSurvey make={make} /> : <Cards demoJob={demoJob} surveys={listed} />}
      {simulated.length > 0 && <Simulated surveys={simulated} />}
      {onlyDemo && demo && may("operator") && <p class="muted">{say("surveys-demo-first")}</p>}
      {making && <NewSurvey close={() => setMaking(false)} />}
    </div>
  );
}

function AddSurvey({ primary, make }: { primary: boolean; make: () => void }) {
  return <Button says="surveys-new" kind={primary ? "primary" : "plain"} icon="add" onClick={make} />;
}

function ChoosePassword() {
  const toAccount = <Button says="surveys-choose-password" small href="/account" />;
  return <Notice actions={toAccount}>{say("surveys-link-used")}</Notice>;
}

function Cards({ demoJob, surveys }: { demoJob: Job | null; surveys: readonly Survey[] }) {
  return (
    <ul class="grid grid--fill" style={{ "--least": "400px" }}>
      {demoJob && (
        <li>
          <DemoCard job={demoJob} />
        </li>
      )}
      {surveys.map((survey) => (
        <li key={survey.id}>
          <SurveyCard survey={survey} />
        </li>
      ))}
    </ul>
  );
}

/** Surveys that were never filmed stand below those that were. */
function Simulated({ surveys }: { surveys: readonly Survey[] }) {
  return (
    <details class="panel panel__body" data-testid="simulated">
      <summary>{say("surveys-simulated", { count: surveys.length })}</summary>
      <p class="muted small">
        <Said what="surveys-simulated-help" parts={linkTo("/studies")} />
      </p>
      <ul>
        {surveys.map((survey) => (
          <li key={survey.id}>
            <a href={`/surveys/${survey.id}`}>{survey.name}</a>
          </li>
        ))}
      </ul>
    </details>
  );
}

function NoSurvey({ make }: { make: () => void }) {
  const demoId = me.value?.demo_survey_id ?? null;
  return (
    <Empty
      panel
      says="surveys-none-title"
      why={may("operator") ? "surveys-none-make" : "surveys-none"}
      actions={
        <>
          {demoId !== null && <Button says="surveys-demo-open" kind="primary" href={`/surveys/${demoId}`} />}
          {may("operator") && (
            <Button
              says="surveys-new"
              kind={demoId === null ? "primary" : "plain"}
              icon="add"
              onClick={make}
            />
          )}
        </>
      }
    />
  );
}

/** One survey: how far the work has come, and what is next. */
export function SurveyCard({ survey }: { survey: Survey }) {
  const { counts } = survey;
  const next = survey.steps.find((step) => step.state === "next");
  const { scans } = survey;
  const reviewed = counts.accepted + counts.rejected;
  const scanned = scans.accepted + scans.rejected;
  const inScans = scans.heights_to_review + scans.heights_accepted + scans.heights_rejected;
  const made = { recordings: counts.recordings, day: formatDay(survey.created_at) };
  const parts = { made: (text: string) => <span title={survey.created_at}>{text}</span> };
  return (
    <article class="stack stack--tight panel card">
      <header class="row row--apart row--far">
        <h2 class="anywhere">
          <a href={`/surveys/${survey.id}`} class="card__link">
            {survey.name}
          </a>
        </h2>
        {survey.is_demo && <span class="badge">{say("survey-demonstration")}</span>}
      </header>
      <p class="muted">
        {survey.site ? (
          <Said what="surveys-card-with-site" values={{ site: survey.site, ...made }} parts={parts} />
        ) : (
          <Said what="surveys-card" values={made} parts={parts} />
        )}
      </p>
      <div class="grid card__bars">
        <Tally
          label={say("surveys-vehicles-measured")}
          done={counts.vehicles_measured}
          of={counts.vehicles}
        />
        <Tally
          label={say("surveys-heights-reviewed", { scans: inScans })}
          done={reviewed}
          of={reviewed + counts.to_review}
        />
        {scans.scans > 0 && (
          <Tally label={say("surveys-scans-reviewed")} done={scanned} of={scanned + scans.to_review} />
        )}
      </div>
      <footer>
        {next ? (
          <StateMark state="next" word={sentencesOf(next.summary)} />
        ) : scans.state === "open" ? (
          <StateMark state="next" word={say("surveys-scans", { summary: sentencesOf(scans.summary) })} />
        ) : (
          <StateMark state="done" word={say("surveys-all-done")} />
        )}
      </footer>
    </article>
  );
}

function Tally({ label, done, of }: { label: string; done: number; of: number }) {
  const share = of > 0 ? done / of : 0;
  return (
    <Progress
      still
      value={share}
      label={label}
      figure={<Said what="surveys-tally" values={{ done, all: of }} />}
    />
  );
}

function DemoCard({ job }: { job: Job }) {
  return (
    <article class="stack stack--tight panel card">
      <header class="row row--apart row--far">
        <h2>{say("surveys-demo-title")}</h2>
        <span class="badge">{say("surveys-demo-being-made")}</span>
      </header>
      <p class="muted">{say("surveys-demo-wait")}</p>
      <JobProgress job={job} />
    </article>
  );
}
