/** Road pose: the board on the frame, its size and its height above the road; the road drawn over the picture. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Problem } from "../../components";
import { CommandButton } from "../../components/CommandButton";
import { useCommands } from "../../core/commands";
import type { ScreenProps } from "../../core/places";
import { canWork } from "../../core/session";
import { linesShown } from "../../viewer/display";
import { FrameView } from "../../viewer/FrameView";
import { FoundBoard, RoadOverlay } from "../../viewer/PoseOverlay";
import type { Player } from "../../viewer/player";
import {
  brightSwitch,
  fitCommand,
  frameCommands,
  linesSwitch,
  loupeSwitch,
} from "../../viewer/stageCommands";
import { type Span, Timeline } from "../../viewer/Timeline";
import { Transport } from "../../viewer/Transport";
import { PoseModel } from "./model";
import { PoseForm } from "./PoseForm";
import { PoseResult } from "./PoseResult";
import "./pose.css";

export default function PoseScreen({ surveyId }: ScreenProps) {
  const model = useMemo(() => new PoseModel(surveyId), [surveyId]);
  useEffect(() => {
    void model.load();
    return () => model.close();
  }, [model]);
  const player = model.reel.player.value;
  useCommands([
    {
      id: "passBegin",
      label: "Mark the first frame of the board",
      run: () => model.mark("first"),
      enabled: mayMark,
    },
    {
      id: "passEnd",
      label: "Mark the last frame of the board",
      run: () => model.mark("last"),
      enabled: mayMark,
    },
    ...frameCommands(model.stage, player),
  ]);
  if (model.problem.value) {
    return (
      <div class="page">
        <Problem error={model.problem.value} again={() => void model.load()} />
      </div>
    );
  }
  if (!model.loaded.value) return <Loading what="the road pose" />;
  if (!player) {
    return (
      <Empty
        title="No recording with the board yet"
        actions={
          <Button kind="primary" href={`/surveys/${surveyId}/recordings`}>
            Add recordings
          </Button>
        }
      >
        <p>Add the video in which the checkerboard stands on the road; the road pose is found from it.</p>
      </Empty>
    );
  }
  return (
    <div class="pose">
      <h1 class="visually-hidden">Road pose</h1>
      <section class="pose__frame" aria-label="Frame">
        <FrameView
          key={player.recordingId}
          player={player}
          stage={model.stage}
          describedBy="pose-hint"
          above={<BoardHint model={model} />}
        >
          {linesShown.value && model.pose.value && (
            <RoadOverlay overlay={model.pose.value.overlay} stage={model.stage} />
          )}
          {model.finding.value?.found && <FoundBoard finding={model.finding.value} stage={model.stage} />}
        </FrameView>
      </section>
      <aside class="pose__side" aria-label="Board and result">
        <PoseResult model={model} />
        <PoseForm model={model} />
      </aside>
      <section class="pose__time" aria-label="Timeline">
        <div class="frame-tools">
          <Transport player={player} stage={model.stage} />
          <span class="grow" />
          <CommandButton command={fitCommand(model.stage)}>Fit</CommandButton>
          <CommandButton command={linesSwitch}>Lines</CommandButton>
          <CommandButton command={brightSwitch}>Bright</CommandButton>
          <CommandButton command={loupeSwitch(model.stage)}>Loupe</CommandButton>
        </div>
        <Timeline player={player} spans={spansOf(model, player)} />
      </section>
    </div>
  );
}

const mayMark = (): boolean => canWork.value;

function spansOf(model: PoseModel, player: Player): Span[] {
  const { first, last } = model.form.value;
  const end = last ?? (first === null ? null : Math.max(first, player.frame.value));
  if (first === null || end === null) return [];
  return [
    { id: "board", first, last: end, label: "", title: `Board: frames ${first} to ${end}`, kind: "board" },
  ];
}

function BoardHint({ model }: { model: PoseModel }) {
  const finding = model.finding.value;
  const inUse = model.pose.value !== null;
  const advice = inUse
    ? "This recording has its road pose. To find it again, go to a frame in which the board stands still."
    : "Go to a frame in which the board stands still.";
  const problem = model.findingProblem.value;
  const words = finding?.found
    ? finding.order_note
    : model.looking.value
      ? "Looking for the board…"
      : inUse || problem === null
        ? advice
        : problem;
  return (
    <p class="frame-hint" id="pose-hint" role="status">
      {finding?.found && (
        <strong class="nowrap">{finding.ids ? "Part" : `${finding.columns} × ${finding.rows}`} found</strong>
      )}
      <span>{words}</span>
    </p>
  );
}
