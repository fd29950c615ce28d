/** What is known of the reviewed measurement, and the verdict: accept, fix, reject with a reason. */
import { Button, Icon, Notice, StateMark } from "../../components";
import { type ActionId, commandName, hint, keyMap, showChord } from "../../core/commands";
import { allOf, say, sentenceOf } from "../../core/messages";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { formatFrameTime, formatMoment, formatPlaceMoment } from "../../core/times";
import type { LineHeight, Measurement, Px, Recording, ReviewItem, Target } from "../../core/types";
import { formatHeight, formatLength } from "../../core/units";
import {
  INSET_PLACE_WORDS,
  LIGHTING_NOUNS,
  STATE_WORDS,
  TARGET_NOUNS,
  TARGET_WORDS,
  vehicleName,
} from "../../core/words";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { StaleMarks } from "../../parts/again/StaleMarks";
import { Budget } from "../../parts/vehicles/Budget";
import { Revisions } from "../../parts/vehicles/Revisions";
import { cropUrl } from "../../viewer/frames";
import { clamp } from "../../viewer/view";
import { BlindPanel, Comparisons } from "./Comparisons";
import { type Height, isOfFrame, isOfLine } from "./kinds";
import type { ReviewModel } from "./model";
import { Reject, RejectButton } from "./Reject";

export function VerdictPanel({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  const m = item.measurement;
  if (model.hidden.value) return <BlindPanel model={model} item={item} />;
  return (
    <aside class="review__side" aria-label={say("review-measurement")} key={m.id}>
      <header class="vehicle__head">
        <h2>
          {vehicleName(item.vehicle.number)} {TARGET_WORDS[m.target]}
        </h2>
        <StateMark state={m.review.verdict} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="review__body" role="group" aria-label={say("review-facts")} tabIndex={0}>
        <p class="vehicle__height">
          {m.status === "ok" ? formatHeight(m.height_m, m.U95_height_m) : STATE_WORDS.not_measurable}
        </p>
        {m.review.lot_id !== null && m.review.verdict === "accepted" && (
          <p class="small row">
            <Icon name="info" size={14} /> {say("lots-by-lot")}
          </p>
        )}
        <StaleMarks measurementId={m.id} />
        {isOfLine(m) && m.older && <p>{say("scan-height-older")}</p>}
        <OutOfDateNotice surveyId={model.surveyId} computed={() => model.load()} />
        {m.reason && <p>{sentenceOf(m.reason)}</p>}
        {m.flags.map((flag) => (
          <p key={flag.code} class="small row">
            <Icon name="info" size={14} /> {sentenceOf(flag)}
          </p>
        ))}
        <Signs item={item} />
        <Comparisons model={model} />
        {isOfFrame(m) && <Pieces m={m} model={model} />}
        <Facts item={item} />
        {m.budget.length > 0 && <Budget entries={m.budget} total_m={m.u_height_m} />}
        <Revisions id={m.id} revision={m.revision} />
      </div>
      <Verdict model={model} item={item} />
    </aside>
  );
}

function Pieces({ m, model }: { m: Measurement; model: ReviewModel }) {
  const recording = model.reel.player.value?.recording.value ?? null;
  return (
    <>
      <Crops m={m} recording={recording} />
      <Neighbours m={m} recording={recording} model={model} />
    </>
  );
}

/** Lossless pixels around both points, four times as large, the point in the middle. */
function Crops({ m, recording }: { m: Measurement; recording: Recording | null }) {
  const size = { width: recording?.width_px ?? 0, height: recording?.height_px ?? 0 };
  if (size.width === 0) return null;
  return (
    <div class="review__crops">
      <Crop m={m} at={m.contact} point="contact" size={size} />
      <Crop m={m} at={m.target_point} point={m.target} size={size} />
    </div>
  );
}

const CROP_PX = 38;
const ZOOM = 4;

interface CropProps {
  m: Measurement;
  at: Px;
  point: "contact" | Target;
  size: { width: number; height: number };
}

function Crop({ m, at, point, size }: CropProps) {
  const x = clamp(Math.round(at[0]) - CROP_PX / 2, 0, Math.max(0, size.width - CROP_PX));
  const y = clamp(Math.round(at[1]) - CROP_PX / 2, 0, Math.max(0, size.height - CROP_PX));
  const w = Math.min(CROP_PX, size.width);
  const h = Math.min(CROP_PX, size.height);
  const cross = { left: `${((at[0] - x + 0.5) / w) * 100}%`, top: `${((at[1] - y + 0.5) / h) * 100}%` };
  return (
    <figure>
      <div class="review__crop">
        <img
          src={cropUrl(m.recording_id, m.frame, { x, y, w, h })}
          width={w * ZOOM}
          height={h * ZOOM}
          alt={say("review-pixels", { point })}
        />
        <svg viewBox="-20 -20 40 40" style={cross} aria-hidden="true">
          <path class="review__cross review__cross--halo" d="M-18 0H-6M6 0H18M0 -18V-6M0 6V18" />
          <path class="review__cross" d="M-18 0H-6M6 0H18M0 -18V-6M0 6V18" />
        </svg>
      </div>
      <figcaption class="small muted">
        {point === "contact" ? say("review-contact") : TARGET_NOUNS[point]}
      </figcaption>
    </figure>
  );
}

function Facts({ item }: { item: ReviewItem }) {
  const { measurement: m, vehicle, judged } = item;
  const side = m.target === "driver_eye" ? sideWords(m) : null;
  const name = [vehicle.make, vehicle.model, vehicle.year].filter(Boolean).join(" ");
  return (
    <dl class="facts small">
      <dt>{say("review-vehicle")}</dt>
      <dd>{name || say("review-vehicle-unknown")}</dd>
      {vehicle.manufacturer_height_m !== null && (
        <>
          <dt>{say("review-manufacturer-height")}</dt>
          <dd>{formatLength(vehicle.manufacturer_height_m)}</dd>
        </>
      )}
      {judged.error_m !== null && (
        <>
          <dt>{say("review-error")}</dt>
          <dd>{formatHeight(judged.error_m, judged.U95_error_m)}</dd>
        </>
      )}
      {side && (
        <>
          <dt>{say("review-side")}</dt>
          <dd>{side}</dd>
        </>
      )}
      {vehicle.lighting && (
        <>
          <dt>{say("review-lighting")}</dt>
          <dd>{LIGHTING_NOUNS[vehicle.lighting]}</dd>
        </>
      )}
      {isOfFrame(m) ? <FrameFacts m={m} /> : <ScanFacts m={m} name={vehicle.scan_name} />}
      <dt>{say("review-distance")}</dt>
      <dd>{formatLength(m.distance_m, 2)}</dd>
      <dt>{say("review-inset")}</dt>
      <dd>
        {say("review-inset-estimate", {
          inset: formatLength(m.inset_m, 2),
          u_inset: formatLength(m.u_inset_m, 2),
        })}
      </dd>
      <dt>{say("review-points-set")}</dt>
      <dd data-testid="review-made">
        {say("review-made-by", {
          made: isOfFrame(m) ? m.made : "clicked",
          person: m.created_by?.name ?? say("person-unknown"),
          time: formatMoment(m.created_at),
        })}
      </dd>
    </dl>
  );
}

function FrameFacts({ m }: { m: Measurement }) {
  return (
    <>
      <dt>{say("stage-frame")}</dt>
      <dd>
        {say("review-frame-at", { frame: String(m.frame), time: formatFrameTime(m.time_s) })}
        {m.filmed_at && (
          <div class="muted small">{say("filmed-at", { time: formatPlaceMoment(m.filmed_at) })}</div>
        )}
      </dd>
      {m.more_frames.length > 0 && (
        <>
          <dt>{say("review-further-frames")}</dt>
          <dd>{allOf(m.more_frames.map((one) => String(one.frame)))}</dd>
        </>
      )}
    </>
  );
}

/** The recording, with the way to the vehicle on its bench, where it is measured again. */
function ScanFacts({ m, name }: { m: LineHeight; name: string | null }) {
  return (
    <>
      <dt>{say("page-scan")}</dt>
      <dd>
        <a href={`/surveys/${survey.value?.id}/scan?scan=${m.scan_id}&vehicle=${m.vehicle_id}`}>{name}</a>
      </dd>
    </>
  );
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
    <p class="small row" data-testid="review-signs">
      <Icon name="warning" size={14} />
      <span class="grow">
        <strong>{say("review-signs")}:</strong> {allOf(signs.map((sign) => say("review-sign", { sign })))}
      </span>
    </p>
  );
}

const NEAR_FRAMES = [-4, 4] as const;
const PIECE_PX = 256;

/** The same piece of the picture a little before and after: what moves with the vehicle is the vehicle. */
function Neighbours({
  m,
  recording,
  model,
}: {
  m: Measurement;
  recording: Recording | null;
  model: ReviewModel;
}) {
  const [width, height] = [recording?.width_px ?? 0, recording?.height_px ?? 0];
  const last = (recording?.frame_count ?? 0) - 1;
  if (width === 0) return null;
  const [w, h] = [Math.min(PIECE_PX, width), Math.min(PIECE_PX, height)];
  const x = clamp(Math.round((m.contact[0] + m.target_point[0] - w) / 2), 0, width - w);
  const y = clamp(Math.round((m.contact[1] + m.target_point[1] - h) / 2), 0, height - h);
  return (
    <section aria-label={say("review-neighbours")}>
      <h3 class="small">{say("review-neighbours")}</h3>
      <div class="review__crops">
        {NEAR_FRAMES.map((by) => m.frame + by)
          .filter((frame) => frame >= 0 && frame <= last)
          .map((frame) => (
            <button
              key={frame}
              type="button"
              class="review__neighbour"
              onClick={() => model.reel.show(m.recording_id, frame)}
            >
              <img
                src={cropUrl(m.recording_id, frame, { x, y, w, h })}
                width={w}
                height={h}
                loading="lazy"
                alt=""
              />
              <span class="small">{say("review-neighbour", { frame: String(frame) })}</span>
            </button>
          ))}
      </div>
    </section>
  );
}

function Key({ of }: { of: ActionId }) {
  const key = keyMap.value[of][0];
  return key ? <kbd>{showChord(key)}</kbd> : null;
}

function Verdict({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  if (!may("reviewer")) {
    return <footer class="review__verdict small muted">{say("review-look-only")}</footer>;
  }
  if (item.mine) {
    return (
      <footer class="review__verdict" data-testid="review-mine">
        <Notice>{say("review-own")}</Notice>
      </footer>
    );
  }
  if (model.rejecting.value) return <Reject model={model} />;
  if (model.fix.value) {
    const changed = isOfFrame(item.measurement) && model.poseChanged(item.measurement);
    return (
      <footer class="review__verdict">
        {changed && <Notice kind="warning">{say("review-pose-changed")}</Notice>}
        <div class="row">
          <span class="grow" data-testid="review-save-fix">
            <Button
              kind="primary"
              busy={model.busy.value}
              disabled={!model.fixing.differs.value}
              title={model.fixing.differs.value ? undefined : say("review-fix-nothing")}
              onClick={() => void model.judge("fixed")}
            >
              {say("review-fix-save")}
            </Button>
          </span>
          <Button onClick={() => model.cancel()}>{say("review-fix-leave")}</Button>
        </div>
      </footer>
    );
  }
  const own = model.repeats.own.value;
  const judged =
    item.measurement.review.verdict === "accepted" || item.measurement.review.verdict === "rejected";
  return (
    <footer class="review__verdict">
      <div class="review__buttons">
        <span data-testid="review-accept">
          <Button
            kind="primary"
            icon="check"
            disabled={!model.mayJudge}
            title={commandName("reviewAccept") + hint("reviewAccept")}
            onClick={() => void model.judge("accepted")}
          >
            {commandName("reviewAccept")} <Key of="reviewAccept" />
          </Button>
        </span>
        {model.ofFrame.value && (
          <span data-testid="review-fix">
            <Button
              disabled={!model.mayJudge}
              title={commandName("reviewFix") + hint("reviewFix")}
              onClick={() => model.startFix()}
            >
              {commandName("reviewFix")} <Key of="reviewFix" />
            </Button>
          </span>
        )}
        <RejectButton model={model} />
      </div>
      {own && own.repeat.frame === model.ofFrame.value?.frame && (
        <Button small disabled={!model.mayJudge} onClick={() => model.startFix(own.repeat)}>
          {say("review-fix-mine")}
        </Button>
      )}
      {judged && (
        <Button small kind="quiet" onClick={() => void model.judge("reopened")}>
          {say("review-reopen")}
        </Button>
      )}
    </footer>
  );
}
