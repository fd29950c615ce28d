"""Following points of a vehicle from frame to frame, to foresee where they will be on other frames.

A car moves tens of pixels between two frames, further than a search finds by itself; so each step starts from
guesses of where the points may have gone (Lucas and Kanade 1981, pyramids after Bouguet 2000) and is believed
only where the way back ends where it began and the patches look alike. What is found here serves to propose a
frame; it is never measured with.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Bools, Floats

Gray = NDArray[np.uint8]

_WINDOW = (17, 17)
_LEVELS = 2
_STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 15, 0.05)
_BACK_PX = 1.0  # the way back ends this close to where it began
_ALIKE = 0.7  # normalised correlation of the two patches
_PATCH_PX = 11
_MOST_SPOTS = 40
_PLAIN = 0.6  # a guess that so large a share of the points follows needs no other beside it
_STILL_PX = 0.5


@dataclass(frozen=True, eq=False)
class Step:
    """Where points (N, 2) went on another frame, pixels; `ok` (N,): whether that can be believed."""

    points_px: Floats
    ok: Bools


def reach_px(gray: Gray) -> float:
    """How far from a guess, in pixels, a point is surely found in a picture `gray` (H, W). Own figure: 14 px
    at 640 px of width, twice as far with each level of the pyramid.
    """
    return 14.0 * 2.0 ** (_levels(gray) - _LEVELS)


def find_textured_spots(gray: Gray, box_px: tuple[float, float, float, float]) -> Floats:
    """Spots (N, 2), pixels, of `gray` (H, W) that are worth following in a box (left, top, right, bottom); N
    may be 0.

    Shi and Tomasi 1994, by OpenCV's goodFeaturesToTrack.
    """
    height, width = gray.shape
    left, top = max(int(box_px[0]), 0), max(int(box_px[1]), 0)
    part = gray[top : min(int(box_px[3]) + 1, height), left : min(int(box_px[2]) + 1, width)]
    if min(part.shape) < 3:
        return np.empty((0, 2))
    found = cv2.goodFeaturesToTrack(part, _MOST_SPOTS, 0.02, 5.0)
    if found is None:
        return np.empty((0, 2))
    return np.asarray(np.asarray(found).reshape(-1, 2) + np.array([left, top]), dtype=np.float64)


def follow_points(first: Gray, second: Gray, points_px: Floats, guess_px: Floats) -> Step:
    """The points of the first frame, `points_px` (N, 2), on the second, each searched for round its guess,
    `guess_px` (N, 2), pixels; `first`, `second` (H, W).

    Lucas and Kanade 1981 on pyramids (Bouguet 2000), believed where the way back ends where it began (Kalal
    et al. 2010) and the patches correlate.
    """
    start = np.ascontiguousarray(points_px, dtype=np.float32).reshape(-1, 1, 2)
    there = _flow(first, second, start, guess_px)
    # the way back is told how far it was, and no more
    back = _flow(second, first, there[0], there[0] - (np.asarray(guess_px).reshape(-1, 1, 2) - start))
    away = np.linalg.norm((back[0] - start).reshape(-1, 2), axis=1)
    ends = there[0].reshape(-1, 2).astype(np.float64)
    ok = there[1] & back[1] & (away < _BACK_PX) & _inside(second, ends)
    if ok.any():
        ok[ok] = _correlate_patches(first, second, start.reshape(-1, 2)[ok], ends[ok]) > _ALIKE
    return Step(ends, ok)


def best_guess(
    first: Gray, second: Gray, points_px: Floats, guesses_px: Sequence[Floats]
) -> tuple[int, Step] | None:
    """Of several guesses, `guesses_px` (N, 2) each, the one that most points follow, and where they went;
    `points_px` (N, 2), pixels; `first`, `second` (H, W). Each guess is tried as `follow_points` tries one.

    None where no guess is followed by three points or more. Points that stay where they are belong to the
    road, not to the vehicle, and count for nothing.
    """
    best: tuple[int, Step] | None = None
    for index, guess in enumerate(guesses_px):
        step = follow_points(first, second, points_px, guess)
        moved = np.linalg.norm(step.points_px - points_px, axis=1) > _STILL_PX
        near = np.linalg.norm(step.points_px - guess, axis=1) < 0.35 * _reach(points_px, guess)
        ok = step.ok & moved & near
        if ok.sum() >= 3 and (best is None or ok.sum() > best[1].ok.sum()):
            best = index, Step(step.points_px, ok)
            if ok.sum() >= max(_PLAIN * len(ok), 8):
                break
    return best


def _reach(points_px: Floats, guess_px: Floats) -> Floats:
    return np.asarray(np.maximum(np.linalg.norm(guess_px - points_px, axis=1), 20.0))


def _levels(gray: Gray) -> int:
    """Larger pictures move further: a level more for twice the width."""
    return _LEVELS + max(0, round(float(np.log2(gray.shape[1] / 640.0))))


def _flow(
    first: Gray, second: Gray, start: NDArray[np.float32], guess: NDArray[Any]
) -> tuple[NDArray[np.float32], Bools]:
    """Where the points went and whether they were found; only the strip round them is looked at."""
    guess = np.asarray(guess, dtype=np.float64).reshape(-1, 1, 2)
    both = np.concatenate([start, guess])[:, 0]
    pad = 3.0 * reach_px(first)
    left, top = np.clip(both.min(axis=0) - pad, 0, None).astype(int)
    right, bottom = np.clip(both.max(axis=0) + pad, (left + 32, top + 32), first.shape[::-1]).astype(int)
    part, corner = (slice(top, bottom), slice(left, right)), np.array([left, top], dtype=np.float32)
    if min(first[part].shape) < 32:
        return start, np.zeros(len(start), dtype=bool)
    ends, status, _ = cv2.calcOpticalFlowPyrLK(
        np.ascontiguousarray(first[part]),
        np.ascontiguousarray(second[part]),
        start - corner,
        np.asarray(guess - corner, dtype=np.float32),
        winSize=_WINDOW,
        maxLevel=_levels(first),
        criteria=_STOP,
        flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
    )
    there = np.asarray(ends, dtype=np.float32) + corner
    return there, status.ravel().astype(bool) & np.isfinite(there).all(axis=(1, 2))


def _inside(gray: Gray, points: Floats) -> Bools:
    height, width = gray.shape
    edge = _PATCH_PX / 2
    return np.asarray(((points >= edge) & (points < np.array([width, height]) - edge)).all(axis=1))


def _correlate_patches(first: Gray, second: Gray, a: NDArray[Any], b: NDArray[Any]) -> Floats:
    """Normalised correlation of the patches round a (N, 2) and b (N, 2)."""
    out = np.zeros(len(a))
    size = (_PATCH_PX, _PATCH_PX)
    for i, (p, q) in enumerate(zip(a, b, strict=True)):
        one = cv2.getRectSubPix(first, size, (float(p[0]), float(p[1])))
        two = cv2.getRectSubPix(second, size, (float(q[0]), float(q[1])))
        out[i] = float(cv2.matchTemplate(two, one, cv2.TM_CCOEFF_NORMED)[0, 0])
    return out
