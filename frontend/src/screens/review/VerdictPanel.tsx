/** What is known of the reviewed measurement, and the verdict: accept, fix, reject with a reason. */
import { Button, Facts, Notice, Remark } from "../../components";
import { Said } from "../../components/Said";
import { allOf, say, sentenceOf } from "../../core/messages";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { formatFrameTime, formatMoment, formatPlaceMoment } from "../../core/times";
import type { LineHeight, Measurement, ReviewItem } from "../../core/types";
import { formatHeight, formatLength } from "../../core/units";
import { heightWords, INSET_PLACE_WORDS, LIGHTING_NOUNS } from "../../core/words";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { StaleMarks } from "../../parts/again/StaleMarks";
import { Budget } from "../../parts/vehicles/Budget";
import { Revisions } from "../../parts/vehicles/Revisions";
import { JudgeButton } from "../../parts/verdicts/Reject";
import { BlindPanel, Comparisons, ItemHead, RejectButton, Rejecting } from "./Comparisons";
import { type Height, isOfFrame, isOfLine } from "./kinds";
import type { ReviewModel } from "./model";
import { Pieces } from "./Pieces";

export function VerdictPanel({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  const m = item.measurement;
  if (model.hidden.value) return <BlindPanel model={model} item={item} />;
  return (
    <aside class="desk__side review__side" aria-label={say("review-measurement")} key={m.id}>
      <ItemHead item={item} />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="stack stack--near review__body" role="group" aria-label={say("review-facts")} tabIndex={0}>
        <p class="vehicle__height">{heightWords(m)}</p>
        {m.review.lot_id !== null && m.review.verdict === "accepted" && (
          <Remark icon="info">{say("lots-by-lot")}</Remark>
        )}
        <StaleMarks measurementId={m.id} />
        {isOfLine(m) && m.older && <p>{say("scan-height-older")}</p>}
        <OutOfDateNotice surveyId={model.surveyId} computed={() => model.load()} />
        {m.reason && <p>{sentenceOf(m.reason)}</p>}
        {m.flags.map((flag) => (
          <Remark key={flag.code} icon="info">
            {sentenceOf(flag)}
          </Remark>
        ))}
        <Signs item={item} />
        <Comparisons model={model} />
        {isOfFrame(m) && <Pieces m={m} model={model} />}
        <Known item={item} />
        {m.budget.length > 0 && <Budget entries={m.budget} total_m={m.u_height_m} />}
        <Revisions id={m.id} revision={m.revision} />
      </div>
      <Verdict model={model} item={item} />
    </aside>
  );
}

function Known({ item }: { item: ReviewItem }) {
  const { measurement: m, vehicle, judged } = item;
  const side = m.target === "driver_eye" ? sideWords(m) : null;
  const name = [vehicle.make, vehicle.model, vehicle.year].filter(Boolean).join(" ");
  const made = isOfFrame(m) ? m.made : "clicked";
  return (
    <Facts
      small
      of={[
        [say("review-vehicle"), name || say("review-vehicle-unknown")],
        vehicle.manufacturer_height_m !== null && [
          say("review-manufacturer-height"),
          formatLength(vehicle.manufacturer_height_m),
        ],
        judged.error_m !== null && [say("review-error"), formatHeight(judged.error_m, judged.U95_error_m)],
        side && [say("review-side"), side],
        vehicle.lighting && [say("review-lighting"), LIGHTING_NOUNS[vehicle.lighting]],
        isOfFrame(m) && [say("stage-frame"), <ClickedFrame m={m} />],
        isOfFrame(m) &&
          m.more_frames.length > 0 && [
            say("review-further-frames"),
            allOf(m.more_frames.map((one) => String(one.frame))),
          ],
        isOfLine(m) && [say("page-scan"), <ToBench m={m} name={vehicle.scan_name} />],
        [say("review-distance"), formatLength(m.distance_m, 2)],
        [
          say("review-inset"),
          say("review-inset-estimate", {
            inset: formatLength(m.inset_m, 2),
            u_inset: formatLength(m.u_inset_m, 2),
          }),
        ],
        [
          say("review-points-set"),
          say("review-made-by", {
            made,
            person: judged.operator?.name ?? say("person-unknown"),
            time: formatMoment(judged.clicked_at),
          }),
          "review-made",
        ],
      ]}
    />
  );
}

function ClickedFrame({ m }: { m: Measurement }) {
  return (
    <>
      {say("review-frame-at", { frame: String(m.frame), time: formatFrameTime(m.time_s) })}
      {m.filmed_at && (
        <div class="muted small">{say("filmed-at", { time: formatPlaceMoment(m.filmed_at) })}</div>
      )}
    </>
  );
}

/** The recording, with the way to the vehicle on its bench, where it is measured again. */
function ToBench({ m, name }: { m: LineHeight; name: string | null }) {
  return <a href={`/surveys/${survey.value?.id}/scan?scan=${m.scan_id}&vehicle=${m.vehicle_id}`}>{name}</a>;
}

/** Near or far, in the survey's words; null where the inset is neither. */
function sideWords(m: Height): string | null {
  const choices = survey.value?.inset_choices?.[m.target] ?? [];
  const chosen = choices.find((one) => one.inset_m === m.inset_m && one.u_inset_m === m.u_inset_m);
  return chosen ? INSET_PLACE_WORDS[chosen.place] : null;
}

/** Why it may be wrong, as the server sees it beside the others of its survey. */
function Signs({ item }: { item: ReviewItem }) {
  const { signs } = item.judged;
  if (signs.length === 0) return null;
  return (
    <Remark icon="warning" data-testid="review-signs">
      <Said
        what="review-signs"
        values={{ signs: allOf(signs.map((sign) => say("review-sign", { sign }))) }}
      />
    </Remark>
  );
}

function Verdict({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  if (!may("reviewer")) {
    return <footer class="stack stack--tight review__verdict small muted">{say("review-look-only")}</footer>;
  }
  if (item.mine) {
    return (
      <footer class="stack stack--tight review__verdict" data-testid="review-mine">
        <Notice>{say("review-own")}</Notice>
      </footer>
    );
  }
  if (model.rejection.begun.value) return <Rejecting model={model} />;
  if (model.fix.value) {
    const changed = isOfFrame(item.measurement) && model.poseChanged(item.measurement);
    return (
      <footer class="stack stack--tight review__verdict">
        {changed && <Notice kind="warning">{say("review-pose-changed")}</Notice>}
        <div class="row">
          <span class="grow" data-testid="review-save-fix">
            <Button
              says="review-fix-save"
              kind="primary"
              busy={model.busy.value}
              disabled={!model.fixing.differs.value}
              title={model.fixing.differs.value ? undefined : say("review-fix-nothing")}
              onClick={() => void model.judge("fixed")}
            />
          </span>
          <Button says="review-fix-leave" onClick={() => model.cancel()} />
        </div>
      </footer>
    );
  }
  const own = model.repeats.own.value;
  const judged =
    item.measurement.review.verdict === "accepted" || item.measurement.review.verdict === "rejected";
  return (
    <footer class="stack stack--tight review__verdict">
      <div class="grid grid--3 grid--close review__buttons">
        <JudgeButton
          of="reviewAccept"
          testId="review-accept"
          kind="primary"
          icon="check"
          disabled={!model.mayJudge}
          onClick={() => void model.judge("accepted")}
        />
        {model.ofFrame.value && (
          <JudgeButton
            of="reviewFix"
            testId="review-fix"
            disabled={!model.mayJudge}
            onClick={() => model.startFix()}
          />
        )}
        <RejectButton model={model} />
      </div>
      {own && own.repeat.frame === model.ofFrame.value?.frame && (
        <Button
          says="review-fix-mine"
          small
          disabled={!model.mayJudge}
          onClick={() => model.startFix(own.repeat)}
        />
      )}
      {judged && (
        <Button says="review-reopen" small kind="quiet" onClick={() => void model.judge("reopened")} />
      )}
    </footer>
  );
}
