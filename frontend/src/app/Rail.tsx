import { Icon, type IconName, StateMark } from "../components";
import { say } from "../core/messages";
import { titleOf } from "../core/places";
import { survey } from "../core/survey";
import { stepState, WORK } from "../core/work";

const ICONS: Record<(typeof WORK)[number]["name"], IconName> = {
  survey: "overview",
  planning: "search",
  camera: "camera",
  recordings: "film",
  pose: "road",
  measure: "ruler",
  checks: "check",
  review: "review",
  repeats: "retry",
  scans: "scan",
  export: "package",
};

/** The order of work beside the quiet screens: each step with its state. */
export function Rail({ surveyId, name }: { surveyId: number; name: string }) {
  return (
    <nav class="rail" aria-label={say("app-work")}>
      <ul>
        {WORK.map((entry) => {
          const state = stepState(survey.value, entry.step);
          return (
            <li key={entry.name}>
              <a
                class="rail__item"
                href={`/surveys/${surveyId}${entry.path}`}
                aria-current={entry.name === name ? "page" : undefined}
              >
                <Icon name={ICONS[entry.name]} />
                <span class="grow">{titleOf(entry.name)}</span>
                {state && <StateMark state={state} hideWord />}
              </a>
            </li>
          );
        })}
      </ul>
      <div class="rail__sep" />
      <ul>
        <li>
          <a class="rail__item" href={`/statistics?survey=${surveyId}`}>
            <Icon name="chart" />
            <span class="grow">{titleOf("statistics")}</span>
          </a>
        </li>
        <li>
          <a class="rail__item" href={`/sight-distance?survey=${surveyId}`}>
            <Icon name="crest" />
            <span class="grow">{titleOf("sight-distance")}</span>
          </a>
        </li>
        <li>
          <a class="rail__item" href="/catalogue">
            <Icon name="overview" />
            <span class="grow">{titleOf("catalogue")}</span>
          </a>
        </li>
        <li>
          <a class="rail__item" href={`/audit?survey_id=${surveyId}`}>
            <Icon name="audit" />
            <span class="grow">{say("app-audit")}</span>
          </a>
        </li>
      </ul>
    </nav>
  );
}
