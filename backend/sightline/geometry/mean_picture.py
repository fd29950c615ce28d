"""The mean picture of frames in which a board stands still: noise averages out before corners are fitted."""

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.corners import Corners, Gray
from sightline.geometry.stillness import STILL_PX, displaced_px, smooth_basis

_MARGIN_PX = 14  # a saddle fit reaches 9 px from a corner


def _box_of(points: Floats, shape: tuple[int, ...]) -> tuple[slice, slice]:
    """Rows and columns of the picture that hold the board's corners with a margin."""
    low = np.maximum(np.floor(points.min(axis=0)).astype(int) - _MARGIN_PX, 0)
    high = np.ceil(points.max(axis=0)).astype(int) + _MARGIN_PX + 1
    return slice(int(low[1]), min(int(high[1]), shape[0])), slice(int(low[0]), min(int(high[0]), shape[1]))


class MeanPicture:
    """Collects frames in time order and keeps the longest stretch in which the board did not move."""

    def __init__(self) -> None:
        self._sum: NDArray[np.float32] | None = None
        self._count = 0
        self._at: Floats | None = None
        self._basis: Floats = np.empty((0, 3))
        self._box = (slice(0), slice(0))
        self._shape = (0, 0)
        self._best: tuple[int, Floats] | None = None

    def add(self, gray: Gray, corners: Corners) -> None:
        """One frame, `gray` (H, W), and the board found in it; a board that moved begins a new stretch."""
        points = corners.points_px.reshape(-1, 2)
        still = (
            self._sum is not None
            and self._at is not None
            and self._shape == gray.shape
            and self._at.shape == points.shape
            and displaced_px((points - self._at)[None], self._basis)[0] <= STILL_PX
        )
        if not still:
            self._keep()
            self._box, self._shape = _box_of(points, gray.shape), gray.shape
            self._sum, self._count, self._at = np.zeros(gray[self._box].shape, np.float32), 0, points
            self._basis = smooth_basis(points)
        assert self._sum is not None
        cv2.accumulate(gray[self._box], self._sum)
        self._count += 1

    def _keep(self) -> None:
        if self._sum is not None and (self._best is None or self._count > self._best[0]):
            mean = np.zeros(self._shape)
            mean[self._box] = self._sum / self._count
            self._best = (self._count, mean)

    def result(self) -> Floats | None:
        """The mean picture (H, W) of the longest stretch, None where no frame was added."""
        self._keep()
        return None if self._best is None else self._best[1]
