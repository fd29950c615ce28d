/** The kind of board and its markers: what both board forms ask for, and what the last board on this machine was. */
import { say } from "../../core/messages";

export type BoardKind = "checkerboard" | "charuco";

export interface TypedMarkers {
  readonly kind: BoardKind;
  readonly dictionary: string;
  /** Side of a marker, in the unit of the form's other lengths. */
  readonly marker: string;
}

export const PLAIN: TypedMarkers = { kind: "checkerboard", dictionary: "4X4_50", marker: "" };

const SIZES = ["4X4", "5X5", "6X6", "7X7"].flatMap((bits) =>
  ["50", "100", "250", "1000"].map((count) => `${bits}_${count}`),
);
export const DICTIONARIES: readonly string[] = [
  ...SIZES,
  "ARUCO_ORIGINAL",
  "APRILTAG_16H5",
  "APRILTAG_25H9",
  "APRILTAG_36H10",
  "APRILTAG_36H11",
];

/** What is wrong with the marker's side, in words; lengths in any one unit. */
export function markerProblem(
  kind: BoardKind,
  marker: number | null,
  square: number | null,
  example: string,
): string | null {
  if (kind === "checkerboard") return null;
  if (marker === null || marker <= 0) return say("board-marker-problem", { example });
  if (square !== null && marker >= square) return say("board-marker-too-large");
  return null;
}

/** The part of a request that tells the kind of board; nothing for a plain one. */
export function markersTold(kind: BoardKind, dictionary: string, marker_m: number | null) {
  return kind === "charuco" && marker_m !== null ? { board_kind: kind, dictionary, marker_m } : {};
}

export interface BoardPlace {
  left: number;
  top: number;
  side: number;
  across: number;
  down: number;
}

/** The dark squares of a board, drawn; `share` of the side of its white squares are their markers, null: it has none. */
export function boardPath({ left, top, side, across, down }: BoardPlace, share: number | null): string {
  let path = "";
  for (let r = 0; r < down; r++) {
    for (let c = 0; c < across; c++) {
      const [x, y] = [left + c * side, top + r * side];
      if ((r + c) % 2 === 0) path += `M${x} ${y}h${side}v${side}h${-side}z`;
      else if (share !== null) path += markerPath(x, y, side, share, r * 17 + c);
    }
  }
  return path;
}

/** One of every white square's markers, drawn: its black body and a few of its cells; `seed` tells them apart. */
function markerPath(x: number, y: number, side: number, share: number, seed: number): string {
  const body = side * share;
  const cell = body / 6;
  const [left, top] = [x + (side - body) / 2, y + (side - body) / 2];
  let path = `M${left} ${top}h${body}v${body}h${-body}z`;
  for (let i = 0; i < 16; i++) {
    if (((seed * 2654435761 + i * 40503) >> 5) % 3 !== 0) continue;
    path += `M${left + (1 + (i % 4)) * cell} ${top + (1 + Math.floor(i / 4)) * cell}v${cell}h${cell}v${-cell}z`;
  }
  return path;
}
