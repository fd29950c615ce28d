import { say } from "../../core/messages";

export function CoverageMap({ coverage, aspect }: { coverage: number[][]; aspect: number }) {
  const rows = coverage.length;
  const columns = coverage[0]?.length ?? 1;
  const most = Math.max(...coverage.flat(), 1);
  const height = 240 / aspect;
  const w = 240 / columns;
  const h = height / rows;
  const empty = coverage.flat().filter((count) => count === 0).length;
  return (
    <svg
      class="coverage"
      viewBox={`0 0 240 ${height}`}
      role="img"
      aria-label={say("camera-coverage-label", { empty, all: rows * columns })}
    >
      <defs>
        <pattern id="hatch" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
          <path d="M0 0v5" stroke="var(--line-strong)" stroke-width="1" />
        </pattern>
      </defs>
      {coverage.map((line, r) =>
        line.map((count, c) => (
          <rect
            key={`${r}-${c}`}
            x={c * w}
            y={r * h}
            width={w}
            height={h}
            fill={count === 0 ? "url(#hatch)" : "var(--ink)"}
            fill-opacity={count === 0 ? 0.7 : 0.12 + 0.78 * Math.sqrt(count / most)}
            stroke="var(--surface)"
            stroke-width="0.6"
          >
            <title>{say("camera-coverage-cell", { count })}</title>
          </rect>
        )),
      )}
    </svg>
  );
}
