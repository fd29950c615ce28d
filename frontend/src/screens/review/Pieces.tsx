/** What is seen around the points of a measurement: its pixels, and the same piece of the frames before and after. */
import { say } from "../../core/messages";
import type { Measurement, Px, Recording, Target } from "../../core/types";
import { TARGET_NOUNS } from "../../core/words";
import { cropUrl } from "../../viewer/frames";
import { clamp } from "../../viewer/view";
import type { ReviewModel } from "./model";

export function Pieces({ m, model }: { m: Measurement; model: ReviewModel }) {
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
    <div class="grid grid--close">
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
      <div class="grid grid--close">
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
