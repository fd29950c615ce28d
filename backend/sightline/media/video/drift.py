"""The background of a picture, found again in another: corners followed to a hundredth of a pixel.

Pictures are brought to local contrast first, so that another exposure or hour of the day is not a motion.
A point counts only where following it forth and back ends where it began and where the small picture around
it is still the same one: vehicles, people and the board fall out there, and in the robust fit.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.drift import Motion, fit_motion
from sightline.media.video.picture import Gray
from sightline.messages.said import Said

_CELLS = (12, 9)
_A_CELL = 4
_QUALITY = 0.01
_WINDOW = 21
_LEVELS = 4
_ROUND_TRIP_PX = 0.3
_ALIKE = 0.6
_CONTRAST_PX = 12.0
_FLAT = 7.0  # grey levels of local deviation that count as one contrast: below, it is noise
_LARGEST_PX = 1280


@dataclass(frozen=True, eq=False)
class Background:
    """What is looked for again: a flattened picture and corners (N, 2) spread over it, in its pixels.

    `scale` is this picture's width over that of the recording; `size_px` is the recording's.
    """

    picture: Gray
    corners: NDArray[np.float32]
    scale: float
    size_px: tuple[int, int]


def mean_of(pictures: Sequence[Gray]) -> Floats:
    """The mean picture, (h, w) float32: less noise, and what moves is smeared."""
    return np.asarray(np.mean([one.astype(np.float32) for one in pictures], axis=0), np.float32)


def background(picture: NDArray[np.generic]) -> Background:
    """The corners of a picture (h, w) that are worth following, at most 432."""
    height, width = picture.shape
    scale = min(1.0, _LARGEST_PX / max(height, width))
    flat = _flattened(picture, scale)
    return Background(flat, _corners(flat), scale, (width, height))


def register(ours: Background, picture: NDArray[np.generic]) -> Motion | Said:
    """How `picture` (h, w) moved against the background, or why it cannot be told."""
    flat = _flattened(picture, ours.scale)
    if flat.shape != ours.picture.shape:
        return Said("drift-other-size")
    if len(ours.corners) == 0:
        return Said("drift-nothing-in-pose-frame")
    before, after = _followed(ours.picture, flat, ours.corners)
    # the centre of the first pixel is (0, 0) at every scale
    return fit_motion(_unscaled(before, ours.scale), _unscaled(after, ours.scale), ours.size_px)


def _unscaled(points: NDArray[np.float32], scale: float) -> Floats:
    return np.asarray((points.astype(np.float64) + 0.5) / scale - 0.5, dtype=np.float64)


def _flattened(picture: NDArray[np.generic], scale: float) -> Gray:
    """Local contrast as 8 bits: 128 is the surroundings' mean."""
    image = np.asarray(picture, np.float32)
    if scale < 1.0:
        size = (round(image.shape[1] * scale), round(image.shape[0] * scale))
        image = np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.float32)
    mean = cv2.GaussianBlur(image, (0, 0), _CONTRAST_PX)
    variance = cv2.GaussianBlur(image * image, (0, 0), _CONTRAST_PX) - mean * mean
    contrast = (image - mean) / (np.sqrt(np.maximum(variance, 0.0)) + _FLAT)
    return np.asarray(np.clip(128.0 + 48.0 * contrast + 0.5, 0, 255), np.uint8)


def _corners(flat: Gray) -> NDArray[np.float32]:
    """The best corners of every cell, so that a board or one tree does not take them all."""
    height, width = flat.shape
    smooth = cv2.GaussianBlur(flat, (0, 0), 1.0)
    strength = np.asarray(cv2.cornerMinEigenVal(smooth, 7), np.float32)
    least = _QUALITY * float(np.percentile(strength, 99.5))
    corners: list[NDArray[np.float32]] = []
    for row in range(_CELLS[1]):
        for column in range(_CELLS[0]):
            mask = np.zeros_like(flat)
            y0, y1 = height * row // _CELLS[1], height * (row + 1) // _CELLS[1]
            x0, x1 = width * column // _CELLS[0], width * (column + 1) // _CELLS[0]
            mask[max(y0, _WINDOW // 2) : min(y1, height - _WINDOW // 2),
                 max(x0, _WINDOW // 2) : min(x1, width - _WINDOW // 2)] = 255  # fmt: skip
            corners += _of_cell(strength, mask, least)
    return np.array(corners, np.float32).reshape(-1, 2)


def _of_cell(strength: NDArray[np.float32], mask: Gray, least: float) -> list[NDArray[np.float32]]:
    """Up to `_A_CELL` corners of one cell, the strongest first, a window's half apart."""
    points: list[NDArray[np.float32]] = []
    rest = np.where(mask > 0, strength, 0.0).astype(np.float32)
    for _ in range(_A_CELL):
        _, value, _, (x, y) = cv2.minMaxLoc(rest)
        if value <= least:
            break
        points.append(np.array([x, y], np.float32))
        cv2.circle(rest, (int(x), int(y)), _WINDOW // 2, 0.0, -1)
    return points


def _followed(
    ours: Gray, theirs: Gray, corners: NDArray[np.float32]
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """The corners that were found again, (N, 2) before and after."""
    how = {
        "winSize": (_WINDOW, _WINDOW),
        "maxLevel": _LEVELS,
        "criteria": (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 60, 0.001),
    }
    start = corners.reshape(-1, 1, 2)
    there, found, _ = cv2.calcOpticalFlowPyrLK(ours, theirs, start, None, **how)  # type: ignore[call-overload]
    back, again, _ = cv2.calcOpticalFlowPyrLK(theirs, ours, there, None, **how)  # type: ignore[call-overload]
    after = there.reshape(-1, 2)
    trip = np.linalg.norm(back.reshape(-1, 2) - corners, axis=1)
    fine = (found.ravel() == 1) & (again.ravel() == 1) & (trip < _ROUND_TRIP_PX)
    fine &= np.isfinite(after).all(axis=1)
    fine[fine] = [_is_same_patch(ours, theirs, a, b) for a, b in zip(corners[fine], after[fine], strict=True)]
    return corners[fine], after[fine]


def _is_same_patch(ours: Gray, theirs: Gray, before: NDArray[np.float32], after: NDArray[np.float32]) -> bool:
    """Whether the small pictures around the two points are the same one, by their correlation."""
    size = (_WINDOW, _WINDOW)
    one = cv2.getRectSubPix(ours, size, (float(before[0]), float(before[1])))
    two = cv2.getRectSubPix(theirs, size, (float(after[0]), float(after[1])))
    return float(cv2.matchTemplate(one, two, cv2.TM_CCOEFF_NORMED)[0, 0]) > _ALIKE
