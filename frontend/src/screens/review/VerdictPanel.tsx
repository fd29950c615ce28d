/** What is known of the reviewed measurement, and the verdict: accept, fix, reject with a reason. */
import { useEffect, useRef, useState } from "preact/hooks";
import { Button, Icon, Notice, StateMark } from "../../components";
import { hint } from "../../core/commands";
import { may } from "../../core/session";
import { formatFrameTime, formatMoment } from "../../core/times";
import type { Measurement, Px, Recording, ReviewItem } from "../../core/types";
import { formatHeight, formatLength, inUnits } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { Revisions } from "../../parts/vehicles/Revisions";
import { cropUrl } from "../../viewer/frames";
import { clamp } from "../../viewer/view";
import { BlindPanel, Comparisons } from "./Comparisons";
import type { ReviewModel } from "./model";

const REASONS = [
  "The contact is not where the tyre meets the road.",
  "The target point is beside the feature.",
  "Another frame shows it better.",
  "The feature is hidden.",
  "The wrong vehicle or target.",
] as const;

export function VerdictPanel({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  const m = item.measurement;
  if (model.hidden.value) return <BlindPanel model={model} item={item} />;
  return (
    <aside class="review__side" aria-label="Measurement" key={m.id}>
      <header class="vehicle__head">
        <h2>
          {String(item.vehicle.number).padStart(2, "0")} {TARGET_WORDS[m.target]}
        </h2>
        <StateMark state={m.review.verdict} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="review__body" role="group" aria-label="Facts and history" tabIndex={0}>
        <p class="vehicle__height">
          {m.status === "ok" ? formatHeight(m.height_m, m.U95_height_m) : "not measurable"}
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
      <Crop m={m} at={m.contact} name="contact" size={size} />
      <Crop m={m} at={m.target_point} name={TARGET_WORDS[m.target].toLowerCase()} size={size} />
    </div>
  );
}

const CROP_PX = 38;
const ZOOM = 4;

interface CropProps {
  m: Measurement;
  at: Px;
  name: string;
  size: { width: number; height: number };
}

function Crop({ m, at, name, size }: CropProps) {
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
          alt={`Pixels around the ${name} point`}
        />
        <svg viewBox="-20 -20 40 40" style={cross} aria-hidden="true">
          <path class="review__cross review__cross--halo" d="M-18 0H-6M6 0H18M0 -18V-6M0 6V18" />
          <path class="review__cross" d="M-18 0H-6M6 0H18M0 -18V-6M0 6V18" />
        </svg>
      </div>
      <figcaption class="small muted">{name}</figcaption>
    </figure>
  );
}

function Facts({ item }: { item: ReviewItem }) {
  const { measurement: m, vehicle } = item;
  const name = [vehicle.make, vehicle.model, vehicle.year].filter(Boolean).join(" ");
  return (
    <dl class="facts small">
      <dt>Vehicle</dt>
      <dd>{name || "not known"}</dd>
      {vehicle.manufacturer_height_m !== null && (
        <>
          <dt>Manufacturer height</dt>
          <dd>{formatLength(vehicle.manufacturer_height_m)}</dd>
        </>
      )}
      {vehicle.lighting && (
        <>
          <dt>Lighting</dt>
          <dd>{vehicle.lighting === "daytime" ? "daytime" : "low light"}</dd>
        </>
      )}
      <dt>Frame</dt>
      <dd>
        {m.frame}, {formatFrameTime(m.time_s)}
      </dd>
      {m.more_frames.length > 0 && (
        <>
          <dt>Further frames</dt>
          <dd>{m.more_frames.map((one) => one.frame).join(", ")}</dd>
        </>
      )}
      <dt>Distance</dt>
      <dd>{formatLength(m.distance_m, 2)}</dd>
      <dt>Inset</dt>
      <dd>
        {formatHeight(m.inset_m, null, 2)} (u {formatLength(m.u_inset_m, 2)}, estimate)
      </dd>
      <dt>Clicked by</dt>
      <dd>
        {m.created_by?.name ?? "unknown"}, {formatMoment(m.created_at)}
      </dd>
    </dl>
  );
}

function Verdict({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  if (!may("reviewer")) {
    return <footer class="review__verdict small muted">You may look; a reviewer gives the verdict.</footer>;
  }
  if (item.mine) {
    return (
      <footer class="review__verdict" data-testid="review-mine">
        <Notice>You made this measurement, so somebody else reviews it.</Notice>
      </footer>
    );
  }
  if (model.rejecting.value) return <Reject model={model} />;
  if (model.fix.value) {
    const changed = model.poseChanged(item.measurement);
    return (
      <footer class="review__verdict">
        {changed && (
          <Notice kind="warning">
            The recording has another road pose since this was measured; the fix is computed with the new one.
          </Notice>
        )}
        <div class="row">
          <span class="grow" data-testid="review-save-fix">
            <Button kind="primary" busy={model.busy.value} onClick={() => void model.judge("fixed")}>
              Save the fix
            </Button>
          </span>
          <Button onClick={() => model.cancel()}>Leave it</Button>
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
            title={`Accept${hint("reviewAccept")}`}
            onClick={() => void model.judge("accepted")}
          >
            Accept <kbd>A</kbd>
          </Button>
        </span>
        <span data-testid="review-fix">
          <Button
            disabled={!model.mayJudge}
            title={`Fix${hint("reviewFix")}`}
            onClick={() => model.startFix()}
          >
            Fix <kbd>E</kbd>
          </Button>
        </span>
        <span data-testid="review-reject">
          <Button
            icon="close"
            disabled={!model.mayJudge}
            title={`Reject${hint("reviewReject")}`}
            onClick={() => {
              model.rejecting.value = true;
            }}
          >
            Reject <kbd>X</kbd>
          </Button>
        </span>
      </div>
      {own && own.repeat.frame === item.measurement.frame && (
        <Button small disabled={!model.mayJudge} onClick={() => model.startFix(own.repeat)}>
          Fix it with my points
        </Button>
      )}
      {judged && (
        <Button small kind="quiet" onClick={() => void model.judge("reopened")}>
          Reopen it
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
      <h3>Why is it rejected?</h3>
      <div class="review__reasons">
        {REASONS.map((one) => (
          <Button key={one} small pressed={reason === one} onClick={() => setReason(one)}>
            {one}
          </Button>
        ))}
      </div>
      <label class="field">
        <span class="field__label">In your own words</span>
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
            Reject
          </Button>
        </span>
        <Button onClick={() => model.cancel()}>Cancel</Button>
      </div>
    </footer>
  );
}
