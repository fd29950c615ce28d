/** What the operator says about the board, as typed; checked here only for being there and readable, judged by the server. */
import { lengthText } from "../measure/lengths";
import type { Pose } from "../types";
import { parseLength } from "../units";

export interface BoardForm {
  readonly calibrationId: number | null;
  /** Inner corners. */
  readonly columns: number;
  readonly rows: number;
  /** Lengths as typed, in the shown unit; `null` stands for the default. */
  readonly square: string;
  readonly reference: "top" | "bottom";
  readonly referenceHeight: string;
  readonly uReferenceHeight: string;
  /** Degrees as typed. */
  readonly uLean: string;
  readonly first: number | null;
  readonly last: number | null;
}

export const EMPTY_FORM: BoardForm = {
  calibrationId: null,
  columns: 9,
  rows: 6,
  square: "",
  reference: "bottom",
  referenceHeight: "",
  uReferenceHeight: "0.003",
  uLean: "0.3",
  first: null,
  last: null,
};

export interface FormProblems {
  calibration: string | null;
  board: string | null;
  square: string | null;
  referenceHeight: string | null;
  uncertainty: string | null;
  span: string | null;
}

const RADIANS_PER_DEGREE = Math.PI / 180;

export function problemsOf(form: BoardForm): FormProblems {
  const square = parseLength(form.square);
  const height = parseLength(form.referenceHeight);
  const tape = parseLength(form.uReferenceHeight);
  const lean = Number(form.uLean.replace(",", "."));
  return {
    calibration:
      form.calibrationId === null ? "Calibrate the camera first; without its lens there is no pose." : null,
    board: form.columns >= 2 && form.rows >= 2 ? null : "A board has at least 2 by 2 inner corners.",
    square: square !== null && square > 0 ? null : "Measure one square over several and enter its side.",
    referenceHeight: height !== null ? null : "Measure it with a tape; every height rests on it.",
    uncertainty: tape !== null && tape >= 0 && lean >= 0 ? null : "Both are figures of zero or more.",
    span:
      form.first !== null && form.last !== null ? null : "Mark the frames in which the board stands still.",
  };
}

/** The request, or null while something is missing. */
export function requestOf(form: BoardForm): Record<string, unknown> | null {
  if (Object.values(problemsOf(form)).some((problem) => problem !== null)) return null;
  return {
    calibration_id: form.calibrationId,
    first_frame: form.first,
    last_frame: form.last,
    columns: form.columns,
    rows: form.rows,
    square_m: parseLength(form.square),
    reference: form.reference,
    reference_height_m: parseLength(form.referenceHeight),
    u_reference_height_m: parseLength(form.uReferenceHeight),
    u_lean_rad: Number(form.uLean.replace(",", ".")) * RADIANS_PER_DEGREE,
  };
}

interface BoardOfPose {
  columns?: number;
  rows?: number;
  square_m?: number;
  reference?: "top" | "bottom";
  reference_height_m?: number;
  u_reference_height_m?: number;
  u_lean_rad?: number;
}

/** What an earlier pose was made from; of another recording without its span. */
export function fromPose(
  pose: Pose,
  own: boolean,
): Partial<BoardForm> & Pick<BoardForm, "columns" | "rows" | "square"> {
  const board = (pose.document["board"] ?? {}) as BoardOfPose;
  const text = (metres: number | undefined, otherwise: string): string =>
    metres === undefined ? otherwise : lengthText(metres);
  return {
    columns: board.columns ?? EMPTY_FORM.columns,
    rows: board.rows ?? EMPTY_FORM.rows,
    square: text(board.square_m, ""),
    reference: board.reference ?? "bottom",
    referenceHeight: text(board.reference_height_m, ""),
    uReferenceHeight: text(board.u_reference_height_m, EMPTY_FORM.uReferenceHeight),
    uLean:
      board.u_lean_rad === undefined
        ? EMPTY_FORM.uLean
        : String(Number((board.u_lean_rad / RADIANS_PER_DEGREE).toFixed(2))),
    ...(own ? { first: pose.first_frame, last: pose.last_frame, calibrationId: pose.calibration_id } : {}),
  };
}
