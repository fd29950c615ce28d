/** What a survey's own vehicles say of its insets and of its road poses. */
import { Loading, Segments } from "../../components";
import { query, setQuery } from "../../core/address";
import type { ScreenProps } from "../../core/places";
import { survey as openSurvey } from "../../core/survey";
import { InsetsTab } from "./InsetsTab";
import { TrafficTab } from "./TrafficTab";
import "./checks.css";

type Tab = "insets" | "traffic";

const TABS: { value: Tab; label: string }[] = [
  { value: "insets", label: "Insets" },
  { value: "traffic", label: "Direction of travel" },
];

export default function ChecksScreen({ surveyId }: ScreenProps) {
  const tab: Tab = query.value.get("tab") === "traffic" ? "traffic" : "insets";
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what="the checks" />;
  return (
    <div class={`page checks checks--${tab}`}>
      <header class="page__head">
        <div>
          <h1>Checks</h1>
          <p class="page__lead">What the vehicles themselves say of the insets and of the road’s axes.</p>
        </div>
        <Segments
          label="Check"
          value={tab}
          options={TABS}
          onChange={(value) => setQuery({ tab: value === "insets" ? null : value })}
        />
      </header>
      {tab === "insets" ? <InsetsTab survey={survey} /> : <TrafficTab surveyId={surveyId} />}
    </div>
  );
}
