/** The heart: passes on the left, the frame in the middle, the vehicle on the right, the timeline below. */
import { useEffect, useMemo } from "preact/hooks";
import { Empty, Loading, Problem } from "../../components";
import { Button } from "../../components/Button";
import { useUndoTools } from "../../components/undoTools";
import { useKeys } from "../../core/commands";
import type { ScreenProps } from "../../core/places";
import { canWork } from "../../core/session";
import { toastProblem } from "../../core/toasts";
import { TARGETS } from "../../core/words";
import { linesShown } from "../../viewer/display";
import { frameKeys, HELD_KEYS } from "../../viewer/Transport";
import { Assist } from "./assist/assist";
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
  const model = useMemo(() => new MeasureModel(surveyId), [surveyId]);
  const assist = useMemo(() => new Assist(model), [model]);
  useEffect(() => {
    void model.load();
    // clicks survive in the outbox; what is typed does not, so leaving asks first
    const ask = (event: BeforeUnloadEvent): void => {
      if (model.hasUnsaved) event.preventDefault();
    };
    window.addEventListener("beforeunload", ask);
    return () => {
      window.removeEventListener("beforeunload", ask);
      assist.close();
      model.close();
    };
  }, [model]);
  useMeasureKeys(model, assist);
  useTabs(model);
  useUndoTools(
    model.undo,
    () => takeBack(model),
    () => void model.undo.redo().catch(toastProblem),
  );

  if (model.problem.value) {
    return (
      <div class="page">
        <Problem error={model.problem.value} again={() => void model.load()} />
      </div>
    );
  }
  const player = model.player.value;
  if (model.loaded.value && !player) return <NothingToMeasure surveyId={surveyId} />;
  return (
    <div class="measure">
      <h1 class="visually-hidden">Measure</h1>
      <PassList model={model} />
      {player ? (
        <FramePanel key={player.recordingId} model={model} player={player} assist={assist} />
      ) : (
        <Loading what="the frame" />
      )}
      <VehiclePanel model={model} />
      {player && <TimelinePanel model={model} player={player} />}
    </div>
  );
}

function NothingToMeasure({ surveyId }: { surveyId: number }) {
  return (
    <Empty
      title="No recording to measure yet"
      actions={
        <Button kind="primary" href={`/surveys/${surveyId}/recordings`}>
          Add recordings
        </Button>
      }
    >
      <p>
        Heights are measured on the frames of a recording. Add the day's videos first; they can be measured as
        soon as they are read.
      </p>
    </Empty>
  );
}

/** Nudges that have not yet ended count as done first. */
function takeBack(model: MeasureModel): void {
  model.points.endBurst();
  if (model.second.takeBack()) return;
  void model.undo.undo().catch(toastProblem);
}

function useMeasureKeys(model: MeasureModel, assist: Assist): void {
  const player = model.player.value;
  const { points } = model;
  const nudge = (dx: number, dy: number) => () => points.nudge(dx, dy);
  const choose = (index: number) => () => {
    const target = TARGETS[index];
    if (target && canWork.value) model.dispatch({ type: "choose", target });
  };
  useKeys(
    {
      ...(player ? frameKeys(player, model.stage) : {}),
      loupeToggle: () => {
        model.stage.loupe.value = !model.stage.loupe.value;
      },
      linesToggle: () => {
        linesShown.value = !linesShown.value;
      },
      cursor: () => points.toggleCursor(),
      proposeContact: () => assist.propose(),
      place: () => {
        if (assist.take()) return true;
        const at = points.cursor.value;
        if (!at || !canWork.value) return false;
        points.place(at);
        return true;
      },
      passNext: () => model.go(1),
      passPrevious: () => model.go(-1),
      bestFrame: () => model.toBestFrame(),
      passBegin: () => model.markPass("first"),
      passEnd: () => model.markPass("last"),
      target1: choose(0),
      target2: choose(1),
      target3: choose(2),
      target4: choose(3),
      target5: choose(4),
      newContact: () => model.dispatch({ type: "new-contact" }),
      selectNext: () => points.selectNext(),
      secondFrame: () => {
        if (canWork.value) void model.second.start();
      },
      confirmNext: () => {
        if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
        model.confirmNext();
      },
      undo: () => takeBack(model),
      redo: () => void model.undo.redo().catch(toastProblem),
      remove: () => points.removeSelected(),
      cancel: () => {
        if (!assist.letGo()) cancel(model);
      },
      nudgeLeft: nudge(-1, 0),
      nudgeRight: nudge(1, 0),
      nudgeUp: nudge(0, -1),
      nudgeDown: nudge(0, 1),
      nudgeLeftFar: nudge(-10, 0),
      nudgeRightFar: nudge(10, 0),
      nudgeUpFar: nudge(0, -10),
      nudgeDownFar: nudge(0, 10),
      nudgeLeftFine: nudge(-0.1, 0),
      nudgeRightFine: nudge(0.1, 0),
      nudgeUpFine: nudge(0, -0.1),
      nudgeDownFine: nudge(0, 0.1),
    },
    HELD_KEYS,
  );
}

/** Esc takes back one thing at a time. */
function cancel(model: MeasureModel): void {
  const { points } = model;
  if (points.cursor.value) points.toggleCursor();
  else if (model.second.now.value) model.second.leave();
  else if (model.passFrom.value !== null) model.passFrom.value = null;
  else {
    points.endBurst();
    const used = points.entriesHere().length > 0;
    model.dispatch({ type: "escape", frame: model.seenFrame.value, used });
  }
}
