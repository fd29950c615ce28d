"""Which way each part of the picture goes: vehicles that meet are one shape before the road, but go apart."""

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Small

Flow = NDArray[np.float32]
Ways = NDArray[np.int8]

LEAST_STEP_PX = 0.6
SMOOTH_PX = 7
MEETING_SHARE = 0.06
SURE = 4.0
SURE_SHARE = 0.3


class Motion:
    """Optical flow from picture to picture: dense inverse search (Kroeger et al. 2016), a quarter size."""

    def __init__(self) -> None:
        self._search = cv2.DISOpticalFlow.create(cv2.DISOPTICAL_FLOW_PRESET_ULTRAFAST)

    def between(self, last: Small, small: Small) -> Flow:
        """Where each pixel of `last` went in `small`, (h, w) both: (h, w, 2) pixels right and down."""
        blank = np.zeros((*last.shape, 2), np.float32)
        return np.asarray(self._search.calc(last, small, blank), np.float32)


def ways_of(flow: Flow, part: NDArray[np.bool_]) -> tuple[int, Ways | None]:
    """Which way a shape goes: 1 right (or down), -1 left (or up), 0 unknown; where two go through one shape,
    0 and the way (h, w) of each pixel.

    `flow` (h, w, 2), pixels, and `part` (h, w) cover the same rectangle; the axis is the one along which
    there is more motion. Own method: a vote of the pixels that move by LEAST_STEP_PX, two ways where the
    fewer are MEETING_SHARE of the shape (DECISIONS.md 23).
    """
    inside = np.abs(flow[part]).sum(axis=0)
    along = flow[..., 0] if inside[0] >= inside[1] else flow[..., 1]
    signs = np.where(part & (np.abs(along) > LEAST_STEP_PX), np.sign(along), 0).astype(np.float32)
    there, back = int((signs > 0).sum()), int((signs < 0).sum())
    area = int(part.sum())
    more, less = max(there, back), min(there, back)
    if less < MEETING_SHARE * area:
        sure = more >= max(SURE * less, SURE_SHARE * area)
        return (1 if there > back else -1) if sure else 0, None
    smooth = cv2.boxFilter(signs, -1, (SMOOTH_PX, SMOOTH_PX), normalize=True)
    return 0, np.where(part, np.sign(smooth), 0).astype(np.int8)
