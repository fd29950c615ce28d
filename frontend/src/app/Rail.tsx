import { Icon, type IconName, StateMark } from "../components";
import { say } from "../core/messages";
import { titleOf } from "../core/places";
import { survey } from "../core/survey";
import { RESULTS, resultAddress, stepState, WORK } from "../core/work";

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

const RESULT_ICONS: Record<(typeof RESULTS)[number]["name"], IconName> = {
  statistics: "chart",
  "sight-distance": "crest",
  studies: "sites",
  catalogue: "overview",
  audit: "audit",
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
        {RESULTS.map((entry) => (
          <li key={entry.name}>
            <a
              class="rail__item"
              href={resultAddress(entry, surveyId)}
              aria-current={entry.name === name ? "page" : undefined}
            >
              <Icon name={RESULT_ICONS[entry.name]} />
              <span class="grow">{entry.name === "audit" ? say("app-audit") : titleOf(entry.name)}</span>
            </a>
          </li>
        ))}
      </ul>
    </nav>
  );
}
