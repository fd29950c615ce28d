import type { ComponentChildren } from "preact";
import { say } from "../../core/messages";
import { formatLength } from "../../core/units";
import type { Plan } from "./model";

/** Typical sizes of a passenger car, for the drawing only. */
const CAR = { width: 1.75, length: 4.3, tyre: 0.62 };
const WIDTH = 540;
const PAD = { left: 92, right: 16, top: 24, bottom: 72 };

type Frame = ReturnType<typeof framed>;

export function SiteAlong({ plan }: { plan: Plan }) {
  return (
    <figure class="panel plan-figure">
      <h2>{say("planning-along-title")}</h2>
      <Elevation plan={plan} />
      <figcaption class="field__hint below">{say("planning-along-note")}</figcaption>
    </figure>
  );
}

export function SiteAbove({ plan }: { plan: Plan }) {
  return (
    <figure class="panel plan-figure">
      <h2>{say("planning-above-title")}</h2>
      <FromAbove plan={plan} />
      <figcaption class="field__hint below">
        {say("planning-above-note", { shown: formatLength(plan.track_shown_m, 1) })}
      </figcaption>
    </figure>
  );
}

function framed(plan: Plan, up: number, down: number) {
  const { distance_m, board_distance_m } = plan.site;
  const far = Math.max(distance_m + CAR.width + 0.3, board_distance_m + 0.3);
  const scale = (WIDTH - PAD.left - PAD.right) / far;
  return {
    x: (metres: number) => PAD.left + metres * scale,
    y: (metres: number) => PAD.top + (up - metres) * scale,
    scale,
    far,
    height: PAD.top + PAD.bottom + (up + down) * scale,
  };
}

function Elevation({ plan }: { plan: Plan }) {
  const { site, outlook, board } = plan;
  const roof = Math.max(...plan.targets.map((one) => one.height_m));
  const frame = framed(plan, Math.max(roof, site.camera_height_m, board.top_m) + 0.25, 0);
  const { x, y, scale } = frame;
  const low = board.top_m - (board.rows - 1) * board.square_m;
  return (
    <Drawing frame={frame} label={elevationWords(plan)}>
      <Wedge frame={frame} from={site.camera_height_m} angles={[outlook.top_rad, outlook.bottom_rad]} floor />
      <path class="site__road" d={`M${x(-0.4)} ${y(0)}H${x(frame.far)}`} />
      <path class="site__post" d={`M${x(0)} ${y(0)}V${y(site.camera_height_m)}`} />
      <path class="site__car" d={carPath(frame, site.distance_m, roof)} />
      {[0, CAR.width - 0.2].map((across) => (
        <rect
          key={across}
          class="site__tyre"
          x={x(site.distance_m + across)}
          y={y(CAR.tyre)}
          width={0.2 * scale}
          height={CAR.tyre * scale}
          rx={3}
        />
      ))}
      <path class="site__post" d={`M${x(site.board_distance_m)} ${y(0)}V${y(low)}`} />
      <path
        class="site__board"
        d={`M${x(site.board_distance_m)} ${y(board.top_m + board.square_m)}V${y(low - board.square_m)}`}
      />
      {plan.targets.map((one) => (
        <circle
          key={one.target}
          class="site__target"
          cx={x(site.distance_m + one.inset_m)}
          cy={y(one.height_m)}
          r={4}
        />
      ))}
      <CameraMark x={x(0)} y={y(site.camera_height_m)} turn={plan.tilt_rad} />
      <path class="site__measure" d={`M${x(0) - 26} ${y(0)}V${y(site.camera_height_m)}`} />
      <text class="site__words" x={x(0) - 32} y={y(site.camera_height_m / 2)} text-anchor="end">
        {formatLength(site.camera_height_m, 2)}
      </text>
      <Distances frame={frame} plan={plan} at={y(0)} />
    </Drawing>
  );
}

function FromAbove({ plan }: { plan: Plan }) {
  const { site, outlook, board } = plan;
  const turn = (site.direction_deg * Math.PI) / 180;
  const aside = site.distance_m * Math.tan(turn);
  const half = CAR.length / 2 + 0.2;
  const frame = framed(plan, Math.max(half, aside + half), Math.max(half, half - aside));
  const { x, y, scale } = frame;
  const boardAt = site.board_distance_m * Math.tan(turn);
  const boardHalf = ((board.columns + 1) * board.square_m) / 2;
  const top = y(aside + CAR.length / 2);
  return (
    <Drawing frame={frame} label={aboveWords(plan)}>
      <Wedge frame={frame} from={0} angles={[outlook.right_rad, outlook.left_rad]} />
      <rect
        class="site__car"
        x={x(site.distance_m)}
        y={top}
        width={CAR.width * scale}
        height={CAR.length * scale}
        rx={10}
      />
      <path class="site__track" d={`M${x(site.distance_m)} ${PAD.top}V${frame.height - PAD.bottom}`} />
      <path
        class="site__board"
        d={`M${x(site.board_distance_m)} ${y(boardAt + boardHalf)}V${y(boardAt - boardHalf)}`}
      />
      <CameraMark x={x(0)} y={y(0)} turn={-turn} />
      <Distances frame={frame} plan={plan} at={frame.height - PAD.bottom} />
    </Drawing>
  );
}

function Drawing({ frame, label, children }: { frame: Frame; label: string; children: ComponentChildren }) {
  return (
    <svg class="site" viewBox={`0 0 ${WIDTH} ${frame.height}`} role="img" aria-label={label}>
      {children}
    </svg>
  );
}

/** What the picture shows; the upward angle first. Down to the road where there is one. */
function Wedge({ frame, from, angles, floor }: WedgeProps) {
  const [up, down] = angles;
  if (up === null || down === null || up === undefined || down === undefined) return null;
  const reach = (angle: number): [number, number] => {
    const far = frame.far * 1.02;
    const drop = from + far * Math.tan(angle);
    if (floor && drop < 0) return [-from / Math.tan(angle), 0];
    return [far, drop];
  };
  const [ux, uy] = reach(Math.min(up, 1.5));
  const [dx, dy] = reach(Math.max(down, -1.5));
  const { x, y, height } = frame;
  const clip = (value: number) => Math.max(PAD.top - 16, Math.min(height - PAD.bottom + 8, y(value)));
  const corner = floor && dy === 0 ? `L${x(frame.far)} ${y(0)}` : "";
  return (
    <path class="site__view" d={`M${x(0)} ${y(from)}L${x(ux)} ${clip(uy)}${corner}L${x(dx)} ${clip(dy)}Z`} />
  );
}

interface WedgeProps {
  frame: Frame;
  from: number;
  angles: [number | null, number | null];
  floor?: boolean;
}

function CameraMark({ x, y, turn }: { x: number; y: number; turn: number }) {
  const degrees = (turn * 180) / Math.PI;
  return (
    <g transform={`translate(${x} ${y}) rotate(${degrees})`}>
      <path class="site__camera" d="M-14 -7H4V-3L10 -6V6L4 3V7H-14Z" />
    </g>
  );
}

function Distances({ frame, plan, at }: { frame: Frame; plan: Plan; at: number }) {
  const { distance_m, board_distance_m } = plan.site;
  const apart = Math.abs(distance_m - board_distance_m) > 0.005;
  return (
    <>
      <Dimension
        frame={frame}
        to={distance_m}
        at={at + 22}
        words={say(apart ? "planning-wheel-track" : "planning-wheel-track-and-board", {
          distance: formatLength(distance_m, 2),
        })}
      />
      {apart && (
        <Dimension
          frame={frame}
          to={board_distance_m}
          at={at + 48}
          words={say("planning-board", { distance: formatLength(board_distance_m, 2) })}
        />
      )}
    </>
  );
}

function Dimension({ frame, to, at, words }: { frame: Frame; to: number; at: number; words: string }) {
  const { x } = frame;
  return (
    <>
      <path class="site__measure" d={`M${x(0)} ${at - 5}v10M${x(0)} ${at}H${x(to)}M${x(to)} ${at - 5}v10`} />
      <text class="site__words" x={x(0)} y={at + 17}>
        {words}
      </text>
    </>
  );
}

/** The outline of a car from the front, its near wheels' outer face at the wheel track. */
function carPath({ x, y }: Frame, from: number, roof: number): string {
  const points: [number, number][] = [
    [0, 0.2],
    [0, 0.85],
    [0.06, 0.98],
    [0.3, roof - 0.05],
    [0.42, roof],
    [CAR.width - 0.42, roof],
    [CAR.width - 0.3, roof - 0.05],
    [CAR.width - 0.06, 0.98],
    [CAR.width, 0.85],
    [CAR.width, 0.2],
  ];
  return `M${points.map(([across, up]) => `${x(from + across)} ${y(up)}`).join("L")}Z`;
}

function elevationWords({ site }: Plan): string {
  return say("planning-along-label", {
    camera_height: formatLength(site.camera_height_m, 2),
    board_distance: formatLength(site.board_distance_m, 2),
    distance: formatLength(site.distance_m, 2),
  });
}

function aboveWords({ site }: Plan): string {
  return site.direction_deg
    ? say("planning-above-label-turned", { turned_deg: site.direction_deg })
    : say("planning-above-label");
}
