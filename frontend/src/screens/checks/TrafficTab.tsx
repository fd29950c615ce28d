/** Both tyres of each vehicle, clicked pass by pass: the direction of travel against the road's X axis. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Notice, Problem } from "../../components";
import { type ButtonCommand, CommandButton } from "../../components/CommandButton";
import { linkTo, Said } from "../../components/Said";
import { type HistoryCommands, historyCommands } from "../../components/undoTools";
import { asked } from "../../core/address";
import { useCommands } from "../../core/commands";
import { say } from "../../core/messages";
import { vehicleName } from "../../core/words";
import { FrameView } from "../../viewer/FrameView";
import { AxesLayer, InImage, Line, PointMark } from "../../viewer/Overlay";
import { RoadOverlay } from "../../viewer/PoseOverlay";
import type { Player } from "../../viewer/player";
import { fromServer } from "../../viewer/points";
import { frameCommands, loupeSwitch } from "../../viewer/stageCommands";
import { Transport } from "../../viewer/Transport";
import { formatHeading } from "./angles";
import { TrafficModel } from "./model";
import { TrafficSide } from "./TrafficSide";

export function TrafficTab({ surveyId }: { surveyId: number }) {
  const model = useMemo(() => new TrafficModel(surveyId), [surveyId]);
  const load = () => void model.load(asked("vehicle"));
  useEffect(() => {
    load();
    return () => model.close();
  }, [model]);
  const commands = useMemo(() => commandsOf(model), [model]);
  const player = model.reel.player.value;
  useCommands([...Object.values(commands), ...frameCommands(model.stage, player)]);
  if (model.problem.value) return <Problem error={model.problem.value} again={load} />;
  if (!model.loaded.value) return <Loading what={say("checks-vehicles-loading")} />;
  if (!player || model.vehicles.value.length === 0) {
    return (
      <Empty
        says="checks-no-vehicles-title"
        why="checks-no-vehicles"
        actions={<Button says="checks-mark-passes" href={`/surveys/${surveyId}/measure`} />}
      />
    );
  }
  return (
    <div class="traffic">
      <section class="frame-place" aria-label={say("stage-frame")}>
        <FrameView
          key={player.recordingId}
          player={player}
          stage={model.stage}
          describedBy="traffic-hint"
          above={
            <>
              <Hint model={model} />
              {/* over the picture: below it, it would move the picture between two clicks */}
              <div class="traffic__refused">
                <Problem error={model.refused.value} />
              </div>
            </>
          }
        >
          <Marks model={model} />
        </FrameView>
      </section>
      <Tools model={model} player={player} commands={commands} />
      <TrafficSide model={model} />
    </div>
  );
}

interface Commands extends HistoryCommands {
  readonly next: ButtonCommand;
  readonly previous: ButtonCommand;
  readonly withdraw: ButtonCommand;
}

function commandsOf(model: TrafficModel): Commands {
  return {
    ...historyCommands(model.history, {
      back: () => model.saving.value || model.stage.back(),
      inHand: () => model.clicks.first.value !== null,
    }),
    next: { id: "passNext", run: () => model.openNext(1) },
    previous: { id: "passPrevious", run: () => model.openNext(-1) },
    withdraw: { id: "remove", label: say("checks-withdraw"), run: () => void model.withdraw() },
  };
}

function Marks({ model }: { model: TrafficModel }) {
  const { stage } = model;
  const preview = model.preview.value;
  const stored = model.pair.value;
  const here = stored && stored.frame === model.reel.seen.value && !model.clicks.first.value ? stored : null;
  const axes = model.axes.value?.axes;
  return (
    <>
      {preview && <RoadOverlay overlay={preview.overlay} stage={stage} />}
      {axes && model.contact.value && !preview && <AxesLayer axes={axes} stage={stage} />}
      {here && (
        <g data-testid="wheel-pair">
          <InImage stage={stage}>
            <Line points={[here.first, here.second]} kind="guide" />
          </InImage>
          <PointMark stage={stage} at={fromServer(here.first)} kind="contact" text="1" />
          <PointMark stage={stage} at={fromServer(here.second)} kind="contact" text="2" />
        </g>
      )}
    </>
  );
}

function Hint({ model }: { model: TrafficModel }) {
  const vehicle = model.vehicle.value;
  const heading = model.pose.value?.vehicles.find((one) => one.vehicle_id === vehicle?.id);
  const here = model.pair.value?.frame === model.reel.seen.value;
  const first = model.clicks.first.value;
  return (
    <p class="frame-hint" id="traffic-hint" role="status">
      {vehicle && <strong class="nowrap">{vehicleName(vehicle.number)}</strong>}
      {here && heading?.heading_rad != null && !first && !model.preview.value && (
        <strong class="nowrap">{formatHeading(heading.heading_rad, heading.u_heading_rad)}</strong>
      )}
      <span>{hintOf(model, here)}</span>
    </p>
  );
}

function hintOf(model: TrafficModel, here: boolean): string {
  if (model.reel.recording.value?.pose_id == null) return say("checks-no-pose");
  if (model.preview.value) return say("checks-turned-road");
  if (here && !model.clicks.first.value) return say("checks-replace");
  return model.stage.hint.value ?? say("checks-choose-vehicle");
}

function Tools(props: { model: TrafficModel; player: Player; commands: Commands }) {
  const { model, player, commands } = props;
  return (
    <section class="traffic__tools" aria-label={say("stage-frames")}>
      {model.reel.recording.value?.pose_id == null && (
        <Notice kind="warning">
          <Said what="checks-no-pose-link" parts={linkTo(`/surveys/${model.surveyId}/pose`)} />
        </Notice>
      )}
      <div class="row row--wrap row--near frame-tools">
        <CommandButton command={commands.previous} kind="plain">
          {say("checks-previous")}
        </CommandButton>
        <CommandButton command={commands.next} kind="plain">
          {say("checks-next")}
        </CommandButton>
        <Transport player={player} stage={model.stage} />
        <span class="grow" />
        <CommandButton command={loupeSwitch(model.stage)}>{say("stage-loupe")}</CommandButton>
        <CommandButton command={commands.undo} />
      </div>
    </section>
  );
}
