import { Problem, StateMark } from "../../components";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { formatMoment } from "../../core/times";
import type { History } from "../../core/types";
import { heightWords } from "../../core/words";
import "./vehicle.css";

function reviewWords({ reviewer, reason }: History["reviews"][number]): string {
  const person = reviewer?.name ?? "";
  return reason ? say("revisions-review", { person, reason }) : person;
}

export function Revisions({ id, revision }: { id: number; revision: number }) {
  const { data: history, error } = useAsked(
    "GET /measurements/{measurement_id}/history",
    { measurement_id: id },
    { keep: true, also: [revision] },
  );
  if (error) return <Problem error={error} />;
  if (!history) return null;
  return (
    <div class="revisions small">
      <p>
        <strong>{say("revisions-title")}</strong>
      </p>
      <ol>
        {[...history.revisions].reverse().map((m) => (
          <li key={m.revision}>
            <span class="revisions__line">
              <span class="muted">{m.revision}</span>
              <span class="grow">{heightWords(m)}</span>
            </span>
            <span class="revisions__who muted">
              {m.computing_id !== null && `${say("revisions-computed-again")} `}
              {say("revisions-who", {
                person: m.created_by?.name ?? say("person-unknown"),
                time: formatMoment(m.created_at),
              })}
            </span>
            {history.reviews
              .filter((review) => review.revision === m.revision)
              .map((review) => (
                <span key={review.id} class="revisions__review">
                  <StateMark state={review.verdict} /> {reviewWords(review)}
                </span>
              ))}
          </li>
        ))}
      </ol>
    </div>
  );
}
