/** Review: the queue on the left, the picture with its points in the middle, what is known and the verdict on the right. */
import { useMemo } from "preact/hooks";
import { Button, Empty, Loading } from "../../components";
import { type ButtonCommand, CommandButton } from "../../components/CommandButton";
import { historyCommands, useUndoTools } from "../../components/undoTools";
import { useCommands } from "../../core/commands";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { may } from "../../core/session";
import type { Measurement } from "../../core/types";
import { FailedPage } from "../../parts/FailedPage";
import { usePageModel } from "../../parts/pageModel";
import { BlindFrame } from "../../viewer/BlindFrame";
import type { Player } from "../../viewer/player";
import { brightSwitch, frameCommands, loupeSwitch, pictureCommands } from "../../viewer/stageCommands";
import { Transport } from "../../viewer/Transport";
import { LineFrame } from "./LineFrame";
import { ReviewModel } from "./model";
import { lotAddress, Queue } from "./Queue";
import { ReviewFrame } from "./ReviewFrame";
import { VerdictPanel } from "./VerdictPanel";
import "../../parts/vehicles/vehicle.css";
import "../../parts/vehicles/passes.css";
import "./review.css";

export default function ReviewScreen({ surveyId }: ScreenProps) {
  const model = usePageModel(() => new ReviewModel(surveyId), [surveyId]);
  const player = model.reel.player.value;
  const steps = useMemo(() => historyCommands(model.history, { back: () => model.stage.back() }), [model]);
  useUndoTools(model.history, steps);
  const item = model.current.value;
  const ofPicture =
    item && !model.ofFrame.value ? pictureCommands(model.strips.stage) : frameCommands(model.stage, player);
  useCommands([steps.undo, steps.redo, ...reviewCommands(model), ...ofPicture]);
  if (model.problem.value) return <FailedPage model={model} />;
  const items = model.queue.items.value;
  return (
    <div class="desk review">
      <h1 class="visually-hidden">{say("page-review")}</h1>
      <Queue model={model} />
      {items === null ? (
        <Loading what={say("review-loading")} />
      ) : item && (player || !model.ofFrame.value) ? (
        <>
          <section class="frame-place" aria-label={say("stage-frame")}>
            <Shown model={model} player={player} />
          </section>
          <VerdictPanel model={model} item={item} />
          {player && model.ofFrame.value && (
            <FrameTools model={model} player={player} m={model.ofFrame.value} />
          )}
        </>
      ) : (
        <NothingHere surveyId={surveyId} model={model} />
      )}
    </div>
  );
}

/** The picture of what is open: a frame, one to be clicked again, or the strips. */
function Shown({ model, player }: { model: ReviewModel; player: Player | null }) {
  if (!player || !model.ofFrame.value) return <LineFrame picture={model.strips} />;
  const key = player.recordingId;
  if (model.hidden.value)
    return <BlindFrame key={key} blind={model.blind} player={player} stage={model.stage} />;
  return <ReviewFrame key={key} model={model} player={player} />;
}

function FrameTools({ model, player, m }: { model: ReviewModel; player: Player; m: Measurement }) {
  return (
    <section
      class="desk__time desk__time--low review__time row row--near frame-tools"
      aria-label={say("stage-frames")}
    >
      <Transport player={player} stage={model.stage} />
      <span class="grow" />
      {!model.onFrame.value && (
        <Button small onClick={() => model.showFrame(m)}>
          {say("review-back-to-frame", { frame: String(m.frame) })}
        </Button>
      )}
      <CommandButton command={brightSwitch}>{say("stage-bright")}</CommandButton>
      <CommandButton command={loupeSwitch(model.stage)}>{say("stage-loupe")}</CommandButton>
    </section>
  );
}

function NothingHere({ surveyId, model }: { surveyId: number; model: ReviewModel }) {
  if (model.queue.lot !== null) {
    return (
      <Empty
        says="lots-sample-done-title"
        why="lots-sample-done"
        actions={<Button says="lots-decide" kind="primary" href={lotAddress(surveyId, model.queue.lot)} />}
      />
    );
  }
  if (model.queue.shown.value !== "to_review") {
    return <Empty says="review-none-in-state-title" why="review-none-in-state" />;
  }
  const measured = model.queue.work.value?.heights ?? 0;
  return (
    <Empty
      says={measured > 0 ? "review-all-done-title" : "review-none-title"}
      why={measured > 0 ? "review-all-done" : "review-none"}
      actions={
        <Button
          says={measured > 0 ? "review-to-export" : "review-to-measure"}
          kind="primary"
          href={`/surveys/${surveyId}/${measured > 0 ? "export" : "measure"}`}
        />
      }
    />
  );
}

function reviewCommands(model: ReviewModel): ButtonCommand[] {
  const mayReview = (): boolean => may("reviewer");
  return [
    { id: "reviewNext", run: () => model.go(1) },
    { id: "reviewPrevious", run: () => model.go(-1) },
    {
      id: "reviewAccept",
      run: () => void model.judge("accepted"),
      enabled: () => mayReview() && model.fix.value === null,
    },
    { id: "reviewReject", run: () => model.startReject(), enabled: mayReview },
    ...model.rejection.commands,
    { id: "reviewFix", run: () => model.startFix(), enabled: mayReview },
    { id: "selectNext", label: say("review-other-point"), run: () => model.fixing.selectNext() },
  ];
}
