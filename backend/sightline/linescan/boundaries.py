"""Front and rear of a vehicle to a fraction of a line, from the upper part of the picture alone.

In every band of rows the edge lies where the picture has gone half the way from the road's grey to the
vehicle's. The foremost point is the vertex of a parabola through the edges of neighbouring bands, each with
the weight of its own noise: bumpers are round, and may have the road's own grey in some bands. Where a
parabola fits no better than an upright line the end is flat, and the line goes through as many bands as agree
with it: the lowest of noisy values, which a vertex seeks, lies too far out. A shadow lies in the lowest part,
which is not looked at. The road is taken as bright as it is just outside the boundary,
for the light changes while a slow vehicle passes.
"""

from dataclasses import dataclass
from math import hypot, log, sqrt

import numpy as np
from numpy.typing import NDArray

from sightline.linescan.parts import USUAL_SHADOW_SHARE, Crossings, Passage, Pixels, Rig
from sightline.robust import robust_scale

Array = NDArray[np.float64]
BANDS = 48
# along the vehicle, metres: searched before and behind the rough edge; where the vehicle's grey is read
BEFORE_M, BEHIND_M = 0.10, 0.30
GREY_M = (0.012, 0.040)
# of what is searched before the edge, the outermost share shows the road as bright as it is now, by the rows
# that are not dark: brighter than a share of the road's median
ROAD_SHARE, DARK_SHARE = 0.2, 0.15
# lamps flicker: over this share of the lines searched before the edge the light is followed, and a band must
# differ by more than so many of its usual changes
LIGHT_SHARE, LIGHT_TIMES = 0.6, 4.0
# bands on either side of the foremost one through which the parabola goes: some 14 cm of a bumper; and those
# through which an upright line goes as long as it stays within so many of its standard uncertainties
REACH = 3
FLAT_REACHES, STAYS = (5, 8, 12, 18), 1.5
# An outline is no parabola: at its foremost point it is off by a share of what the parabola falls back within
# one band. And of the bands about it, one that shows no clear edge, or one that strays, may have been the
# foremost: by how much it hides grows as the square of their number, as a parabola falls back. Metres.
FALL_SHARE, HIDDEN_M = 0.15, 0.0003
# what is left of a flat edge of one grey
FLAT_M = 0.0001
# Both cameras see one end's shape and greys, each with its own noise, road and lines: correlation of both
# errors of an end, over their u, of 1680 simulated pairs (0.65 at 2 DN, 0.51 at 8 DN).
SAME_END = 0.58
# above this noise of a pixel, means along the vehicle are twice as long
NOISY_DN = 4.5
SOFT_M = 0.006
CLEAR_SHARE = 0.4
# a band's edge is there, and clear, where the greys differ by so many standard deviations of the noise, and
# no less than these shares of the road's grey
SIGMAS, LEAST_SHARE, CLEAR_GREY_SHARE = 5.0, 0.02, 0.03
# optics and exposure spread a step over so many metres, so it rises no less steeply than over these
EDGE_M = 0.02
# by how much edges of bands stray from a parabola without any noise, metres; weighs low noise down
BUMPY_M = 0.0005
# the half-way rule takes the grey read behind an edge for the grey at it: where that changes, read over these
# metres behind the edge, a boundary is off by half its change over a step as wide as SOFT_EDGE_M (optics of
# 4 mm)
NEAR_M, FAR_M, SOFT_EDGE_M = (0.010, 0.020), (0.028, 0.040), 0.010
# What differs from the road lies at most so far before its half-way edge, metres, by optics alone. What lies
# farther before it (by noise, up to TOLD_M), or is brighter where the vehicle is darker, may be the vehicle's
# own edge or a shadow.
AHEAD_M, TOLD_M = 0.008, 0.011
# of seven bands as many change independently of each other
OWN_BANDS = 3.0
CAUCHY, ROBUST_ROUNDS = 2.385, 6
# what interpolating half the grey between two lines leaves of an edge that fell into a line of full exposure:
# with a share f of that line covered it is off by (0.5 - f) f / (1 - f) lines; root mean square over f
U_LINE_LINES = 0.06
# standard uncertainty of a doubtful boundary: the rms error of 50 such ones of 1008 simulated vehicles, most
# of them bumpers of the road's own grey at 8 DN and 30 m/s or more, which hide up to 110 mm
DOUBT_M = 0.025


@dataclass(frozen=True)
class Edge:
    """One boundary: its line, None where the bands show none; doubtful where few bands near it are clear.

    `u_lines`: standard uncertainty by the scatter of the bands about the outline, by what too few of them may
    hide and its shape leaves, and by greys that change behind the edge, 0 where there is no line.
    """

    line: float | None
    doubtful: bool = True
    u_lines: float = 0.0


def refined(passage: Passage, rig: Rig) -> tuple[Crossings, float]:
    """The crossings to a fraction of a line, and what they bring to the length's u, metres.

    A boundary that is not clear at all keeps its rough line. The length is the mean of both cameras' lengths,
    so each of four boundaries counts half in it, those of the same end correlated (JCGM 100:2008, 5.2.2).
    """
    rough = passage.crossings
    delay = (rough.front_line_2 - rough.front_line_1 + rough.rear_line_2 - rough.rear_line_1) / 2
    per_m = max(abs(delay), 1.0) / rig.baseline_m
    lines, u_m = [], []
    for line, rear, second in (
        (rough.front_line_1, False, False),
        (rough.rear_line_1, True, False),
        (rough.front_line_2, False, True),
        (rough.rear_line_2, True, True),
    ):
        picture, start = (passage.second, passage.start_2) if second else (passage.first, passage.start_1)
        road = passage.background_2 if second else passage.background_1
        edge = edge_near(picture, road, line - start, rear, per_m, passage.noise_dn, rig.shadow_share)
        lines.append(line if edge.line is None else start + edge.line)
        u_m.append(hypot(edge.u_lines / per_m, FLAT_M, DOUBT_M * edge.doubtful))
    variance = sum((a * a + b * b + 2 * SAME_END * a * b) / 4 for a, b in zip(u_m[:2], u_m[2:], strict=True))
    return Crossings(*lines), sqrt(variance)


def edge_near(
    picture: Pixels,
    road: NDArray[np.float32],
    line: float,
    rear: bool,
    lines_per_m: float,
    noise_dn: float,
    shadow_share: float = USUAL_SHADOW_SHARE,
) -> Edge:
    """The boundary near a line of a `picture` (lines, rows); `rear` looks for the end. `road` (rows,): the
    empty road's line, grey values. `shadow_share`: of the rows, not looked at below.

    Own method: in each band of rows the place half the way from the road's grey to the vehicle's, then the
    vertex of a weighted parabola through neighbouring bands. An Edge without a line where there is none.
    (Douxchamps et al., section IV, compare whole lines with the background, shadow included.)
    """
    before, behind = BEFORE_M * lines_per_m + 6, BEHIND_M * lines_per_m + 6
    lo, hi = (line - behind, line + before) if rear else (line - before, line + behind)
    lo, hi = max(round(lo), 0), min(round(hi), len(picture))
    if hi - lo < 6:
        return Edge(None)
    window = picture[lo:hi, : max(1, int(picture.shape[1] * (1.0 - shadow_share)))]
    if rear:
        window = window[::-1]
    lit, unrest = _as_lit(road[: window.shape[1]], window[: max(3, round(LIGHT_SHARE * before))])
    differs, height = _differences(window, lit)
    soft = max(1, round(SOFT_M * (1 + (noise_dn > NOISY_DN)) * lines_per_m))
    smooth = _box(differs, soft)
    sigma = 1.15 * noise_dn / np.sqrt(height * soft)
    least = np.maximum((LEAST_SHARE, CLEAR_GREY_SHARE), LIGHT_TIMES * unrest) * float(np.median(lit))
    edges, u, ahead, clear = _band_edges(smooth, sigma, (float(least[0]), float(least[1])), lines_per_m)
    uneven = _uneven(smooth, edges, lines_per_m)
    found = _foremost(edges, np.hypot(u, BUMPY_M * lines_per_m), uneven, ahead, clear, lines_per_m)
    if found.line is None:
        return found
    return Edge(hi - 1 - found.line if rear else lo + found.line, found.doubtful, found.u_lines)


def _as_lit(road: NDArray[np.float32], outside: Pixels) -> tuple[NDArray[np.float32], float]:
    """The road's line (rows,) as bright as the outermost lines (n, rows) show it, and by which share of it
    the light usually changes in them.
    """
    bright = road > DARK_SHARE * float(np.median(road))
    if np.count_nonzero(bright) < 8:
        return road, 0.0
    ratio = np.median(outside[:, bright] / road[bright], axis=1)
    now = float(ratio[: max(3, round(len(ratio) * ROAD_SHARE / LIGHT_SHARE))].mean())
    if now <= 0:
        return road, 0.0
    return road * np.float32(now), float(np.median(np.abs(ratio / now - 1)))


def _differences(window: Pixels, road: NDArray[np.float32]) -> tuple[Array, int]:
    """Band means (lines, bands) of the window minus road, and the rows in a band."""
    rows = window.shape[1]
    height = max(1, rows // BANDS)
    bands = max(1, rows // height)
    used = bands * height
    means = window[:, :used].reshape(len(window), bands, height).mean(-1)
    return means - road[:used].reshape(bands, height).mean(-1), height


def _box(values: Array, size: int) -> Array:
    """Centred running mean over the lines; the ends are repeated."""
    if size < 2:
        return values
    size += 1 - size % 2
    half = size // 2
    padded = np.concatenate([np.repeat(values[:1], half + 1, 0), values, np.repeat(values[-1:], half, 0)])
    sums = np.cumsum(padded, 0)
    return np.asarray((sums[size:] - sums[:-size]) / size)


def _band_edges(
    smooth: Array, sigma: float, least: tuple[float, float], lines_per_m: float
) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
    """(bands,) line at which each band is half the way to the vehicle's grey, u of that line by noise, lines
    before it in which something else differs from the road, and whether it is clear. `least`: grey values by
    which something, and something clear, differs from the road.
    """
    count, bands = smooth.shape
    every = np.arange(bands)
    limit = max(SIGMAS * sigma, least[0])
    beyond = np.abs(smooth) > limit
    start = beyond.argmax(0)
    near, far = (max(1, round(part * lines_per_m)) for part in GREY_M)
    places = np.minimum(start + np.arange(near, max(far, near + 1) + 1)[:, None], count - 1)
    level = np.median(smooth[places, every], axis=0)
    rising = smooth * np.sign(level)
    half = np.abs(level) / 2
    # back from the middle of what was read as the vehicle's grey to the last line below half of it
    index = np.arange(count)[:, None]
    below = (rising < half) & (index <= start + near)
    last = np.where(below.any(0), count - 1 - below[::-1].argmax(0), 0)
    after = np.minimum(last + 1, count - 1)
    y0, y1 = rising[last, every], rising[after, every]
    part = np.clip((half - y0) / np.maximum(y1 - y0, 1e-9), 0, 1)
    steady = np.abs(level) > max(SIGMAS * sigma, least[1])
    inside = beyond.any(0) & below.any(0) & (last > 0) & (start + near < count)
    # of the level, half of whose noise comes on top, and of the line itself
    steep = np.maximum(np.maximum(y1 - y0, np.abs(level) / max(EDGE_M * lines_per_m, 1.5)), 1e-9)
    lead = last + part - start
    turns = smooth[start, every] * level < 0
    ahead = np.where(turns, lead, (lead - AHEAD_M * lines_per_m) * (lead > TOLD_M * lines_per_m)) * inside
    return last + part, 1.2 * sigma / steep, ahead, steady & inside


def _of_three(values: Array) -> Array:
    """The median of each value and its two neighbours; at the ends the mean of both that are there."""
    before, here, after = values[:-2], values[1:-1], values[2:]
    inner = np.maximum(np.minimum(before, here), np.minimum(np.maximum(before, here), after))
    return np.concatenate([[values[:2].mean()], inner, [values[-2:].mean()]])


def _uneven(smooth: Array, edges: Array, lines_per_m: float) -> Array:
    """(bands,) lines by which each edge may be off because the vehicle's grey changes behind it."""
    every = np.arange(smooth.shape[1])

    def grey(span_m: tuple[float, float]) -> Array:
        low, high = (max(1, round(one * lines_per_m)) for one in span_m)
        places = np.rint(edges).astype(int) + np.arange(low, max(high, low + 1) + 1)[:, None]
        return np.asarray(smooth[np.clip(places, 0, len(smooth) - 1), every].mean(axis=0))

    near, far = grey(NEAR_M), grey(FAR_M)
    change = (far - near) * (sum(NEAR_M) + sum(FAR_M)) / 2 / (sum(FAR_M) - sum(NEAR_M))
    level = np.maximum(np.abs(near + far) / 2, 1e-6)
    return np.minimum(SOFT_EDGE_M * np.abs(change) / level / 2, BEFORE_M / 10) * lines_per_m


def _foremost(
    edges: Array, u: Array, uneven: Array, ahead: Array, clear: NDArray[np.bool_], lines_per_m: float
) -> Edge:
    """The smallest line of the outline through the edges around the foremost bands, all (bands,)."""
    bands = np.flatnonzero(clear)
    if len(bands) < 3:
        return Edge(None)
    # a single band that is ahead of all others is noise, so the foremost three decide where to look
    smooth = _of_three(edges[bands])
    middle = bands[int(smooth[1:-1].argmin()) + 1]
    near = bands[np.abs(bands - middle) <= REACH]
    if len(near) < 3:
        return Edge(float(smooth.min()))
    away = np.abs(edges[near] - np.median(edges[near]))
    kept = near[away <= 3 * np.maximum(max(robust_scale(away), 0.7), u[near])]
    if len(kept) < 4:
        return Edge(float(np.median(edges[near])))
    doubtful = float(np.mean(clear[max(middle - 2 * REACH, 0) : middle + 2 * REACH + 1])) < CLEAR_SHARE
    end = _end_of(kept - middle, edges[kept], u[kept], uneven[kept])
    hidden = HIDDEN_M * lines_per_m * (2 * REACH + 1 - len(kept)) ** 2
    other = float(np.max(ahead[kept[np.abs(kept - middle) <= 1]], initial=0.0)) / 2
    line, u_lines = end.line, hypot(end.u_lines, hidden, other)
    for reach in FLAT_REACHES if end.flat else ():
        near = bands[np.abs(bands - middle) <= reach]
        wider = _end_of(near - middle, edges[near], u[near], uneven[near])
        if not wider.flat or abs(wider.line - end.line) > STAYS * end.u_lines:
            break
        end, line, u_lines = wider, wider.line, hypot(wider.u_lines, other)
    return Edge(line, doubtful, u_lines)


@dataclass(frozen=True)
class _End:
    """The foremost line of an outline, its u but for what is hidden, and whether the outline is flat."""

    line: float
    u_lines: float
    flat: bool


def _end_of(x: NDArray[np.intp], y: Array, s: Array, uneven: Array) -> _End:
    """The foremost line of a parabola, or of an upright line if that is enough, through the edges `y` (n,) of
    bands `x` (n,), of standard deviations `s` (n,) by noise and `uneven` (n,) by greys.
    """
    place = x.astype(float)
    c, normal, wider = _weighted_fit(place, y, s, 2)
    flat = _weighted_fit(place, y, s, 0)
    spread = max(1.0, robust_scale(_misses(place, y, s, c)) * sqrt(len(y) / max(len(y) - 3, 1)))
    costs = [
        CAUCHY**2 * float(np.log1p((_misses(place, y, s, one) / (CAUCHY * spread)) ** 2).sum())
        for one in (flat[0], c)
    ]
    # a parabola must gain what its two more coefficients cost (Schwarz 1978)
    is_flat = costs[0] < costs[1] + 2 * log(len(y))
    at = 0.0
    if is_flat:
        c, normal, wider = flat
    elif c[2] > 1e-6:
        at = float(np.clip(-c[1] / (2 * c[2]), place.min(), place.max()))
    else:
        c, normal, wider = _weighted_fit(place, y, s, 1)
        at = float(place.min() if c[1] > 0 else place.max())
    gradient = at ** np.arange(len(c))
    by_noise = wider * float(gradient @ np.linalg.solve(normal, gradient))
    # as many of them change independently of each other
    own = OWN_BANDS * len(y) / (2 * REACH + 1)
    by_grey = float(np.average(uneven**2, weights=s**-2)) / own
    by_shape = FALL_SHARE * float(c[2]) if len(c) == 3 else 0.0
    return _End(float(gradient @ c), sqrt(by_noise + by_grey + by_shape**2), is_flat)


def _misses(x: Array, y: Array, s: Array, c: Array) -> Array:
    """(n,) by how many of its standard deviations each edge lies off the polynomial `c`, from x^0 up."""
    return np.asarray((y - np.vander(x, len(c), increasing=True) @ c) / s)


def _weighted_fit(x: Array, y: Array, s: Array, degree: int) -> tuple[Array, Array, float]:
    """Coefficients from x^0 up of a polynomial through `y` (n,) of standard deviations `s`, its normal
    matrix, and by how much its variances are too small.

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
    wider = max(1.0, float(left @ left) / max(len(x) - degree - 1, 1))
    return np.asarray(c, np.float64), design.T @ design, wider
