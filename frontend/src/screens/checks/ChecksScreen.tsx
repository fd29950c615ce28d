/** What a survey's own vehicles say of its insets and of its road poses, and heights computed again. */
import { Loading, Segments } from "../../components";
import { query, setQuery } from "../../core/address";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { survey as openSurvey } from "../../core/survey";
import { AdjustTab } from "./AdjustTab";
import { AgainTab } from "./AgainTab";
import { InsetsTab } from "./InsetsTab";
import { LotsTab } from "./LotsTab";
import { TrafficTab } from "./TrafficTab";
import "./checks.css";

type Tab = "insets" | "traffic" | "adjust" | "again" | "lots";
const TABS: readonly string[] = ["traffic", "adjust", "again", "lots"];

const LEADS = {
  insets: "checks-lead",
  traffic: "checks-lead",
  adjust: "adjust-lead",
  again: "computing-lead",
  lots: "lots-lead",
} as const;

export default function ChecksScreen({ surveyId }: ScreenProps) {
  const asked = query.value.get("tab") ?? "";
  const tab = (TABS.includes(asked) ? asked : "insets") as Tab;
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what={say("checks-loading")} />;
  return (
    <div class={`page checks checks--${tab}`}>
      <header class="page__head">
        <div>
          <h1>{say("page-checks")}</h1>
          <p class="page__lead">{say(LEADS[tab])}</p>
        </div>
        <Segments
          label={say("checks-which")}
          value={tab}
          options={[
            { value: "insets", label: say("checks-insets") },
            { value: "traffic", label: say("checks-direction") },
            { value: "adjust", label: say("adjust-tab") },
            { value: "again", label: say("checks-again") },
            { value: "lots", label: say("lots-tab") },
          ]}
          onChange={(value) =>
            setQuery({ tab: value === "insets" ? null : value, computing: null, lot: null })
          }
        />
      </header>
      {tab === "insets" && <InsetsTab survey={survey} />}
      {tab === "traffic" && <TrafficTab surveyId={surveyId} />}
      {tab === "adjust" && <AdjustTab surveyId={surveyId} />}
      {tab === "again" && <AgainTab surveyId={surveyId} />}
      {tab === "lots" && <LotsTab surveyId={surveyId} />}
    </div>
  );
}
