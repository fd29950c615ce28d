"""The foremost point of a vehicle's outline from what its bands of rows show.

It is that of a round end through the edges of neighbouring bands, each with the weight of its own doubt:
bumpers are round or come to a point, seldom alike above and below, some flat about their foremost point, and
may have the road's own grey in some bands; over all such shapes the mean is taken by how likely each is. The
lowest of many noisy values, which a vertex seeks, lies too far out, and so does a parabola about a corner; a
bumper that stands before an upright face does not. So wherever more bands agree with an upright line, both
are weighed by what the bands say, and u holds what lies between them.

An outline falls back from its foremost point upwards and downwards, so bands that lie behind others on either
side are no part of it: they are gaps, or show an edge within a vehicle whose grey is the road's there. Which
of both is told by what little differs before them.
"""

from dataclasses import dataclass
from math import exp, hypot, log, sqrt

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.robust import SD_OVER_MEDIAN, robust_scale

# along the vehicle, metres: searched before the rough edge
BEFORE_M = 0.10
# bands on either side of the foremost one through which the parabola goes: some 14 cm of a bumper
REACH = 3
# bands on either side of its middle through which an upright line may go, with the foremost one in the middle
# or as the second from above or from below; so many must be there, of whom such a share agree with it: within
# so many of their standard deviations
UPRIGHT_REACHES, SIDES = (5, 8, 12, 18), (0, -1, 1)
UPRIGHT_BANDS, UPRIGHT_SHARE, AGREES = 8, 0.7, 2.0
# Neighbouring bands that may stand before such a line as a bumper: from so many to so many, beside so many at
# least that do not, of which none lies farther behind it than so many standard deviations; and how far
# bumpers usually do, metres
BUMPER_BANDS, BESIDE_BANDS, BEHIND, BUMPER_M = (3, 12), 4, 3.0, 0.010
# how likely a bumper is before anything is seen: one in twenty ends that may be upright
BUMPER_SHARE = 0.05
# Of the bands about the foremost point, one that shows no clear edge, or one that strays, may have been the
# foremost: by how much it hides grows as the square of their number, as a parabola falls back. Metres. Over a
# notch that is seen to hide something an outline may bend by so many metres per band squared.
HIDDEN_M, BEND_M = 0.0002, 0.0012
# outlines of vehicles have no notches deeper than this, metres; before a notch there is something where it
# differs by so many standard deviations (root mean square over its bands)
NOTCH_M, THERE = 0.010, 2.5
# of the bands about the foremost one so many must be clear
CLEAR_SHARE = 0.4
# What differs from the road lies at most so far before its half-way edge, metres, by optics and noise.
TOLD_M = 0.011
# Greys that change behind an edge change alike in all bands: by so many times their mean a round end is off
# (from the errors of 1900 ends, seeds 9901 and 9903), and a flat one. That and the next two were found from
# the errors of the ends of 480 simulated bodies (seeds 8801 and 8901).
ROUND_GREY, FLAT_GREY = 0.75, 0.4
# In an upright end the bands' own scatter tells u of its line, beside a share of what is usual. What they
# stray by more than MORE_NOISE times their noise, for so few bands do so by chance, is its own: it is as far
# before its line as the foremost of three such errors is, in the mean and with that standard deviation.
USUAL_SHARE = 0.2
MORE_NOISE, OF_THREE, U_OF_THREE = 1.3, 0.85, 0.75
# A round end may be flat about its foremost point, over so many bands to either side: as likely not as it is,
# before anything is seen. From there on it falls back as one of these powers of the way, all as likely, and
# to either side by an amount of its own: in REACH bands usually by some such many metres.
FLAT_HALVES, HALF_LIKELY = (0.0, 0.75, 1.5), (1 / 2, 1 / 4, 1 / 4)
POWERS, USUAL_FALL_M = (1.0, 1.5, 2.0), 0.06
# steps of bands in which its middle is looked for, how far beyond them, and how likely it lies at the end of
# what is seen or beyond
MIDDLE_STEP, BEYOND, AT_END = 0.5, 1.5, 0.6
# No vehicle keeps to such a shape: it strays from it by so large a share of what it falls back, and by so
# large a share of the bumps about a parabola (seed 9901).
SHAPE_SHARE, ROUND_BUMPS = 0.05, 0.2
# how many bands' worth it weighs that bands stray by what their u says, beside what they do (seed 9901)
USUAL_BANDS = 16
CAUCHY, ROBUST_ROUNDS = 2.385, 6
# standard uncertainty of a doubtful boundary: the rms error of 311 such ones of 6,120 simulated passages
# (seeds 9901, 9905), most of them of the road's own grey, of which some hide 70 mm
DOUBT_M = 0.012


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
    road, and whether it is clear. `bumps`: lines that every u holds for bands which stray without any noise.
    """

    edges: Floats
    u: Floats
    uneven: Floats
    ahead: Floats
    clear: NDArray[np.bool_]
    bumps: float = 0.0


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

    Own method: a round end through them and an upright line through more, averaged by how likely each is
    (Hoeting et al. 1999).
    """
    edges, u, clear, lines_per_m = bands.edges, bands.u, bands.clear, view.lines_per_m
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
    line, u_lines = _round_end_of(bands, kept, int(middle), lines_per_m)
    hidden = max(
        HIDDEN_M * lines_per_m * (2 * REACH + 1 - len(kept)) ** 2,
        _may_hide(bands, view, notches, line, BEND_M * lines_per_m),
    )
    other = float(np.max(bands.ahead[kept[np.abs(kept - middle) <= 1]], initial=0.0)) / 2
    line, u_lines = _upright_or(bands, used, int(middle), (line, hypot(u_lines, hidden)), lines_per_m)
    return Edge(line, doubtful, hypot(u_lines, other))


def _upright_or(
    bands: Bands, used: NDArray[np.intp], middle: int, end: tuple[float, float], lines_per_m: float
) -> tuple[float, float]:
    """The surest upright line through more of the bands `used` (n,) about the `middle` one, or to one side of
    it, than the `end` (its line and u) was found by, or that end, by how likely each is; the end alone where
    no such line has bands enough.

    Own method. Against the line stands a bumper: neighbouring bands, the `middle` one among them, that lie
    before the others of the line. Bands that are too unsure to tell leave it as likely as it was.
    """
    found: tuple[float, float] | None = None
    s = np.hypot(bands.u, bands.uneven)
    near, misses = used, s
    for reach in UPRIGHT_REACHES:
        for side in SIDES:
            some = used[np.abs(used - middle - side * (reach - 1)) <= reach]
            if len(some) < UPRIGHT_BANDS:
                continue
            line = _upright_line(bands, some)
            # one that lies before a round end says nothing that the round end does not
            if line is None or line[0] <= end[0]:
                continue
            off = (bands.edges[some] - line[0]) / s[some]
            agree = float(np.mean(np.abs(off) < AGREES))
            if agree >= UPRIGHT_SHARE and (found is None or line[1] < found[1]):
                found, near, misses = line, some, off
    if found is None:
        return end
    scatter = max(1.0, robust_scale(misses)) ** 2
    at = int(np.searchsorted(used, middle))
    beside = np.isin(used, near[misses < BEHIND])
    gain = _bumper_gain(bands.edges[used], scatter * s[used] ** 2, beside, at, BUMPER_M * lines_per_m)
    share = 1 / (1 + BUMPER_SHARE / (1 - BUMPER_SHARE) * exp(min(gain, 50.0)))
    # mean and standard deviation of both together
    apart = found[0] - end[0]
    variance = share * found[1] ** 2 + (1 - share) * end[1] ** 2 + share * (1 - share) * apart**2
    return end[0] + share * apart, sqrt(variance)


def _bumper_gain(y: Floats, variance: Floats, upright: NDArray[np.bool_], at: int, usual: float) -> float:
    """Logarithm of how many times likelier the edges `y` (n,) of a `variance` each are where neighbouring
    bands, the one `at` among them, lie before the other `upright` ones: of those that may the likeliest.

    Bayes factor of a mean that is 0 or normal of standard deviation `usual` (Kass and Raftery 1995).
    """
    weights = 1 / variance
    columns = weights, weights * y, weights * upright, weights * y * upright, 1.0 * upright
    sums = np.cumsum(np.column_stack([np.zeros(5), np.array(columns)]), axis=1).T
    least, most = BUMPER_BANDS
    gains = list[float]()
    for first in range(max(at + 1 - most, 0), at + 1):
        for last in range(max(first + least, at + 1), min(first + most, len(y)) + 1):
            inner = sums[last] - sums[first]
            beside = sums[-1] - inner
            if beside[4] >= BESIDE_BANDS:
                before = max(float(beside[3] / beside[2] - inner[1] / inner[0]), 0.0)
                own = float(1 / inner[0] + 1 / beside[2])
                gains.append((before**2 / own / (1 + own / usual**2) - log(1 + usual**2 / own)) / 2)
    return max(gains, default=0.0)


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


def _upright_line(bands: Bands, at: NDArray[np.intp]) -> tuple[float, float] | None:
    """The foremost line of an upright end through the bands `at` (n,), and its u; None where a parabola
    through them gains what its two more coefficients cost (Schwarz 1978).
    """
    place, y, uneven = at - at.mean(), bands.edges[at], bands.uneven[at]
    # a band whose grey changes says less
    s = np.hypot(bands.u[at], uneven)
    round_c, _, _ = _weighted_fit(place, y, s, 2)
    (line,), normal, strays = _weighted_fit(place, y, s, 0)
    off = (y - np.vander(place, 3, increasing=True) @ round_c) / s
    spread = max(1.0, robust_scale(off) * sqrt(len(y) / (len(y) - 3)))
    costs = [
        CAUCHY**2 * float(np.log1p((one / (CAUCHY * spread)) ** 2).sum()) for one in ((y - line) / s, off)
    ]
    if costs[0] - costs[1] >= 2 * log(len(y)):
        return None
    grey = float(np.average(uneven, weights=s**-2))
    by_noise = (USUAL_SHARE + (1 - USUAL_SHARE) * strays) / float(normal[0, 0])
    noise = float(np.median(s**2 - bands.bumps**2))
    own = sqrt(max(robust_scale(y - line) ** 2 - MORE_NOISE * noise, 0.0))
    return line - OF_THREE * own, hypot(sqrt(by_noise), FLAT_GREY * grey, U_OF_THREE * own)


def _round_end_of(bands: Bands, at: NDArray[np.intp], middle: int, lines_per_m: float) -> tuple[float, float]:
    """The foremost line of a round end through the few bands `at` (n,) about the `middle` one, and its u."""
    uneven = bands.uneven[at]
    own = np.sqrt(bands.u[at] ** 2 + uneven**2 - (1 - ROUND_BUMPS**2) * bands.bumps**2)
    line, u = _round_end((at - middle).astype(float), bands.edges[at], own, USUAL_FALL_M * lines_per_m)
    grey = float(np.average(uneven, weights=1 / (bands.u[at] ** 2 + uneven**2)))
    return line, hypot(u, ROUND_GREY * grey)


def _round_shapes(x: Floats) -> tuple[Floats, Floats, Floats]:
    """What round ends fall back by at bands `x` (n,) above and below their foremost point, each for itself
    and one at REACH bands from it, (shapes, n, 2); what of it is left at the foremost row that is seen,
    (shapes, 2); and how likely each shape is before anything is seen: every middle, which may lie beyond the
    bands, all that it may be flat by, and every power.
    """
    low, high = float(x.min()), float(x.max())
    middles = np.arange(low - BEYOND, high + BEYOND + MIDDLE_STEP / 2, MIDDLE_STEP)
    every = np.meshgrid(POWERS, FLAT_HALVES, middles, indexing="ij")
    power, half, middle = (part.ravel()[:, None] for part in every)

    def falls(way: Floats) -> Floats:
        return np.asarray((np.maximum(way - half, 0.0) / (REACH - half)) ** power)

    def over_rows(way: Floats) -> Floats:
        return np.asarray(np.maximum(way - half, 0.0) * falls(way) / (power + 1))

    # a band shows the mean of its rows
    sides = [over_rows(way + 0.5) - over_rows(way - 0.5) for way in (middle - x, x - middle)]
    beyond = middle - np.clip(middle, low - 0.5, high + 0.5)
    at_end = ((middles <= low - 0.5) & (low > -REACH)) | ((middles >= high + 0.5) & (high < REACH))
    share = AT_END * at_end.any()
    of_middles = np.where(at_end, share / max(at_end.sum(), 1), (1 - share) / (~at_end).sum())
    likely = np.outer(np.full(len(POWERS), 1 / len(POWERS)), np.outer(HALF_LIKELY, of_middles))
    return (
        np.stack(sides, -1),
        np.hstack([falls(beyond), falls(-beyond)]),
        likely.ravel(),
    )


def _round_end(x: Floats, y: Floats, s: Floats, usual_fall: float) -> tuple[float, float]:
    """Foremost line of a round end through the edges `y` (n,) of bands `x` (n,), of standard deviations `s`
    (n,), and its u: mean and standard deviation over all shapes. `usual_fall`: lines, in REACH bands.

    Each is fitted with Cauchy's weights, and is as likely as it was before times the chance of what it
    leaves, of normal errors whose scale is that of `s` as USUAL_BANDS bands more would tell it: Student's t
    (averaged as in Hoeting et al. 1999). One that would not fall back to both sides is none.
    """
    falls, left_of_falls, likely = _round_shapes(x)
    design = np.concatenate([np.ones((*falls.shape[:2], 1)), falls], axis=2)
    least = np.column_stack([np.ones(len(likely)), left_of_falls])
    products = (design[..., None] * design[:, :, None]).reshape(*design.shape[:2], -1)
    before = np.diag([0.0, usual_fall**-2, usual_fall**-2])
    start = float(np.median(y))
    s = np.hypot(s, SHAPE_SHARE * (y - y.min()))
    weights = np.broadcast_to(s**-2, falls.shape[:2])
    for _ in range(ROBUST_ROUNDS):
        power = (weights[:, None] @ products).reshape(-1, 3, 3) + before
        right = (weights * (y - start))[:, None] @ design
        c = np.linalg.solve(power, right[:, 0, :, None])
        misses = (y - start - (design @ c)[..., 0]) / s
        scale = np.maximum(1.0, SD_OVER_MEDIAN * np.median(np.abs(misses), axis=1))[:, None]
        weights = s**-2 / (1 + (misses / (CAUCHY * scale)) ** 2)
    c = c[..., 0]
    left = CAUCHY**2 * np.log1p((misses / CAUCHY) ** 2).sum(1) + (c**2 @ before).sum(1) + USUAL_BANDS
    freedom = USUAL_BANDS + len(y) - 2
    gain = np.log(likely) - freedom / 2 * np.log(left) - np.linalg.slogdet(power)[1] / 2
    falls_back = (c[:, 1:] >= 0).all(axis=1)
    falls_back = falls_back if falls_back.any() else np.full(len(c), True)
    chance = np.where(falls_back, np.exp(np.minimum(gain - gain[falls_back].max(), 0.0)), 0.0)
    chance /= chance.sum()
    foremost = start + (c * least).sum(axis=1)
    mean = float(chance @ foremost)
    by_bands = (least * np.linalg.solve(power, least[..., None])[..., 0]).sum(axis=1)
    return mean, sqrt(float(chance @ (left / freedom * by_bands + (foremost - mean) ** 2)))


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
