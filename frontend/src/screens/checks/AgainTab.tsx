/** Heights computed again: what is out of date, each time it was done, old beside new, and the undo of all. */
import { Button, DataTable, JobProgress, Loaded, Notice, Panel, Problem } from "../../components";
import { query, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { ComputedHeight, ComputedHeights, Computing, Computings } from "../../core/types";
import { fixed, formatCount, formatHeight, formatSmall, lengthScale, smallScale } from "../../core/units";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { useComputing } from "../../parts/again/computing";
import { causesInWords } from "../../parts/again/words";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";

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
          scroll="heads-stay tall"
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

interface Props {
  surveyId: number;
  computing: Computing;
  busy: boolean;
  undo(): Promise<unknown>;
}

/** One computing: what it changed in words, as a figure, and height by height, with the undo of all. */
function ComputedHeightsPanel({ surveyId, computing, busy, undo }: Props) {
  const read = useAsked(
    "GET /computings/{computing_id}",
    { computing_id: computing.id },
    { also: [computing.undone_by] },
  );
  const found = read.data;
  if (!found) return <Loaded of={read} what={say("computing-old-new")} />;
  return (
    <Panel
      says="computing-old-new"
      aside={
        canWork.value && (
          <Button
            says="computing-undo"
            small
            icon="undo"
            busy={busy}
            disabled={found.undoable !== null}
            title={found.undoable ?? say("computing-undo-text")}
            onClick={() => void undo()}
          />
        )
      }
    >
      <div class="panel__body stack">
        <p>{inWords(found)}</p>
        <Changes found={found} />
      </div>
      <Heights surveyId={surveyId} found={found} />
    </Panel>
  );
}

function inWords({ computing, mean_change_m }: ComputedHeights): string {
  const count = computing.heights;
  const kept = computing.kept > 0 ? ` ${say("computing-kept", { count: computing.kept })}` : "";
  if (computing.kind === "undo") return say("computing-summary-undo", { count }) + kept;
  const values = {
    count,
    causes: causesInWords(computing.causes),
    mean: formatSmall(mean_change_m),
    largest: formatSmall(computing.largest_m),
  };
  return `${say("computing-summary", values)} ${say("computing-sent", { count: computing.to_review })}`;
}

/** Where each height lies: of a recording across the road, of a line scan away from the camera. */
const PLACES = {
  frames: {
    at_m: (one: ComputedHeight) => (one.scan_id === null ? one.y_m : null),
    axis: "computing-figure-x",
    says: "computing-figure-says",
    column: "y_m",
  },
  lines: {
    at_m: (one: ComputedHeight) => (one.scan_id === null ? null : one.distance_m),
    axis: "computing-figure-x-lines",
    says: "computing-figure-says-lines",
    column: "distance_m",
  },
} as const;

function Changes({ found }: { found: ComputedHeights }) {
  const inLines = found.listed.some((one) => one.scan_id !== null);
  const inFrames = found.listed.some((one) => one.scan_id === null);
  return (
    <>
      {(inFrames || !inLines) && <ChangesOf found={found} of="frames" />}
      {inLines && <ChangesOf found={found} of="lines" />}
    </>
  );
}

function ChangesOf({ found, of }: { found: ComputedHeights; of: keyof typeof PLACES }) {
  const { at_m, axis, says, column } = PLACES[of];
  const rows = found.listed.filter((one) => one.change_m !== null && at_m(one) !== null);
  return (
    <PlotFigure
      name={`computing-${found.computing.id}${of === "lines" ? "-lines" : ""}`}
      title={say(of === "lines" ? "computing-figure-lines" : "computing-figure")}
      says={say(says, { count: rows.length, small: smallScale()[1] })}
      note={say("computing-figure-note")}
      data={found}
      reason={rows.length === 0 ? say("computing-figure-none") : null}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        const [perY, small] = smallScale(unit);
        const at = { x: (one: ComputedHeight) => (at_m(one) ?? 0) * perX, y: changeIn(perY) };
        return {
          x: { label: say(axis, { unit: long }) },
          y: { label: say("computing-figure-y", { small }), nice: true, zero: true },
          marks: [
            plot.ruleY([0], { stroke: "var(--line-strong)" }),
            readable(
              plot.dot(
                rows.filter((one) => !one.to_review),
                { ...at, r: 3, stroke: "var(--ink)", strokeWidth: 1.2, fill: "var(--surface)" },
              ),
              readRows(rows, at, "points"),
            ),
            plot.dot(
              rows.filter((one) => one.to_review),
              { ...at, r: 3.5, fill: "var(--ink)" },
            ),
          ],
        };
      }}
      table={() => ({
        columns: ["vehicle", "target", "height_before_m", "u_before_m", "height_m", "u_height_m", column],
        rows: rows.map((one) => [
          ...[one.vehicle_number, one.target, one.height_before_m, one.u_before_m],
          ...[one.height_m, one.u_height_m, at_m(one)],
        ]),
      })}
    />
  );
}

function changeIn(factor: number): (one: ComputedHeight) => number {
  return (one) => (one.change_m ?? 0) * factor;
}

function addressOf(surveyId: number, one: ComputedHeight): string {
  return one.scan_id === null
    ? `/surveys/${surveyId}/measure?vehicle=${one.vehicle_id}`
    : `/surveys/${surveyId}/scan?scan=${one.scan_id}&vehicle=${one.vehicle_id}`;
}

function Heights({ surveyId, found }: { surveyId: number; found: ComputedHeights }) {
  return (
    <>
      <DataTable
        label={say("computing-table")}
        scroll="heads-stay again-heights"
        data-testid="computed-heights"
        rows={found.listed}
        keyOf={(one) => one.measurement_id}
        columns={({ col, num, actions }) => [
          col(say("computing-vehicle"), (one) => (
            <a href={addressOf(surveyId, one)}>{vehicleName(one.vehicle_number)}</a>
          )),
          col(say("computing-target"), (one) => (
            <>
              {TARGET_WORDS[one.target]}{" "}
              {one.scan_id !== null && <span class="badge">{say("computing-line-scan")}</span>}{" "}
              {one.repeat && <span class="badge">{say("computing-repeat")}</span>}
            </>
          )),
          num(say("computing-before"), (one) => formatHeight(one.height_before_m, one.U95_before_m)),
          {
            ...num(say("computing-after"), (one) => formatHeight(one.height_m, one.U95_height_m)),
            cellTitle: ({ reason }) => (reason ? sentenceOf(reason) : undefined),
          },
          num(say("computing-change"), (one) => formatSmall(one.change_m)),
          {
            ...num(say("computing-by-u"), (one) =>
              one.moved_by_u === null ? "–" : fixed(one.moved_by_u, 2),
            ),
            title: say("computing-by-u-help"),
          },
          actions(
            say("table-actions"),
            (one) => one.to_review && <span class="badge">{say("computing-review-yes")}</span>,
          ),
        ]}
      />
      {found.listed.length < found.computing.heights && (
        <p class="panel__body muted small">{say("computing-listed", { count: found.listed.length })}</p>
      )}
    </>
  );
}
