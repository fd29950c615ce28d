import { Icon, StateMark } from "../components";
import { survey } from "../state/survey";
import { stepState, WORK } from "./work";

/** The order of work beside the quiet screens: each step with its state. */
export function Rail({ surveyId, name }: { surveyId: number; name: string }) {
  return (
    <nav class="rail" aria-label="Order of work">
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
                <Icon name={entry.icon} />
                <span class="grow">{entry.title}</span>
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
            <span class="grow">Statistics</span>
          </a>
        </li>
        <li>
          <a class="rail__item" href={`/audit?survey_id=${surveyId}`}>
            <Icon name="audit" />
            <span class="grow">Audit trail</span>
          </a>
        </li>
      </ul>
    </nav>
  );
}
