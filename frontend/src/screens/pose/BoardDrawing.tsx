import { say } from "../../core/messages";
import { boardPath } from "../../parts/boards/markers";

/** What is to be measured, drawn: the board on the road, the tape from the road to the reference row of inner corners. */
export function BoardDrawing({
  reference,
  columns,
  rows,
  markers,
}: {
  reference: "top" | "bottom";
  columns: number;
  rows: number;
  markers: boolean;
}) {
  const across = Math.min(Math.max(columns, 2), 12) + 1;
  const down = Math.min(Math.max(rows, 2), 9) + 1;
  const side = Math.min(200 / across, 104 / down);
  const left = 44;
  const bottom = 150;
  const top = bottom - 26 - down * side;
  const row = reference === "top" ? top + side : top + (down - 1) * side;
  const right = left + across * side;
  return (
    <svg
      class="board-drawing"
      viewBox="0 0 320 172"
      role="img"
      aria-label={say("pose-drawing", { reference })}
    >
      <path
        class="board-drawing__road"
        d="M0 150H320M10 158l8-8M50 158l8-8M90 158l8-8M130 158l8-8M170 158l8-8M210 158l8-8M250 158l8-8M290 158l8-8"
      />
      <path
        class="board-drawing__leg"
        d={`M${left + side} ${bottom}V${bottom - 26}M${right - side} ${bottom}V${bottom - 26}`}
      />
      <rect class="board-drawing__light" x={left} y={top} width={across * side} height={down * side} />
      <path
        class="board-drawing__dark"
        d={boardPath({ left, top, side, across, down }, markers ? 0.75 : null)}
      />
      <rect class="board-drawing__edge" x={left} y={top} width={across * side} height={down * side} />
      <path class="board-drawing__row" d={`M${left + side} ${row}H${right + 26}`} />
      {Array.from({ length: across - 1 }, (_, i) => (
        <circle key={i} class="board-drawing__corner" cx={left + (i + 1) * side} cy={row} r="3" />
      ))}
      <path
        class="board-drawing__tape"
        d={`M${right + 20} ${row}V${bottom}M${right + 16} ${row + 6}l4-6 4 6M${right + 16} ${bottom - 6}l4 6 4-6`}
      />
      <text x={right + 30} y={(row + bottom) / 2 + 4}>
        {say("pose-drawing-tape")}
      </text>
      <text x="4" y="168" class="board-drawing__small">
        {say("pose-drawing-road")}
      </text>
    </svg>
  );
}
