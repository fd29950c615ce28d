import { useEffect, useRef, useState } from "preact/hooks";
import { TextField } from "../../components";
import { Said } from "../../components/Said";
import { fieldsOf } from "../../core/form";
import { say } from "../../core/messages";
import { stored } from "../../core/stored";
import type { CameraDetail } from "../../core/types";
import { lengthUnit, parseNumber, parseSmall, smallScale } from "../../core/units";
import { KindField, MarkerFields } from "../../parts/boards/MarkerFields";
import { PLAIN } from "../../parts/boards/markers";
import { BoardDrawing } from "./BoardDrawing";
import { boardText, inUnit, problemsOf, readBoard, type TypedBoard } from "./board";

/** The board as it was for this camera's images; the square as it was typed last on this machine. */
function firstBoard(camera: CameraDetail): TypedBoard {
  const image = camera.images.find((one) => !one.found) ?? camera.images[0];
  const square_m = square_mm.value / 1000;
  const share = image?.marker_share ?? null;
  return {
    columns: String(image?.columns ?? 9),
    rows: String(image?.rows ?? 6),
    square: boardText(square_m),
    kind: image?.dictionary ? "charuco" : "checkerboard",
    dictionary: image?.dictionary ?? PLAIN.dictionary,
    marker: share === null ? "" : boardText(share * square_m),
  };
}

/** The board being typed; when the person turns to another unit, its lengths are turned with it. */
export function useTypedBoard(camera: CameraDetail): [TypedBoard, (board: TypedBoard) => void] {
  const [typed, setTyped] = useState(() => firstBoard(camera));
  const unit = lengthUnit.value;
  const before = useRef(unit);
  useEffect(() => {
    const from = before.current;
    before.current = unit;
    if (from !== unit) setTyped((board) => inUnit(board, from, unit));
  }, [unit]);
  return [typed, setTyped];
}

const square_mm = stored("square_mm", 25, (value) => value > 0);

export function BoardFields({ board, change }: { board: TypedBoard; change: (board: TypedBoard) => void }) {
  const problems = problemsOf(board);
  const [, unit] = smallScale();
  const set = (part: Partial<TypedBoard>) => {
    const next = { ...board, ...part };
    change(next);
    if (part.square && !problemsOf(next).square) square_mm.value = 1000 * (parseSmall(part.square) ?? 0);
  };
  const field = fieldsOf(board, set);
  return (
    <div class="board">
      <div class="stack stack--near board__fields">
        <KindField value={board} change={set} />
        <p>
          <Said what="camera-inner-corners" /> {board.kind === "charuco" && say("camera-charuco-corners")}
        </p>
        <div class="board__inputs">
          <TextField says="camera-columns" numeric {...field("columns")} problem={problems.columns} />
          <TextField says="camera-rows" numeric {...field("rows")} problem={problems.rows} />
          <TextField says="camera-square" unit={unit} {...field("square")} problem={problems.square} />
        </div>
        <MarkerFields value={board} unit={unit} problem={problems.marker} change={set} />
        <p class="field__hint">{say("camera-square-hint")}</p>
        <PrintBoard board={board} />
      </div>
      <BoardDrawing
        columns={Number(board.columns) || 9}
        rows={Number(board.rows) || 6}
        square={`${board.square || "?"} ${unit}`}
        markers={board.kind === "charuco"}
        share={markerShare(board)}
      />
    </div>
  );
}

/** The board that is typed, as a PDF at true size; nothing to press while a field is wrong. */
function PrintBoard({ board }: { board: TypedBoard }) {
  const told = readBoard(board);
  if (!told) return null;
  const asked = new URLSearchParams(Object.entries(told).map(([name, value]) => [name, `${value}`]));
  return (
    <p class="field__hint">
      <a href={`/api/boards.pdf?${asked}`} target="_blank" rel="noopener">
        {say("camera-print")}
      </a>
      {" – "}
      {say("camera-print-hint")}
    </p>
  );
}

/** How much of a square's side the marker takes in the drawing. */
function markerShare(board: TypedBoard): number {
  const [marker, square] = [parseNumber(board.marker), parseNumber(board.square)];
  return marker && square && marker > 0 && marker < square ? Math.max(marker / square, 0.3) : 0.75;
}
