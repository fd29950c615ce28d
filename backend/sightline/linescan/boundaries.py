"""Front and rear of a vehicle to a fraction of a line, from the upper part of the picture alone.

In every band of rows the edge lies where the picture has gone half the way from the road's grey to the
vehicle's. The foremost point is the vertex of a parabola through the edges of neighbouring bands: bumpers are
round. A shadow lies in the lowest part, which is not looked at.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.linescan.background import UPPER_PART
from sightline.linescan.parts import Crossings, Passage, Pixels, Rig

Array = NDArray[np.float64]
BANDS = 48
# along the vehicle, metres: searched before and behind the rough edge; where the vehicle's grey is read
BEFORE_M, BEHIND_M = 0.10, 0.30
GREY_M = (0.012, 0.040)
REACH = 4
# above this noise of a pixel, bands and means along the vehicle are twice as wide
NOISY_DN = 4.5
CLEAR_SHARE = 0.4
# standard uncertainty of a doubtful boundary: the rms error of 53 such ones on 180 simulated vehicles at
# 8 DN, most of them white bumpers before a road of their own grey, which hide 60 to 70 mm
DOUBT_M = 0.06


@dataclass(frozen=True)
class Edge:
    """One boundary: its line, None where the bands show none; doubtful where few bands near it are clear."""

    line: float | None
    doubtful: bool = True


def refined(passage: Passage, rig: Rig) -> tuple[Crossings, float]:
    """The crossings to a fraction of a line, and what doubt adds to the length's uncertainty, metres.

    A boundary that is not clear at all keeps its rough line.
    """
    rough = passage.crossings
    delay = (rough.front_line_2 - rough.front_line_1 + rough.rear_line_2 - rough.rear_line_1) / 2
    per_m = max(delay, 1.0) / rig.baseline_m
    lines, doubts = [], 0
    for line, rear, second in (
        (rough.front_line_1, False, False),
        (rough.rear_line_1, True, False),
        (rough.front_line_2, False, True),
        (rough.rear_line_2, True, True),
    ):
        picture, start = (passage.second, passage.start_2) if second else (passage.first, passage.start_1)
        road = passage.background_2 if second else passage.background_1
        edge = edge_near(picture, road, line - start, rear, per_m, passage.noise_dn)
        lines.append(line if edge.line is None else start + edge.line)
        doubts += edge.doubtful
    # each of four boundaries counts half in the length, and both of a pair tend to fail together
    return Crossings(*lines), DOUBT_M * doubts / 2


def edge_near(
    picture: Pixels, road: NDArray[np.float32], line: float, rear: bool, lines_per_m: float, noise_dn: float
) -> Edge:
    """The boundary near a line of a `picture` (lines, rows); `rear` looks for the end. `road` (rows,): the
    empty road's line, grey values.

    Own method: in each band of rows the place half the way from the road's grey to the vehicle's, then the
    vertex of a parabola through neighbouring bands. An Edge without a line where there is none. (Douxchamps
    et al., section IV, compare whole lines with the background, shadow included.)
    """
    before, behind = BEFORE_M * lines_per_m + 6, BEHIND_M * lines_per_m + 6
    lo, hi = (line - behind, line + before) if rear else (line - before, line + behind)
    lo, hi = max(round(lo), 0), min(round(hi), len(picture))
    if hi - lo < 6:
        return Edge(None)
    wide = 1 + (noise_dn > NOISY_DN)
    differs, height = _differences(picture[lo:hi], road, wide)
    if rear:
        differs = differs[::-1]
    soft = max(1, round(0.006 * wide * lines_per_m))
    smooth = _box(differs, soft)
    sigma = 1.3 * noise_dn / np.sqrt(height * soft)
    edges, clear = _band_edges(smooth, sigma, lines_per_m)
    found = _vertex(edges, clear, REACH // wide + 1)
    if found.line is None:
        return found
    return Edge(hi - 1 - found.line if rear else lo + found.line, found.doubtful)


def _differences(window: Pixels, road: NDArray[np.float32], wide: int) -> tuple[Array, int]:
    """Band means (lines, bands) of picture minus road in the upper part, and the rows in a band."""
    rows = max(1, int(window.shape[1] * UPPER_PART))
    height = max(1, window.shape[1] // BANDS) * wide
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


def _band_edges(smooth: Array, sigma: float, lines_per_m: float) -> tuple[Array, NDArray[np.bool_]]:
    """(bands,) line at which each band is half the way to the vehicle's grey, and whether that is clear."""
    count, bands = smooth.shape
    every = np.arange(bands)
    limit = max(5 * sigma, 3.0)
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
    steady = np.abs(level) > max(10 * sigma, 6.0)
    inside = beyond.any(0) & below.any(0) & (last > 0) & (start + near < count)
    return last + part, steady & inside


def _of_three(values: Array) -> Array:
    """The median of each value and its two neighbours; at the ends the mean of both that are there."""
    before, here, after = values[:-2], values[1:-1], values[2:]
    inner = np.maximum(np.minimum(before, here), np.minimum(np.maximum(before, here), after))
    return np.concatenate([[values[:2].mean()], inner, [values[-2:].mean()]])


def _vertex(edges: Array, clear: NDArray[np.bool_], reach: int) -> Edge:
    """The smallest line of a parabola through the edges around the foremost bands."""
    bands = np.flatnonzero(clear)
    if len(bands) < 3:
        return Edge(None)
    # a single band that is ahead of all others is noise, so the foremost three decide where to look
    smooth = _of_three(edges[bands])
    middle = bands[int(smooth[1:-1].argmin()) + 1]
    near = bands[np.abs(bands - middle) <= reach]
    if len(near) < 3:
        return Edge(float(smooth.min()))
    x, y = (near - middle).astype(float), edges[near]
    keep = np.abs(y - np.median(y)) <= 3 * max(1.4826 * float(np.median(np.abs(y - np.median(y)))), 0.7)
    x, y = x[keep], y[keep]
    if len(x) < 4:
        return Edge(float(np.median(y)))
    c2, c1, c0 = np.polyfit(x, y, 2)
    if c2 > 1e-6:
        at = float(np.clip(-c1 / (2 * c2), x.min(), x.max()))
        value = float(np.polyval([c2, c1, c0], at))
    else:
        value = float(min(np.polyval(np.polyfit(x, y, 1), [x.min(), x.max()])))
    around = clear[max(middle - 2 * reach, 0) : middle + 2 * reach + 1]
    return Edge(value, float(np.mean(around)) < CLEAR_SHARE)
