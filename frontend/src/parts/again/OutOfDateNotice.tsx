/** Says, wherever heights are shown, that stored ones follow from facts that no longer hold; computes them again. */
import { useEffect } from "preact/hooks";
import { Button, Notice, Problem } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { changes } from "../../core/survey";
import { useComputing } from "./computing";
import { stale } from "./stale";
import { causesInWords } from "./words";

interface NoticeProps {
  surveyId: number;
  /** What the page shows of heights is read anew once they were computed. */
  computed?: (() => Promise<unknown> | unknown) | undefined;
}

export function OutOfDateNotice({ surveyId, computed }: NoticeProps) {
  const where = { survey_id: surveyId };
  // whoever changes an inset, a side or a pose has the survey read again
  const read = useAsked("GET /surveys/{survey_id}/computings", where, { keep: true, also: [changes.value] });
  const work = useComputing(() => computed?.());
  const answered = read.data?.out_of_date;
  useEffect(() => {
    if (answered) stale.value = { surveyId, found: answered };
  }, [answered]);
  // from vehicle to vehicle it stands still while it is asked again
  const known = stale.value?.surveyId === surveyId ? stale.value.found : null;
  const found = answered ?? known;
  if (read.error) return <Problem error={read.error} again={read.reload} />;
  if (!found || found.heights === 0) return <Problem error={work.problem} />;
  return (
    <>
      <Problem error={work.problem} />
      <Notice
        kind="warning"
        actions={
          canWork.value && (
            <Button
              says="computing-start"
              small
              busy={work.underWay}
              onClick={() => void work.start(() => api.write("POST /surveys/{survey_id}/computings", where))}
            />
          )
        }
      >
        <span data-testid="out-of-date">
          {say("computing-stale", { count: found.heights, causes: causesInWords(found.causes) })}
        </span>{" "}
        <a href={`/surveys/${surveyId}/checks?tab=again`}>{say("computing-which")}</a>
      </Notice>
    </>
  );
}
