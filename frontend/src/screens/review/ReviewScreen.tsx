/** Review: the queue on the left, the picture with its points in the middle, what is known and the verdict on the right. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Problem } from "../../components";
import { type ButtonCommand, CommandButton } from "../../components/CommandButton";
import { historyCommands, useUndoTools } from "../../components/undoTools";
import { type ActionId, useCommands } from "../../core/commands";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { BlindFrame } from "../../viewer/BlindFrame";
import { brightSwitch, frameCommands, loupeSwitch } from "../../viewer/stageCommands";
import { Transport } from "../../viewer/Transport";
import { ReviewModel } from "./model";
import { benchOf, lotAddress, Queue } from "./Queue";
import { ReviewFrame } from "./ReviewFrame";
import { REASONS } from "./reasons";
import { VerdictPanel } from "./VerdictPanel";
import "../../parts/vehicles/vehicle.css";
import "../../parts/vehicles/passes.css";
import "./review.css";

export default function ReviewScreen({ surveyId }: ScreenProps) {
  const model = useMemo(() => new ReviewModel(surveyId), [surveyId]);
  useEffect(() => {
    void model.load();
    return () => model.close();
  }, [model]);
  const player = model.reel.player.value;
  const steps = useMemo(() => historyCommands(model.history, { back: () => model.stage.back() }), [model]);
  useUndoTools(model.history, steps);
  useCommands([steps.undo, steps.redo, ...reviewCommands(model), ...frameCommands(model.stage, player)]);
  if (model.problem.value) {
    return (
      <div class="page">
        <Problem error={model.problem.value} again={() => void model.load()} />
      </div>
    );
  }
  const items = model.queue.items.value;
  return (
    <div class="review">
      <h1 class="visually-hidden">{say("page-review")}</h1>
      <Queue model={model} />
      {items === null ? (
        <Loading what={say("review-loading")} />
      ) : model.current.value && player ? (
        <>
          <section class="frame-place" aria-label={say("stage-frame")}>
            {model.hidden.value ? (
              <BlindFrame key={player.recordingId} blind={model.blind} player={player} stage={model.stage} />
            ) : (
              <ReviewFrame key={player.recordingId} model={model} player={player} />
            )}
          </section>
          <VerdictPanel model={model} item={model.current.value} />
          <section class="review__time frame-tools" aria-label={say("stage-frames")}>
            <Transport player={player} stage={model.stage} />
            <span class="grow" />
            {!model.onFrame.value && (
              <Button
                small
                onClick={() => model.current.value && model.showFrame(model.current.value.measurement)}
              >
                {say("review-back-to-frame", { frame: String(model.current.value.measurement.frame) })}
              </Button>
            )}
            <CommandButton command={brightSwitch}>{say("stage-bright")}</CommandButton>
            <CommandButton command={loupeSwitch(model.stage)}>{say("stage-loupe")}</CommandButton>
          </section>
        </>
      ) : (
        <NothingHere surveyId={surveyId} model={model} />
      )}
    </div>
  );
}

function NothingHere({ surveyId, model }: { surveyId: number; model: ReviewModel }) {
  if (model.queue.lot !== null) {
    return (
      <Empty
        title={say("lots-sample-done-title")}
        actions={
          <Button kind="primary" href={lotAddress(surveyId, model.queue.lot)}>
            {say("lots-decide")}
          </Button>
        }
      >
        <p>{say("lots-sample-done")}</p>
      </Empty>
    );
  }
  if (model.queue.shown.value !== "to_review") {
    return (
      <Empty title={say("review-none-in-state-title")}>
        <p>{say("review-none-in-state")}</p>
      </Empty>
    );
  }
  const line = model.queue.lineHeights.value?.items.find((one) => !one.mine);
  if (line) {
    return (
      <Empty
        title={say("review-lines-left-title")}
        actions={
          <Button kind="primary" href={benchOf(surveyId, line)}>
            {say("review-lines-open")}
          </Button>
        }
      >
        <p>{say("review-lines-left")}</p>
      </Empty>
    );
  }
  const measured = survey.value?.counts.measurements ?? 0;
  return (
    <Empty
      title={say(measured > 0 ? "review-all-done-title" : "review-none-title")}
      actions={
        <Button kind="primary" href={`/surveys/${surveyId}/${measured > 0 ? "export" : "measure"}`}>
          {say(measured > 0 ? "review-to-export" : "review-to-measure")}
        </Button>
      }
    >
      <p>{say(measured > 0 ? "review-all-done" : "review-none")}</p>
    </Empty>
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
    ...REASONS.map(
      (reason, i): ButtonCommand => ({
        id: `reviewReason${i + 1}` as ActionId,
        run: () => {
          model.reason.value = say(reason);
        },
        enabled: () => model.rejecting.value,
      }),
    ),
    { id: "reviewFix", run: () => model.startFix(), enabled: mayReview },
    { id: "selectNext", label: say("review-other-point"), run: () => model.fixing.selectNext() },
  ];
}
