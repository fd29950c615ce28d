/** The line-scan bench: both strips above, the vehicles below with everything that is known of the chosen one. */
import { useEffect, useMemo, useState } from "preact/hooks";
import { Button, Empty, JobProgress, Loading, Notice, Problem } from "../../components";
import { type ButtonCommand, CommandButton } from "../../components/CommandButton";
import { historyCommands, useUndoTools } from "../../components/undoTools";
import { query } from "../../core/address";
import { type ActionId, useCommands } from "../../core/commands";
import { cancelJob } from "../../core/jobs";
import type { ScreenProps } from "../../core/places";
import { canWork, may } from "../../core/session";
import { formatDuration } from "../../core/times";
import { toastProblem } from "../../core/toasts";
import type { Scan, Target } from "../../core/types";
import { formatCount, formatLength } from "../../core/units";
import { TARGETS } from "../../core/words";
import { pictureCommands } from "../../viewer/stageCommands";
import { FindDialog } from "./FindDialog";
import { ScanModel } from "./model";
import { RigDialog } from "./RigDialog";
import { RodPanel } from "./RodPanel";
import { StripView } from "./StripView";
import { VehiclePanel } from "./VehiclePanel";
import { VehicleTable } from "./VehicleTable";
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
  const steps = useMemo(() => historyCommands(model.history, { back: () => model.stage.back() }), [model]);
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
            <CommandButton command={addVehicle(model)} kind="plain">
              Vehicle
            </CommandButton>
            <CommandButton command={calibrateHeight(model)} kind="plain">
              Calibrate height
            </CommandButton>
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

/** The keys that step through frames elsewhere move along the strips. */
function benchCommands(model: ScanModel): ButtonCommand[] {
  const { stage, heights } = model;
  const pan = (share: number) => () => {
    stage.view.value = stage.view.value.pan(-share * stage.view.value.width, 0);
  };
  const target = (at: Target, index: number): ButtonCommand => ({
    id: `target${index + 1}` as ActionId,
    run: () => heights.begin(at),
  });
  return [
    { id: "frameNext", label: "On along the strips", run: pan(PAN_SHARE) },
    { id: "framePrevious", label: "Back along the strips", run: pan(-PAN_SHARE) },
    { id: "frameNextTen", label: "On by a window", run: pan(0.9) },
    { id: "framePreviousTen", label: "Back by a window", run: pan(-0.9) },
    { id: "frameFirst", label: "To the first line", run: pan(-1e9) },
    { id: "frameLast", label: "To the last line", run: pan(1e9) },
    { id: "scanTaller", run: () => stage.zoom(1.5, true) },
    { id: "scanFlatter", run: () => stage.zoom(1 / 1.5, true) },
    { id: "scanFit", run: () => model.show("fit") },
    { id: "scanWheels", run: () => model.start("wheels") },
    addVehicle(model),
    calibrateHeight(model),
    { id: "scanHeight", run: () => heights.begin(null) },
    { id: "newContact", run: () => heights.newContact() },
    ...TARGETS.map(target),
    { id: "passNext", label: "Next vehicle", run: () => model.step(1) },
    { id: "passPrevious", label: "Previous vehicle", run: () => model.step(-1) },
    { id: "selectNext", run: () => model.selectNext() },
    { id: "remove", label: "Take the vehicle out", run: () => void model.remove() },
    { id: "reviewAccept", run: () => void model.review("accepted") },
    {
      id: "reviewReject",
      run: () => {
        model.rejecting.value = true;
      },
    },
    ...pictureCommands(stage),
  ];
}

function addVehicle(model: ScanModel): ButtonCommand {
  return {
    id: "scanNew",
    icon: "add",
    run: () => model.start("new"),
    pressed: () => model.mode.value === "new",
  };
}

function calibrateHeight(model: ScanModel): ButtonCommand {
  return {
    id: "scanRod",
    run: () => model.start("rod"),
    pressed: () => model.mode.value === "rod",
  };
}
