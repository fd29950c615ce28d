/** What a survey's own vehicles say of its insets and of its road poses. */
import { Loading, Segments } from "../../components";
import { query, setQuery } from "../../core/address";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { survey as openSurvey } from "../../core/survey";
import { InsetsTab } from "./InsetsTab";
import { TrafficTab } from "./TrafficTab";
import "./checks.css";

type Tab = "insets" | "traffic";

export default function ChecksScreen({ surveyId }: ScreenProps) {
  const tab: Tab = query.value.get("tab") === "traffic" ? "traffic" : "insets";
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what={say("checks-loading")} />;
  return (
    <div class={`page checks checks--${tab}`}>
      <header class="page__head">
        <div>
          <h1>{say("page-checks")}</h1>
          <p class="page__lead">{say("checks-lead")}</p>
        </div>
        <Segments
          label={say("checks-which")}
          value={tab}
          options={[
            { value: "insets", label: say("checks-insets") },
            { value: "traffic", label: say("checks-direction") },
          ]}
          onChange={(value) => setQuery({ tab: value === "insets" ? null : value })}
        />
      </header>
      {tab === "insets" ? <InsetsTab survey={survey} /> : <TrafficTab surveyId={surveyId} />}
    </div>
  );
}
