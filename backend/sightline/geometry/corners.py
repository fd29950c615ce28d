"""Finding the checkerboard: bounded in time, with fallbacks, always in the order as seen."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.arrays import freeze_array
from sightline.geometry.board import Board, canonical_order, numbered_as_seen, require_board
from sightline.geometry.charuco import Charuco, find_charuco
from sightline.geometry.extent import goes_on
from sightline.geometry.saddle import Saddles, refine_saddles, refine_saddles_at
from sightline.messages.said import Said

Gray = NDArray[np.uint8]

_CLASSIC = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE
_FAST = _CLASSIC | cv2.CALIB_CB_FAST_CHECK
_SB = cv2.CALIB_CB_NORMALIZE_IMAGE
_CLASSIC_PIXELS = 0.5e6
_STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)
_SECTOR_PIXELS = 1.5e6
_SOFT_PX = 2.5  # blur up to which the saddle's disc holds a corner
_LEAST_ROOM_PX = 12.0
_LEAST_FITTED = 0.5
_MOST_MENDED = 0.2  # of the corners
_NEIGHBOURS = 15
_ASTRAY_SHARE = 0.08  # of a square
_DOUBT = 10.0  # times how far the neighbours themselves miss the quadratic
# seconds per megapixel searched that an attempt may take where there is no board (measured, doubled)
_CLASSIC_COST, _FULL_COST, _SECTOR_COST = 0.1, 1.2, 0.25


@dataclass(frozen=True)
class _Attempt:
    """A search of the picture enlarged by `scale`, and what it may cost, seconds."""

    name: str
    scale: float
    search: Callable[[Gray], Floats | None]
    cost_s: float


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
    reason: Said | None
    sharpness: float
    detector: str
    ids: NDArray[np.intp] | None = None

    @property
    def which(self) -> NDArray[np.intp]:
        """Places (N,) of the corners seen in the board's points, row by row."""
        return np.arange(self.board_as_seen.corners) if self.ids is None else self.ids


def not_found(board: Board, reason: Said) -> Corners:
    """A detection that did not succeed, and why."""
    return Corners(
        found=False,
        points_px=freeze_array(np.empty((0, 0, 2))),
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


def _scaled(gray: Gray, scale: float, search: Callable[[Gray], Floats | None], board: Board) -> Floats | None:
    """What a search finds in a copy; found in a smaller one, the corners are first refined there, for the
    window in the picture itself may be too small to bring them home.
    """
    how = cv2.INTER_CUBIC if scale > 1.0 else cv2.INTER_AREA
    size: Any = (round(gray.shape[1] * scale), round(gray.shape[0] * scale))
    by = np.array(size) / (gray.shape[1], gray.shape[0])
    resized: Any = cv2.resize(gray, size, interpolation=how)
    points = search(resized)
    if points is not None and scale < 1.0:
        points = refine_subpixel(resized, points.reshape(board.rows, board.columns, 2)).reshape(-1, 2)
    return None if points is None else np.asarray((points + 0.5) / by - 0.5, dtype=np.float64)


def _attempts(board: Board, pixels: int) -> Sequence[_Attempt]:
    """Searches in their order, from small copies to large ones. The classic one takes milliseconds where the
    board is, but up to twenty seconds for a large picture without one, and cannot be stopped: large pictures
    it only sees reduced. A board is found as well in a copy in which its squares still have 10 px or so.
    """

    def attempt(name: str, scale: float, how: str) -> _Attempt:
        searches = {
            "fast": (lambda gray: _classic(gray, board, _FAST), _CLASSIC_COST),
            "full": (lambda gray: _classic(gray, board, _CLASSIC), _FULL_COST),
            "sector": (lambda gray: _sector(gray, board), _SECTOR_COST),
        }
        search, cost = searches[how]
        return _Attempt(name, scale, search, cost * scale**2 * pixels / 1e6)

    small, middle = (float(np.sqrt(most / pixels)) for most in (_CLASSIC_PIXELS, _SECTOR_PIXELS))
    if small >= 0.9:
        return (
            attempt("classic", 1.0, "fast"),
            attempt("sector", 1.0, "sector"),
            attempt("classic, full", 1.0, "full"),
            attempt("classic, enlarged", 2.0, "fast"),
            attempt("sector, enlarged", 2.0, "sector"),
        )
    reduced = [attempt("classic, reduced", small, "fast")]
    if middle < 0.9:
        reduced += [attempt("sector, reduced", scale, "sector") for scale in (small, middle)]
    return (
        *reduced,
        attempt("sector", 1.0, "sector"),
        attempt("classic, reduced and full", small, "full"),
        attempt("sector, enlarged", 2.0, "sector"),
    )


def find_board(gray: Gray, board: Board, time_limit_s: float = 2.0) -> Corners:
    """Find a checkerboard in a grey picture.

    The classic detector with its quick rejection first, the sector-based one next (Duda and Frese 2018),
    then the classic one in full and the enlarged picture; a large picture is searched from small copies on,
    the corners are fitted in the picture itself.

    Parameters
    ----------
    gray : (H, W) array of uint8
        The picture.
    board : Board
        Its inner corners.
    time_limit_s : float
        No attempt starts that could outlast it.

    Returns
    -------
    Corners
        `points_px` (rows, columns, 2); a picture without the board is a result with its reason.

    Raises
    ------
    BadInput
        For an impossible board.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> gray = np.full((240, 320), 255, np.uint8)
    >>> for row, column in np.argwhere(np.indices((5, 7)).sum(axis=0) % 2):
    ...     gray[20 + 40 * row : 60 + 40 * row, 20 + 40 * column : 60 + 40 * column] = 0
    >>> found = sightline.find_board(gray, sightline.Board(columns=6, rows=4, square_m=0.1))
    >>> found.points_px.shape, [round(float(px), 1) for px in found.points_px[0, 0]]
    ((4, 6, 2), [59.5, 59.5])
    """
    require_board(board)
    if gray.ndim != 2 or min(gray.shape) < 32:
        return not_found(board, Said("board-picture-too-small"))
    if board.charuco is not None:
        return _numbered(gray, board, board.charuco)
    started = perf_counter()
    doubt: Said | None = None
    skipped = False
    for index, attempt in enumerate(_attempts(board, gray.size)):
        if index and perf_counter() - started + attempt.cost_s > time_limit_s:
            skipped = True
            continue
        search, scale = attempt.search, attempt.scale
        points = search(gray) if scale == 1.0 else _scaled(gray, scale, search, board)
        if points is not None:
            corners = _accepted(gray, points, board, attempt.name)
            if corners.found:
                return corners
            doubt = doubt or corners.reason
    return not_found(board, doubt or _advice(board, skipped))


def _numbered(gray: Gray, board: Board, charuco: Charuco) -> Corners:
    """The corners seen of a board with markers: all of them as a grid, or a part with their ids."""
    detected = find_charuco(gray, charuco, board.columns, board.rows, board.square_m)
    if detected is None:
        return not_found(
            board,
            Said(
                "board-none-with-markers",
                columns=board.columns,
                rows=board.rows,
                dictionary=charuco.dictionary,
            ),
        )
    ids, rough, as_seen = numbered_as_seen(*detected, board)
    if spacing_px(rough) < 3.0:
        return not_found(board, Said("board-markers-tiny"))
    right, down = neighbours(ids, rough, as_seen)
    points = refine_saddles_at(gray, rough, right, down, board.clear_share).points_px
    whole = len(ids) == board.corners
    grid = points.reshape(as_seen.rows, as_seen.columns, 2) if whole else points
    return Corners(
        found=True,
        points_px=freeze_array(grid),
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


def _advice(board: Board, skipped: bool) -> Said:
    if skipped:
        return Said("board-none-in-time", columns=board.columns, rows=board.rows)
    return Said("board-none", columns=board.columns, rows=board.rows)


def _accepted(gray: Gray, points: Floats, board: Board, name: str) -> Corners:
    """Refine, check and order what a detector returned."""
    grid = points.reshape(board.rows, board.columns, 2)
    grid = refine_subpixel(gray, grid)
    reason = flaw(gray, grid)
    if reason is not None:
        return not_found(board, reason)
    grid = _mended(gray, grid, refine_by_blur(gray, grid))
    ordered, as_seen = canonical_order(grid, board)
    side = goes_on(gray, ordered)
    if side is not None:
        return not_found(board, Said("board-goes-on", side=side, columns=board.columns, rows=board.rows))
    return Corners(
        found=True,
        points_px=freeze_array(ordered),
        board_as_seen=as_seen,
        reason=None,
        sharpness=_sharpness(gray, ordered),
        detector=name,
    )


def _mended(gray: Gray, grid: Floats, fitted: Saddles) -> Floats:
    """The fitted grid. A corner whose fit failed may have had a start that lies beside it, which
    cornerSubPix does not bring home: it is fitted again from where its neighbours say that it is, and put
    there if it was far from it.
    """
    points = fitted.points_px.reshape(grid.shape)
    bad = ~fitted.ok.reshape(grid.shape[:2])
    if not bad.any() or bad.mean() > _MOST_MENDED:
        return points
    at = np.argwhere(~bad)
    start = points.copy()
    doubt = np.full(bad.shape, _ASTRAY_SHARE * spacing_px(grid))
    for place in np.argwhere(bad):
        near = at[np.argsort(np.square(at - place).sum(axis=1), kind="stable")[:_NEIGHBOURS]]
        terms, seen = _quadratic(near - place), points[near[:, 0], near[:, 1]]
        bent = np.linalg.lstsq(terms, seen, rcond=None)[0]
        start[tuple(place)] = bent[0]
        misfit = float(np.sqrt(np.square(terms @ bent - seen).sum(axis=1).mean()))
        doubt[tuple(place)] = max(doubt[tuple(place)], _DOUBT * misfit)
    again = refine_by_blur(gray, start)
    better = bad & again.ok.reshape(bad.shape)
    astray = bad & (np.linalg.norm(start - points, axis=2) > doubt)
    return np.where((better | astray)[..., None], again.points_px.reshape(grid.shape), points)


def _quadratic(at: NDArray[np.intp]) -> Floats:
    """Terms (N, 6) of a quadratic in row and column, the constant first."""
    i, j = at.T.astype(np.float64)
    return np.stack([np.ones_like(i), i, j, i * i, i * j, j * j], axis=1)


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


def refine_by_blur(gray: Gray, grid: Floats) -> Saddles:
    """The corners of `grid` (rows, columns, 2), found to within a pixel or two, fitted in `gray` (H, W),
    which may be soft: in a copy reduced so far that the fit's disc holds the whole of the blur.

    Means of f x f pixels lose nothing of an edge that is blurred over more than f of them, and the disc of
    9 px becomes one of 9 f. Own method: refine_saddles with f = 1, 2, 4, 8 until the blur is at most
    _SOFT_PX of the copy's pixels; squares that would become too small keep what there is. `blur_px` is in
    pixels of `gray`.
    """
    best = refine_saddles(gray, grid)
    for f in (2, 4, 8):
        if _is_clear(best, f // 2) or spacing_px(grid) < _LEAST_ROOM_PX * f:
            break
        rows, columns = (size // f for size in gray.shape)
        small: Any = cv2.resize(
            gray[: rows * f, : columns * f], (columns, rows), interpolation=cv2.INTER_AREA
        )
        fitted = refine_saddles(small, refine_subpixel(small, (grid + 0.5) / f - 0.5))
        points = np.where(fitted.ok[:, None], (fitted.points_px + 0.5) * f - 0.5, best.points_px)
        blur = np.where(fitted.ok, fitted.blur_px * f, best.blur_px)
        if fitted.ok.mean() >= min(best.ok.mean(), _LEAST_FITTED):
            best = Saddles(points, blur, fitted.ok | best.ok)
    return best


def _is_clear(fitted: Saddles, f: int) -> bool:
    """Whether the discs at a reduction by `f` held the blur."""
    if fitted.ok.mean() < _LEAST_FITTED:
        return False
    return bool(np.median(fitted.blur_px[fitted.ok]) <= _SOFT_PX * f)


def flaw(gray: Gray, grid: Floats) -> Said | None:
    """Why a detection is not believed, or None: its `grid` (rows, columns, 2), pixels, must be a smooth one
    of alternating squares in the picture, `gray` (H, W).

    Own method: neighbouring steps differ by less than half of the shorter, and nine in ten neighbouring
    squares in brightness as a checkerboard's do.
    """
    if _cut(gray, grid):
        return Said("board-cut-off")
    if spacing_px(grid) < 3.0:
        return Said("board-squares-tiny")
    for axis in (0, 1):
        step = np.diff(grid, axis=axis)
        bend = np.linalg.norm(np.diff(step, axis=axis), axis=2)
        length = np.linalg.norm(step, axis=2)
        shorter = np.minimum(np.take(length, range(length.shape[axis] - 1), axis), np.delete(length, 0, axis))
        if (bend > 0.5 * shorter + 1.0).any():
            return Said("board-corners-uneven")
    return None if _alternates(gray, grid) else Said("board-no-checkerboard")


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
