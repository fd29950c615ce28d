/** What clicking again shows: per target and per person, beside what the budgets claim. */
import { useState } from "preact/hooks";
import { Button, Empty, Loading, Problem } from "../../components";
import { api } from "../../core/api";
import type { ScreenProps } from "../../core/places";
import { useResource } from "../../core/resource";
import { canWork } from "../../core/session";
import { toastProblem } from "../../core/toasts";
import type { PersonRepeats } from "../../core/types";
import { plural } from "../../core/units";
import { DifferenceFigure } from "./DifferenceFigure";
import { PeopleTable } from "./PeopleTable";
import { TargetTable } from "./TargetTable";
import "./repeats.css";

export default function RepeatsScreen({ surveyId }: ScreenProps) {
  const found = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/repeats", { survey_id: surveyId }, { signal }),
    [surveyId],
  );
  const [busy, setBusy] = useState(false);
  const choose = async (person: PersonRepeats, own: boolean): Promise<void> => {
    setBusy(true);
    try {
      await api.write(
        "PUT /surveys/{survey_id}/people/{person_id}/click-sigma",
        { survey_id: surveyId, person_id: person.person.id },
        { body: { own } },
      );
      await found.reload();
    } catch (error) {
      toastProblem(error);
    } finally {
      setBusy(false);
    }
  };
  const data = found.data;
  return (
    <div class="page">
      <header class="page__head">
        <div>
          <h1>Repeats</h1>
          <p class="page__lead">
            The same targets clicked again without seeing the first clicks: how far a person comes out beside
            themselves, and how far two people beside each other.
          </p>
        </div>
        {canWork.value && data !== null && data.repeats > 0 && <Again surveyId={surveyId} />}
      </header>
      <Problem error={found.error} again={found.reload} />
      {!data && found.loading && <Loading what="the repeats" />}
      {data && data.repeats === 0 && <Nothing surveyId={surveyId} />}
      {data && data.repeats > 0 && (
        <>
          <TargetTable found={data} />
          <PeopleTable people={data.people} busy={busy} choose={choose} />
          {data.differences.length > 0 && <DifferenceFigure differences={data.differences} />}
          {data.not_compared > 0 && (
            <p class="small muted">
              {plural(data.not_compared, "repeat")} with another road pose or inset, or without a height: in
              none of these figures.
            </p>
          )}
        </>
      )}
    </div>
  );
}

function Again({ surveyId }: { surveyId: number }) {
  const path = `/surveys/${surveyId}/repeats/click`;
  return (
    <div class="row row--wrap">
      <Button kind="primary" href={path}>
        Click 10 of mine again
      </Button>
      <Button href={`${path}?of=all`}>Click 10 of anybody’s again</Button>
    </div>
  );
}

function Nothing({ surveyId }: { surveyId: number }) {
  return (
    <Empty
      title="Nothing was clicked again yet"
      actions={
        <>
          {canWork.value && <Again surveyId={surveyId} />}
          <Button href={`/surveys/${surveyId}/review`}>Go to the review</Button>
        </>
      }
    >
      <p>
        Repeats come from two places: click a random ten again here, each without its points, or review with
        “1 in 5 blind”, where you click before you see. Ten repeats of your own give you a click sigma of your
        own; repeats of other people’s work tell how far people differ.
      </p>
      <p>Repeats stand in no list and change no result.</p>
    </Empty>
  );
}
