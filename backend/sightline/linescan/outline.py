"""The foremost point of a vehicle's outline from what its bands of rows show.

It is the vertex of a parabola through the edges of neighbouring bands, each with the weight of its own doubt:
bumpers are round, and may have the road's own grey in some bands. Where a parabola fits no better than an
upright line the end is flat, and the line goes through as many bands as agree with it: the lowest of noisy
values, which a vertex seeks, lies too far out. An outline falls back from its foremost point upwards and
downwards, so bands that lie behind others on either side are no part of it: they are gaps, or show an edge
within a vehicle whose grey is the road's there. Which of both is told by what little differs before them.
"""

from dataclasses import dataclass
from math import hypot, inf, log, sqrt

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.robust import robust_scale

# along the vehicle, metres: searched before the rough edge
BEFORE_M = 0.10
# bands on either side of the foremost one through which the parabola goes: some 14 cm of a bumper; and those
# through which an upright line goes as long as it stays within so many of its standard uncertainties
REACH = 3
FLAT_REACHES, STAYS = (5, 8, 12, 18), 1.5
# Of the bands about the foremost point, one that shows no clear edge, or one that strays, may have been the
# foremost: by how much it hides grows as the square of their number, as a parabola falls back. Metres.
HIDDEN_M = 0.0003
# outlines of vehicles have no notches deeper than this, metres; before a notch there is something where it
# differs by so many standard deviations (root mean square over its bands)
NOTCH_M, THERE = 0.010, 2.5
# of the bands about the foremost one so many must be clear
CLEAR_SHARE = 0.4
# What differs from the road lies at most so far before its half-way edge, metres, by optics and noise.
TOLD_M = 0.011
# The next four were found from the errors of the ends of 480 simulated bodies (seeds 8801 and 8901).
# Greys that change behind an edge change alike in all bands: by so many times their mean a round end is off,
# and a flat one.
ROUND_GREY, FLAT_GREY = 1.0, 0.4
# A flat end of few bands that stray by more than their noise is hardly flat: what they stray more counts so
# many times. In a long one the bands' own scatter tells, beside a share of what is usual.
FEW_STRAY, USUAL_SHARE = 11.0, 0.2
# An outline that is flat about its foremost point and falls back faster beside it (x^4) lets a parabola
# through 2 REACH + 1 bands lie before it by 1.07 times what that falls back at one band, a true parabola by
# none: standard uncertainty, so many times, from the errors of the ends of 92 bodies (seed 9901).
ROUND_SHAPE = 0.25
CAUCHY, ROBUST_ROUNDS = 2.385, 6
# standard uncertainty of a doubtful boundary: the rms error of 50 such ones of 1008 simulated vehicles, most
# of them bumpers of the road's own grey at 8 DN and 30 m/s or more, which hide up to 110 mm
DOUBT_M = 0.025


@dataclass(frozen=True)
class Edge:
    """One boundary: its line, None where the bands show none; doubtful where few bands near it are clear.

    `u_lines`: standard uncertainty by the scatter of the bands about the outline, by what too few of them may
    hide, and by greys that change behind the edge, 0 where there is no line. `u_between_lines`: by
    interpolating between lines, which either camera does for itself.
    """

    line: float | None
    doubtful: bool = True
    u_lines: float = 0.0
    u_between_lines: float = 0.0


@dataclass(frozen=True, eq=False)
class Bands:
    """Of every band of rows (bands,): the line of its edge, u of that line by noise, lines by which it may be
    off because the vehicle's grey changes behind it, lines before it in which something else differs from the
    road, and whether it is clear.
    """

    edges: Floats
    u: Floats
    uneven: Floats
    ahead: Floats
    clear: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Seen:
    """Differences from the road (lines, bands), grey values; `sigma_dn`: noise of each; `least_dn`: what the
    road itself may be off by.
    """

    differs: Floats
    sigma_dn: float
    least_dn: float
    lines_per_m: float

    def told(self, band: int, start: float, end: float) -> float:
        """By how many standard deviations what lies between two lines differs from the road; of long
        stretches, the part next to `start`. Own method: their mean over its u.
        """
        end = min(end, start + BEFORE_M * self.lines_per_m)
        part = self.differs[max(round(start), 0) : max(round(end), 0), band]
        if len(part) < 2:
            return 0.0
        return float(part.mean()) / hypot(self.sigma_dn / sqrt(len(part)), self.least_dn)


def fit_foremost_edge(bands: Bands, view: Seen) -> Edge:
    """The smallest line of the outline through the edges around the foremost bands.

    Own method: an upright line or a weighted parabola through them, whichever is enough (Schwarz 1978).
    """
    edges, u, uneven, clear, lines_per_m = bands.edges, bands.u, bands.uneven, bands.clear, view.lines_per_m
    notches = _notches(bands, lines_per_m)
    used = np.flatnonzero(clear & ~notches)
    if len(used) < 3:
        return Edge(None)
    # a single band that is ahead of all others is noise, so the foremost three decide where to look
    smooth = _of_three(edges[used])
    middle = used[int(smooth[1:-1].argmin()) + 1]
    near = used[(np.abs(used - middle) <= REACH) & (edges[used] < smooth.min() + BEFORE_M * lines_per_m)]
    if len(near) < 3:
        return Edge(float(smooth.min()))
    away = np.abs(edges[near] - np.median(edges[near]))
    kept = near[away <= 3 * np.maximum(max(robust_scale(away), 0.7), u[near])]
    if len(kept) < 4:
        return Edge(float(np.median(edges[near])))
    doubtful = float(np.mean(clear[max(middle - 2 * REACH, 0) : middle + 2 * REACH + 1])) < CLEAR_SHARE
    end = _end_of(kept - middle, edges[kept], u[kept], uneven[kept])
    # a flat end hides less than a round one may
    bend = min(4 * HIDDEN_M * lines_per_m, end.bend)
    hidden = max(
        bend / 4 * (2 * REACH + 1 - len(kept)) ** 2,
        _may_hide(bands, view, notches, end.line, bend),
    )
    other = float(np.max(bands.ahead[kept[np.abs(kept - middle) <= 1]], initial=0.0)) / 2
    line, u_lines = end.line, hypot(end.u_lines, hidden, other)
    for reach in FLAT_REACHES if end.flat else ():
        near = used[np.abs(used - middle) <= reach]
        wider = _end_of(near - middle, edges[near], u[near], uneven[near])
        if not wider.flat or abs(wider.line - end.line) > STAYS * end.u_lines:
            break
        end, line, u_lines = wider, wider.line, hypot(wider.u_lines, other)
    return Edge(line, doubtful, u_lines)


def _of_three(values: Floats) -> Floats:
    """The median of each value and its two neighbours; at the ends the mean of both that are there."""
    before, here, after = values[:-2], values[1:-1], values[2:]
    inner = np.maximum(np.minimum(before, here), np.minimum(np.maximum(before, here), after))
    return np.concatenate([[values[:2].mean()], inner, [values[-2:].mean()]])


def _notches(bands: Bands, lines_per_m: float) -> NDArray[np.bool_]:
    """(bands,) whether each lies behind bands on either side of it, or is not clear between such."""
    sure = np.where(bands.clear, bands.edges + 2 * bands.u, np.inf)
    above = np.concatenate([[np.inf], np.minimum.accumulate(sure)[:-1]])
    below = np.concatenate([np.minimum.accumulate(sure[::-1])[::-1][1:], [np.inf]])
    beside = np.maximum(above, below)
    place = np.where(bands.clear, bands.edges, np.inf)
    return np.asarray(np.isfinite(beside) & (place > beside + NOTCH_M * lines_per_m))


def _may_hide(bands: Bands, view: Seen, notches: NDArray[np.bool_], line: float, bend: float) -> float:
    """Lines by which the outline may lie before its foremost `line` where it is not seen: in `notches`
    (bands,), over which it may bend by `bend` (lines per band squared).

    Notches are gaps, or show an edge within a vehicle of the road's own grey. Of such a grey little is left
    that differs, which is seen over all lines before that edge together: then the outline runs before them.
    """
    place = np.where(bands.clear, bands.edges, np.inf)
    most, first = 0.0, -1
    for band in np.flatnonzero(notches).tolist():
        first = band if first < 0 or not notches[band - 1] else first
        if notches[band + 1]:
            continue
        near, far = sorted((float(place[first - 1]), float(place[band + 1])))
        apart = band + 2 - first
        # the vertex of a parabola through both bands beside the notch, in bands from the foremost of them
        vertex = max(apart / 2 - (far - near) / (2 * max(bend, 1e-6) * apart), 0.0)
        start = max(line, near) + NOTCH_M / 2 * view.lines_per_m
        told = [
            view.told(one, start, place[one] - TOLD_M * view.lines_per_m) for one in range(first, band + 1)
        ]
        if np.mean(np.square(told)) > THERE**2:
            most = max(most, bend * vertex**2 - (near - line))
    return min(most, DOUBT_M * view.lines_per_m)


@dataclass(frozen=True)
class _End:
    """The foremost line of an outline, its u but for what is hidden, and whether the outline is flat.

    `bend`: by how many lines it falls back at one band from its foremost; of a flat one, at most (one u more
    than was found), of another, no more is known than of any.
    """

    line: float
    u_lines: float
    flat: bool
    bend: float


def _end_of(x: NDArray[np.intp], y: Floats, s: Floats, uneven: Floats) -> _End:
    """The foremost line of a parabola, or of an upright line if that is enough, through the edges `y` (n,) of
    bands `x` (n,), of standard deviations `s` (n,) by noise and `uneven` (n,) by greys.
    """
    place = x.astype(float)
    # a band whose grey changes says less
    s = np.hypot(s, uneven)
    c, normal, strays = _weighted_fit(place, y, s, 2)
    flat = _weighted_fit(place, y, s, 0)
    spread = max(1.0, robust_scale(_misses(place, y, s, c)) * sqrt(len(y) / max(len(y) - 3, 1)))
    costs = [
        CAUCHY**2 * float(np.log1p((_misses(place, y, s, one) / (CAUCHY * spread)) ** 2).sum())
        for one in (flat[0], c)
    ]
    # a parabola must gain what its two more coefficients cost (Schwarz 1978)
    is_flat = costs[0] < costs[1] + 2 * log(len(y))
    bend, at = inf, 0.0
    if is_flat:
        bend = max(float(c[2]), 0.0) + sqrt(max(1.0, strays) * float(np.linalg.pinv(normal)[2, 2]))
        c, normal, strays = flat
    elif c[2] > 1e-6:
        at = float(np.clip(-c[1] / (2 * c[2]), place.min(), place.max()))
    else:
        c, normal, strays = _weighted_fit(place, y, s, 1)
        at = float(place.min() if c[1] > 0 else place.max())
    gradient = at ** np.arange(len(c))
    wider = max(1.0, strays)
    if is_flat:
        wider = (
            USUAL_SHARE + (1 - USUAL_SHARE) * strays
            if len(y) > 2 * REACH + 1
            else 1 + FEW_STRAY * (wider - 1)
        )
    by_noise = wider * float(gradient @ np.linalg.solve(normal, gradient))
    by_grey = (FLAT_GREY if is_flat else ROUND_GREY) * float(np.average(uneven, weights=s**-2))
    by_shape = 0.0 if is_flat or len(c) < 3 else ROUND_SHAPE * float(c[2])
    return _End(float(gradient @ c), hypot(sqrt(by_noise), by_grey, by_shape), is_flat, bend)


def _misses(x: Floats, y: Floats, s: Floats, c: Floats) -> Floats:
    """(n,) by how many of its standard deviations each edge lies off the polynomial `c`, from x^0 up."""
    return np.asarray((y - np.vander(x, len(c), increasing=True) @ c) / s)


def _weighted_fit(x: Floats, y: Floats, s: Floats, degree: int) -> tuple[Floats, Floats, float]:
    """Coefficients from x^0 up of a polynomial through `y` (n,) of standard deviations `s`, its normal
    matrix, and the mean square of what the bands stray by, over what their noise lets expect.

    Bands in which a lamp or a gap has the road's grey lie far off: their weights fall as
    1 / (1 + t^2). Bands that stray by more than their noise say how well the polynomial fits.
    """
    powers, sure = np.vander(x, degree + 1, increasing=True), s
    for _ in range(ROBUST_ROUNDS):
        design = powers / sure[:, None]
        c = np.linalg.lstsq(design, y / sure, rcond=1e-10)[0]
        misses = (y - powers @ c) / s
        scale = max(1.0, robust_scale(misses))
        sure = s * np.sqrt(1 + (misses / (CAUCHY * scale)) ** 2)
    design = powers / sure[:, None]
    left = (y - powers @ c) / sure
    strays = float(left @ left) / max(len(x) - degree - 1, 1)
    return np.asarray(c, np.float64), design.T @ design, strays
