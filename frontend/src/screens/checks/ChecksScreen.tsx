/** What a survey's own vehicles say of its insets and of its road poses, and heights computed again. */
import { Loading, PageHead } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { query } from "../../core/address";
import { say, wordsOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { survey as openSurvey } from "../../core/survey";
import { CHECKS, type Check, checksTabs } from "../../core/tabs";
import { AdjustTab } from "./AdjustTab";
import { AgainTab } from "./AgainTab";
import { InsetsTab } from "./InsetsTab";
import { TrafficTab } from "./TrafficTab";
import "./checks.css";

const LEADS: Readonly<Record<Check, string>> = wordsOf({
  insets: "checks-lead",
  traffic: "checks-lead",
  adjust: "adjust-lead",
  again: "computing-lead",
});

export default function ChecksScreen({ surveyId }: ScreenProps) {
  const asked = query.value.get("tab") ?? "";
  const tab = CHECKS.find((one) => one === asked) ?? "insets";
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what={say("checks-loading")} />;
  return (
    <div class={`page checks checks--${tab}`}>
      <PageHead says="page-checks" lead={LEADS[tab]} />
      <PageTabs label={say("page-checks")} tabs={checksTabs(surveyId, tab)} />
      {tab === "insets" && <InsetsTab survey={survey} />}
      {tab === "traffic" && <TrafficTab surveyId={surveyId} />}
      {tab === "adjust" && <AdjustTab surveyId={surveyId} />}
      {tab === "again" && <AgainTab surveyId={surveyId} />}
    </div>
  );
}
