import type { Px } from "../../core/types";

interface Props {
  width: number;
  height: number;
  corners: Px[];
  columns: number;
  /** Which corners these are, row by row; null for all of the board's. */
  ids: readonly number[] | null;
  label: string;
}

/** Detected corners, joined in their order so that a wrong order is seen at once; the first one has a square. */
export function CornerMarks({ width, height, corners, columns, ids, label }: Props) {
  const number = (i: number): number => ids?.[i] ?? i;
  const path = corners.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x + 0.5} ${y + 0.5}`).join("");
  const dot = width / 110;
  const [first] = corners;
  return (
    <svg class="corner-marks" viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label}>
      <path d={path} class="corner-marks__halo" vector-effect="non-scaling-stroke" />
      <path d={path} class="corner-marks__line" vector-effect="non-scaling-stroke" />
      {corners.map(([x, y], i) => (
        <circle
          key={i}
          cx={x + 0.5}
          cy={y + 0.5}
          r={number(i) % columns === 0 ? dot * 1.15 : dot * 0.8}
          class="corner-marks__dot"
        />
      ))}
      {first && number(0) === 0 && (
        <rect
          x={first[0] + 0.5 - dot * 2}
          y={first[1] + 0.5 - dot * 2}
          width={dot * 4}
          height={dot * 4}
          class="corner-marks__first"
          vector-effect="non-scaling-stroke"
        />
      )}
    </svg>
  );
}
