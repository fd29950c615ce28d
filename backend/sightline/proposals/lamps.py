"""The lower edge of the rear lamp, at the rear end of the side view."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.geometry.arrays import Floats
from sightline.proposals.roof import Place
from sightline.proposals.side_view import Plane, SideView

TAIL_Z_M = (0.5, 1.35)
END_M = 0.75  # from the body's end inwards
LEAST_RED = 28.0
SIZES_M = (0.04, 0.8)


def taillight_of(view: SideView, body: NDArray[np.bool_], end_m: float, ahead: int) -> Place | str:
    """The lower edge of the rear lamp at the end of the body at X = `end_m`; `ahead` is 1 where the vehicle
    goes to larger X; or why none is seen. `body` (h, w).

    Own method: the red piece nearest to the end, lit or not; where redness rises most below it, column by
    column.
    """
    patch, left, bottom = _window(view, view.red, end_m, ahead, TAIL_Z_M)
    inside = _window(view, body.astype(np.float32), end_m, ahead, TAIL_Z_M)[0] > 0.5
    if patch.size == 0 or inside.sum() < 30:
        return "proposals-rear-not-in-picture"
    usual = float(np.median(patch[inside]))
    most = float(np.percentile(patch[inside], 99.0))
    if most - usual < LEAST_RED:
        return "proposals-no-red"
    piece = _piece((patch > usual + 0.5 * (most - usual)) & inside, view.cell_m)
    if piece is None:
        return "proposals-red-not-a-lamp"
    return _lower_edge(view, patch, piece, left, bottom)


def _window(
    view: SideView, values: Plane, end_m: float, ahead: int, z_m: tuple[float, float]
) -> tuple[Plane, int, int]:
    """The part of a picture at one end of the body, its first column and row."""
    ends = sorted((end_m - 0.12 * ahead, end_m + END_M * ahead))
    left, right = view.column(ends[0]), view.column(ends[1])
    low, high = view.row(z_m[0]), view.row(z_m[1])
    return values[low : high + 1, left : right + 1], left, low


def _piece(where: NDArray[np.bool_], cell_m: float) -> NDArray[np.bool_] | None:
    """The largest piece with the size of a lamp."""
    count, labels, stats, _ = cv2.connectedComponentsWithStats(np.where(where, np.uint8(255), np.uint8(0)))
    best, most = None, 0
    for i in range(1, count):
        wide, high, area = (int(stats[i, k]) for k in (2, 3, 4))
        fits = all(SIZES_M[0] <= side * cell_m <= SIZES_M[1] for side in (wide, high))
        if fits and area > most:
            best, most = i, area
    return None if best is None else np.asarray(labels == best, dtype=np.bool_)


def _lower_edge(view: SideView, red: Plane, piece: NDArray[np.bool_], left: int, bottom: int) -> Place | str:
    columns = np.flatnonzero(piece.sum(axis=0) >= 2)
    if len(columns) < 3:
        return "proposals-lamp-small"
    columns = columns[len(columns) // 5 : len(columns) - len(columns) // 5]
    slope = np.gradient(red.astype(np.float64), axis=0)
    rows: list[float] = []
    for column in columns:
        first = int(np.argmax(piece[:, column]))
        rows += _steepest(slope[:, column], first)
    if len(rows) < 3:
        return "proposals-lamp-edge"
    found: Floats = np.array(rows)
    middle = float(np.median(found))
    scatter = 1.4826 * float(np.median(np.abs(found - middle)))
    return Place(view.x_m(left + float(columns.mean())), view.z_m(bottom + middle), scatter)


def _steepest(slope: Floats, first: int) -> list[float]:
    """Where the slope about row `first` is steepest, in fractions of a row; empty at the window's border."""
    low, high = max(1, first - 4), min(len(slope) - 2, first + 3)
    if high <= low:
        return []
    peak = low + int(np.argmax(slope[low : high + 1]))
    if peak in (low, high):
        return []
    before, on, after = slope[peak - 1 : peak + 2]
    return [peak + 0.5 * float(before - after) / min(float(before - 2 * on + after), -1e-9)]
