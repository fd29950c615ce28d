/** Passes taken apart, put together and confirmed; each a step that can be undone. */
import type { ChangeSet } from "../../../core/history";
import { say } from "../../../core/messages";
import { telling, toast } from "../../../core/toasts";
import type { Vehicle } from "../../../core/types";
import { lightingProposed } from "../../../parts/vehicles/passes";
import type { MeasureModel } from "../model";
import { type JoinAbout, PASS_JOINED, PASS_SPLIT, type Parts, type SplitAbout } from "./kinds";

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

/** The frames of a pass: what splitting and joining change of one that stays. */
const SPAN = ["first_frame", "last_frame", "best_frame"] as const;

function touchSpan(model: MeasureModel, changes: ChangeSet, id: number): void {
  for (const field of SPAN) changes.touch(model.facts, { id, field });
}

/** The current pass becomes two; the second begins on the frame that is seen. */
export async function splitPass(model: MeasureModel): Promise<void> {
  const chosen = model.vehicle.value;
  const frame = model.seenFrame.value;
  if (!chosen) return;
  await model.passes.inTurn(async () => {
    const vehicle = model.vehicles.get(chosen.id) ?? chosen;
    const named = { vehicle: String(vehicle.number) };
    const stored = await model.passes.store<Parts, number, SplitAbout>({
      key: `split.${vehicle.id}`,
      kind: PASS_SPLIT,
      lane: `vehicle.${vehicle.id}`,
      about: { id: vehicle.id, version: model.passes.versionOf(vehicle) },
      what: say("measure-step-split", named),
      mine: say("measure-frame", { frame: String(frame) }),
      saved: null,
      want: frame,
    });
    const { earlier, later } = stored?.saved ?? {};
    if (!earlier || !later) return toast(say("measure-pass-kept"));
    const made = earlier.id === vehicle.id ? later : earlier;
    model.history.run(say("measure-step-split", named), (changes) => {
      touchSpan(model, changes, vehicle.id);
      changes.touch(model.passes.presence, made.id);
      model.reading.put(earlier);
      model.reading.put(later);
    });
    const parts = { ...named, other: String(made.number) };
    toast(say("measure-pass-splitted", { ...parts, frame: String(frame) }));
  });
}

/** The current pass and the one that begins next become one. */
export async function joinPass(model: MeasureModel): Promise<void> {
  const chosen = model.vehicle.value;
  if (!chosen) return;
  await model.passes.inTurn(async () => {
    const vehicle = model.vehicles.get(chosen.id) ?? chosen;
    const next = nextInTime(model.vehicles.list.value, vehicle);
    if (!next) return toast(say("measure-pass-no-next"));
    const named = { vehicle: String(vehicle.number), next: String(next.number) };
    const opened = model.vehicleId.value;
    const about = {
      id: vehicle.id,
      other_id: next.id,
      version: model.passes.versionOf(vehicle),
      other_version: model.passes.versionOf(next),
    };
    const ends = [vehicle.first_frame, Math.max(vehicle.last_frame, next.last_frame)] as const;
    const stored = await model.passes.store<Vehicle, readonly [number, number], JoinAbout>({
      key: `join.${vehicle.id}`,
      kind: PASS_JOINED,
      lane: `vehicle.${vehicle.id}`,
      about,
      what: say("measure-step-joining", named),
      mine: say("measure-step-joining", named),
      saved: null,
      want: ends,
    });
    const kept = stored?.saved;
    if (!kept) return toast(say("measure-pass-kept"));
    const gone = kept.id === vehicle.id ? next : vehicle;
    model.history.run(say("measure-step-joining", named), (changes) => {
      touchSpan(model, changes, kept.id);
      changes.touch(model.passes.presence, gone.id);
      model.passes.takenOut(gone);
      model.reading.put(kept);
      if (opened === gone.id) model.passes.openUnless(kept, opened);
    });
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
  await telling(async () => {
    await model.reading.again();
    const first = model.list.value[0];
    if (first && model.vehicleId.value === null) model.open(first);
  });
}
