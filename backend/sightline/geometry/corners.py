"""Finding the checkerboard: bounded in time, with fallbacks, always in the order as seen."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.geometry.arrays import Floats, frozen
from sightline.geometry.board import Board, canonical_order, numbered_as_seen, require_board
from sightline.geometry.charuco import Charuco, find_charuco
from sightline.geometry.extent import goes_on
from sightline.geometry.saddle import refine_saddles, refine_saddles_at

Gray = NDArray[np.uint8]

_CLASSIC = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE
_FAST = _CLASSIC | cv2.CALIB_CB_FAST_CHECK
_SB = cv2.CALIB_CB_NORMALIZE_IMAGE
_CLASSIC_PIXELS = 0.5e6
_STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)
# seconds per megapixel that an attempt may take where there is no board (measured, doubled)
_COST = {
    "classic": 0.1,
    "sector": 0.25,
    "classic, full": 1.2,
    "classic, enlarged": 0.5,
    "classic, reduced and full": 0.5,
    "sector, enlarged": 1.2,
}


@dataclass(frozen=True, eq=False)
class Corners:
    """A detection. `points_px` (rows, columns, 2) of `board_as_seen`: [0, 0] top left as seen, columns to the
    right, rows down; empty with a `reason` where nothing was found. `sharpness`: width in pixels of the edges
    from 10 to 90 per cent (smaller is sharper), 0 where unknown. `ids` is None where every corner was seen;
    else points_px is (N, 2) and `ids` (N,) says which they are, counted row by row in `board_as_seen`.
    """

    found: bool
    points_px: Floats
    board_as_seen: Board
    reason: str | None
    sharpness: float
    detector: str
    ids: NDArray[np.intp] | None = None

    @property
    def which(self) -> NDArray[np.intp]:
        """Places (N,) of the corners seen in the board's points, row by row."""
        return np.arange(self.board_as_seen.corners) if self.ids is None else self.ids


def not_found(board: Board, reason: str) -> Corners:
    """A detection that did not succeed, and why."""
    return Corners(
        found=False,
        points_px=frozen(np.empty((0, 0, 2))),
        board_as_seen=board,
        reason=reason,
        sharpness=0.0,
        detector="",
    )


def _classic(gray: Gray, board: Board, flags: int) -> Floats | None:
    found, points = cv2.findChessboardCorners(gray, (board.columns, board.rows), flags=flags)
    return np.asarray(points, dtype=np.float64).reshape(-1, 2) if found else None


def _sector(gray: Gray, board: Board) -> Floats | None:
    found, points = cv2.findChessboardCornersSB(gray, (board.columns, board.rows), flags=_SB)
    return np.asarray(points, dtype=np.float64).reshape(-1, 2) if found else None


def _scaled(gray: Gray, scale: float, search: Callable[[Gray], Floats | None]) -> Floats | None:
    how = cv2.INTER_CUBIC if scale > 1.0 else cv2.INTER_AREA
    size: Any = (round(gray.shape[1] * scale), round(gray.shape[0] * scale))
    by = np.array(size) / (gray.shape[1], gray.shape[0])
    resized: Any = cv2.resize(gray, size, interpolation=how)
    points = search(resized)
    return None if points is None else np.asarray((points + 0.5) / by - 0.5, dtype=np.float64)


def _attempts(board: Board, pixels: int) -> Sequence[tuple[str, Callable[[Gray], Floats | None]]]:
    """Searches in their order. The classic one takes milliseconds where the board is, but up to twenty
    seconds for a large picture without one, and cannot be stopped: large pictures it only sees reduced.
    """
    small = float(np.sqrt(_CLASSIC_PIXELS / pixels))
    sector = ("sector", lambda gray: _sector(gray, board))
    enlarged = ("sector, enlarged", lambda gray: _scaled(gray, 2.0, lambda big: _sector(big, board)))
    if small < 0.9:
        return (
            (
                "classic, reduced",
                lambda gray: _scaled(gray, small, lambda less: _classic(less, board, _FAST)),
            ),
            sector,
            (
                "classic, reduced and full",
                lambda gray: _scaled(gray, small, lambda less: _classic(less, board, _CLASSIC)),
            ),
            enlarged,
        )
    return (
        ("classic", lambda gray: _classic(gray, board, _FAST)),
        sector,
        ("classic, full", lambda gray: _classic(gray, board, _CLASSIC)),
        ("classic, enlarged", lambda gray: _scaled(gray, 2.0, lambda big: _classic(big, board, _FAST))),
        enlarged,
    )


def detect(gray: Gray, board: Board, time_limit_s: float = 2.0) -> Corners:
    """Find `board` in a grey picture, `gray` (H, W) uint8.

    The classic detector with its quick rejection first, the sector-based one next (Duda and Frese 2018), then
    the classic one in full (small pictures only) and both on the enlarged picture. No attempt starts that
    could outlast `time_limit_s`. Raises BadInput for an impossible board; a picture without the board is a
    result with its reason.
    """
    require_board(board)
    if gray.ndim != 2 or min(gray.shape) < 32:
        return not_found(board, "The picture is too small to hold a board.")
    if board.charuco is not None:
        return _numbered(gray, board, board.charuco)
    started = perf_counter()
    megapixels = gray.size / 1e6
    doubt: str | None = None
    skipped = False
    for index, (name, search) in enumerate(_attempts(board, gray.size)):
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


def _numbered(gray: Gray, board: Board, charuco: Charuco) -> Corners:
    """The corners seen of a board with markers: all of them as a grid, or a part with their ids."""
    found = find_charuco(gray, charuco, board.columns, board.rows, board.square_m)
    if found is None:
        return not_found(
            board,
            f"No ChArUco board of {board.columns}x{board.rows} inner corners with {charuco.dictionary} "
            "markers was found, or too little of it; it must be sharp and of that dictionary.",
        )
    ids, rough, as_seen = numbered_as_seen(*found, board)
    if spacing_px(rough) < 3.0:
        return not_found(board, "The squares are smaller than 3 px; bring the board closer.")
    right, down = neighbours(ids, rough, as_seen)
    points = refine_saddles_at(gray, rough, right, down, board.clear_share).points_px
    whole = len(ids) == board.corners
    grid = points.reshape(as_seen.rows, as_seen.columns, 2) if whole else points
    return Corners(
        found=True,
        points_px=frozen(grid),
        board_as_seen=as_seen,
        reason=None,
        sharpness=0.0,
        detector="charuco",
        ids=None if whole else ids,
    )


def neighbours(ids: NDArray[np.intp], points: Floats, board: Board) -> tuple[Floats, Floats]:
    """Vectors (N, 2) from corners of a board, `points` (N, 2), pixels, to where their neighbours right and
    below are, each (N, 2); `ids` (N,): the corners' places, row by row.

    By the homography of the board's plane (Hartley and Zisserman 2004, ch. 4), half a square to either side.
    """
    at = np.column_stack([ids % board.columns, ids // board.columns]).astype(np.float64)
    to_px: Any = cv2.findHomography(at, points)[0]

    def moved(by: tuple[float, float]) -> Floats:
        shifted = np.column_stack([at + by, np.ones(len(at))]) @ to_px.T
        return np.asarray(shifted[:, :2] / shifted[:, 2:], dtype=np.float64)

    right, down = (moved(step) - moved((-step[0], -step[1])) for step in ((0.5, 0.0), (0.0, 0.5)))
    return right, down


def _advice(board: Board, skipped: bool) -> str:
    text = (
        f"No board of {board.columns}x{board.rows} inner corners was found; the whole board with its white "
        "margin must be in the picture, sharp and evenly lit, and inner corners are counted"
    )
    return text + ("; the search was cut short by its time limit." if skipped else ".")


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
    return Corners(
        found=True,
        points_px=frozen(ordered),
        board_as_seen=as_seen,
        reason=None,
        sharpness=_sharpness(gray, ordered),
        detector=name,
    )


def spacing_px(grid: Floats) -> float:
    """Smallest distance between neighbours of `grid` (rows, columns, 2), or of some of its corners (N, 2)."""
    if grid.ndim == 2:
        apart = np.linalg.norm(grid[:, None] - grid[None], axis=2)
        return float(apart[~np.eye(len(grid), dtype=bool)].min())
    right, down = grid[:, 1:] - grid[:, :-1], grid[1:] - grid[:-1]
    least = min((step * step).sum(axis=2).min() for step in (right, down))
    return float(np.sqrt(least))


def refine_subpixel(
    gray: Gray, grid: Floats, stop: tuple[int, int, float] = _STOP, share: float = 0.4
) -> Floats:
    """The `grid` (rows, columns, 2) or (N, 2) moved onto the corners of `gray` (H, W), of the same shape,
    pixels.

    OpenCV's cornerSubPix (Foerstner 1987), its window kept inside the squares (`share` of one): a wider one
    falls onto the neighbours. A corner that moves far from its start keeps its start.
    """
    spacing = spacing_px(grid)
    half = int(np.clip(share * spacing, 1, 5 if min(gray.shape) <= 600 else 11))
    start = grid.reshape(-1, 1, 2).astype(np.float32)
    moved: Any = cv2.cornerSubPix(gray, start, (half, half), (-1, -1), stop)
    out = np.asarray(moved, dtype=np.float64).reshape(grid.shape)
    shift = out - grid
    lost = (shift * shift).sum(axis=-1) > max(2.0, 0.3 * spacing) ** 2
    return np.where(lost[..., None], grid, out) if lost.any() else out


def flaw(gray: Gray, grid: Floats) -> str | None:
    """Why a detection is not believed, or None: its `grid` (rows, columns, 2), pixels, must be a smooth one
    of alternating squares in the picture, `gray` (H, W).

    Own method: neighbouring steps differ by less than half of the shorter, and nine in ten neighbouring
    squares in brightness as a checkerboard's do.
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
