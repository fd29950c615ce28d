"""Front and rear of a vehicle to a fraction of a line, from the upper part of the picture alone.

In every band of rows the edge lies where the picture has gone half the way from the road's grey to the
vehicle's; where those differ too little for that, in means over more lines. What the bands' edges say of the
outline's foremost point is `outline`'s. A shadow lies in the lowest part, which is not looked at. The road is
taken as bright as it is just outside the boundary, for the light changes while a slow vehicle passes.
"""

from math import hypot, sqrt

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.linescan.outline import BEFORE_M, DOUBT_M, TOLD_M, Bands, Edge, Seen, fit_foremost_edge
from sightline.linescan.parts import USUAL_SHADOW_SHARE, Crossings, Passage, Pixels, Rig
from sightline.linescan.rig import baseline_of

BANDS = 48
# along the vehicle, metres: searched behind the rough edge; where the vehicle's grey is read
BEHIND_M = 0.30
GREY_M = (0.012, 0.040)
# of what is searched before the edge, the outermost share shows the road as bright as it is now, by the rows
# that are not dark: brighter than a share of the road's median
ROAD_SHARE, DARK_SHARE = 0.2, 0.15
# lamps flicker: over this share of the lines searched before the edge the light is followed, and a band must
# differ by more than so many of its usual changes
LIGHT_SHARE, LIGHT_TIMES = 0.6, 4.0
# what is left of a flat edge of one grey
FLAT_M = 0.0001
# Both cameras see one end's shape and greys, each with its own noise, road and lines: correlation of both
# errors of an end, over their u, of 1680 simulated pairs (0.65 at 2 DN, 0.51 at 8 DN).
SAME_END = 0.58
# above this noise of a pixel, means along the vehicle are twice as long
NOISY_DN = 4.5
SOFT_M = 0.006
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
AHEAD_M = 0.008
# An edge too faint to be clear is looked for in means over so many times the lines. The half-way rule puts an
# edge in means over a length off by half of it times the error of the grey behind: a half, for what covers so
# much of a vehicle is seldom of one grey.
FAINT_TIMES, FAINT_SHARE = 4.0, 4.0
# what interpolating half the grey between two lines leaves of an edge that fell into a line of full exposure:
# with a share f of that line covered it is off by (0.5 - f) f / (1 - f) lines; root mean square over f. Of an
# edge that rises by less than STEP of the greys' difference from line to line, for it is spread over several
# (optics, means over lines), less is left: as this power of what it rises by. Own computation for Gaussian
# optics of up to 1.3 lines, within a tenth (tests/linescan/test_boundaries.py).
U_LINE_LINES, STEP, STEP_POWER = 0.06, 0.72, 2.4
# var of a median over that of a mean
OF_MEDIAN = 1.57


def refine_crossings(passage: Passage, rig: Rig) -> tuple[Crossings, tuple[float, float]]:
    """The crossings to a fraction of a line, and what front and rear bring to the length's u, metres.

    A boundary that is not clear at all keeps its rough line. The length is the mean of both cameras' lengths,
    so each of four boundaries counts half in it, those of the same end correlated (JCGM 100:2008, 5.2.2).
    """
    rough = passage.crossings
    delay = (rough.front_line_2 - rough.front_line_1 + rough.rear_line_2 - rough.rear_line_1) / 2
    per_m = max(abs(delay), 1.0) / baseline_of(rig)[0]
    lines, u_m, between = [], [], []
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
        between.append(edge.u_between_lines / per_m)
    front_m, rear_m = (
        hypot(sqrt((a * a + b * b + 2 * SAME_END * a * b) / 4), hypot(c, d) / 2)
        for a, b, c, d in zip(u_m[:2], u_m[2:], between[:2], between[2:], strict=True)
    )
    return Crossings(*lines), (front_m, rear_m)


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
    foremost point of a weighted outline through neighbouring bands. An Edge without a line where there is
    none. (Douxchamps et al., section IV, compare whole lines with the background, shadow included.)
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
    own = noise_dn / sqrt(height)
    least = np.maximum((LEAST_SHARE, CLEAR_GREY_SHARE), LIGHT_TIMES * unrest) * float(np.median(lit))
    limits = float(least[0]), float(least[1])
    long = round(FAINT_TIMES * soft) // 2 * 2 + 1
    faint, _ = _band_edges(
        _box(differs, long), (sigma * sqrt(soft / long), own), limits, lines_per_m, long, True
    )
    sharp, rise = _band_edges(smooth, (sigma, own), limits, lines_per_m, soft + 1 - soft % 2)
    edges, u, ahead, clear = _with_faint(sharp, faint, long)
    uneven = _uneven(smooth, edges, lines_per_m)
    bumps = BUMPY_M * lines_per_m
    bands = Bands(edges=edges, u=np.hypot(u, bumps), uneven=uneven, ahead=ahead, clear=clear, bumps=bumps)
    found = fit_foremost_edge(
        bands, Seen(differs, 1.15 * noise_dn / sqrt(height), limits[0] / 2, lines_per_m)
    )
    if found.line is None:
        return found
    line = hi - 1 - found.line if rear else lo + found.line
    return Edge(line, found.doubtful, found.u_lines, left_between_lines(rise))


def left_between_lines(rise: float) -> float:
    """Standard uncertainty, lines, that interpolating leaves of an edge which rises by so much of the greys'
    difference from one line to the next.
    """
    return float(U_LINE_LINES * min(rise / STEP, 1.0) ** STEP_POWER)


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


def _differences(window: Pixels, road: NDArray[np.float32]) -> tuple[Floats, int]:
    """Band means (lines, bands) of the window minus road, and the rows in a band."""
    rows = window.shape[1]
    height = max(1, rows // BANDS)
    bands = max(1, rows // height)
    used = bands * height
    means = window[:, :used].reshape(len(window), bands, height).mean(-1)
    return means - road[:used].reshape(bands, height).mean(-1), height


def _box(values: Floats, size: int) -> Floats:
    """Centred running mean over the lines; the ends are repeated."""
    if size < 2:
        return values
    size += 1 - size % 2
    half = size // 2
    padded = np.concatenate([np.repeat(values[:1], half + 1, 0), values, np.repeat(values[-1:], half, 0)])
    sums = np.cumsum(padded, 0)
    return np.asarray((sums[size:] - sums[:-size]) / size)


_Edges = tuple[Floats, Floats, Floats, NDArray[np.bool_]]


def _with_faint(seen: _Edges, faint: _Edges, long: int) -> _Edges:
    """Edges as `_band_edges` tells them, the faint ones in the place of those that are not clear, or that lie
    behind them by more than `long` lines: what differs so little shows only over that many lines together.
    """
    edges, u, ahead, clear = seen
    use = faint[3] & (faint[0] < edges + np.where(clear, -long, long))
    u_faint = np.hypot(faint[1], long / FAINT_SHARE)
    return (
        np.where(use, faint[0], edges),
        np.where(use, u_faint, u),
        np.where(use, 0.0, ahead),
        clear | use,
    )


def _band_edges(
    smooth: Floats,
    noise: tuple[float, float],
    least: tuple[float, float],
    lines_per_m: float,
    size: int,
    faint: bool = False,
) -> tuple[_Edges, float]:
    """(bands,) line at which each band is half the way to the vehicle's grey, u of that line by noise, lines
    before it in which something else differs from the road, and whether it is clear; and by which share of
    the grey clear ones rise from line to line there. `smooth`: means over `size` lines. `noise`: of such a
    mean at most, and of one line. `least`: grey values by which something, and something clear, differs.

    The half-way line's noise is that of the two means it lies between, which share all lines but one, and
    half of that of the vehicle's grey, a median.
    """
    count, bands = smooth.shape
    sigma, long = noise[0], size if faint else 0
    every = np.arange(bands)
    limit = max(SIGMAS * sigma, least[0])
    beyond = np.abs(smooth) > limit
    start = beyond.argmax(0)
    near, far = (max(1, round(part * lines_per_m)) + long // 2 for part in GREY_M)
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
    steep = np.maximum(np.maximum(y1 - y0, np.abs(level) / max(EDGE_M * lines_per_m, 1.5, long)), 1e-9)
    lead = last + part - start
    turns = smooth[start, every] * level < 0
    ahead = np.where(turns, lead, (lead - AHEAD_M * lines_per_m) * (lead > TOLD_M * lines_per_m)) * inside
    of_line = (size - 1 / 3) / size**2
    of_level = OF_MEDIAN / (len(places) + size - 1) / 4
    u = noise[1] * sqrt(of_line + of_level) / steep
    clear = steady & inside
    rise = float(np.median(((y1 - y0) / np.maximum(np.abs(level), 1e-9))[clear])) if clear.any() else 1.0
    return (last + part, u, ahead, clear), rise


def _uneven(smooth: Floats, edges: Floats, lines_per_m: float) -> Floats:
    """(bands,) lines by which each edge may be off because the vehicle's grey changes behind it."""
    every = np.arange(smooth.shape[1])

    def grey(span_m: tuple[float, float]) -> Floats:
        low, high = (max(1, round(one * lines_per_m)) for one in span_m)
        places = np.rint(edges).astype(int) + np.arange(low, max(high, low + 1) + 1)[:, None]
        return np.asarray(smooth[np.clip(places, 0, len(smooth) - 1), every].mean(axis=0))

    near, far = grey(NEAR_M), grey(FAR_M)
    change = (far - near) * (sum(NEAR_M) + sum(FAR_M)) / 2 / (sum(FAR_M) - sum(NEAR_M))
    level = np.maximum(np.abs(near + far) / 2, 1e-6)
    return np.minimum(SOFT_EDGE_M * np.abs(change) / level / 2, BEFORE_M / 10) * lines_per_m
