"""The highest point of the roof's near edge: the top of what stands before the road, in the side view."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from sightline.geometry.arrays import Floats
from sightline.proposals.side_view import SideView

STANDS = 0.6  # share of the frames in which something stands before the road where the vehicle is
CLOSED_M = 0.12
SMOOTH_M = 0.3
NARROWEST_M = 0.5
CROWN_M = 0.12  # of the outline, what lies so near its upper part belongs to the roof
HALF_M = 0.6  # of the roof, so much to either side is followed
SEARCH_M = 0.16
FREE_M = 0.5  # what ends so near to the picture's border may go on beyond it
TILTS = np.linspace(-0.09, 0.09, 7)
BENDS = (0.0, -0.03, -0.07, -0.12, -0.18, -0.25)  # 1 / m
PARTING = 2.0  # weight of where the body ends beside that of a step in luminance
APART = 4  # cells above and below the edge
BESIDE = 3  # cells
LEAST_STEP = 1.2  # grey levels a cell: less is no edge
LEAST_SHARE = 0.55
SCATTER_CELLS = 1.2
ROUNDS = 3
MOST_CUT_OFF = 0.08  # share of the columns
NOT_ONE_LINE = "proposals-roof-not-one-line"


@dataclass(frozen=True)
class Place:
    """A place in the side view, metres, and how far its edge scatters there, cells."""

    x_m: float
    z_m: float
    scatter: float


def body_of(view: SideView, x_m: tuple[float, float]) -> NDArray[np.bool_]:
    """What stands before the road (h, w), of it the piece that covers most of the strip between two X at half
    a metre to one metre up. Own method: components of the change against the road, small gaps closed.
    """
    standing = np.where((view.change > STANDS) & view.seen, np.uint8(255), np.uint8(0))
    standing = np.asarray(cv2.morphologyEx(standing, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)), np.uint8)
    size = max(3, round(CLOSED_M / view.cell_m))
    closed = cv2.morphologyEx(standing, cv2.MORPH_CLOSE, np.ones((size, size), np.uint8))
    _, labels = cv2.connectedComponents(np.asarray(closed, np.uint8))
    strip = labels[view.row(0.45) : view.row(1.0) + 1, view.column(x_m[0]) : view.column(x_m[1]) + 1]
    counts = np.bincount(strip.ravel(), minlength=2)
    counts[0] = 0
    best = int(np.argmax(counts))
    return np.asarray(labels == best, dtype=np.bool_) if counts[best] else np.zeros(labels.shape, np.bool_)


def roof_of(view: SideView, body: NDArray[np.bool_]) -> Place | str:
    """The highest point of a roof, or why it is not seen. `body` (h, w).

    Own method: of flat parabolas about the top of the body, that along which luminance steps most clearly
    and what stands before the road ends; then a parabola through the steepest steps beside it.
    """
    some = body.any(axis=0)
    if some.sum() * view.cell_m < NARROWEST_M:
        return "proposals-vehicle-not-distinct"
    height = body.shape[0]
    columns = np.flatnonzero(some)
    top = (height - 1 - np.argmax(body[::-1], axis=0))[columns]
    top = median_filter(top, max(3, round(SMOOTH_M / view.cell_m)))
    usual = float(np.percentile(top, 92))
    near = columns[np.abs(top - usual) < CROWN_M / view.cell_m]
    if len(near) * view.cell_m < NARROWEST_M:
        return NOT_ONE_LINE
    middle = int(np.median(near))
    half = min(HALF_M / view.cell_m, 0.5 * len(near))
    x = np.arange(max(0, round(middle - half)), min(body.shape[1], round(middle + half) + 1))
    above = int(min(height - 1, usual + FREE_M / view.cell_m))
    if not view.seen[above, x].mean() > 0.9:
        return "proposals-roof-not-in-picture"
    if _cut_off(view, body)[columns].mean() > MOST_CUT_OFF:
        return "proposals-roof-not-in-picture"
    slope = np.abs(np.gradient(view.light.astype(np.float64), axis=0))
    return _edge(view, slope, x, _curve(view, slope, x, usual))


def _cut_off(view: SideView, body: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Columns (w,) in which the body reaches out of the picture above."""
    unseen = np.zeros(body.shape, np.bool_)
    unseen[:-APART] = ~view.seen[APART:]
    unseen[: view.row(1.0)] = False
    return np.asarray((body & unseen).any(axis=0))


def _curve(view: SideView, slope: Floats, x: NDArray[np.intp], usual: float) -> Floats:
    """Rows (n,) of the parabola over columns x along which luminance steps and the body ends."""
    u, reach = (x - x.mean()) * view.cell_m, SEARCH_M / view.cell_m
    shapes = np.array([b * u + c * u * u for b in TILTS for c in BENDS]) / view.cell_m
    heights = np.arange(usual - reach, usual + reach, 0.5)
    rows = np.clip(heights[:, None, None] + shapes, 0, slope.shape[0] - 1.001)
    low = rows.astype(np.intp)
    part = rows - low
    at = slope[low, x] * (1 - part) + slope[low + 1, x] * part
    unit = max(LEAST_STEP, float(np.percentile(at, 97)))
    clear = np.tanh(at / unit).mean(axis=2)
    parting = _share(view, rows, x, -APART) - _share(view, rows, x, APART)
    best = np.unravel_index(int(np.argmax(clear + PARTING * parting)), clear.shape)
    return np.asarray(rows[best])


def _share(view: SideView, rows: Floats, x: NDArray[np.intp], away: int) -> Floats:
    """How much stands before the road some cells beside curves (..., n): (...,)."""
    at = np.clip(np.round(rows).astype(np.intp) + away, 0, view.change.shape[0] - 1)
    return np.asarray(view.change[at, x].mean(axis=2), dtype=np.float64)


def _edge(view: SideView, slope: Floats, x: NDArray[np.intp], curve: Floats) -> Place | str:
    """The top of a parabola through the steepest steps within BESIDE cells of the curve."""
    steps = np.arange(-BESIDE, BESIDE + 1)
    rows = np.clip(np.round(curve)[:, None].astype(np.intp) + steps, 1, slope.shape[0] - 2)
    at = slope[rows, x[:, None]]
    peak = np.argmax(at, axis=1)
    keep = (peak > 0) & (peak < len(steps) - 1) & (at.max(axis=1) > LEAST_STEP)
    if keep.mean() < LEAST_SHARE:
        return "proposals-roof-not-distinct"
    index = np.flatnonzero(keep)
    peak = peak[index]
    before, on, after = at[index, peak - 1], at[index, peak], at[index, peak + 1]
    shift = 0.5 * (before - after) / np.minimum(before - 2 * on + after, -1e-9)
    z = rows[index, peak] + np.clip(shift, -1, 1)
    u = x[index] - x.mean()
    good = np.ones(len(u), np.bool_)
    for _ in range(ROUNDS):
        fit = np.polyfit(u[good], z[good], 2)
        rest = z - np.polyval(fit, u)
        scatter = 1.4826 * float(np.median(np.abs(rest[good])))
        good = np.abs(rest) < 3 * max(scatter, 0.3)
    if good.mean() < LEAST_SHARE or scatter > SCATTER_CELLS:
        return NOT_ONE_LINE
    apex = _apex(fit, u[good])
    return Place(view.x_m(x.mean() + apex), view.z_m(float(np.polyval(fit, apex))), scatter)


def _apex(fit: Floats, x: Floats) -> float:
    """Where the parabola is highest, among the columns that it was fitted to."""
    low, high = float(x.min()), float(x.max())
    if fit[0] < 0:
        return float(np.clip(-fit[1] / (2 * fit[0]), low, high))
    return low if np.polyval(fit, low) > np.polyval(fit, high) else high
