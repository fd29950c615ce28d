/** The heart: passes on the left, the frame in the middle, the vehicle on the right, the timeline below. */
import { useMemo } from "preact/hooks";
import { Empty, Loading } from "../../components";
import { Button } from "../../components/Button";
import type { ButtonCommand } from "../../components/CommandButton";
import { type HistoryCommands, historyCommands, useUndoTools } from "../../components/undoTools";
import { useCommands } from "../../core/commands";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { canWork } from "../../core/session";
import type { Target } from "../../core/types";
import { TARGETS } from "../../core/words";
import { FailedPage } from "../../parts/FailedPage";
import { usePageModel } from "../../parts/pageModel";
import { targetAction } from "../../parts/vehicles/TargetButton";
import { frameCommands } from "../../viewer/stageCommands";
import { FramePanel } from "./FramePanel";
import { MeasureModel } from "./model";
import { PassList } from "./PassList";
import { TimelinePanel } from "./TimelinePanel";
import { useTabs } from "./tabs";
import { VehiclePanel } from "./VehiclePanel";
import "../../parts/vehicles/vehicle.css";
import "./vehicle.css";
import "./measure.css";

export default function MeasureScreen({ surveyId }: ScreenProps) {
  const model = usePageModel(() => new MeasureModel(surveyId), [surveyId]);
  const steps = useMemo(() => stepsOf(model), [model]);
  const player = model.reel.player.value;
  useCommands([steps.undo, steps.redo, ...measureCommands(model), ...frameCommands(model.stage, player)]);
  useTabs(model);
  useUndoTools(model.history, steps);

  if (model.problem.value) return <FailedPage model={model} />;
  if (model.loaded.value && !player) return <NothingToMeasure surveyId={surveyId} />;
  return (
    <div class="desk measure">
      <h1 class="visually-hidden">{say("page-measure")}</h1>
      <PassList model={model} />
      {player ? (
        <FramePanel key={player.recordingId} model={model} player={player} />
      ) : (
        <Loading what={say("measure-loading")} />
      )}
      <VehiclePanel model={model} />
      {player && <TimelinePanel model={model} player={player} />}
    </div>
  );
}

function NothingToMeasure({ surveyId }: { surveyId: number }) {
  return (
    <Empty
      says="measure-none-title"
      why="measure-none"
      actions={
        <Button says="measure-add-recordings" kind="primary" href={`/surveys/${surveyId}/recordings`} />
      }
    />
  );
}

function measureCommands(model: MeasureModel): ButtonCommand[] {
  const choose = (target: Target): ButtonCommand => ({
    id: targetAction(target),
    run: () => void (model.proposals.jump(target) || model.dispatch({ type: "choose", target })),
    enabled: mayWork,
  });
  return [
    ...TARGETS.map(choose),
    { id: "proposeContact", run: () => model.assist.propose() },
    { id: "passNext", run: () => model.go(1) },
    { id: "passPrevious", run: () => model.go(-1) },
    { id: "bestFrame", run: () => model.toBestFrame() },
    { id: "passBegin", run: () => model.passes.mark("first") },
    { id: "passEnd", run: () => model.passes.mark("last") },
    { id: "notVisible", run: () => model.askWhyUnseen(), enabled: mayWork },
    {
      id: "newContact",
      run: () => void (model.proposals.jump("contact") || model.dispatch({ type: "new-contact" })),
    },
    { id: "selectNext", run: () => model.points.selectNext() },
    { id: "driverSide", run: () => model.insets.turnSide(), enabled: mayWork },
    { id: "secondFrame", run: () => void model.second.start(), enabled: mayWork },
    { id: "followPass", run: () => void model.whole.start(), enabled: mayWork },
    { id: "confirmNext", run: () => confirmNext(model) },
    { id: "remove", run: () => model.points.removeSelected() },
  ];
}

const mayWork = (): boolean => canWork.value;

/** What is typed counts: its field is left first. */
function confirmNext(model: MeasureModel): void {
  if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  model.confirmNext();
}

/** Nudges that have not yet ended count as done first. */
function stepsOf(model: MeasureModel): HistoryCommands {
  return historyCommands(model.history, {
    settle: () => model.points.endBurst(),
    back: () => model.stage.back(),
    inHand: () => model.points.moving || model.second.active.value,
  });
}
