"""Wheels in a vehicle's picture: where their hubs cross camera 1, found without knowing the rows' size.

Along the vehicle the picture is laid out in metres by the motion; upwards a row's size is not known, so a
wheel is an ellipse. What all wheels of a vehicle have in common is used: they stand on one line, and are of
one size or nearly so. A wheel is a dark ring (the tyre), lighter beside it at its foot (road or shadow) and
lighter within (rim). Own method: normalised correlation with that ring for every size that a wheel may have;
the size at which the two best places agree best is the vehicle's, looked for among those that fit best in a
shorter picture. Wheels behind the picture's side and lifted axles are not seen, and twin wheels of
one axle are one.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import ceil

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.linescan.equations import travelled_m
from sightline.linescan.parts import Motion, Pixels, Rig
from sightline.messages.said import Said

Array = NDArray[np.float32]
STEP_M = 0.02
ROWS = 72
# of a wheel: outer radius along the vehicle; half its height in rows of ROWS, for fields of 1.1 to 4.5 m
RADII_M = (0.26, 0.30, 0.34, 0.38, 0.43, 0.48, 0.54)
RADII_ROWS = (5.0, 6.0, 7.2, 8.6, 10.3, 12.4, 15.0, 18.0, 21.5)
# so many sizes are tried in full, after all of them in a picture that is shorter by so much
LIKELY, SHORTER = 9, 3
RIM, FOOT = 0.62, 1.30
WITHIN = 0.9
LEAST_LIKENESS = 0.45
# of the best: how like it another must be, and how far apart axles are in radii
LEAST_SHARE = 0.72
LEAST_APART = 2.05
MOST_AXLES = 12


@dataclass(frozen=True)
class Wheels:
    """Lines of strip 1 at which the hubs cross camera 1, rising; none: `reason` says why. `foot`: where tyres
    meet the road, of the picture's height from the top.
    """

    lines: tuple[float, ...]
    reason: Said | None = None
    row: float | None = None
    likeness: float | None = None
    foot: float | None = None


NONE_FOUND = Said("scan-no-wheel")
NO_MOTION = Said("scan-no-scale")


def tyres_row(picture: Pixels, start: int, motion: Motion, rig: Rig) -> float | None:
    """The row of strip 1, from the top, at which a vehicle's tyres meet the road; None without wheels.

    `picture` (lines, rows) begins at line `start`. Own method: the foot of the ring that fits best (decision
    70).
    """
    foot = wheels_in(picture, start, motion, rig).foot
    return None if foot is None else foot * picture.shape[1]


def wheels_in(picture: Pixels, start: int, motion: Motion, rig: Rig) -> Wheels:
    """The wheels of a vehicle; `picture` (lines, rows) begins at line `start` of strip 1.

    Where there are none, the reason. Own method: normalised correlation with a ring (decision 75).
    """
    if motion.speed_mps is None or motion.acceleration_mps2 is None or motion.length_m is None:
        return Wheels((), NO_MOTION)
    laid, lines = _laid_out(picture, start, motion, rig)
    score, likeness, along, row, upwards = max(
        (_best(laid, *size) for size in _likely_sizes(laid)), key=lambda one: one[0]
    )
    if score < LEAST_LIKENESS:
        return Wheels((), NONE_FOUND)
    hubs = _peaks(likeness, along)
    if not hubs:
        return Wheels((), NONE_FOUND)
    at = np.interp(hubs, np.arange(len(lines)), lines)
    foot = min((ROWS // 2 + row + 0.5 + upwards) / ROWS, 1.0)
    return Wheels(tuple(sorted(float(line) for line in at)), None, row, float(score), foot)


def _laid_out(picture: Pixels, start: int, motion: Motion, rig: Rig) -> tuple[Array, NDArray[np.float64]]:
    """(ROWS, steps) of the vehicle, a step STEP_M long, and the line of strip 1 of each step."""
    v, a = motion.speed_mps or 1.0, motion.acceleration_mps2 or 0.0
    since_s = (np.arange(len(picture)) + start - motion.crossings.front_line_1) / rig.line_rate_hz
    place_m = np.asarray(travelled_m(v, a, since_s))
    steps = np.arange(0.0, (motion.length_m or 1.0) + STEP_M, STEP_M)
    lines = np.interp(steps, place_m, np.arange(len(picture), dtype=np.float64))
    small = cv2.resize(picture, (ROWS, len(picture)), interpolation=cv2.INTER_AREA).astype(np.float32)
    sums = np.vstack([np.zeros((1, ROWS), np.float32), np.cumsum(small, 0, dtype=np.float64)])
    ends_m = np.append(steps, steps[-1] + STEP_M) - STEP_M / 2
    edges = np.clip(np.interp(ends_m, place_m, np.arange(len(picture)) + 0.5), 0, len(picture))
    low = np.minimum(edges.astype(int), len(picture) - 1)
    at = sums[low] + (edges - low)[:, None] * small[low]
    width = np.maximum(np.diff(edges), 1e-3)[:, None]
    return np.asarray((np.diff(at, axis=0) / width).T, np.float32), lines + start


def _likely_sizes(laid: Array) -> list[tuple[float, float]]:
    """Radii along, steps, and upwards, rows, that fit best in a shorter picture."""
    rows, steps = laid.shape
    short = cv2.resize(laid, (ceil(steps / SHORTER), rows), interpolation=cv2.INTER_AREA)
    sizes = [(radius_m / STEP_M, upwards) for radius_m in RADII_M for upwards in RADII_ROWS]
    fits = [_best(np.asarray(short, np.float32), along / SHORTER, upwards)[0] for along, upwards in sizes]
    return [sizes[at] for at in np.argsort(fits)[-LIKELY:]]


@lru_cache(maxsize=2 * len(RADII_M) * len(RADII_ROWS))
def _ring(along: float, upwards: float) -> tuple[Array, Array, float]:
    """Weights of a ring, the tyre -1, its foot's surroundings and the rim +1, weighted less its mean, and its
    spread.
    """
    half_x, half_y = ceil(FOOT * along), ceil(FOOT * upwards)
    y, x = np.mgrid[-half_y : half_y + 1, -half_x : half_x + 1]
    r = np.hypot(x / along, y / upwards)
    tyre = (r >= RIM) & (r <= 1.0)
    foot = (r > 1.08) & (r <= FOOT) & (y > 0.35 * upwards)
    rim = r < RIM - 0.08
    template = np.where(tyre, -1.0, np.where(foot | rim, 1.0, 0.0)).astype(np.float32)
    count = np.maximum([tyre.sum(), foot.sum(), rim.sum()], 1)
    weight = 2.0 * tyre / count[0] + 1.2 * foot / count[1] + 0.8 * rim / count[2]
    weight = np.asarray(weight / weight.sum(), np.float32)
    centred = template - float((weight * template).sum())
    spread = float(np.sqrt((weight * centred**2).sum()))
    return weight, np.asarray(weight * centred, np.float32), spread


def _best(laid: Array, along: float, upwards: float) -> tuple[float, Array, float, float, float]:
    """Of a size: mean likeness of the two best places of its best row, that row's (steps,), radius along,
    row, radius upwards.
    """
    likeness = _likeness(laid, along, upwards)
    if not likeness.size:
        return -1.0, np.zeros(0, np.float32), along, 0.0, upwards
    apart = int(LEAST_APART * along)
    most = (-1.0, 0)
    for row in np.argsort(-likeness.max(1))[:6]:
        left = likeness[row].copy()
        first = int(left.argmax())
        one = float(left[first])
        left[max(0, first - apart) : first + apart + 1] = -1.0
        most = max(most, ((one + float(left.max())) / 2, int(row)))
    return most[0], likeness[most[1]], along, float(most[1]), upwards


def _likeness(laid: Array, along: float, upwards: float) -> Array:
    """Weighted normalised correlation (rows, steps) with the ring, rows whose ring does not fit left out."""
    weight, ring, spread = _ring(along, upwards)
    if weight.shape[0] > laid.shape[0] or weight.shape[1] > laid.shape[1]:
        return np.zeros((0, 0), np.float32)
    part = laid[laid.shape[0] // 2 :]

    def correlated(image: Array, kernel: Array) -> Array:
        return np.asarray(
            cv2.filter2D(image, cv2.CV_32F, kernel, borderType=cv2.BORDER_REPLICATE), np.float32
        )

    both = np.stack([part, part * part], axis=-1)
    mean, square = cv2.split(correlated(both, weight))
    found = correlated(part, ring)
    deviation = np.sqrt(np.maximum(square - mean * mean, 4.0))
    out = np.asarray(found / (spread * deviation), np.float32)
    # no wheel stands out beyond a bumper
    within = max(1, int(WITHIN * along))
    out[:, :within] = out[:, -within:] = -1.0
    return out


def _peaks(likeness: Array, along: float) -> list[float]:
    """Places of hubs, steps; each the vertex of a parabola through its best step and the neighbours."""
    apart = int(LEAST_APART * along)
    left, out = likeness.copy(), list[float]()
    least = max(LEAST_LIKENESS * 0.8, LEAST_SHARE * float(likeness.max()))
    while len(out) < MOST_AXLES:
        at = int(left.argmax())
        if left[at] < least:
            break
        out.append(_vertex(likeness, at))
        left[max(0, at - apart) : at + apart + 1] = -1.0
    return out


def _vertex(values: Array, at: int) -> float:
    if not 0 < at < len(values) - 1:
        return float(at)
    before, here, after = (float(value) for value in values[at - 1 : at + 2])
    bend = before - 2 * here + after
    return at + (0.5 * (before - after) / bend if bend < 0 else 0.0)
