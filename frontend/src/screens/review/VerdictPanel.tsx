/** What is known of the reviewed measurement, and the verdict: accept, fix, reject with a reason. */
import { useEffect, useRef, useState } from "preact/hooks";
import { Button, Icon, Notice, StateMark } from "../../components";
import { commandName, hint } from "../../core/commands";
import { allOf, say } from "../../core/messages";
import { may } from "../../core/session";
import { formatFrameTime, formatMoment } from "../../core/times";
import type { Measurement, Px, Recording, ReviewItem, Target } from "../../core/types";
import { formatHeight, formatLength, inUnits } from "../../core/units";
import { LIGHTING_NOUNS, STATE_WORDS, TARGET_NOUNS, TARGET_WORDS, vehicleName } from "../../core/words";
import { Revisions } from "../../parts/vehicles/Revisions";
import { cropUrl } from "../../viewer/frames";
import { clamp } from "../../viewer/view";
import { BlindPanel, Comparisons } from "./Comparisons";
import type { ReviewModel } from "./model";

const REASONS = [
  "review-reason-contact",
  "review-reason-point",
  "review-reason-frame",
  "review-reason-hidden",
  "review-reason-wrong",
] as const;

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
        {m.reason && <p>{inUnits(m.reason)}</p>}
        {m.flags.map((flag) => (
          <p key={flag} class="small row">
            <Icon name="info" size={14} /> {inUnits(flag)}
          </p>
        ))}
        <Comparisons model={model} />
        <Crops m={m} recording={model.reel.player.value?.recording.value ?? null} />
        <Facts item={item} />
        <Revisions id={m.id} revision={m.revision} />
      </div>
      <Verdict model={model} item={item} />
    </aside>
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
  const { measurement: m, vehicle } = item;
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
      {vehicle.lighting && (
        <>
          <dt>{say("review-lighting")}</dt>
          <dd>{LIGHTING_NOUNS[vehicle.lighting]}</dd>
        </>
      )}
      <dt>{say("stage-frame")}</dt>
      <dd>{say("review-frame-at", { frame: String(m.frame), time: formatFrameTime(m.time_s) })}</dd>
      {m.more_frames.length > 0 && (
        <>
          <dt>{say("review-further-frames")}</dt>
          <dd>{allOf(m.more_frames.map((one) => String(one.frame)))}</dd>
        </>
      )}
      <dt>{say("review-distance")}</dt>
      <dd>{formatLength(m.distance_m, 2)}</dd>
      <dt>{say("review-inset")}</dt>
      <dd>
        {say("review-inset-estimate", {
          inset: formatLength(m.inset_m, 2),
          u_inset: formatLength(m.u_inset_m, 2),
        })}
      </dd>
      <dt>{say("review-clicked-by")}</dt>
      <dd>
        {say("revisions-who", {
          person: m.created_by?.name ?? say("person-unknown"),
          time: formatMoment(m.created_at),
        })}
      </dd>
    </dl>
  );
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
    const changed = model.poseChanged(item.measurement);
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
  const own = model.ownRepeat.value;
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
            {commandName("reviewAccept")} <kbd>A</kbd>
          </Button>
        </span>
        <span data-testid="review-fix">
          <Button
            disabled={!model.mayJudge}
            title={commandName("reviewFix") + hint("reviewFix")}
            onClick={() => model.startFix()}
          >
            {commandName("reviewFix")} <kbd>E</kbd>
          </Button>
        </span>
        <span data-testid="review-reject">
          <Button
            icon="close"
            disabled={!model.mayJudge}
            title={commandName("reviewReject") + hint("reviewReject")}
            onClick={() => {
              model.rejecting.value = true;
            }}
          >
            {commandName("reviewReject")} <kbd>X</kbd>
          </Button>
        </span>
      </div>
      {own && own.repeat.frame === item.measurement.frame && (
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

/** A rejection needs a reason that the operator can act on. */
function Reject({ model }: { model: ReviewModel }) {
  const [reason, setReason] = useState("");
  const box = useRef<HTMLTextAreaElement>(null);
  useEffect(() => box.current?.focus(), []);
  const send = (): void => {
    if (reason.trim()) void model.judge("rejected", reason.trim());
  };
  return (
    <footer class="review__verdict" data-testid="review-reasons">
      <h3>{say("review-reject-why")}</h3>
      <div class="review__reasons">
        {REASONS.map((key) => say(key)).map((one) => (
          <Button key={one} small pressed={reason === one} onClick={() => setReason(one)}>
            {one}
          </Button>
        ))}
      </div>
      <label class="field">
        <span class="field__label">{say("review-reject-words")}</span>
        <textarea
          class="input"
          rows={2}
          value={reason}
          ref={box}
          onInput={(event) => setReason(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === "Escape") model.cancel();
            if (event.key === "Enter" && !event.shiftKey) {
              event.preventDefault();
              send();
            }
          }}
        />
      </label>
      <div class="row">
        <span class="grow" data-testid="review-send-rejection">
          <Button kind="primary" busy={model.busy.value} disabled={!reason.trim()} onClick={send}>
            {commandName("reviewReject")}
          </Button>
        </span>
        <Button onClick={() => model.cancel()}>{say("action-cancel")}</Button>
      </div>
    </footer>
  );
}
