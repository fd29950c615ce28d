/** The line-scan bench: both strips above, the vehicles below with everything that is known of the chosen one. */
import { useEffect, useMemo, useState } from "preact/hooks";
import { Button, Empty, JobProgress, Loading, Notice, Problem } from "../../components";
import { historyCommands, useUndoTools } from "../../components/undoTools";
import { query } from "../../core/address";
import { type ActionId, type Command, hint, useCommands } from "../../core/commands";
import { cancelJob } from "../../core/jobs";
import type { ScreenProps } from "../../core/places";
import { canWork, may } from "../../core/session";
import { formatDuration } from "../../core/times";
import { toastProblem } from "../../core/toasts";
import type { Scan } from "../../core/types";
import { formatCount, formatLength } from "../../core/units";
import { TARGETS } from "../../core/words";
import { FindDialog } from "./FindDialog";
import { ScanModel } from "./model";
import { RigDialog } from "./RigDialog";
import { RodPanel } from "./RodPanel";
import { StripView } from "./StripView";
import { VehiclePanel } from "./VehiclePanel";
import { VehicleTable } from "./VehicleTable";
import { panBy, zoomHeight, zoomTime } from "./view";
import "../../parts/vehicles/vehicle.css";
import "./heights.css";
import "./scan.css";

export default function BenchScreen({ surveyId }: ScreenProps) {
  const id = Number(query.value.get("scan")) || 0;
  const model = useMemo(() => new ScanModel(id), [id]);
  useEffect(() => {
    if (id > 0) void model.load();
    return () => model.close();
  }, [model]);
  const steps = useMemo(() => historyCommands(model.history), [model]);
  useUndoTools(model.history, steps);
  useCommands([steps.undo, steps.redo, ...benchCommands(model)]);
  const scan = model.scan.value;
  if (id === 0) return <Nothing surveyId={surveyId} />;
  if (model.problem.value) {
    return (
      <div class="page">
        <Problem error={model.problem.value} again={() => void model.load()} />
      </div>
    );
  }
  if (!scan) return <Loading what="the line scan" />;
  if (scan.state !== "ready") return <NotReady scan={scan} model={model} surveyId={surveyId} />;
  return (
    <div class="scan">
      <Head model={model} scan={scan} surveyId={surveyId} />
      <StripView model={model} />
      <section class="scan__list" aria-label="Vehicles">
        {model.vehicles.value.length > 0 ? (
          <VehicleTable model={model} />
        ) : (
          <NoVehicles model={model} scan={scan} />
        )}
      </section>
      {model.mode.value === "rod" ? <RodPanel model={model} /> : <VehiclePanel model={model} />}
    </div>
  );
}

function Head({ model, scan, surveyId }: { model: ScanModel; scan: Scan; surveyId: number }) {
  const [open, setOpen] = useState<"find" | "rig" | null>(null);
  const job = model.job.value;
  return (
    <header class="scan__head">
      <div class="scan__title">
        <h1 class="clip">{scan.name}</h1>
        <p class="small muted clip">{headWords(scan)}</p>
      </div>
      <span class="grow" />
      {job ? (
        <div class="scan__job">
          <JobProgress
            job={job}
            onCancel={may("operator") ? () => void cancelJob(job.id).catch(toastProblem) : undefined}
          />
        </div>
      ) : (
        canWork.value && (
          <>
            <Button
              small
              pressed={model.mode.value === "new"}
              title={`Add a vehicle by two clicks${hint("scanNew")}`}
              icon="add"
              onClick={() => model.start("new")}
            >
              Vehicle
            </Button>
            <Button
              small
              pressed={model.mode.value === "rod"}
              title={`Click the marks of a rod, so that heights can be measured${hint("scanRod")}`}
              onClick={() => model.start("rod")}
            >
              Calibrate height
            </Button>
            <Button small onClick={() => setOpen("rig")}>
              Rig…
            </Button>
            <Button small kind={scan.run ? "plain" : "primary"} icon="search" onClick={() => setOpen("find")}>
              Find the vehicles…
            </Button>
          </>
        )
      )}
      <Button small kind="quiet" href={`/surveys/${surveyId}/scans`}>
        All line scans
      </Button>
      {open === "find" && <FindDialog model={model} scan={scan} onClose={() => setOpen(null)} />}
      {open === "rig" && <RigDialog model={model} scan={scan} onClose={() => setOpen(null)} />}
      {scan.run && scan.run.warnings.length > 0 && <RunWarnings scan={scan} />}
    </header>
  );
}

function headWords({ lines, rows_px, duration_s, rig, run }: Scan): string {
  const words = [
    `${formatCount(lines ?? 0)} lines of ${rows_px} rows`,
    formatDuration(duration_s ?? 0),
    `baseline ${formatLength(rig.baseline_m)}`,
    `${formatCount(rig.line_rate_hz)} lines a second`,
    run?.misalignment_words,
  ];
  return words.filter(Boolean).join("  ·  ");
}

function RunWarnings({ scan }: { scan: Scan }) {
  return (
    <div class="scan__warnings">
      {scan.run?.warnings.map((one) => (
        <Notice key={one} kind="warning">
          {one}
        </Notice>
      ))}
    </div>
  );
}

function NoVehicles({ model, scan }: { model: ScanModel; scan: Scan }) {
  return (
    <Empty
      title={scan.run ? "No vehicle was found" : "No vehicles yet"}
      actions={
        canWork.value && model.job.value === null ? (
          <Button kind="primary" onClick={() => void model.find("direct", true)}>
            Find the vehicles
          </Button>
        ) : undefined
      }
    >
      <p>
        {scan.run
          ? "Look at the strips: where a vehicle is seen, add it by two clicks, on its front and on its rear."
          : "Let them be found: front, rear, speed, length and the gaps between them come by themselves."}
      </p>
    </Empty>
  );
}

function NotReady({ scan, model, surveyId }: { scan: Scan; model: ScanModel; surveyId: number }) {
  const job = model.job.value ?? scan.job;
  return (
    <div class="page">
      <h1>{scan.name}</h1>
      {scan.state === "failed" ? (
        <Notice kind="problem">{scan.error ?? "The strips could not be read."}</Notice>
      ) : (
        job && <JobProgress job={job} />
      )}
      <p>
        <Button href={`/surveys/${surveyId}/scans`}>All line scans</Button>
      </p>
    </div>
  );
}

function Nothing({ surveyId }: { surveyId: number }) {
  return (
    <div class="page">
      <Empty
        title="No line scan is chosen"
        actions={<Button href={`/surveys/${surveyId}/scans`}>Choose one</Button>}
      />
    </div>
  );
}

const PAN_SHARE = 0.15;

function benchCommands(model: ScanModel): Command[] {
  const pan = (share: number) => () => {
    const view = model.view.value;
    if (view) model.view.value = panBy(view, -share * view.width, 0);
  };
  const zoom = (factor: number) => () => {
    const view = model.view.value;
    if (view) model.view.value = zoomTime(view, view.width / 2, factor);
  };
  const tall = (factor: number) => () => {
    const view = model.view.value;
    if (view) model.view.value = zoomHeight(view, view.height / 2, factor);
  };
  const nudge = (by: number) => () => (canWork.value ? model.heights.nudge(by, 0) || model.nudge(by) : false);
  const rise = (by: number) => () => model.heights.nudge(0, by);
  const runs: Partial<Record<ActionId, () => unknown>> = {
    frameNext: pan(PAN_SHARE),
    framePrevious: pan(-PAN_SHARE),
    frameNextTen: pan(0.9),
    framePreviousTen: pan(-0.9),
    frameFirst: pan(-1e9),
    frameLast: pan(1e9),
    zoomIn: zoom(1.5),
    zoomOut: zoom(1 / 1.5),
    zoomFit: zoom(1e-9),
    scanTaller: tall(1.5),
    scanFlatter: tall(1 / 1.5),
    scanFit: () => model.show("fit"),
    scanWheels: () => model.start("wheels"),
    scanNew: () => model.start("new"),
    scanRod: () => model.start("rod"),
    scanHeight: () => model.heights.begin(null),
    newContact: () => model.heights.newContact(),
    ...Object.fromEntries(
      TARGETS.map((target, at) => [`target${at + 1}`, () => model.heights.begin(target)]),
    ),
    passNext: () => model.step(1),
    passPrevious: () => model.step(-1),
    selectNext: () => model.selectNext(),
    remove: () => void model.remove(),
    cancel: () => model.cancel(),
    reviewAccept: () => void model.review("accepted"),
    reviewReject: () => {
      model.rejecting.value = true;
    },
    nudgeLeft: nudge(-1),
    nudgeRight: nudge(1),
    nudgeLeftFar: nudge(-10),
    nudgeRightFar: nudge(10),
    nudgeUp: rise(-1),
    nudgeDown: rise(1),
    nudgeUpFar: rise(-10),
    nudgeDownFar: rise(10),
    nudgeUpFine: rise(-0.1),
    nudgeDownFine: rise(0.1),
    nudgeLeftFine: nudge(-0.1),
    nudgeRightFine: nudge(0.1),
  };
  return (Object.keys(runs) as ActionId[]).map((id) => ({ id, run: () => runs[id]?.() !== false }));
}
