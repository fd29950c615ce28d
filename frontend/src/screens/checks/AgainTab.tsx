/** Heights computed again: what is out of date, each time it was done, old beside new, and the undo of all. */
import { Button, DataTable, JobProgress, Loaded, Notice, Panel, Problem } from "../../components";
import { query, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { Computing, Computings } from "../../core/types";
import { formatCount, formatSmall } from "../../core/units";
import { useComputing } from "../../parts/again/computing";
import { causesInWords } from "../../parts/again/words";
import { ComputedHeightsPanel } from "./ComputedHeightsPanel";

const KINDS: Readonly<Record<Computing["kind"], string>> = wordsOf("computing-kind-");

export function AgainTab({ surveyId }: { surveyId: number }) {
  const where = { survey_id: surveyId };
  const read = useAsked("GET /surveys/{survey_id}/computings", where);
  const work = useComputing((job) => {
    if (job.state === "done") setQuery({ computing: null });
    return read.reload();
  });
  const start = () => work.start(() => api.write("POST /surveys/{survey_id}/computings", where));
  if (!read.data) return <Loaded of={read} what={say("computing-loading")} />;
  const { computings } = read.data;
  const wanted = Number(query.value.get("computing"));
  const shown = computings.find((one) => one.id === wanted) ?? computings[0];
  return (
    <>
      <Problem error={work.problem} />
      <Stale found={read.data} busy={work.underWay} start={start} />
      {work.job && (
        <JobProgress panel job={work.job} onCancel={work.job.progress < 0.9 ? work.cancel : undefined} />
      )}
      <Runs computings={computings} shown={shown?.id ?? 0} />
      {shown && (
        <ComputedHeightsPanel
          key={`${shown.id} ${shown.undone_by}`}
          surveyId={surveyId}
          computing={shown}
          busy={work.underWay}
          undo={() =>
            work.start(() => api.write("POST /computings/{computing_id}/undo", { computing_id: shown.id }))
          }
        />
      )}
    </>
  );
}

function Stale({ found, busy, start }: { found: Computings; busy: boolean; start(): Promise<unknown> }) {
  const stale = found.out_of_date;
  const button = canWork.value && (
    <Button
      says="computing-start"
      kind={stale.heights > 0 ? "primary" : undefined}
      busy={busy}
      onClick={() => void start()}
    />
  );
  return (
    <Notice kind={stale.heights > 0 ? "warning" : "info"} actions={button}>
      {stale.heights > 0
        ? say("computing-stale", { count: stale.heights, causes: causesInWords(stale.causes) })
        : say("computing-fine")}{" "}
      {stale.in_line_scans > 0 && say("computing-in-line-scans", { count: stale.in_line_scans })}{" "}
      {stale.waiting > 0 && say("computing-waiting", { count: stale.waiting })}{" "}
      {stale.other_program > 0 && say("computing-other-program", { count: stale.other_program })}
    </Notice>
  );
}

function Runs({ computings, shown }: { computings: readonly Computing[]; shown: number }) {
  return (
    <Panel says="computing-runs">
      {computings.length === 0 ? (
        <p class="panel__body muted">{say("computing-runs-none")}</p>
      ) : (
        <DataTable
          label={say("computing-runs")}
          scroll="again-runs"
          data-testid="computings"
          rows={computings}
          keyOf={(one) => one.id}
          rowAttributes={(one) => ({ "aria-current": one.id === shown ? "true" : undefined })}
          columns={({ col, num, actions }) => [
            col(say("computing-when"), (one) => formatMoment(one.created_at), "nowrap"),
            col(say("computing-who"), (one) => one.created_by?.name),
            col(say("computing-kind"), (one) => (
              <>
                {KINDS[one.kind]}{" "}
                {one.undone_by !== null && <span class="badge">{say("computing-undone")}</span>}
              </>
            )),
            num(say("computing-heights"), (one) => formatCount(one.heights)),
            num(say("computing-to-review"), (one) => formatCount(one.to_review)),
            num(say("computing-largest"), (one) => formatSmall(one.largest_m)),
            actions(say("table-actions"), (one) =>
              one.id === shown ? (
                <span class="muted">{say("computing-shown")}</span>
              ) : (
                <Button says="computing-show" small onClick={() => setQuery({ computing: String(one.id) })} />
              ),
            ),
          ]}
        />
      )}
    </Panel>
  );
}
