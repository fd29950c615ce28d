/** Review: the queue on the left, the picture with its points in the middle, what is known and the verdict on the right. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Problem } from "../../components";
import { type ButtonCommand, CommandButton } from "../../components/CommandButton";
import { useCommands } from "../../core/commands";
import type { ScreenProps } from "../../core/places";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { BlindFrame } from "../../viewer/BlindFrame";
import { brightSwitch, frameCommands, loupeSwitch } from "../../viewer/stageCommands";
import { Transport } from "../../viewer/Transport";
import { ReviewModel, type Shown } from "./model";
import { Queue } from "./Queue";
import { ReviewFrame } from "./ReviewFrame";
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
  useCommands([...reviewCommands(model), ...frameCommands(model.stage, player)]);
  if (model.problem.value) {
    return (
      <div class="page">
        <Problem error={model.problem.value} again={() => void model.load()} />
      </div>
    );
  }
  const items = model.items.value;
  return (
    <div class="review">
      <h1 class="visually-hidden">Review</h1>
      <Queue model={model} />
      {items === null ? (
        <Loading what="the queue" />
      ) : model.current.value && player ? (
        <>
          <section class="review__frame" aria-label="Frame">
            {model.hidden.value ? (
              <BlindFrame key={player.recordingId} blind={model.blind} player={player} stage={model.stage} />
            ) : (
              <ReviewFrame key={player.recordingId} model={model} player={player} />
            )}
          </section>
          <VerdictPanel model={model} item={model.current.value} />
          <section class="review__time frame-tools" aria-label="Frames">
            <Transport player={player} stage={model.stage} />
            <span class="grow" />
            {!model.onFrame.value && (
              <Button
                small
                onClick={() => model.current.value && model.showFrame(model.current.value.measurement)}
              >
                Back to frame {model.current.value.measurement.frame}
              </Button>
            )}
            <CommandButton command={brightSwitch}>Bright</CommandButton>
            <CommandButton command={loupeSwitch(model.stage)}>Loupe</CommandButton>
          </section>
        </>
      ) : (
        <NothingHere surveyId={surveyId} shown={model.shown.value} />
      )}
    </div>
  );
}

function NothingHere({ surveyId, shown }: { surveyId: number; shown: Shown }) {
  if (shown !== "to_review") {
    return (
      <Empty title="Nothing in this state">
        <p>Choose another state in the list on the left.</p>
      </Empty>
    );
  }
  const measured = survey.value?.counts.measurements ?? 0;
  return (
    <Empty
      title={measured > 0 ? "Everything is reviewed" : "Nothing to review yet"}
      actions={
        <Button kind="primary" href={`/surveys/${surveyId}/${measured > 0 ? "export" : "measure"}`}>
          {measured > 0 ? "Go to the export" : "Go to measuring"}
        </Button>
      }
    >
      <p>
        {measured > 0
          ? "Each measurement has a verdict. New and corrected ones appear here by themselves."
          : "Measurements appear here as soon as an operator has clicked them."}
      </p>
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
    {
      id: "reviewReject",
      run: () => {
        if (model.mayJudge) model.rejecting.value = true;
      },
      enabled: mayReview,
    },
    { id: "reviewFix", run: () => model.startFix(), enabled: mayReview },
    { id: "selectNext", label: "Choose the other point", run: () => model.fixing.selectNext() },
  ];
}
