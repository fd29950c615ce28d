import { useEffect } from "preact/hooks";
import { choices, Loaded, Loading, Notice, PageHead, Problem, Segments } from "../../components";
import { current, query, setQuery } from "../../core/address";
import { say, wordsOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useResource } from "../../core/resource";
import { Advice } from "./Advice";
import { PlanFigure } from "./Figures";
import { LineRate } from "./LineRate";
import type { Plan } from "./model";
import { PassingTable } from "./PassingTable";
import { PlanForm } from "./PlanForm";
import { SiteAbove, SiteAlong } from "./SiteDrawing";
import { TargetTable } from "./TargetTable";
import { askPlan, completed, sheetAddress, type Values, valuesOf } from "./values";
import "./planning.css";

type What = "heights" | "lines";

/** Before going out: what heights and speeds will be worth from a place, and what to do about it. */
export default function PlanningScreen({ surveyId }: ScreenProps) {
  const what: What = query.value.get("plan") === "lines" ? "lines" : "heights";
  return (
    <div class="page">
      <PageHead
        says="page-planning"
        lead={
          <>
            {say(what === "heights" ? "planning-lead-heights" : "planning-lead-lines")}{" "}
            {say("planning-nothing-stored")}
          </>
        }
      >
        <Segments<What>
          says="planning-what"
          value={what}
          options={choices(wordsOf("planning-what-", "heights", "lines"))}
          onInput={(next) => setQuery({ plan: next === "lines" ? next : null })}
        />
      </PageHead>
      {what === "heights" ? <Heights surveyId={surveyId} /> : <LineRate surveyId={surveyId} />}
    </div>
  );
}

function Heights({ surveyId }: { surveyId: number }) {
  const cameras = useAsked("GET /surveys/{survey_id}/cameras", { survey_id: surveyId });
  const list = cameras.data;
  const values = list && completed(valuesOf(query.value), list);
  const address = JSON.stringify(values);
  useEffect(() => {
    // a link copied from the address bar holds every value, also after a link to this page took them away
    if (values && current.value?.place.name === "planning") setQuery({ ...values });
  }, [address, query.value]);
  return (
    <>
      <Problem error={cameras.error} again={cameras.reload} />
      {values ? (
        <>
          <PlanForm cameras={list} values={values} />
          <p>
            <a href={sheetAddress(surveyId, values)} target="_blank" rel="noopener">
              {say("planning-sheet")}
            </a>
          </p>
          <Planned surveyId={surveyId} values={values} />
        </>
      ) : (
        !cameras.error && <Loading what={say("planning-loading-cameras")} />
      )}
    </>
  );
}

/** What the server makes of the values; what it says last stays until the next answer is there. */
function Planned({ surveyId, values }: { surveyId: number; values: Values }) {
  const plan = useResource(
    (signal) => askPlan(surveyId, values, signal),
    [surveyId, JSON.stringify(values)],
    { keep: true },
  );
  if (plan.error || !plan.data) return <Loaded of={plan} what={say("planning-loading")} />;
  return <Result plan={plan.data} />;
}

function Result({ plan }: { plan: Plan }) {
  return (
    <>
      {!plan.camera.lens_known && (
        <Notice>
          {say(plan.camera.calibration_id === null ? "planning-lens-exact-plain" : "planning-lens-exact")}{" "}
          {say("planning-lens-calibrated")}
        </Notice>
      )}
      <TargetTable targets={plan.targets} travelM={plan.site.travel_m} />
      <Advice advice={plan.advice} />
      <PassingTable passing={plan.passing} />
      <div class="plan-figures">
        <SiteAlong plan={plan} />
        <PlanFigure plan={plan} of="distance" />
        <SiteAbove plan={plan} />
        <PlanFigure plan={plan} of="bias" />
      </div>
    </>
  );
}
