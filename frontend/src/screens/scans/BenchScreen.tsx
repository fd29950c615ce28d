/** The line-scan bench: both strips above, the vehicles below with everything that is known of the chosen one. */
import { useEffect, useMemo, useState } from "preact/hooks";
import { Button, Empty, JobProgress, Loading, Notice, Notices } from "../../components";
import { type ButtonCommand, CommandButton } from "../../components/CommandButton";
import { historyCommands, useUndoTools } from "../../components/undoTools";
import { navigate, query } from "../../core/address";
import { useCommands } from "../../core/commands";
import { cancelJob } from "../../core/jobs";
import { say, sentenceOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { canWork, may } from "../../core/session";
import { formatDuration, formatMoment, formatPlaceMoment } from "../../core/times";
import { toastProblem } from "../../core/toasts";
import type { Scan, Target } from "../../core/types";
import { fixed, formatLength } from "../../core/units";
import { TARGETS } from "../../core/words";
import { FailedPage } from "../../parts/FailedPage";
import { targetAction } from "../../parts/vehicles/TargetButton";
import { pictureCommands } from "../../viewer/stageCommands";
import { FindDialog } from "./FindDialog";
import { ScanModel } from "./model";
import { RigDialog } from "./RigDialog";
import { RodPanel } from "./RodPanel";
import { ScanStart } from "./ScanStart";
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
    else navigate(`/surveys/${surveyId}/scans`, { replace: true }); // where one is chosen
    return () => model.close();
  }, [model]);
  const steps = useMemo(() => historyCommands(model.history, { back: () => model.stage.back() }), [model]);
  useUndoTools(model.history, steps);
  useCommands([steps.undo, steps.redo, ...benchCommands(model)]);
  const scan = model.scan.value;
  if (id === 0) return null;
  if (model.problem.value) return <FailedPage model={model} />;
  if (!scan) return <Loading what={say("scan-loading")} />;
  if (scan.survey_id !== surveyId) return <Elsewhere surveyId={surveyId} />;
  if (scan.state !== "ready") return <NotReady scan={scan} model={model} surveyId={surveyId} />;
  return (
    <div class="desk scan">
      <Head model={model} scan={scan} surveyId={surveyId} />
      <StripView model={model} />
      <section class="scan__list" aria-label={say("scan-vehicles")}>
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
  const job = model.search.job.value;
  return (
    <header class="row row--wrap desk__head">
      <h1 class="scan__title clip">{scan.name}</h1>
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
              {say("scan-head-vehicle")}
            </CommandButton>
            <CommandButton command={calibrateHeight(model)} kind="plain">
              {say("scan-calibrate")}
            </CommandButton>
            <Button says="scan-rig" small onClick={() => setOpen("rig")} />
            <Button
              says="scan-find"
              small
              kind={scan.run ? "plain" : "primary"}
              icon="search"
              onClick={() => setOpen("find")}
            />
          </>
        )
      )}
      <Button says="scans-all" small kind="quiet" href={`/surveys/${surveyId}/scans`} />
      <div class="scan__below row row--wrap">
        <p class="small muted">{headWords(scan)}</p>
        {!scan.started_at && (
          <ScanStart
            scan={scan}
            changed={async (stored) => {
              model.take(stored);
              await model.refresh();
            }}
          />
        )}
      </div>
      {open === "find" && <FindDialog model={model} scan={scan} onClose={() => setOpen(null)} />}
      {open === "rig" && <RigDialog model={model} scan={scan} onClose={() => setOpen(null)} />}
      {scan.run && scan.run.warnings.length > 0 && (
        <div class="scan__below">
          <Notices of={scan.run.warnings} kind="warning" />
        </div>
      )}
    </header>
  );
}

function headWords({ lines, rows_px, duration_s, rig, run, started_local }: Scan): string {
  const words = [
    started_local && formatPlaceMoment(started_local),
    say("scans-fact-lines", { lines: lines ?? 0, rows_px: String(rows_px) }),
    formatDuration(duration_s ?? 0),
    say("scans-fact-baseline", { baseline: formatLength(rig.baseline_m) }),
    say("scans-fact-rate", { rate_hz: fixed(rig.line_rate_hz, 0) }),
    sentenceOf(run?.summary.misalignment_words),
  ];
  return words.filter(Boolean).join("  ·  ");
}

function NoVehicles({ model, scan }: { model: ScanModel; scan: Scan }) {
  return (
    <Empty
      says={scan.run ? "scan-nothing-found-title" : "scan-nothing-yet-title"}
      why={scan.run ? "scan-nothing-found" : "scan-nothing-yet"}
      actions={
        canWork.value && model.search.job.value === null ? (
          <Button
            says="scan-find-now"
            kind="primary"
            onClick={() => void model.search.find("direct", true)}
          />
        ) : undefined
      }
    />
  );
}

function NotReady({ scan, model, surveyId }: { scan: Scan; model: ScanModel; surveyId: number }) {
  const job = model.search.job.value ?? scan.job;
  return (
    <div class="page">
      <h1>{scan.name}</h1>
      {scan.state === "failed" ? (
        <Notice kind="problem">{sentenceOf(scan.error) ?? say("scans-not-read")}</Notice>
      ) : scan.state === "live" ? (
        <Stream scan={scan} />
      ) : (
        job && <JobProgress job={job} />
      )}
      <p class="row">
        {scan.state === "live" && <Button says="page-live" href={`/surveys/${surveyId}/live`} />}
        <Button says="scans-all" href={`/surveys/${surveyId}/scans`} />
      </p>
    </div>
  );
}

/** Whether the lines of a live recording still come. */
function Stream({ scan }: { scan: Scan }) {
  if (scan.stream_state !== "stopped" || !scan.heard_at) return <Notice>{say("scan-live")}</Notice>;
  return <Notice kind="warning">{say("live-stopped", { time: formatMoment(scan.heard_at) })}</Notice>;
}

function Elsewhere({ surveyId }: { surveyId: number }) {
  const words = say("address-elsewhere", { what: "scan" });
  return (
    <div class="page">
      <Empty label={words} actions={<Button says="scan-none-choose" href={`/surveys/${surveyId}/scans`} />} />
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
  const target = (at: Target): ButtonCommand => ({
    id: targetAction(at),
    run: () => heights.begin(at),
    enabled: () => !model.judging.rejection.begun.value, // a digit is a reason then
  });
  return [
    { id: "frameNext", label: say("scan-on"), run: pan(PAN_SHARE) },
    { id: "framePrevious", label: say("scan-back"), run: pan(-PAN_SHARE) },
    { id: "frameNextTen", label: say("scan-on-window"), run: pan(0.9) },
    { id: "framePreviousTen", label: say("scan-back-window"), run: pan(-0.9) },
    { id: "frameFirst", label: say("scan-to-first"), run: pan(-1e9) },
    { id: "frameLast", label: say("scan-to-last"), run: pan(1e9) },
    { id: "scanTaller", run: () => stage.zoom(1.5, true) },
    { id: "scanFlatter", run: () => stage.zoom(1 / 1.5, true) },
    { id: "scanFit", run: () => model.show("fit") },
    { id: "scanWheels", run: () => model.start("wheels") },
    addVehicle(model),
    calibrateHeight(model),
    { id: "scanHeight", run: () => heights.begin(null) },
    { id: "newContact", run: () => heights.newContact() },
    ...TARGETS.map(target),
    { id: "passNext", label: say("scan-next-vehicle"), run: () => model.step(1) },
    { id: "passPrevious", label: say("scan-previous-vehicle"), run: () => model.step(-1) },
    { id: "selectNext", run: () => model.selectNext() },
    { id: "remove", label: say("scan-take-out-vehicle"), run: () => void model.edits.remove() },
    { id: "reviewAccept", run: () => void model.judging.review("accepted") },
    { id: "reviewReject", run: () => model.judging.reject() },
    ...model.judging.rejection.commands,
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
  return { id: "scanRod", run: () => model.start("rod"), pressed: () => model.mode.value === "rod" };
}
