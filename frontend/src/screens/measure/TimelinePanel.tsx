/** Below the frame: recording, steps, frame and time, loupe; and the timeline with the passes. */
import { useEffect } from "preact/hooks";
import { Select } from "../../components";
import { CommandButton } from "../../components/CommandButton";
import { say } from "../../core/messages";
import type { Vehicle } from "../../core/types";
import { vehicleName } from "../../core/words";
import { bestFrame, isOpen, nextOpen } from "../../parts/vehicles/passes";
import { around } from "../../viewer/ahead";
import type { Player } from "../../viewer/player";
import type { Span } from "../../viewer/spans";
import { brightSwitch, fitCommand, linesSwitch, loupeSwitch } from "../../viewer/stageCommands";
import { Timeline } from "../../viewer/Timeline";
import { Transport } from "../../viewer/Transport";
import type { MeasureModel } from "./model";
import { passWords, spanLabel } from "./passes/marks";
import { followedSpans } from "./WholePassParts";

export function TimelinePanel({ model, player }: { model: MeasureModel; player: Player }) {
  const spans = model.vehicles.list.value
    .filter((vehicle) => vehicle.recording_id === player.recordingId)
    .map((vehicle) => spanOf(vehicle, model.vehicleId.value));
  const next = nextOpen(model.list.value, model.vehicle.value);
  const expected = next?.recording_id === player.recordingId ? bestFrame(next) : null;
  useEffect(() => player.expect(expected === null ? [] : around(expected)), [player, expected]);
  const from = model.passes.from.value;
  if (from !== null) {
    const at = model.seenFrame.value;
    spans.push({
      id: "new",
      first: Math.min(from, at),
      last: Math.max(from, at),
      label: say("measure-pass-new-short"),
      title: say("measure-pass-new"),
      kind: "current",
    });
  }
  return (
    <section class="desk__time" aria-label={say("stage-timeline")}>
      <div class="row row--near frame-tools">
        <Transport player={player} stage={model.stage} />
        <span class="grow" />
        {model.reel.recordings.value.length > 1 && <RecordingChoice model={model} player={player} />}
        <CommandButton command={fitCommand(model.stage)}>{say("stage-fit")}</CommandButton>
        <CommandButton command={linesSwitch}>{say("stage-lines")}</CommandButton>
        <CommandButton command={brightSwitch}>{say("stage-bright")}</CommandButton>
        <CommandButton command={loupeSwitch(model.stage)}>{say("stage-loupe")}</CommandButton>
      </div>
      <Timeline player={player} spans={[...spans, ...followedSpans(model)]} />
    </section>
  );
}

function spanOf(vehicle: Vehicle, current: number | null): Span {
  return {
    id: String(vehicle.id),
    first: vehicle.first_frame,
    last: vehicle.last_frame,
    label: spanLabel(vehicle),
    title: titleOf(vehicle),
    kind: vehicle.id === current ? "current" : isOpen(vehicle) ? "todo" : "done",
  };
}

function titleOf(vehicle: Vehicle): string {
  const span = {
    vehicle: vehicleName(vehicle.number),
    first_frame: String(vehicle.first_frame),
    last_frame: String(vehicle.last_frame),
  };
  const more = passWords(vehicle);
  return more ? say("measure-pass-title-more", { ...span, more }) : say("measure-pass-title", span);
}

function RecordingChoice({ model, player }: { model: MeasureModel; player: Player }) {
  return (
    <Select
      class="measure__recording"
      aria-label={say("field-recording")}
      value={player.recordingId}
      options={model.reel.recordings.value.map(({ id, name, state }) => ({
        value: id,
        label: name,
        disabled: state !== "ready",
      }))}
      onInput={(id) => model.chooseRecording(id)}
    />
  );
}
