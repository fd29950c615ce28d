/** The line-scan recordings of a survey, and where new ones come in. */
import { Fragment } from "preact";
import { useState } from "preact/hooks";
import { ask, Button, Empty, JobProgress, Loaded, Notice, PageHead, StateMark } from "../../components";
import { api } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useEvery } from "../../core/resource";
import { canWork } from "../../core/session";
import { formatDuration } from "../../core/times";
import { telling, toast } from "../../core/toasts";
import type { Scan } from "../../core/types";
import { fixed, formatLength } from "../../core/units";
import { LIVE_WORDS } from "../../core/words";
import { AddScan } from "./AddScan";
import { RigDialog } from "./RigDialog";
import { RigOfTraffic } from "./RigOfTraffic";
import type { RigTyped } from "./rig";
import { ScanStart } from "./ScanStart";
import "./scan.css";

export default function ScansScreen({ surveyId }: ScreenProps) {
  const scans = useAsked("GET /surveys/{survey_id}/scans", { survey_id: surveyId });
  const [adding, setAdding] = useState(false);
  const busy = scans.data?.some((scan) => scan.state === "reading" || isWorking(scan)) ?? false;
  useEvery(busy ? 1000 : null, scans.reload);
  const none = scans.data?.length === 0;
  return (
    <div class="page">
      <PageHead says="page-scans" lead={say("scans-lead")}>
        <div class="row row--wrap">
          <Button says="page-planning" href={`/surveys/${surveyId}/planning?plan=lines`} />
          <Button says="page-live" href={`/surveys/${surveyId}/live`} />
          {!none && (
            <Button says="page-scan-results" icon="chart" href={`/surveys/${surveyId}/scans/results`} />
          )}
          {!none && canWork.value && !adding && (
            <Button says="scans-add" kind="primary" icon="add" onClick={() => setAdding(true)} />
          )}
        </div>
      </PageHead>
      <Loaded of={scans} what={say("scans-loading")} />
      {canWork.value && (adding || none) && (
        <AddScan
          surveyId={surveyId}
          onClose={none ? undefined : () => setAdding(false)}
          added={async () => {
            setAdding(false);
            await scans.reload();
          }}
        />
      )}
      {none && !canWork.value && <Empty panel says="scans-none-title" why="scans-none" />}
      <div class="stack">
        {scans.data?.map((scan) => (
          <ScanCard key={scan.id} scan={scan} reload={scans.reload} />
        ))}
      </div>
      <Limits />
    </div>
  );
}

const LIMITS = ["opposing", "abreast", "slow", "cut", "distance"] as const;

/** What no setting helps against, in words; a vehicle that it concerns has the reason in place of its numbers. */
function Limits() {
  return (
    <details class="words scan-limits">
      <summary>{say("scans-limits")}</summary>
      <dl>
        {LIMITS.map((limit) => (
          <Fragment key={limit}>
            <dt>{say(`scans-limit-${limit}`)}</dt>
            <dd>{say(`scans-limit-${limit}-why`)}</dd>
          </Fragment>
        ))}
      </dl>
    </details>
  );
}

function stateOf(scan: Scan): "ingesting" | "running" | "not_measurable" | "ready" | "failed" {
  if (scan.state === "live") return scan.stream_state === "running" ? "running" : "not_measurable";
  return scan.state === "reading" ? "ingesting" : scan.state;
}

function isWorking(scan: Scan): boolean {
  return scan.job?.state === "running" || scan.job?.state === "queued";
}

function ScanCard({ scan, reload }: { scan: Scan; reload: () => Promise<void> }) {
  const [rigOpen, setRigOpen] = useState(false);
  const [offered, setOffered] = useState<Partial<RigTyped> | null>(null);
  const run = async (work: () => Promise<unknown>): Promise<void> => {
    await telling(async () => {
      await work();
      await reload();
    });
  };
  const remove = () =>
    run(async () => {
      const yes = await ask({
        title: say("scans-delete-title", { scan: scan.name }),
        body: say("scans-delete-what"),
        action: say("scans-delete"),
      });
      if (!yes) return;
      await api.write("DELETE /scans/{scan_id}", { scan_id: scan.id });
      toast(say("scans-deleted", { scan: scan.name }));
    });
  const bench = `/surveys/${scan.survey_id}/scan?scan=${scan.id}`;
  return (
    <article class="panel stack stack--near scan-card" data-testid={`scan-${scan.id}`}>
      {scan.state === "ready" && (
        <div class="scan-card__picture">
          <Overview scan={scan} />
        </div>
      )}
      <div class="stack stack--tight scan-card__body">
        <header class="row row--apart">
          <h2 class="clip">{scan.name}</h2>
          <div class="row">
            <StateMark
              state={stateOf(scan)}
              word={scan.stream_state ? LIVE_WORDS[scan.stream_state] : undefined}
            />
            {canWork.value && scan.state !== "reading" && (
              <Button
                kind="quiet"
                icon="trash"
                label={say("scans-delete-one", { scan: scan.name })}
                onClick={() => void remove()}
              />
            )}
          </div>
        </header>
        <p class="small muted">{facts(scan)}</p>
        {scan.state === "ready" && <ScanStart scan={scan} changed={reload} />}
        {isWorking(scan) && scan.job && <JobProgress job={scan.job} />}
        {scan.state === "failed" && (
          <Notice
            kind="problem"
            actions={
              canWork.value && (
                <Button
                  says="scans-read-again"
                  small
                  icon="retry"
                  onClick={() =>
                    void run(() => api.write("POST /scans/{scan_id}/read", { scan_id: scan.id }))
                  }
                />
              )
            }
          >
            {sentenceOf(scan.error) ?? say("scans-not-read")}
          </Notice>
        )}
        {scan.notes.map(sentenceOf).map((note) => (
          <p key={note} class="small">
            {note}
          </p>
        ))}
        {scan.state === "ready" && scan.run && (
          <details
            class="scan__advanced"
            onToggle={(event) => setRigOpen((event.currentTarget as HTMLDetailsElement).open)}
          >
            <summary>{say("scans-rig")}</summary>
            {rigOpen && (
              <>
                <RigOfTraffic scan={scan} use={setOffered} changed={reload} />
                {canWork.value && <Button says="scans-rig-change" small onClick={() => setOffered({})} />}
              </>
            )}
          </details>
        )}
        {offered && (
          <RigDialog scan={scan} offered={offered} changed={reload} onClose={() => setOffered(null)} />
        )}
        {scan.state === "ready" && (
          <footer class="row row--apart">
            <span class="small">{counts(scan)}</span>
            <Button says="scans-open" kind="primary" href={bench} />
          </footer>
        )}
      </div>
    </article>
  );
}

const OVERVIEW_LINES = 800;

/** The whole recording, squeezed: camera 1 at the coarsest level that still shows vehicles. */
function Overview({ scan }: { scan: Scan }) {
  const level = scan.levels.findLast((one) => one.lines >= OVERVIEW_LINES) ?? scan.levels[0];
  if (!level) return null;
  const tiles = Array.from({ length: level.tiles }, (_, index) => ({
    index,
    lines: Math.min(scan.tile_lines, level.lines - index * scan.tile_lines),
  }));
  const address = `/api/scans/${scan.id}/tiles/1/${level.level}`;
  return tiles.map(({ index, lines }) => (
    <img
      key={index}
      src={`${address}/${index}?v=${scan.tiles_version ?? ""}`}
      style={{ flexGrow: lines }}
      alt=""
      loading="lazy"
    />
  ));
}

function facts(scan: Scan): string {
  return [
    scan.lines !== null
      ? say("scans-fact-lines", { lines: scan.lines, rows_px: String(scan.rows_px) })
      : null,
    scan.duration_s !== null ? formatDuration(scan.duration_s) : null,
    say("scans-fact-baseline", { baseline: formatLength(scan.rig.baseline_m) }),
    say("scans-fact-rate", { rate_hz: fixed(scan.rig.line_rate_hz, 0) }),
    scan.source === "video"
      ? say("scans-fact-video", {
          along: scan.cut_along === "columns" ? "columns" : "rows",
          cut_1_px: String(scan.cut_1_px),
          cut_2_px: String(scan.cut_2_px),
        })
      : null,
  ]
    .filter(Boolean)
    .join("  ·  ");
}

function counts({ counts: one, run }: Scan): string {
  if (!run && one.vehicles === 0) return say("scans-count-none");
  const parts = [say("scans-count-vehicles", { count: one.vehicles })];
  if (one.to_review > 0) parts.push(say("scans-count-to-review", { count: one.to_review }));
  if (one.accepted > 0) parts.push(say("scans-count-accepted", { count: one.accepted }));
  if (one.rejected > 0) parts.push(say("scans-count-rejected", { count: one.rejected }));
  if (one.not_measurable > 0) parts.push(say("scans-count-not-measurable", { count: one.not_measurable }));
  if (one.heights > 0) parts.push(say("scans-count-heights", { count: one.heights }));
  if (one.heights_to_review > 0)
    parts.push(say("scans-count-heights-to-review", { count: one.heights_to_review }));
  return parts.join(", ");
}
