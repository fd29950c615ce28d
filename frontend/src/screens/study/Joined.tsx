import { Button, DataTable, Panel } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { Study, StudyResult } from "../../core/types";
import { formatSmall } from "../../core/units";

interface Props {
  study: Study;
  result: StudyResult | null;
  edit: (() => void) | undefined;
  remove: (() => void) | undefined;
}

export function Joined({ study, result, edit, remove }: Props) {
  const counted = new Map(result?.found.packages.map((one) => [one.place, one]));
  const countOf = ({ survey_id }: Study["surveys"][number]) => counted.get(`survey ${survey_id}`);
  return (
    <Panel
      says="study-joined"
      aside={
        <div class="row">
          {remove && <Button says="study-remove" small kind="quiet" icon="trash" onClick={remove} />}
          {edit && <Button says="study-edit" small onClick={edit} />}
        </div>
      }
      data-testid="study-joined"
    >
      {study.surveys.length > 0 && (
        <DataTable
          label={say("study-joined")}
          rows={study.surveys}
          keyOf={(one) => one.survey_id}
          columns={({ col, num, rowHead, actions }) => [
            rowHead(say("study-survey"), (one) => <a href={`/surveys/${one.survey_id}`}>{one.name}</a>),
            col(say("study-site"), (one) => one.site),
            col(say("study-stratum"), (one) => one.stratum || "–"),
            col(say("study-year"), (one) => one.year ?? "–"),
            num(say("study-counted"), (one) => countOf(one)?.counted ?? "–"),
            num(say("study-outside"), (one) => countOf(one)?.out_of_sample ?? "–"),
            actions(say("page-statistics"), (one) => (
              <a href={`/statistics?survey=${one.survey_id}`}>{say("page-statistics")}</a>
            )),
          ]}
        />
      )}
      <div class="stat-notes small">
        <p>{say(study.fleet_csv ? "study-weighted" : "study-not-weighted")}</p>
        <p>{say(study.sites_csv ? "study-sites-known" : "study-sites-unknown")}</p>
        <p>{say("study-goal-is", { goal: formatSmall(study.goal_m) })}</p>
        {result?.found.notes.map(sentenceOf).map((note) => (
          <p key={note}>{note}</p>
        ))}
      </div>
    </Panel>
  );
}
