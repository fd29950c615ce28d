/** The checkerboard as a person types it, and what is wrong with it in words. */
import { say } from "../../core/messages";
import type { BoardIn, CalibrationWish } from "../../core/types";
import {
  type LengthUnit,
  lengthUnit,
  localNumber,
  parseNumber,
  parseSmall,
  smallText,
} from "../../core/units";
import { markerProblem, markersTold, type TypedMarkers } from "../../parts/boards/markers";

export interface TypedBoard extends TypedMarkers {
  columns: string;
  rows: string;
  /** side of one square, as a small length in the shown unit */
  square: string;
}

/** What is calibrated with, as far as it is the board. */
export type Board = Pick<CalibrationWish, keyof BoardIn>;

const EXAMPLES: Record<LengthUnit, { square: string; marker: string }> = {
  m: { square: "25", marker: "18" },
  ft: { square: "1", marker: "0.75" },
};

function countProblem(text: string, what: "columns" | "rows"): string | null {
  const value = parseNumber(text);
  if (value === null || !Number.isInteger(value)) return say("camera-count-problem", { what });
  if (value < 3 || value > 50) return say("camera-count-range", { what });
  return null;
}

export function problemsOf(typed: TypedBoard) {
  const square = parseSmall(typed.square);
  const example = EXAMPLES[lengthUnit.value];
  return {
    columns: countProblem(typed.columns, "columns"),
    rows: countProblem(typed.rows, "rows"),
    square:
      square === null || square <= 0 || square > 2
        ? say("camera-square-problem", { unit: lengthUnit.value, example: localNumber(example.square) })
        : null,
    marker: markerProblem(typed.kind, parseSmall(typed.marker), square, localNumber(example.marker)),
  };
}

export function readBoard(typed: TypedBoard): Board | null {
  const problems = problemsOf(typed);
  if (Object.values(problems).some((problem) => problem !== null)) return null;
  const number = (text: string) => parseNumber(text) ?? 0;
  const length = (text: string) => parseSmall(text) ?? 0;
  return {
    columns: number(typed.columns),
    rows: number(typed.rows),
    square_m: length(typed.square),
    ...markersTold(typed.kind, typed.dictionary, length(typed.marker)),
  };
}

/** A length of the board as it is typed: to a micrometre or finer, so that turning the unit and back changes nothing. */
export function boardText(metres: number | null | undefined, unit = lengthUnit.value): string {
  return smallText(metres, unit, unit === "ft" ? 5 : 3);
}

/** The same board typed in another unit; what is no number stays as it is. */
export function inUnit(typed: TypedBoard, from: LengthUnit, to: LengthUnit): TypedBoard {
  const turned = (text: string) => boardText(parseSmall(text, from), to) || text;
  return { ...typed, square: turned(typed.square), marker: turned(typed.marker) };
}
