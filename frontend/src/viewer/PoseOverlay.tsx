/** The found board with its corner order, and the road as the pose sees it. */
import { say } from "../core/messages";
import type { BoardFinding, PoseOverlay, Px } from "../core/types";
import { formatRung } from "../core/units";
import { AxesLayer, InImage, Line, Word } from "./Overlay";
import { fromServer } from "./points";
import type { FrameStage } from "./stage";
import "./board.css";

export function RoadOverlay({ overlay, stage }: { overlay: PoseOverlay; stage: FrameStage }) {
  return (
    <g data-testid="road-overlay">
      <InImage stage={stage}>
        {overlay.grid.map((line, i) => (
          <Line key={i} points={line} kind="grid" />
        ))}
        {overlay.iso_heights.map((iso) => (
          <Line key={iso.height_m} points={iso.points} kind="iso" />
        ))}
      </InImage>
      {overlay.axes && <AxesLayer axes={overlay.axes} stage={stage} />}
      {overlay.iso_heights.map((iso) => {
        const end = iso.points.at(-1);
        return (
          end && (
            <Word
              key={iso.height_m}
              stage={stage}
              at={fromServer(end)}
              text={formatRung(iso.height_m)}
              dx={-44}
              dy={-5}
              strong
            />
          )
        );
      })}
    </g>
  );
}

/** Corners seen as rings, the first one named, an arrow along the first row and one down the first column as far as their ends are seen: no doubt about the order. */
export function FoundBoard({ finding, stage }: { finding: BoardFinding; stage: FrameStage }) {
  const { corners_px: corners, columns, rows, ids } = finding;
  const view = stage.view.value;
  const corner = (number: number): Px | undefined => corners[ids === null ? number : ids.indexOf(number)];
  const first = corner(0);
  const rowEnd = corner(columns - 1);
  const columnEnd = corner((rows - 1) * columns);
  return (
    <g data-testid="found-board">
      <InImage stage={stage}>
        <Line points={finding.outline_px} kind="board" />
      </InImage>
      {corners.map((seen, i) => {
        const [x, y] = view.toScreen(fromServer(seen));
        return <circle key={i} class="corner" cx={x} cy={y} r={seen === first ? 6 : 3} />;
      })}
      {first && rowEnd && <Arrow from={first} to={rowEnd} stage={stage} />}
      {first && columnEnd && <Arrow from={first} to={columnEnd} stage={stage} />}
      {first && (
        <Word
          stage={stage}
          at={fromServer(first)}
          text={say("viewer-first-corner")}
          dx={-12}
          dy={-12}
          strong
        />
      )}
    </g>
  );
}

function Arrow({ from, to, stage }: { from: Px; to: Px; stage: FrameStage }) {
  const view = stage.view.value;
  const [x1, y1] = view.toScreen(fromServer(from));
  const [x2, y2] = view.toScreen(fromServer(to));
  const angle = (Math.atan2(y2 - y1, x2 - x1) * 180) / Math.PI;
  return (
    <g class="order-arrow">
      <path class="order-arrow__halo" d={`M${x1} ${y1}L${x2} ${y2}`} />
      <path d={`M${x1} ${y1}L${x2} ${y2}`} />
      <path
        class="order-arrow__head"
        d="M3 0L-9 -6V6Z"
        transform={`translate(${x2} ${y2}) rotate(${angle})`}
      />
    </g>
  );
}
