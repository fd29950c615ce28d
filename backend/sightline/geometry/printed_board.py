"""A board as it is printed: rectangles of ink, in the order in which a person sees its corners."""

import math
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.errors import BadInput
from sightline.geometry.board import Board, require_board

#: Standing sheets (width, height) in m, ISO 216 from the smallest on, then ANSI/ASME Y14.1.
PAPERS = {
    "A4": (0.210, 0.297),
    "A3": (0.297, 0.420),
    "A2": (0.420, 0.594),
    "A1": (0.594, 0.841),
    "A0": (0.841, 1.189),
    "Letter": (0.2159, 0.2794),
    "Tabloid": (0.2794, 0.4318),
}
_ISO = ("A4", "A3", "A2", "A1", "A0")
_EDGE_M = 0.010  # what printers leave white
_EDGE_SQUARES = 0.4  # white about the board, at least
_CAPTION_M = 0.015
_BAR_M = 0.1
# Of a sheet's sides; the least has room for the bar and what printers leave white.
_LEAST_MM, _MOST_MM = 120, 5000


@dataclass(frozen=True, eq=False)
class PrintedBoard:
    """A sheet (width, height) in m with ink on it. `black`, and `white` on top of it: rectangles (N, 4), m,
    each left, top, width, height from the sheet's top left; `bar`: the scale bar (left, top, length).
    """

    paper: str
    size_m: tuple[float, float]
    black: Floats
    white: Floats
    bar_m: tuple[float, float, float]


def printed_board(board: Board, paper: str | None = None) -> PrintedBoard:
    """The board on a sheet of `paper` ("A3", "Letter", or "841x1500" in mm), lying or standing; without one,
    on the smallest ISO sheet (ISO 216) that holds it with white round it.

    Markers stand where OpenCV's boards have them (Garrido-Jurado et al. 2014). Raises BadInput for a board
    that no detector can look for, for a paper that is not known, and where the board does not go on it.
    """
    require_board(board)
    across, down = (board.columns + 1) * board.square_m, (board.rows + 1) * board.square_m
    edge = max(_EDGE_M, _EDGE_SQUARES * board.square_m)
    needed = across + 2.0 * edge, down + 2.0 * edge + _CAPTION_M
    name, size = _sheet(board, needed, paper)
    left, top = 0.5 * (size[0] - across), 0.5 * (size[1] - _CAPTION_M - down)
    black, white = _ink(board)
    place = np.array([left, top, 0.0, 0.0])
    bar = min(left, size[0] - _EDGE_M - _BAR_M), top + down + edge, _BAR_M
    return PrintedBoard(name, size, black + place, white + place, bar)


def _sheet(board: Board, needed: tuple[float, float], paper: str | None) -> tuple[str, tuple[float, float]]:
    names = _ISO if paper is None else (paper,)
    for name in names:
        short, long = _size_of(name)
        for size in ((short, long), (long, short)):
            if needed[0] <= size[0] + 1e-9 and needed[1] <= size[1] + 1e-9:
                return name, size
    wide, high = (round(1000.0 * side) for side in needed)
    most = math.floor(1e4 * _largest_square_m(board, _size_of(names[-1])) + 1e-7) / 10.0
    if paper is None:
        raise BadInput("geometry-board-over-paper", width_mm=wide, height_mm=high, square_mm=most)
    raise BadInput("geometry-board-off-paper", paper=paper, width_mm=wide, height_mm=high, square_mm=most)


def _largest_square_m(board: Board, sheet: tuple[float, float]) -> float:
    """The side of the largest squares with which such a board goes on a sheet, lying or standing."""

    def along(squares: int, room_m: float) -> float:
        return min((room_m - 2.0 * _EDGE_M) / squares, room_m / (squares + 2.0 * _EDGE_SQUARES))

    return max(
        min(along(board.columns + 1, width), along(board.rows + 1, height - _CAPTION_M))
        for width, height in (sheet, sheet[::-1])
    )


def _size_of(paper: str) -> tuple[float, float]:
    known = {name.lower(): size for name, size in PAPERS.items()}
    if paper.strip().lower() in known:
        return known[paper.strip().lower()]
    sides = paper.lower().split("x")
    if len(sides) == 2 and all(
        side.strip().isdigit() and _LEAST_MM <= int(side) <= _MOST_MM for side in sides
    ):
        return 0.001 * int(sides[0]), 0.001 * int(sides[1])
    raise BadInput(
        "geometry-paper-not-known",
        paper=repr(paper),
        papers=", ".join(PAPERS),
        least_mm=_LEAST_MM,
        most_mm=_MOST_MM,
    )


def _ink(board: Board) -> tuple[Floats, Floats]:
    """Black and white rectangles (N, 4) from the board's own top left corner, m."""
    square = board.square_m
    if board.charuco is None:
        row, column = np.nonzero(np.indices((board.rows + 1, board.columns + 1)).sum(axis=0) % 2 == 0)
        return _squares(np.column_stack([column, row]) * square, square), np.empty((0, 4))
    name = getattr(cv2.aruco, f"DICT_{board.charuco.dictionary}")
    dictionary = cv2.aruco.getPredefinedDictionary(name)
    size = (board.columns + 1, board.rows + 1)
    charuco_board = cv2.aruco.CharucoBoard(size, square, board.charuco.marker_m, dictionary)
    corners = np.asarray(charuco_board.getObjPoints(), dtype=np.float64)[:, 0, :2]
    with_marker = np.zeros((board.rows + 1, board.columns + 1), dtype=bool)
    with_marker[tuple((corners // square).astype(int).T[::-1])] = True
    row, column = np.nonzero(~with_marker)
    side, cells = board.charuco.marker_m, dictionary.markerSize + 2
    white = [
        _holes(_marker(dictionary, int(number), cells), side) + np.array([*at, 0.0, 0.0])
        for number, at in zip(charuco_board.getIds(), corners, strict=True)
    ]
    black = [_squares(np.column_stack([column, row]) * square, square), _squares(corners, side)]
    return np.concatenate(black), np.concatenate(white)


def _marker(dictionary: cv2.aruco.Dictionary, number: int, cells: int) -> NDArray[np.bool_]:
    """(cells, cells), True where a marker is white."""
    return np.asarray(cv2.aruco.generateImageMarker(dictionary, number, cells)) > 0


def _squares(at: NDArray[Any], side: float) -> Floats:
    return np.column_stack([at, np.full((len(at), 2), side)])


def _holes(marker: NDArray[np.bool_], side: float) -> Floats:
    """Runs of white cells of a marker (n, n), each one rectangle, so that no seam shows within a row."""
    cell = side / len(marker)
    runs = []
    for row, line in enumerate(marker):
        steps = np.flatnonzero(np.diff(np.concatenate([[False], line, [False]]).astype(np.int8)))
        runs += [(start, row, stop - start, 1) for start, stop in zip(steps[::2], steps[1::2], strict=True)]
    return np.asarray(runs, dtype=np.float64).reshape(-1, 4) * cell
