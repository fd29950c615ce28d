/** What is set for a survey, a part each with the button that changes it. */
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { Button, Loading, PageHead, Panel } from "../../components";
import { type PlainKey, say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { may } from "../../core/session";
import { survey as openSurvey } from "../../core/survey";
import type { Survey } from "../../core/types";
import { formatLength } from "../../core/units";
import { INSET_NAMES, INSET_WORDS } from "../../core/words";
import { ClassesDialog } from "./ClassesDialog";
import { EditSurvey } from "./EditSurvey";
import { MembersDialog } from "./MembersDialog";
import { Photographs } from "./Photographs";
import { SampleSection } from "./SampleSection";
import { SamplingDialog } from "./SamplingDialog";
import { askedWords, placeWords, trafficWords } from "./words";
import "./survey.css";

type Changing = "survey" | "sample" | "classes" | "members";

export default function SettingsScreen({ surveyId }: ScreenProps) {
  const [changing, setChanging] = useState<Changing | null>(null);
  const survey = openSurvey.value;
  if (!survey || survey.id !== surveyId) return <Loading what={say("survey-loading")} />;
  const close = () => setChanging(null);
  const edit = may("operator") ? () => setChanging("survey") : null;
  return (
    <div class="page">
      <PageHead says="page-settings" lead={say("settings-lead")} />
      <Part says="settings-site" change={edit} action="survey-edit">
        <p>{[survey.name, survey.site, survey.description].filter(Boolean).join("  ·  ")}</p>
        <p class="muted">{placeWords(survey.place)}</p>
        <p>{trafficWords(survey.traffic) || say("settings-traffic-unsaid")}</p>
        <p>{askedWords(survey.asked)}</p>
        <h3>{say("survey-insets")}</h3>
        <Insets survey={survey} />
      </Part>
      <SampleSection
        key={`${survey.id}.${survey.version}`}
        survey={survey}
        edit={() => setChanging("sample")}
      />
      <Part says="settings-members" change={() => setChanging("members")} action="members-open">
        <p>{say("settings-members-lead")}</p>
      </Part>
      <Part
        says="settings-classes"
        change={may("operator") ? () => setChanging("classes") : null}
        action="classes-open"
      >
        <p>{say("settings-classes-lead")}</p>
      </Part>
      <Part
        says="statistics-standards-title"
        href={`/statistics?survey=${survey.id}#standards`}
        action="settings-standards-open"
      >
        <p>{say("settings-standards-lead")}</p>
      </Part>
      <Photographs surveyId={survey.id} />
      {changing === "survey" && <EditSurvey survey={survey} close={close} />}
      {changing === "sample" && <SamplingDialog survey={survey} close={close} />}
      {changing === "members" && <MembersDialog surveyId={survey.id} close={close} />}
      {changing === "classes" && <ClassesDialog survey={survey} close={close} />}
    </div>
  );
}

interface PartProps {
  says: PlainKey;
  action: PlainKey;
  /** Opens what changes it; null for who may only read. */
  change?: (() => void) | null;
  href?: string;
  children: ComponentChildren;
}

function Part({ says, action, change, href, children }: PartProps) {
  const way = (change || href) && <Button says={action} small href={href} onClick={change ?? undefined} />;
  return (
    <Panel says={says} aside={way}>
      <div class="panel__body stack">{children}</div>
    </Panel>
  );
}

function Insets({ survey }: { survey: Survey }) {
  return (
    <table class="table settings-insets">
      <tbody>
        {INSET_NAMES.map((name) => {
          const { inset_m, u_inset_m } = survey.insets[name];
          return (
            <tr key={name}>
              <th scope="row">{INSET_WORDS[name]}</th>
              <td class="num">
                {say("settings-inset", { inset: formatLength(inset_m, 2), u: formatLength(u_inset_m, 2) })}
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
