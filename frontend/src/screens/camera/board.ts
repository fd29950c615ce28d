/** The checkerboard as a person types it, and what is wrong with it in words. */

import { parseNumber } from "../../core/units";
import { type BoardKind, markerProblem, markersTold } from "../../parts/boards/markers";

export interface TypedBoard {
  columns: string;
  rows: string;
  /** side of one square, millimetres */
  square: string;
  kind: BoardKind;
  dictionary: string;
  /** side of one marker, millimetres */
  marker: string;
}

export interface Board {
  columns: number;
  rows: number;
  square_m: number;
  board_kind?: "charuco";
  dictionary?: string;
  marker_m?: number;
}

export interface BoardProblems {
  columns: string | null;
  rows: string | null;
  square: string | null;
  marker: string | null;
}

function countProblem(text: string, what: string): string | null {
  const value = parseNumber(text);
  if (value === null || !Number.isInteger(value)) return `Give the number of ${what} as a whole number.`;
  if (value < 3 || value > 50) return `Between 3 and 50 ${what} can be found; count the inner corners again.`;
  return null;
}

export function problemsOf(typed: TypedBoard): BoardProblems {
  const square = parseNumber(typed.square);
  return {
    columns: countProblem(typed.columns, "columns"),
    rows: countProblem(typed.rows, "rows"),
    square:
      square === null || square <= 0 || square > 2000
        ? "Give the side of one square in millimetres, for example 25."
        : null,
    marker: markerProblem(typed.kind, parseNumber(typed.marker), square, "18"),
  };
}

/** The board in numbers, or null while something is wrong. */
export function readBoard(typed: TypedBoard): Board | null {
  const problems = problemsOf(typed);
  if (Object.values(problems).some((problem) => problem !== null)) return null;
  const number = (text: string) => parseNumber(text) ?? 0;
  return {
    columns: number(typed.columns),
    rows: number(typed.rows),
    square_m: number(typed.square) / 1000,
    ...markersTold(typed.kind, typed.dictionary, number(typed.marker) / 1000),
  };
}
