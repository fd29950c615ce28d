/** Review: the queue on the left, the picture with its points in the middle, what is known and the verdict on the right. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Problem } from "../../components";
import { useKeys } from "../../core/commands";
import type { ScreenProps } from "../../core/places";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { BlindFrame } from "../../viewer/BlindFrame";
import { BrightButton } from "../../viewer/BrightButton";
import { linesShown } from "../../viewer/display";
import { frameKeys, HELD_KEYS, Transport } from "../../viewer/Transport";
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
  useReviewKeys(model);
  const player = model.player.value;
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
              <BlindFrame
                key={player.recordingId}
                blind={model.blind}
                player={player}
                stage={model.stage}
                geometry={model.geometry}
              />
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
            <BrightButton />
            <Button
              small
              kind="quiet"
              pressed={model.stage.loupe.value}
              onClick={() => {
                model.stage.loupe.value = !model.stage.loupe.value;
              }}
            >
              Loupe
            </Button>
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

function useReviewKeys(model: ReviewModel): void {
  const player = model.player.value;
  const { blind } = model;
  const nudge = (dx: number, dy: number) => () => model.nudge(dx, dy) || blind.nudge(dx, dy);
  const allowed = may("reviewer");
  useKeys(
    {
      ...(player ? frameKeys(player, model.stage) : {}),
      loupeToggle: () => {
        model.stage.loupe.value = !model.stage.loupe.value;
      },
      linesToggle: () => {
        linesShown.value = !linesShown.value;
      },
      reviewNext: () => model.go(1),
      reviewPrevious: () => model.go(-1),
      reviewAccept: () => {
        if (allowed && !model.fix.value) void model.judge("accepted");
      },
      reviewReject: () => {
        if (allowed && model.mayJudge) model.rejecting.value = true;
      },
      reviewFix: () => {
        if (allowed) model.startFix();
      },
      place: () => {
        const at = blind.cursor.value;
        if (model.hidden.value && at) {
          void blind.place(at, player?.shown.value?.frame ?? null);
          return true;
        }
        if (!model.fix.value) return false;
        void model.judge("fixed");
        return true;
      },
      selectNext: () => {
        const fix = model.fix.value;
        if (fix) model.fix.value = { ...fix, selected: fix.selected === "point" ? "contact" : "point" };
      },
      cursor: () => {
        if (model.hidden.value) blind.toggleCursor();
      },
      cancel: () => {
        if (!blind.takeBack()) model.cancel();
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
