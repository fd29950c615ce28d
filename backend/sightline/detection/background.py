"""The empty road behind the traffic, and what stands before it: at reduced size, on luminance.

The background of a moment is, for each pixel, the densest cluster of its values in a window that reaches as
far ahead as back (the "shorth" of Andrews et al. 1972, here of a third): a median wants the road to be seen
half of the time, which a near lane with dense traffic does not grant. What stands for seconds (a board, a
parked car) belongs to the background when it is there longer than the road is.
"""

from collections import deque
from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

Small = NDArray[np.uint8]
Mask = NDArray[np.uint8]

WINDOW_S = 12.0
SAMPLES = 90
CLUSTER_SHARE = 0.34
NOISE_FACTOR = 3.0
LEAST_CONTRAST = 3.0
EDGE_SHARE = 0.35
GAIN_STEP = 0.1
DARK = 12
STEEP = 0.4
SOFT = 16.0


@dataclass(frozen=True, eq=False)
class Background:
    """The empty road, (h, w) float32, and how far a pixel may stray from it before it is something else."""

    level: NDArray[np.float32]
    tolerance: NDArray[np.float32]


class Sampler:
    """Keeps about `SAMPLES` pictures of the last `WINDOW_S` seconds before and after the moment asked for."""

    def __init__(self, rate_hz: float) -> None:
        self._every = max(1, round(2 * WINDOW_S * rate_hz / SAMPLES))
        self._kept: deque[Small] = deque(maxlen=SAMPLES)
        self._noise: deque[float] = deque(maxlen=SAMPLES)
        self._last: Small | None = None
        self._count = 0

    def offer(self, small: Small) -> None:
        """Look at the next picture, `small` (h, w); one in a few is kept."""
        if self._count % self._every == 0:
            self._kept.append(small)
            if self._last is not None:
                self._noise.append(_noise(small, self._last))
        self._last = small
        self._count += 1

    def background(self) -> Background:
        """What the window shows. Raises ValueError before the first picture."""
        noise = float(np.median(self._noise)) if self._noise else 1.0
        return _background(np.stack(self._kept), noise)


def background_of(samples: NDArray[np.uint8]) -> Background:
    """The empty road that `samples` (n, h, w) show, in order of time.

    Own method: `densest_level` of each pixel; noise from neighbouring samples, what moved between them
    clipped away.
    """
    noise = [_noise(one, other) for one, other in pairwise(samples)]
    return _background(samples, float(np.median(noise)) if noise else 1.0)


def _background(samples: NDArray[np.uint8], noise: float) -> Background:
    level = densest_level(samples)
    smooth = cv2.GaussianBlur(level, (3, 3), 0)
    kernel = np.ones((3, 3), np.uint8)
    edges = cv2.dilate(smooth, kernel) - cv2.erode(smooth, kernel)
    tolerance = LEAST_CONTRAST + NOISE_FACTOR * noise + EDGE_SHARE * edges
    return Background(level, np.asarray(tolerance, np.float32))


def densest_level(samples: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Level (h, w) of each pixel, grey values: the middle of the shortest interval that holds a third of its
    `samples` (n, h, w).

    After the "shorth" of Andrews et al. 1972, the mean of the shortest half; a third in place of the half,
    and the interval's middle in place of the mean.
    """
    ordered = np.sort(samples, axis=0)
    hold = max(1, round(CLUSTER_SHARE * len(ordered)))
    if hold >= len(ordered):
        return np.asarray(np.median(ordered, axis=0), np.float32)
    width = ordered[hold:] - ordered[:-hold]
    at = np.argmin(width, axis=0)[None]
    low, high = np.take_along_axis(ordered, at, 0)[0], np.take_along_axis(ordered, at + hold, 0)[0]
    return np.asarray((low.astype(np.float32) + high) / 2, np.float32)


def _noise(one: Small, other: Small) -> float:
    """Standard deviation of the noise, from two pictures in a row; what moves is clipped away."""
    change = cv2.absdiff(one, other)
    calm = change[change <= 2.5 * float(change.mean()) + 2]
    return float(np.sqrt(np.mean(np.square(calm, dtype=np.float64)) / 2))


def gain_of(small: Small, road: Background, before: float) -> float:
    """By how much the exposure differs from the background's: the median ratio of `small` (h, w) to the road,
    near what it was before.

    A lorry may fill most of the picture, so pixels that are far from the gain before do not vote, and the
    gain moves slowly. Own method: median of small / road over a ninth of the pixels, in steps of GAIN_STEP at
    most.
    """
    part, level = small[::3, ::3].astype(np.float32), road.level[::3, ::3]
    ratio = part[level > DARK] / level[level > DARK]
    near = ratio[np.abs(ratio - before) < 0.3 * before]
    if len(near) < 0.1 * max(len(ratio), 1):
        return before
    return float(np.clip(np.median(near), before - GAIN_STEP, before + GAIN_STEP))


def foreground(small: Small, road: Background, gain: float) -> tuple[Mask, Mask]:
    """What stands before the road in `small` (h, w), and of that what is no mere light on it: two masks (h,
    w), 0 or 255.

    The light of a headlamp changes the road smoothly; a body begins with a step. Own method: |small - gain
    road| above the background's tolerance; light is what is brighter and steps by less than STEEP of it in 3
    x 3 pixels.
    """
    apart = small.astype(np.float32) - road.level * np.float32(gain)
    kernel = np.ones((3, 3), np.uint8)
    step = cv2.dilate(apart, kernel) - cv2.erode(apart, kernel)
    mask = _mask(np.abs(apart) > road.tolerance)
    mask = np.asarray(cv2.medianBlur(mask, 3), np.uint8)
    light = (apart > 0) & (step < STEEP * apart + np.maximum(road.tolerance, SOFT))
    solid = cv2.bitwise_and(mask, _mask(~light))
    return _close_gaps(mask), np.asarray(solid, np.uint8)


def _close_gaps(mask: Mask) -> Mask:
    """Small gaps filled; with a border, or what comes near the picture's edge would be taken to touch it."""
    wide = cv2.copyMakeBorder(mask, 4, 4, 4, 4, cv2.BORDER_CONSTANT, value=0)
    return np.asarray(
        cv2.morphologyEx(wide, cv2.MORPH_CLOSE, np.ones((5, 7), np.uint8))[4:-4, 4:-4], np.uint8
    )


def _mask(where: NDArray[np.bool_]) -> Mask:
    return np.where(where, np.uint8(255), np.uint8(0))
