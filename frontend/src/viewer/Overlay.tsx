/**
 * Shapes above the frame, all given in image pixels. Lines ride on the view's transform with strokes that do not scale;
 * marks and words keep their size on the screen. Colours: the three axes, white, and the accent for what is selected.
 */
import type { AxisLines, Px } from "../core/types";
import { fromServer, type ImagePoint, type ScreenPoint } from "./points";
import type { FrameStage } from "./stage";
import type { Size } from "./view";

export type LineKind =
  | "longitudinal"
  | "vertical"
  | "transversal"
  | "ladder"
  | "ladder-major"
  | "grid"
  | "iso"
  | "board"
  | "guide";

export function Line({ points, kind }: { points: readonly Px[]; kind: LineKind }) {
  if (points.length < 2) return null;
  const path = points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${round(x)} ${round(y)}`).join("");
  return (
    <>
      <path class="line line--halo" d={path} />
      <path class={`line line--${kind}`} d={path} />
    </>
  );
}

export function InImage({ stage, children }: { stage: FrameStage; children: preact.ComponentChildren }) {
  return <g transform={stage.view.value.svgTransform}>{children}</g>;
}

export function AxesLayer({ axes, stage }: { axes: AxisLines; stage: FrameStage }) {
  return (
    <g data-testid="axes">
      <InImage stage={stage}>
        <Line points={axes.transversal} kind="transversal" />
        <Line points={axes.longitudinal} kind="longitudinal" />
        <Line points={axes.vertical} kind="vertical" />
      </InImage>
    </g>
  );
}

export interface Rung {
  readonly height_m: number;
  readonly points: readonly Px[];
  readonly label: boolean;
  readonly words: string;
}

export function LadderLayer({ rungs, stage }: { rungs: readonly Rung[]; stage: FrameStage }) {
  return (
    <g data-testid="ladder">
      <InImage stage={stage}>
        {rungs.map((rung) => (
          <Line key={rung.height_m} points={rung.points} kind={rung.label ? "ladder-major" : "ladder"} />
        ))}
      </InImage>
      {rungs.map(
        (rung) =>
          rung.label && (
            <Word key={rung.height_m} stage={stage} at={rightmost(rung.points)} text={rung.words} />
          ),
      )}
    </g>
  );
}

export function Word(props: {
  stage: FrameStage;
  at: ImagePoint | null;
  text: string;
  dx?: number;
  dy?: number;
  strong?: boolean;
}) {
  if (!props.at) return null;
  const [x, y] = props.stage.view.value.toScreen(props.at);
  return (
    <text
      class={`overlay-word${props.strong ? " overlay-word--strong" : ""}`}
      x={x + (props.dx ?? 5)}
      y={y + (props.dy ?? 4)}
    >
      {props.text}
    </text>
  );
}

export interface MarkProps {
  stage: FrameStage;
  at: ImagePoint;
  kind: "contact" | "point";
  selected?: boolean;
  faint?: boolean;
  /** Not clicked by anybody: a diamond, whatever it is of. */
  proposed?: boolean;
  text?: string;
}

const SHAPES = {
  contact: { path: "M0 3.5L8 15H-8ZM-5 0H-14M5 0H14", x: 17, y: 18 },
  point: { path: "M8 0A8 8 0 11-8 0A8 8 0 118 0M-8 0H-14M8 0H14M0 -8V-14M0 8V14", x: 18, y: -6 },
};
const DIAMOND = "M0 -10L10 0L0 10L-10 0Z";

/** A contact is a triangle standing on the road, a target a ring; the pixel itself stays free. */
export function PointMark({ stage, at, kind, selected, faint, proposed, text }: MarkProps) {
  const [x, y] = stage.view.value.toScreen(at);
  const place = SHAPES[kind];
  const shape = proposed ? DIAMOND : place.path;
  const word = proposed ? { x: 15, y: kind === "contact" ? 20 : -8 } : { x: place.x, y: place.y };
  return (
    <g
      transform={`translate(${x} ${y})`}
      class={`point-mark${selected ? " point-mark--selected" : ""}${faint ? " point-mark--faint" : ""}`}
    >
      <path class="point-mark__halo" d={shape} />
      <path class="point-mark__line" d={shape} />
      {text && (
        <text class="overlay-word overlay-word--strong" {...word}>
          {text}
        </text>
      )}
    </g>
  );
}

/** The keyboard's cursor: a full cross, so that it is found at once. */
export function CursorCross({ at, screen }: { at: ScreenPoint; screen: Size }) {
  const [x, y] = at;
  const { width, height } = screen;
  const shape = `M0 ${y}H${x - 9}M${x + 9} ${y}H${width}M${x} 0V${y - 9}M${x} ${y + 9}V${height}`;
  return (
    <g class="point-mark" data-testid="keyboard-cursor">
      <path class="point-mark__halo" d={shape} />
      <path class="point-mark__line point-mark__line--thin" d={shape} />
    </g>
  );
}

function rightmost(points: readonly Px[]): ImagePoint | null {
  let best: Px | null = null;
  for (const point of points) if (!best || point[0] > best[0]) best = point;
  return best && fromServer(best);
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
