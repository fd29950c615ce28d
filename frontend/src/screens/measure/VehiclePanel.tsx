/** The right side: the vehicle's measurements, and its record, saved by itself. */
import { Button, IconButton, StateMark } from "../../components";
import { late, soon } from "../../components/late";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { vehicleName } from "../../core/words";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { MeasurementList } from "./MeasurementList";
import type { MeasureModel } from "./model";
import { readAgain } from "./passes/actions";

const ProposalPanel = late(async () => (await import("./proposals/ProposalPanel")).ProposalPanel);
const WholePassPanel = late(async () => (await import("./WholePassPanel")).WholePassPanel);
const VehicleConflict = late(async () => (await import("./Conflicts")).VehicleConflict);
const SpanEditor = soon(async () => (await import("./SpanEditor")).SpanEditor);
// after the frame, which is what the page is opened for
const VehicleRecord = soon(async () => (await import("./VehicleRecord")).VehicleRecord);

export function VehiclePanel({ model }: { model: MeasureModel }) {
  const vehicle = model.vehicle.value;
  if (!vehicle) {
    return (
      <aside class="desk__side measure__vehicle" aria-label={say("measure-vehicle")}>
        <p class="panel__body muted">{say("measure-vehicle-none")}</p>
      </aside>
    );
  }
  return (
    <aside class="desk__side measure__vehicle" aria-label={say("measure-vehicle")} key={vehicle.id}>
      <header class="row row--far vehicle__head">
        <h2>{say("measure-vehicle-number", { vehicle: vehicleName(vehicle.number) })}</h2>
        <StateMark state={vehicle.state} />
        <span class="grow" />
        <DraftWord model={model} id={vehicle.id} />
        {canWork.value && (
          <IconButton
            icon="trash"
            label={say("measure-pass-delete-of", { vehicle: String(vehicle.number) })}
            onClick={() => void model.passes.remove()}
          />
        )}
      </header>
      {model.vehicles.drafts.value.get(vehicle.id)?.state === "conflict" && (
        <VehicleConflict model={model} id={vehicle.id} />
      )}
      {canWork.value && model.proposals.all.value.length > 0 && <ProposalPanel model={model} />}
      {(model.whole.looking.value || model.whole.now.value) && <WholePassPanel model={model} />}
      <OutOfDateNotice surveyId={model.surveyId} computed={() => readAgain(model)} />
      <MeasurementList model={model} />
      <SpanEditor model={model} vehicle={vehicle} />
      <VehicleRecord model={model} vehicle={vehicle} />
    </aside>
  );
}

function DraftWord({ model, id }: { model: MeasureModel; id: number }) {
  const draft = model.vehicles.drafts.value.get(id);
  if (!draft || draft.state === "conflict" || Object.keys(draft.changes).length === 0) return null;
  if (draft.state === "failed") {
    return (
      <Button
        says="measure-save-again"
        small
        icon="warning"
        title={draft.problem ?? undefined}
        onClick={() => void model.vehicles.flush(id)}
      />
    );
  }
  return <span class="small muted">{say("save-pending")}</span>;
}
