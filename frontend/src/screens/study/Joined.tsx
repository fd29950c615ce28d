import { Button, num, Panel, Table } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { Study, StudyResult } from "../../core/types";
import { formatSmall } from "../../core/units";

interface Props {
  study: Study;
  result: StudyResult | null;
  edit: (() => void) | undefined;
  remove: (() => void) | undefined;
}

/** The surveys of a study with what they brought, its fleet and its goal. */
export function Joined({ study, result, edit, remove }: Props) {
  const counted = new Map(result?.found.packages.map((one) => [one.place, one]));
  return (
    <Panel
      says="study-joined"
      aside={
        <div class="row">
          {remove && (
            <Button small kind="quiet" icon="trash" onClick={remove}>
              {say("study-remove")}
            </Button>
          )}
          {edit && (
            <Button small onClick={edit}>
              {say("study-edit")}
            </Button>
          )}
        </div>
      }
      data-testid="study-joined"
    >
      {study.surveys.length > 0 && (
        <Table
          label={say("study-joined")}
          heads={[
            say("study-survey"),
            say("study-site"),
            say("study-stratum"),
            say("study-year"),
            num(say("study-counted")),
            num(say("study-outside")),
            <span class="visually-hidden">{say("page-statistics")}</span>,
          ]}
        >
          {study.surveys.map((one) => {
            const row = counted.get(`survey ${one.survey_id}`);
            return (
              <tr key={one.survey_id}>
                <th scope="row">
                  <a href={`/surveys/${one.survey_id}`}>{one.name}</a>
                </th>
                <td>{one.site}</td>
                <td>{one.stratum || "–"}</td>
                <td>{one.year ?? "–"}</td>
                <td class="num">{row?.counted ?? "–"}</td>
                <td class="num">{row?.out_of_sample ?? "–"}</td>
                <td>
                  <a href={`/statistics?survey=${one.survey_id}`}>{say("page-statistics")}</a>
                </td>
              </tr>
            );
          })}
        </Table>
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
