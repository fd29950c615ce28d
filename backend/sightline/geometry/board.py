"""The checkerboard: its points, and the one order in which its corners are ever handed on.

OpenCV's detectors start at any of the corners that look alike to them: for a board that is the same after
half a turn, the classic one and SB return opposite first corners for one and the same picture, and a height
computed from the wrong one is negative (Dupuis et al. 2019, eq. (8), needs n_x to point *down*). So every
detection is brought into the order as seen: first corner at the top left, columns to the right, rows down.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.enums import BoardSide
from sightline.errors import BadInput
from sightline.geometry.charuco import Charuco, require_charuco

MAX_ROLL_RAD = np.deg2rad(62.0)  # a board given as columns x rows is believed up to this roll of the camera


@dataclass(frozen=True)
class Board:
    """A checkerboard by its inner corners: `columns` across, `rows` down, squares of `square_m`; `charuco`
    where its white squares carry markers.
    """

    columns: int
    rows: int
    square_m: float
    charuco: Charuco | None = None

    @property
    def corners(self) -> int:
        return self.columns * self.rows

    @property
    def clear_share(self) -> float:
        """Radius round a corner, in squares, in which a fit meets nothing but the four squares."""
        return 0.42 if self.charuco is None else min(0.42, 0.95 * self.charuco.clear_share(self.square_m))


def require_board(board: Board) -> None:
    """Raise BadInput for a board that no detector can look for."""
    if min(board.columns, board.rows) < 3 or max(board.columns, board.rows) > 60:
        raise BadInput("geometry-board-corner-count", columns=board.columns, rows=board.rows)
    if not (np.isfinite(board.square_m) and 0.0005 <= board.square_m <= 5.0):
        raise BadInput("geometry-square-implausible", square_m=board.square_m)
    if board.charuco is not None:
        require_charuco(board.charuco, board.columns, board.rows, board.square_m)


def board_points(board: Board) -> Floats:
    """Corners (rows * columns, 3) in the board's own frame, m: x right, y down, z away from the viewer."""
    row, column = np.mgrid[0 : board.rows, 0 : board.columns]
    flat = np.stack([column.ravel(), row.ravel(), np.zeros(board.corners)], axis=1)
    return np.asarray(flat * board.square_m, dtype=np.float64)


def road_points(board: Board, side: BoardSide, height_m: float) -> Floats:
    """Corners (rows * columns, 3) in the road frame, of a board that stands square on the road.

    X to the right, Y = 0, Z the height above the road: the reference row (top or bottom inner corners) lies
    at `height_m`. Dupuis et al. 2019, eq. (8), corrected: the ground lies `height_m` below the reference
    *corner*, in the direction in which the rows count, never above it.
    """
    at_board = board_points(board)
    top_m = height_m if side == "top" else height_m + (board.rows - 1) * board.square_m
    zeros = np.zeros(board.corners)
    return np.stack([at_board[:, 0], zeros, top_m - at_board[:, 1]], axis=1)


def canonical_order(points_px: Floats, board: Board) -> tuple[Floats, Board]:
    """Bring a detection of `board`, `points_px` (rows, columns, 2), in any of its orders, into the order as
    seen.

    Returns the grid, of the same shape or transposed, and the board as seen: transposed where the picture
    shows that the board stands the other way up (its rows would otherwise point more than 62 degrees away
    from the picture's down). A board that is as many columns as rows is taken to stand upright within 45
    degrees.

    CONVENTIONS.md, Corner order: Dupuis et al. 2019, eq. (8), needs n_x to point down, which they leave to
    the detector.
    """
    grids = [points_px, points_px.transpose(1, 0, 2)]
    best = min((_upright(grid) for grid in grids if _fits(grid, board)), key=lambda found: found[1])
    if best[1] > MAX_ROLL_RAD and board.columns != board.rows:
        best = min((_upright(grid) for grid in grids if not _fits(grid, board)), key=lambda found: found[1])
    grid = best[0]
    return np.ascontiguousarray(grid), replace(board, columns=grid.shape[1], rows=grid.shape[0])


def numbered_as_seen(
    numbers: NDArray[np.intp], points_px: Floats, board: Board
) -> tuple[NDArray[np.intp], Floats, Board]:
    """Corners of a numbered board, seen in part, in the order as seen: their places in the grid as seen (N,),
    rising, and pixels (N, 2) in that order; points_px (N, 2).

    numbers (N,): row by row as printed. The whole grid is carried on from what is seen, by the affine map
    that fits best, and ordered like any other (CONVENTIONS.md, Corner order).
    """
    at = np.column_stack([numbers % board.columns, numbers // board.columns, np.ones(len(numbers))])
    to_px = np.linalg.lstsq(at, points_px, rcond=None)[0]
    row, column = np.mgrid[0 : board.rows, 0 : board.columns]
    whole = np.stack([column, row, np.ones_like(row)], axis=-1) @ to_px
    printed = np.arange(board.corners).reshape(board.rows, board.columns, 1)
    ordered, as_seen = canonical_order(np.concatenate([whole, printed], axis=2), board)
    place = np.empty(board.corners, dtype=np.intp)
    place[ordered[..., 2].ravel().astype(np.intp)] = np.arange(board.corners)
    order = np.argsort(place[numbers])
    return place[numbers][order], points_px[order], as_seen


def _fits(grid: Floats, board: Board) -> bool:
    return grid.shape[:2] == (board.rows, board.columns)


def _upright(grid: Floats) -> tuple[Floats, float]:
    """Of two right-handed half-turns of a grid, the one whose rows run down; its roll, 0 to 90 degrees."""
    right, down = _directions(grid)
    if right[0] * down[1] - right[1] * down[0] < 0:  # mirrored: numbered against the hand of the picture
        grid = grid[:, ::-1]
    down = _directions(grid)[1]
    if down[1] < 0:
        grid, down = grid[::-1, ::-1], -down
    return grid, float(np.arctan2(abs(down[0]), down[1]))


def _directions(grid: Floats) -> tuple[Floats, Floats]:
    """Mean direction of the columns and of the rows in the picture, each from edge to edge."""
    right = (grid[:, -1] - grid[:, 0]).mean(axis=0)
    down = (grid[-1] - grid[0]).mean(axis=0)
    return right, down
