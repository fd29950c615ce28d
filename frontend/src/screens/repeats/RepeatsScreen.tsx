/** What clicking again shows: per target and per person, beside what the budgets claim. */
import { Button, Empty, Loaded, PageHead, Problem } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { checksTabs } from "../../core/tabs";
import type { PersonRepeats } from "../../core/types";
import { AnchoringPanel } from "./AnchoringPanel";
import { DifferenceFigure } from "./DifferenceFigure";
import { PeopleTable } from "./PeopleTable";
import { TargetTable } from "./TargetTable";
import "./repeats.css";

export default function RepeatsScreen({ surveyId }: ScreenProps) {
  const found = useAsked("GET /surveys/{survey_id}/repeats", { survey_id: surveyId });
  const plan = useAsked("GET /surveys/{survey_id}/review-plan", { survey_id: surveyId });
  const { busy, problem, run } = useAction();
  const choose = (person: PersonRepeats, own: boolean) =>
    run(async () => {
      await api.write(
        "PUT /surveys/{survey_id}/people/{person_id}/click-sigma",
        { survey_id: surveyId, person_id: person.person.id },
        { body: { own } },
      );
      await found.reload();
    });
  const data = found.data;
  return (
    <div class="page">
      <PageHead says="page-repeats" lead={say("repeats-lead", { people: data?.people.length ?? 0 })}>
        {canWork.value && data !== null && data.repeats > 0 && <Again surveyId={surveyId} />}
      </PageHead>
      <PageTabs label={say("page-checks")} tabs={checksTabs(surveyId, "repeats")} />
      <Problem error={problem} />
      <Loaded of={found} what={say("repeats-loading")} />
      <Problem error={plan.error} again={plan.reload} />
      {data && data.repeats === 0 && plan.data && (
        <Nothing surveyId={surveyId} oneIn={plan.data.blind_one_in} />
      )}
      {data && data.repeats > 0 && (
        <>
          <TargetTable found={data} />
          <PeopleTable people={data.people} busy={busy} choose={choose} />
          {data.differences.length > 0 && <DifferenceFigure differences={data.differences} />}
          {data.not_compared > 0 && (
            <p class="small muted">{say("repeats-not-compared", { count: data.not_compared })}</p>
          )}
        </>
      )}
      {data && <AnchoringPanel surveyId={surveyId} />}
    </div>
  );
}

function Again({ surveyId }: { surveyId: number }) {
  const path = `/surveys/${surveyId}/repeats/click`;
  return (
    <div class="row row--wrap">
      <Button says="repeats-click-mine" kind="primary" href={path} />
      <Button says="repeats-click-anybodys" href={`${path}?of=all`} />
    </div>
  );
}

function Nothing({ surveyId, oneIn }: { surveyId: number; oneIn: number }) {
  return (
    <Empty
      says="repeats-none-title"
      actions={
        <>
          {canWork.value && <Again surveyId={surveyId} />}
          <Button says="repeats-to-review" href={`/surveys/${surveyId}/review`} />
        </>
      }
    >
      <p>{say("repeats-none", { one_in: oneIn })}</p>
      <p>{say("repeats-no-result")}</p>
    </Empty>
  );
}
