import { Problem } from "../../components";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { lengthUnit } from "../../core/units";

/** What came out of a survey's accepted heights, in the sentences that its report opens with. */
export function Conclusion({ surveyId, of }: { surveyId: number; of: unknown }) {
  const unit = lengthUnit.value;
  const found = useAsked(
    "GET /surveys/{survey_id}/conclusion",
    { survey_id: surveyId, unit },
    { keep: true, also: [of] },
  );
  if (!found.data) return <Problem error={found.error} again={found.reload} />;
  const [, ...rest] = found.data.sentences; // how many there are stands above
  return (
    <section
      class="panel panel__body stat-conclusion"
      aria-label={say("results-conclusion")}
      data-testid="conclusion"
    >
      <ul>
        {rest.map((one) => (
          <li key={one}>{one}</li>
        ))}
      </ul>
    </section>
  );
}
