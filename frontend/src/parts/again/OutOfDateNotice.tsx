/** Says, where results are looked at, that stored heights follow from facts that no longer hold. */
import { useEffect } from "preact/hooks";
import { Button, Notice } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { survey } from "../../core/survey";
import { causesInWords } from "./words";

export function OutOfDateNotice({ surveyId }: { surveyId: number }) {
  const read = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/computings", { survey_id: surveyId }, { signal }),
    [surveyId],
  );
  // whoever changes an inset or a pose has the survey read again
  useEffect(() => void read.reload(), [survey.value]);
  const stale = read.data?.out_of_date;
  if (!stale || stale.heights === 0) return null;
  return (
    <Notice
      kind="warning"
      actions={
        <Button small href={`/surveys/${surveyId}/checks?tab=again`}>
          {say("computing-look")}
        </Button>
      }
    >
      {say("computing-stale", { count: stale.heights, causes: causesInWords(stale.causes) })}
    </Notice>
  );
}
