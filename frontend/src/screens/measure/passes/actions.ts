/** Passes taken apart, put together and confirmed; each a step that can be undone. */

import { api } from "../../../core/api";
import { say } from "../../../core/messages";
import { toast, toastProblem } from "../../../core/toasts";
import type { Vehicle } from "../../../core/types";
import { lightingProposed } from "../../../parts/vehicles/passes";
import type { MeasureModel } from "../model";
import { listVehicles, removeVehicle, restoreVehicle } from "../ports";

/** The pass of the same recording that begins next. */
function nextInTime(all: readonly Vehicle[], vehicle: Vehicle): Vehicle | undefined {
  return all
    .filter((one) => one.recording_id === vehicle.recording_id && isLater(one, vehicle))
    .sort((a, b) => (isLater(a, b) ? 1 : -1))[0];
}

function isLater(one: Vehicle, other: Vehicle): boolean {
  return one.first_frame !== other.first_frame
    ? one.first_frame > other.first_frame
    : one.number > other.number;
}

/** The current pass becomes two; the second begins on the frame that is seen. */
export async function splitPass(model: MeasureModel): Promise<void> {
  const chosen = model.vehicle.value;
  const frame = model.seenFrame.value;
  if (!chosen) return;
  await tellInTurn(model, async () => {
    const vehicle = model.vehicles.get(chosen.id) ?? chosen;
    let made = await split(model, vehicle, frame);
    model.history.push({
      label: say("measure-step-split", { vehicle: String(vehicle.number) }),
      undo: async () => {
        await dropPass(model, made);
        await putSpan(model, vehicle);
      },
      redo: async () => {
        made = await split(model, vehicle, frame);
      },
    });
    const parts = { vehicle: String(vehicle.number), other: String(made.number) };
    toast(say("measure-pass-splitted", { ...parts, frame: String(frame) }));
  });
}

/** The current pass and the one that begins next become one. */
export async function joinPass(model: MeasureModel): Promise<void> {
  const chosen = model.vehicle.value;
  if (!chosen) return;
  await tellInTurn(model, async () => {
    const vehicle = model.vehicles.get(chosen.id) ?? chosen;
    const next = nextInTime(model.vehicles.list.value, vehicle);
    if (!next) {
      toast(say("measure-pass-no-next"));
      return;
    }
    let kept = await join(model, vehicle, next);
    model.history.push({
      label: say("measure-step-joining", { vehicle: String(vehicle.number), next: String(next.number) }),
      undo: async () => {
        const gone = kept.id === vehicle.id ? next : vehicle;
        put(model, await restoreVehicle(gone.id));
        await putSpan(model, kept.id === vehicle.id ? vehicle : next);
      },
      redo: async () => {
        kept = await join(model, vehicle, next);
      },
    });
    const gone = kept.id === vehicle.id ? next : vehicle;
    toast(say("measure-pass-joined", { gone: String(gone.number), kept: String(kept.number) }));
  });
}

/** A found pass is right: its proposed lighting is written down as a person's. */
export function confirmPass(model: MeasureModel): void {
  const vehicle = model.vehicle.value;
  const proposed = vehicle && lightingProposed(vehicle);
  if (proposed) model.edit({ lighting: proposed });
}

/** Reads the survey's passes anew, after some were found; opens the first where none was open. */
export async function readAgain(model: MeasureModel): Promise<void> {
  await tell(async () => {
    for (const vehicle of await listVehicles(model.surveyId)) put(model, vehicle);
    const first = model.list.value[0];
    if (first && model.vehicleId.value === null) model.open(first);
  });
}

async function split(model: MeasureModel, vehicle: Vehicle, frame: number): Promise<Vehicle> {
  const version = await saved(model, vehicle);
  const { earlier, later } = await api.write(
    "POST /vehicles/{vehicle_id}/split",
    { vehicle_id: vehicle.id },
    { body: { frame, version } },
  );
  put(model, earlier);
  put(model, later);
  return earlier.id === vehicle.id ? later : earlier;
}

async function join(model: MeasureModel, one: Vehicle, other: Vehicle): Promise<Vehicle> {
  const version = await saved(model, one);
  const other_version = await saved(model, other);
  const body = { other_id: other.id, version, other_version };
  const kept = await api.write("POST /vehicles/{vehicle_id}/join", { vehicle_id: one.id }, { body });
  model.vehicles.drop(kept.id === one.id ? other.id : one.id);
  put(model, kept);
  if (model.vehicleId.value !== kept.id) model.open(kept);
  return kept;
}

async function dropPass(model: MeasureModel, vehicle: Vehicle): Promise<void> {
  await removeVehicle(vehicle.id, await saved(model, vehicle));
  model.vehicles.drop(vehicle.id);
}

async function putSpan(model: MeasureModel, vehicle: Vehicle): Promise<void> {
  const { first_frame, last_frame, best_frame } = vehicle;
  model.vehicles.edit(vehicle.id, { first_frame, last_frame, best_frame });
  await model.vehicles.flush(vehicle.id);
}

/** The version on the server once what is typed has been stored. */
async function saved(model: MeasureModel, vehicle: Vehicle): Promise<number> {
  await model.vehicles.flush(vehicle.id);
  return model.vehicles.get(vehicle.id)?.version ?? vehicle.version;
}

function put(model: MeasureModel, vehicle: Vehicle): void {
  model.vehicles.take(vehicle);
  model.records.take(vehicle);
}

/** After what is being undone or redone, whose versions this work needs. */
function tellInTurn(model: MeasureModel, work: () => Promise<void>): Promise<void> {
  return tell(() => model.history.inTurn(work));
}

async function tell(work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (error) {
    toastProblem(error);
  }
}
