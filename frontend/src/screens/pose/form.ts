/** What the operator says about the board, as typed; checked here only for being there and readable, judged by the server. */
import { say } from "../../core/messages";
import type { BodyOf } from "../../core/routes";
import type { Pose } from "../../core/types";
import {
  type LengthUnit,
  lengthText,
  lengthUnit,
  parseLength,
  parseNumber,
  parseSmall,
  smallText,
} from "../../core/units";
import { markerProblem, markersTold, PLAIN, type TypedMarkers } from "../../parts/boards/markers";

export interface BoardForm extends TypedMarkers {
  readonly calibrationId: number | null;
  readonly columns: number;
  readonly rows: number;
  /** Lengths as typed, the board's own and the uncertainties as small lengths (mm), the tape's in m; or in and ft. */
  readonly square: string;
  readonly reference: "top" | "bottom";
  readonly referenceHeight: string;
  /** The four uncertainties: empty stands for the usual estimate. */
  readonly uReferenceHeight: string;
  readonly uLean: string;
  readonly uSquare: string;
  readonly uBow: string;
  readonly first: number | null;
  readonly last: number | null;
}

export const EMPTY_FORM: BoardForm = {
  calibrationId: null,
  columns: 9,
  rows: 6,
  square: "",
  ...PLAIN,
  reference: "bottom",
  referenceHeight: "",
  uReferenceHeight: "",
  uLean: "0.3",
  uSquare: "",
  uBow: "",
  first: null,
  last: null,
};

/** Usual estimates: a steel tape on asphalt, the middle of a stiff board out of plane. */
export const U_TAPE_M = 0.003;
export const U_BOW_M = 0.0005;

const RADIANS_PER_DEGREE = Math.PI / 180;

export function problemsOf(form: BoardForm) {
  const square = parseSmall(form.square);
  const height = parseLength(form.referenceHeight);
  const tape = smallOr(form.uReferenceHeight, U_TAPE_M);
  const lean = leanOf(form);
  const ofSquare = smallOr(form.uSquare, 0);
  const bow = smallOr(form.uBow, U_BOW_M);
  return {
    calibration: form.calibrationId === null ? say("pose-problem-calibration") : null,
    board: form.columns >= 2 && form.rows >= 2 ? null : say("pose-problem-board"),
    square: square !== null && square > 0 ? null : say("pose-problem-square"),
    marker: markerProblem(form.kind, parseSmall(form.marker), square, smallText(0.075)),
    referenceHeight: height !== null ? null : say("pose-problem-height"),
    uncertainty: [tape, lean, ofSquare, bow].every((one) => one !== null && one >= 0)
      ? null
      : say("pose-problem-u"),
    span: form.first !== null && form.last !== null ? null : say("pose-problem-span"),
  };
}

function leanOf({ uLean }: BoardForm): number | null {
  return parseNumber(uLean.trim() || "0");
}

function smallOr(text: string, metres: number): number | null {
  return text.trim() === "" ? metres : parseSmall(text);
}

export function requestOf(form: BoardForm): BodyOf<"POST /recordings/{recording_id}/poses"> | null {
  const { calibrationId, first, last } = form;
  const square_m = parseSmall(form.square);
  const reference_height_m = parseLength(form.referenceHeight);
  const u_reference_height_m = smallOr(form.uReferenceHeight, U_TAPE_M);
  const u_bow_m = smallOr(form.uBow, U_BOW_M);
  if (Object.values(problemsOf(form)).some((problem) => problem !== null)) return null;
  if (calibrationId === null || first === null || last === null) return null;
  if (square_m === null || reference_height_m === null) return null;
  if (u_reference_height_m === null || u_bow_m === null) return null;
  return {
    calibration_id: calibrationId,
    first_frame: first,
    last_frame: last,
    columns: form.columns,
    rows: form.rows,
    square_m,
    ...markersTold(form.kind, form.dictionary, parseSmall(form.marker)),
    reference: form.reference,
    reference_height_m,
    u_reference_height_m,
    u_lean_rad: (leanOf(form) ?? 0) * RADIANS_PER_DEGREE,
    ...(form.uSquare.trim() === "" ? {} : { u_square_m: parseSmall(form.uSquare) }),
    u_bow_m,
  };
}

export type BoardSought = Omit<BodyOf<"POST /recordings/{recording_id}/board">, "frame" | "calibration_id">;

export function boardOf(form: BoardForm): BoardSought | null {
  if (form.columns < 2 || form.rows < 2) return null;
  const size = { columns: form.columns, rows: form.rows };
  if (form.kind === "checkerboard") return size;
  const { square, marker } = problemsOf(form);
  if (square !== null || marker !== null) return null;
  const square_m = parseSmall(form.square);
  return { ...size, square_m, ...markersTold(form.kind, form.dictionary, parseSmall(form.marker)) };
}

/** What somebody measured where the board stood: true of that one setting up alone, so never carried to another. */
export const NOT_MEASURED: Pick<BoardForm, "referenceHeight" | "uReferenceHeight" | "uLean"> = {
  referenceHeight: EMPTY_FORM.referenceHeight,
  uReferenceHeight: EMPTY_FORM.uReferenceHeight,
  uLean: EMPTY_FORM.uLean,
};

/** What an earlier pose was made from; of another recording without its span and without what was measured there. */
export function fromPose(
  pose: Pose,
  own: boolean,
): Partial<BoardForm> & Pick<BoardForm, "columns" | "rows" | "square"> {
  const board = pose.document.board;
  const small = (metres: number | null | undefined): string => smallText(metres, lengthUnit.value, 4);
  return {
    columns: board?.columns ?? EMPTY_FORM.columns,
    rows: board?.rows ?? EMPTY_FORM.rows,
    square: small(board?.square_m),
    reference: board?.reference ?? "bottom",
    uSquare: small(board?.u_square_m),
    uBow: small(board?.u_bow_m),
    ...(own ? ofSettingUp(pose) : NOT_MEASURED),
  };
}

function ofSettingUp(pose: Pose): Partial<BoardForm> {
  const board = pose.document.board;
  return {
    referenceHeight: lengthText(board?.reference_height_m),
    uReferenceHeight: smallText(board?.u_reference_height_m, lengthUnit.value, 4),
    uLean:
      board === null ? EMPTY_FORM.uLean : String(Number((board.u_lean_rad / RADIANS_PER_DEGREE).toFixed(2))),
    first: pose.first_frame,
    last: pose.last_frame,
    calibrationId: pose.calibration_id,
  };
}

const SMALL = ["square", "marker", "uReferenceHeight", "uSquare", "uBow"] as const;

/** What is typed, in another unit: the lengths stay, their numbers change. */
export function inUnit(form: BoardForm, from: LengthUnit, to: LengthUnit): BoardForm {
  const turned = SMALL.map((name) => {
    const metres = parseSmall(form[name], from);
    return [name, metres === null ? form[name] : smallText(metres, to, to === "ft" ? 5 : 4)];
  });
  const height = parseLength(form.referenceHeight, from);
  const referenceHeight = height === null ? form.referenceHeight : lengthText(height, to, 5);
  return { ...form, ...Object.fromEntries(turned), referenceHeight };
}
