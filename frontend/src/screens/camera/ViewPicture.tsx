import { say } from "../../core/messages";
import type { CameraDocument, CameraView } from "../../core/types";
import { fixed } from "../../core/units";

interface Props {
  view: CameraView;
  worst: boolean;
  lens: CameraDocument;
  picture: string | null;
}

/** One view with its residuals as lines, drawn longer than they are so that they can be seen. */
export function ViewPicture({ view, worst, lens, picture }: Props) {
  const corners = view.corners_px ?? [];
  const residuals = view.residuals_px ?? [];
  const longest = Math.max(...residuals.map(([x, y]) => Math.hypot(x, y)), 1e-6);
  const longest_px = fixed(longest, 2);
  const times = niceFactor(lens.width_px / 28 / longest);
  const dot = lens.width_px / 260;
  const lines = corners
    .map(([x, y], i) => {
      const [dx, dy] = residuals[i] ?? [0, 0];
      return `M${x + 0.5} ${y + 0.5}l${dx * times} ${dy * times}`;
    })
    .join("");
  return (
    <figure class="view-picture">
      <div class="shot__picture" style={{ aspectRatio: `${lens.width_px} / ${lens.height_px}` }}>
        {picture && <img src={picture} alt="" />}
        <svg
          class="corner-marks"
          viewBox={`0 0 ${lens.width_px} ${lens.height_px}`}
          role="img"
          aria-label={say("camera-residuals-label", { file: view.file, longest_px })}
        >
          <path d={lines} class="corner-marks__halo" vector-effect="non-scaling-stroke" />
          <path d={lines} class="corner-marks__line" vector-effect="non-scaling-stroke" />
          {corners.map(([x, y], i) => (
            <circle key={i} cx={x + 0.5} cy={y + 0.5} r={dot} class="corner-marks__dot" />
          ))}
        </svg>
      </div>
      <figcaption class="small muted below">
        {worst && <strong>{say("camera-worst-view")} </strong>}
        {say("camera-residuals-drawn", { file: view.file, times, longest_px })}
      </figcaption>
    </figure>
  );
}

/** 1, 2 or 5 times a power of ten, not above the value and at least 1. */
export function niceFactor(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1)));
  const lead = value / power;
  return Math.max(1, (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power);
}
