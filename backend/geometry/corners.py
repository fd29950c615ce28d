"""Finding the checkerboard: bounded in time, with fallbacks, always in the order as seen."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from backend.geometry.arrays import Floats, frozen
from backend.geometry.board import Board as Board
from backend.geometry.board import canonical_order, require_board
from backend.geometry.extent import goes_on
from backend.geometry.saddle import refine_saddles

Gray = NDArray[np.uint8]

_CLASSIC = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE
_FAST = _CLASSIC | cv2.CALIB_CB_FAST_CHECK
_SB = cv2.CALIB_CB_NORMALIZE_IMAGE
_STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)
# seconds per megapixel that an attempt may take where there is no board (measured, doubled)
_COST = {
    "classic": 0.1,
    "sector": 0.25,
    "classic, full": 1.2,
    "classic, enlarged": 0.5,
    "sector, enlarged": 1.2,
}


@dataclass(frozen=True, eq=False)
class Corners:
    """A detection. `points_px` (rows, columns, 2) of `board_as_seen`: [0, 0] top left as seen, columns to the
    right, rows down; empty with a `reason` where nothing was found. `sharpness`: width in pixels of the edges
    from 10 to 90 per cent (smaller is sharper), 0 where unknown.
    """

    found: bool
    points_px: Floats
    board_as_seen: Board
    reason: str | None
    sharpness: float
    detector: str


def not_found(board: Board, reason: str) -> Corners:
    """A detection that did not succeed, and why."""
    return Corners(False, frozen(np.empty((0, 0, 2))), board, reason, 0.0, "")


def _classic(gray: Gray, board: Board, flags: int) -> Floats | None:
    found, points = cv2.findChessboardCorners(gray, (board.columns, board.rows), flags=flags)
    return np.asarray(points, dtype=np.float64).reshape(-1, 2) if found else None


def _sector(gray: Gray, board: Board) -> Floats | None:
    found, points = cv2.findChessboardCornersSB(gray, (board.columns, board.rows), flags=_SB)
    return np.asarray(points, dtype=np.float64).reshape(-1, 2) if found else None


def _enlarged(gray: Gray, search: Callable[[Gray], Floats | None]) -> Floats | None:
    twice: Any = cv2.resize(gray, None, fx=2.0, fy=2.0, interpolation=cv2.INTER_CUBIC)
    points = search(twice)
    return None if points is None else (points + 0.5) / 2.0 - 0.5


def _attempts(board: Board) -> Sequence[tuple[str, Callable[[Gray], Floats | None]]]:
    return (
        ("classic", lambda gray: _classic(gray, board, _FAST)),
        ("sector", lambda gray: _sector(gray, board)),
        ("classic, full", lambda gray: _classic(gray, board, _CLASSIC)),
        ("classic, enlarged", lambda gray: _enlarged(gray, lambda big: _classic(big, board, _FAST))),
        ("sector, enlarged", lambda gray: _enlarged(gray, lambda big: _sector(big, board))),
    )


def detect(gray: Gray, board: Board, time_limit_s: float = 2.0) -> Corners:
    """Find `board` in a grey picture (H, W) uint8.

    The classic detector with its quick rejection first, the sector-based one next (Duda and Frese 2018),
    then the classic one in full and both on the enlarged picture. No attempt starts that could outlast
    `time_limit_s`. Raises BadInput for an impossible board; a picture without the board is a result with
    its reason.
    """
    require_board(board)
    if gray.ndim != 2 or min(gray.shape) < 32:
        return not_found(board, "The picture is too small to hold a board.")
    started = perf_counter()
    megapixels = gray.size / 1e6
    doubt: str | None = None
    skipped = False
    for index, (name, search) in enumerate(_attempts(board)):
        if index and perf_counter() - started + _COST[name] * megapixels > time_limit_s:
            skipped = True
            continue
        points = search(gray)
        if points is not None:
            corners = _accepted(gray, points, board, name)
            if corners.found:
                return corners
            doubt = doubt or corners.reason
    return not_found(board, doubt or _advice(board, skipped))


def _advice(board: Board, skipped: bool) -> str:
    text = (
        f"No board of {board.columns}x{board.rows} inner corners was found; the whole board with its white "
        "margin must be in the picture, sharp and evenly lit, and inner corners are counted."
    )
    return text + (" The search was cut short by its time limit." if skipped else "")


def _accepted(gray: Gray, points: Floats, board: Board, name: str) -> Corners:
    """Refine, check and order what a detector returned."""
    grid = points.reshape(board.rows, board.columns, 2)
    grid = refine_subpixel(gray, grid)
    reason = flaw(gray, grid)
    if reason is not None:
        return not_found(board, reason)
    grid = refine_saddles(gray, grid).points_px.reshape(grid.shape)
    ordered, as_seen = canonical_order(grid, board)
    side = goes_on(gray, ordered)
    if side is not None:
        return not_found(
            board,
            f"The board goes on {side} beyond {board.columns}x{board.rows} inner corners; count its inner "
            "corners again.",
        )
    return Corners(True, frozen(ordered), as_seen, None, _sharpness(gray, ordered), name)


def spacing_px(grid: Floats) -> float:
    """Smallest distance between neighbours of a grid (rows, columns, 2)."""
    right = np.linalg.norm(np.diff(grid, axis=1), axis=2).min()
    down = np.linalg.norm(np.diff(grid, axis=0), axis=2).min()
    return float(min(right, down))


def refine_subpixel(gray: Gray, grid: Floats, stop: tuple[int, int, float] = _STOP) -> Floats:
    """OpenCV's cornerSubPix, its window kept inside the squares: a wider one falls onto the neighbours."""
    most = 5 if min(gray.shape) <= 600 else 11
    half = int(np.clip(0.4 * spacing_px(grid), 1, most))
    start = grid.reshape(-1, 1, 2).astype(np.float32)
    moved: Any = cv2.cornerSubPix(gray, start.copy(), (half, half), (-1, -1), stop)
    out = np.asarray(moved, dtype=np.float64).reshape(grid.shape)
    lost = np.linalg.norm(out - grid, axis=2) > max(2.0, 0.3 * spacing_px(grid))
    return np.where(lost[..., None], grid, out)


def flaw(gray: Gray, grid: Floats) -> str | None:
    """Why a detection is not believed, or None: it must be a smooth grid of alternating squares in the
    picture.
    """
    if _cut(gray, grid):
        return "The board is cut by the border of the picture; show the whole board."
    if spacing_px(grid) < 3.0:
        return "The squares are smaller than 3 px; bring the board closer or use larger squares."
    for axis in (0, 1):
        step = np.diff(grid, axis=axis)
        bend = np.linalg.norm(np.diff(step, axis=axis), axis=2)
        length = np.linalg.norm(step, axis=2)
        shorter = np.minimum(np.take(length, range(length.shape[axis] - 1), axis), np.delete(length, 0, axis))
        if (bend > 0.5 * shorter + 1.0).any():
            return "The corners found do not form an even grid; something covers the board or it is not flat."
    return None if _alternates(gray, grid) else "What was found is not a pattern of alternating squares."


def _cut(gray: Gray, grid: Floats) -> bool:
    """Whether the outer squares leave the picture: a quarter of each must show outside the inner corners."""
    first, last = 1.25 * grid[:, :1] - 0.25 * grid[:, 1:2], 1.25 * grid[:, -1:] - 0.25 * grid[:, -2:-1]
    wide = np.concatenate([first, grid, last], axis=1)
    top, bottom = 1.25 * wide[:1] - 0.25 * wide[1:2], 1.25 * wide[-1:] - 0.25 * wide[-2:-1]
    full = np.concatenate([top, wide, bottom], axis=0)
    x, y = full[..., 0], full[..., 1]
    height, width = gray.shape
    return bool(min(x.min(), y.min()) < 0 or x.max() > width - 1 or y.max() > height - 1)


def _alternates(gray: Gray, grid: Floats) -> bool:
    """Whether neighbouring squares differ in brightness, with the sign that a checkerboard has."""
    centre = 0.25 * (grid[:-1, :-1] + grid[1:, :-1] + grid[:-1, 1:] + grid[1:, 1:])
    smooth: Any = cv2.blur(gray, (3, 3)) if spacing_px(grid) >= 8 else gray
    column, row = np.rint(centre[..., 0]).astype(int), np.rint(centre[..., 1]).astype(int)
    value = smooth[row, column].astype(np.float64)
    parity = np.indices(value.shape).sum(axis=0) % 2
    signed = value * (1.0 - 2.0 * parity)
    steps = np.concatenate([(signed[:, 1:] + signed[:, :-1]).ravel(), (signed[1:] + signed[:-1]).ravel()])
    agreement = float((steps > 0).mean())
    return max(agreement, 1.0 - agreement) >= 0.9


def _sharpness(gray: Gray, grid: Floats) -> float:
    size = (grid.shape[1], grid.shape[0])
    points: Any = grid.reshape(-1, 1, 2).astype(np.float32)
    try:
        measured: Any = cv2.estimateChessboardSharpness(gray, size, points)[0]
        return float(measured[0])
    except cv2.error:  # it refuses boards of few squares; sharpness is then unknown
        return 0.0
