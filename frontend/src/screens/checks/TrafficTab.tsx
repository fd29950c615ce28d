/** Both tyres of each vehicle, clicked pass by pass: the direction of travel against the road's X axis. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Notice, Problem } from "../../components";
import { query } from "../../core/address";
import { hint, useKeys } from "../../core/commands";
import { FrameView } from "../../viewer/FrameView";
import { AxesLayer, InImage, KeyboardCursor, Line, PointMark } from "../../viewer/Overlay";
import { RoadOverlay } from "../../viewer/PoseOverlay";
import type { Player } from "../../viewer/player";
import { fromServer, pair } from "../../viewer/points";
import { frameKeys, HELD_KEYS, Transport } from "../../viewer/Transport";
import { formatHeading } from "./angles";
import { TrafficModel } from "./model";
import { TrafficSide } from "./TrafficSide";

export function TrafficTab({ surveyId }: { surveyId: number }) {
  const model = useMemo(() => new TrafficModel(surveyId), [surveyId]);
  const load = () => void model.load(Number(query.value.get("vehicle")) || null);
  useEffect(() => {
    load();
    return () => model.close();
  }, [model]);
  useTrafficKeys(model);
  const player = model.player.value;
  if (model.problem.value) return <Problem error={model.problem.value} again={load} />;
  if (!model.loaded.value) return <Loading what="the vehicles" />;
  if (!player || model.vehicles.value.length === 0) {
    return (
      <Empty
        title="No vehicles yet"
        actions={<Button href={`/surveys/${surveyId}/measure`}>Mark the passes</Button>}
      >
        <p>The direction of travel comes from the tyres of vehicles whose passes are marked.</p>
      </Empty>
    );
  }
  return (
    <div class="traffic">
      <section class="traffic__frame" aria-label="Frame">
        <FrameView
          key={player.recordingId}
          player={player}
          stage={model.stage}
          label={`Frame ${player.frame.value}`}
          describedBy="traffic-hint"
          placing={model.placing.value}
          onPlace={(point) => model.place(point)}
          onHover={() => {
            model.cursor.value = null;
          }}
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
      <Tools model={model} player={player} />
      <TrafficSide model={model} />
    </div>
  );
}

function useTrafficKeys(model: TrafficModel): void {
  const player = model.player.value;
  const move = (dx: number, dy: number) => () => model.moveCursor(dx, dy);
  useKeys(
    {
      ...(player ? frameKeys(player, model.stage) : {}),
      loupeToggle: () => {
        model.stage.loupe.value = !model.stage.loupe.value;
      },
      passNext: () => model.openNext(1),
      passPrevious: () => model.openNext(-1),
      undo: () => void model.undo(),
      remove: () => void model.withdraw(),
      cursor: () => model.toggleCursor(),
      place: () => {
        if (!model.cursor.value) return false;
        model.place(model.cursor.value);
        return true;
      },
      cancel: () => {
        if (model.cursor.value) model.cursor.value = null;
        else if (model.first.value) model.first.value = null;
        else model.preview.value = null;
      },
      nudgeLeft: move(-1, 0),
      nudgeRight: move(1, 0),
      nudgeUp: move(0, -1),
      nudgeDown: move(0, 1),
      nudgeLeftFar: move(-10, 0),
      nudgeRightFar: move(10, 0),
      nudgeUpFar: move(0, -10),
      nudgeDownFar: move(0, 10),
      nudgeLeftFine: move(-0.1, 0),
      nudgeRightFine: move(0.1, 0),
      nudgeUpFine: move(0, -0.1),
      nudgeDownFine: move(0, 0.1),
    },
    HELD_KEYS,
  );
}

function Marks({ model }: { model: TrafficModel }) {
  const { stage } = model;
  const preview = model.preview.value;
  const stored = model.pair.value;
  const here = stored && stored.frame === model.shownFrame.value && !model.first.value ? stored : null;
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
      {model.first.value && (
        <>
          {stage.pointer.value && (
            <InImage stage={stage}>
              <Line points={[pair(model.first.value.at), pair(stage.pointer.value)]} kind="guide" />
            </InImage>
          )}
          <PointMark stage={stage} at={model.first.value.at} kind="contact" text="1" selected />
        </>
      )}
      {model.cursor.value && <KeyboardCursor stage={stage} at={model.cursor.value} />}
    </>
  );
}

function Hint({ model }: { model: TrafficModel }) {
  const vehicle = model.vehicle.value;
  const heading = model.pose.value?.vehicles.find((one) => one.vehicle_id === vehicle?.id);
  const here = model.pair.value?.frame === model.shownFrame.value;
  let words = "Choose a vehicle.";
  if (model.recording.value?.pose_id == null) words = "This recording has no road pose yet.";
  else if (model.preview.value) words = "The road as the turned pose sees it.";
  else if (model.first.value) words = "Now the other tyre of the same side.";
  else if (here) words = "Click again to replace it.";
  else if (vehicle && model.placing.value)
    words = "Click where the first tyre of the near side touches the road.";
  return (
    <p class="frame-hint" id="traffic-hint" role="status">
      {vehicle && <strong class="nowrap">#{vehicle.number}</strong>}
      {here && heading?.heading_rad != null && !model.first.value && !model.preview.value && (
        <strong class="nowrap">{formatHeading(heading.heading_rad, heading.u_heading_rad)}</strong>
      )}
      <span>{words}</span>
    </p>
  );
}

function Tools({ model, player }: { model: TrafficModel; player: Player }) {
  return (
    <section class="traffic__tools" aria-label="Frames">
      {model.recording.value?.pose_id == null && (
        <Notice kind="warning">
          Clicks need this recording’s road pose;{" "}
          <a href={`/surveys/${model.surveyId}/pose`}>find the road</a> first.
        </Notice>
      )}
      <div class="frame-tools">
        <Button small title={`Previous pass${hint("passPrevious")}`} onClick={() => model.openNext(-1)}>
          Previous
        </Button>
        <Button small title={`Next pass${hint("passNext")}`} onClick={() => model.openNext(1)}>
          Next
        </Button>
        <Transport player={player} stage={model.stage} />
        <span class="grow" />
        <Button
          small
          kind="quiet"
          pressed={model.stage.loupe.value}
          title={`Loupe${hint("loupeToggle")}`}
          onClick={() => {
            model.stage.loupe.value = !model.stage.loupe.value;
          }}
        >
          Loupe
        </Button>
        <Button
          small
          kind="quiet"
          icon="undo"
          label="Undo"
          title={`Undo${hint("undo")}`}
          disabled={model.undos.value.length === 0 && !model.first.value}
          onClick={() => void model.undo()}
        />
      </div>
    </section>
  );
}
