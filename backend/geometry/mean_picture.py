"""The mean picture of the frames in which a board stands still: its noise averages out before corners are
fitted.
"""

import cv2
import numpy as np

from backend.geometry.arrays import Floats
from backend.geometry.corners import Corners, Gray
from backend.geometry.stillness import STILL_PX, displacement_px


class MeanPicture:
    """Collects frames in time order and keeps the longest stretch in which the board did not move."""

    def __init__(self) -> None:
        self._sum: Floats | None = None
        self._count = 0
        self._at: Floats | None = None
        self._best: tuple[int, Floats] | None = None

    def add(self, gray: Gray, corners: Corners) -> None:
        """One frame and the board found in it; a board that moved begins a new stretch."""
        points = corners.points_px.reshape(-1, 2)
        still = (
            self._sum is not None
            and self._at is not None
            and self._sum.shape == gray.shape
            and self._at.shape == points.shape
            and displacement_px(points - self._at, self._at) <= STILL_PX
        )
        if not still:
            self._keep()
            self._sum, self._count, self._at = np.zeros(gray.shape), 0, points
        assert self._sum is not None
        cv2.accumulate(gray, self._sum)
        self._count += 1

    def _keep(self) -> None:
        if self._sum is not None and (self._best is None or self._count > self._best[0]):
            self._best = (self._count, self._sum / self._count)

    def result(self) -> Floats | None:
        """The mean picture (H, W) of the longest stretch, None where no frame was added."""
        self._keep()
        return None if self._best is None else self._best[1]
