import { Icon, type IconName, StateMark } from "../components";
import { say } from "../core/messages";
import { type PlaceName, titleOf } from "../core/places";
import { survey } from "../core/survey";
import { type EntryName, groupsOf, holds, stepState } from "../core/work";

const ICONS: Record<EntryName, IconName> = {
  survey: "overview",
  planning: "search",
  camera: "camera",
  recordings: "film",
  pose: "road",
  measure: "ruler",
  scans: "scan",
  review: "review",
  checks: "check",
  statistics: "chart",
  export: "package",
  history: "audit",
  settings: "settings",
};

/** The pages of a survey beside the quiet screens, in groups: each step of the work with its state. */
export function Rail({ surveyId, name }: { surveyId: number; name: PlaceName }) {
  return (
    <nav class="rail" aria-label={say("app-work")}>
      {groupsOf(survey.value, name).map((group) => (
        <section key={group.key} class={`rail__${group.key}`}>
          {group.key !== "overview" && group.key !== "aside" && (
            <h2 class="rail__group">{say(`rail-${group.key}`)}</h2>
          )}
          <ul>
            {group.entries.map((entry) => {
              const state = stepState(survey.value, entry.step);
              return (
                <li key={entry.name}>
                  <a
                    class="rail__item"
                    href={entry.address(surveyId)}
                    aria-current={holds(entry, name) ? "page" : undefined}
                  >
                    <Icon name={ICONS[entry.name]} />
                    <span class="grow">{titleOf(entry.name)}</span>
                    {state && <StateMark state={state} hideWord />}
                  </a>
                </li>
              );
            })}
          </ul>
        </section>
      ))}
    </nav>
  );
}
