import { say } from "../../core/messages";
import { boardPath } from "../../parts/boards/markers";

interface Props {
  columns: number;
  rows: number;
  square: string;
  markers: boolean;
  /** Side of a marker over the side of a square. */
  share: number;
}

/** A checkerboard with its inner corners marked and counted: what "columns" and "rows" mean, drawn. */
export function BoardDrawing({ columns, rows, square, markers, share }: Props) {
  const n = Math.min(Math.max(columns, 3), 16);
  const m = Math.min(Math.max(rows, 3), 12);
  const u = Math.min(200 / (n + 1), 132 / (m + 1));
  const width = (n + 1) * u;
  const height = (m + 1) * u;
  const x0 = 34;
  const y0 = 24;
  const place = { left: x0, top: y0, side: u, across: n + 1, down: m + 1 };
  const corners: [number, number][] = [];
  for (let r = 1; r <= m; r++) for (let c = 1; c <= n; c++) corners.push([x0 + c * u, y0 + r * u]);
  const kind = markers ? "charuco" : "checkerboard";
  const label = { "font-size": 11, fill: "var(--ink)", "text-anchor": "middle" } as const;
  return (
    <svg
      class="board__drawing"
      width={x0 + width + 40}
      height={y0 + height + 24}
      role="img"
      aria-label={say("camera-drawing", { kind, columns, rows })}
    >
      <rect x={x0} y={y0} width={width} height={height} fill="#fff" stroke="var(--line-strong)" />
      <path d={boardPath(place, markers ? share : null)} fill="#3a3b37" />
      {corners.map(([x, y], i) => (
        <circle
          key={i}
          cx={x}
          cy={y}
          r={Math.min(3.2, u / 4)}
          fill="var(--accent)"
          stroke="#1a1b18"
          stroke-width="0.8"
        />
      ))}
      <path
        d={`M${x0 + u} 16h${width - 2 * u}M${x0 + u} 13v6M${x0 + width - u} 13v6M26 ${y0 + u}v${height - 2 * u}M23 ${y0 + u}h6M23 ${y0 + height - u}h6`}
        stroke="var(--ink-2)"
      />
      <text x={x0 + width / 2} y="10" {...label}>
        {say("camera-drawing-columns", { count: columns })}
      </text>
      <text x="12" y={y0 + height / 2} transform={`rotate(-90 12 ${y0 + height / 2})`} {...label}>
        <tspan dy="4">{say("camera-drawing-rows", { count: rows })}</tspan>
      </text>
      <path
        d={`M${x0 + width - u} ${y0 + height + 6}h${u}M${x0 + width - u} ${y0 + height + 3}v6M${x0 + width} ${y0 + height + 3}v6`}
        stroke="var(--ink-2)"
      />
      <text x={x0 + width - u / 2} y={y0 + height + 20} {...label} text-anchor="end" dx={u / 2 + 4}>
        {say("camera-drawing-square", { side: square })}
      </text>
    </svg>
  );
}
