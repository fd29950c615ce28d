/** The line-scan recordings of a survey, and where new ones come in. */
import { useState } from "preact/hooks";
import { ask, Button, Empty, JobProgress, Loading, Notice, Problem, StateMark } from "../../components";
import { api } from "../../core/api";
import type { ScreenProps } from "../../core/places";
import { useEvery, useResource } from "../../core/resource";
import { canWork } from "../../core/session";
import { formatDuration } from "../../core/times";
import { toast, toastProblem } from "../../core/toasts";
import type { Scan } from "../../core/types";
import { formatCount, formatLength, plural } from "../../core/units";
import { AddScan } from "./AddScan";
import { RigDialog } from "./RigDialog";
import { RigOfTraffic } from "./RigOfTraffic";
import type { RigTyped } from "./rig";
import "./scan.css";

export default function ScansScreen({ surveyId }: ScreenProps) {
  const scans = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/scans", { survey_id: surveyId }, { signal }),
    [surveyId],
  );
  const [adding, setAdding] = useState(false);
  const busy = scans.data?.some((scan) => scan.state === "reading" || isWorking(scan)) ?? false;
  useEvery(busy ? 1000 : null, scans.reload);
  const none = scans.data?.length === 0;
  return (
    <div class="page">
      <header class="page__head">
        <div>
          <h1>Line scans</h1>
          <p class="page__lead">
            Two line cameras a known baseline apart: speed, length, acceleration and the gaps between
            vehicles, with the picture to check each by.
          </p>
        </div>
        <div class="row row--wrap">
          <Button href={`/surveys/${surveyId}/planning?plan=lines`}>Plan the line rate</Button>
          {!none && (
            <Button icon="chart" href={`/surveys/${surveyId}/scans/results`}>
              Results
            </Button>
          )}
          {!none && canWork.value && !adding && (
            <Button kind="primary" icon="add" onClick={() => setAdding(true)}>
              Add a line scan
            </Button>
          )}
        </div>
      </header>
      <Problem error={scans.error} again={scans.reload} />
      {!scans.data && scans.loading && <Loading what="the line scans" />}
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
      {none && !canWork.value && (
        <div class="panel">
          <Empty title="No line scans yet">
            <p>An operator can upload the strips of both cameras here.</p>
          </Empty>
        </div>
      )}
      <div class="stack">
        {scans.data?.map((scan) => (
          <ScanCard key={scan.id} scan={scan} reload={scans.reload} />
        ))}
      </div>
      <Limits />
    </div>
  );
}

/** What no setting helps against, in words; a vehicle that it concerns has the reason in place of its numbers. */
function Limits() {
  return (
    <details class="scan-limits">
      <summary>What a line scan cannot measure</summary>
      <dl>
        <dt>Opposing direction</dt>
        <dd>
          A pair measures the direction that reaches camera 1 first; a vehicle that comes the other way is
          told and left out. For the other lane add a second line scan of the same strips with the cameras the
          other way round, and that lane’s baseline and distance.
        </dd>
        <dt>Side by side</dt>
        <dd>
          Two vehicles that hide each other share their lines, so neither has a front and a rear of its own.
          Only their passing one after the other helps: a lane farther away, or a steeper view from above.
        </dd>
        <dt>Stopped, turned back, or very slow</dt>
        <dd>
          Along a strip runs time, not way. A vehicle that stands paints the same line again and again, and
          the fit takes one constant acceleration from front to rear; stop-and-go traffic has none.
        </dd>
        <dt>Cut off, or lines lost</dt>
        <dd>
          What began before the recording or ended after it has no front or no rear; where the recorder lost
          lines the clock of the strip is wrong.
        </dd>
        <dt>Another distance than the lane’s</dt>
        <dd>
          Planes that are not quite parallel make the baseline longer or shorter with the distance; the
          traffic alone cannot tell that. Enter the divergence’s uncertainty and the lane’s distance under
          Rig.
        </dd>
      </dl>
    </details>
  );
}

function isWorking(scan: Scan): boolean {
  return scan.job?.state === "running" || scan.job?.state === "queued";
}

function ScanCard({ scan, reload }: { scan: Scan; reload: () => Promise<void> }) {
  const [rigOpen, setRigOpen] = useState(false);
  const [offered, setOffered] = useState<Partial<RigTyped> | null>(null);
  const run = async (work: () => Promise<unknown>): Promise<void> => {
    try {
      await work();
      await reload();
    } catch (error) {
      toastProblem(error);
    }
  };
  const remove = () =>
    run(async () => {
      const yes = await ask({
        title: `Delete ${scan.name}?`,
        body: "Both strips and what was found in them go; a line scan on which somebody worked cannot be deleted.",
        action: "Delete the line scan",
      });
      if (!yes) return;
      await api.write("DELETE /scans/{scan_id}", { scan_id: scan.id });
      toast(`${scan.name} was deleted.`);
    });
  const bench = `/surveys/${scan.survey_id}/scan?scan=${scan.id}`;
  return (
    <article class="panel scan-card" data-testid={`scan-${scan.id}`}>
      {scan.state === "ready" && (
        <div class="scan-card__picture">
          <Overview scan={scan} />
        </div>
      )}
      <div class="scan-card__body">
        <header class="row row--apart">
          <h2 class="clip">{scan.name}</h2>
          <div class="row">
            <StateMark state={scan.state === "reading" ? "ingesting" : scan.state} />
            {canWork.value && scan.state !== "reading" && (
              <Button kind="quiet" icon="trash" label={`Delete ${scan.name}`} onClick={() => void remove()} />
            )}
          </div>
        </header>
        <p class="small muted">{facts(scan)}</p>
        {isWorking(scan) && scan.job && <JobProgress job={scan.job} />}
        {scan.state === "failed" && (
          <Notice
            kind="problem"
            actions={
              canWork.value && (
                <Button
                  small
                  icon="retry"
                  onClick={() =>
                    void run(() => api.write("POST /scans/{scan_id}/read", { scan_id: scan.id }))
                  }
                >
                  Read it again
                </Button>
              )
            }
          >
            {scan.error ?? "The strips could not be read."}
          </Notice>
        )}
        {scan.notes.map((note) => (
          <p key={note} class="small">
            {note}
          </p>
        ))}
        {scan.state === "ready" && scan.run && (
          <details
            class="scan__advanced"
            onToggle={(event) => setRigOpen((event.currentTarget as HTMLDetailsElement).open)}
          >
            <summary>The rig, and what the traffic says of it</summary>
            {rigOpen && (
              <>
                <RigOfTraffic scan={scan} use={setOffered} changed={reload} />
                {canWork.value && (
                  <Button small onClick={() => setOffered({})}>
                    Change the rig…
                  </Button>
                )}
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
            <Button kind="primary" href={bench}>
              Open the bench
            </Button>
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
    scan.lines !== null ? `${formatCount(scan.lines)} lines of ${scan.rows_px} rows` : null,
    scan.duration_s !== null ? formatDuration(scan.duration_s) : null,
    `baseline ${formatLength(scan.rig.baseline_m)}`,
    `${formatCount(scan.rig.line_rate_hz)} lines a second`,
    scan.source === "video"
      ? `cut from a video at columns ${scan.column_1_px} and ${scan.column_2_px}`
      : null,
  ]
    .filter(Boolean)
    .join("  ·  ");
}

function counts({ counts: one, run }: Scan): string {
  if (!run && one.vehicles === 0) return "vehicles not looked for yet";
  const parts = [plural(one.vehicles, "vehicle")];
  if (one.to_review > 0) parts.push(`${one.to_review} to review`);
  if (one.accepted > 0) parts.push(`${one.accepted} accepted`);
  if (one.rejected > 0) parts.push(`${one.rejected} rejected`);
  if (one.not_measurable > 0) parts.push(`${one.not_measurable} not measurable`);
  return parts.join(", ");
}
