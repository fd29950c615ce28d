"""What stands before the road as boxes, without the shadow and the light that it throws on the road."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from backend.media.passes_background import Mask

LEAST_AREA_SHARE = 0.004
LOW_SHARE = 0.32
GAP_PX = 8
LEAST_WIDTH_PX = 3
STACKED_SHARE = 0.7
STACKED_GAP_PX = 8


@dataclass(frozen=True)
class Box:
    """A rectangle of the reduced picture, pixels, `x1` and `y1` exclusive; `area_px` of it is not road."""

    x0: float
    y0: float
    x1: float
    y1: float
    area_px: float

    @property
    def width(self) -> float:
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        return self.y1 - self.y0

    @property
    def middle(self) -> tuple[float, float]:
        return (self.x0 + self.x1) / 2, (self.y0 + self.y1) / 2

    def moved(self, dx: float, dy: float) -> Box:
        return Box(self.x0 + dx, self.y0 + dy, self.x1 + dx, self.y1 + dy, self.area_px)


def common(one: Box, other: Box) -> float:
    """Area that two boxes share, px^2."""
    across = min(one.x1, other.x1) - max(one.x0, other.x0)
    down = min(one.y1, other.y1) - max(one.y0, other.y0)
    return max(0.0, across) * max(0.0, down)


def boxes_of(mask: Mask, solid: Mask) -> list[Box]:
    """The things in a foreground mask, largest first; `solid` is what of it is no light on the road.

    A shadow lies flat on the road: columns in which little stands are cut off at both ends, and where they
    run through the middle, two vehicles are told apart.
    """
    least = LEAST_AREA_SHARE * mask.size
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
    found = []
    for label, (x, y, w, h, area) in enumerate(stats):
        if label == 0 or area < least:
            continue
        part = (labels[y : y + h, x : x + w] == label) & (solid[y : y + h, x : x + w] > 0)
        found += _upright(part, int(x), int(y))
    found = _stacked(sorted(found, key=lambda box: -box.area_px))
    return [box for box in found if box.area_px >= least]


def _upright(part: NDArray[np.bool_], x: int, y: int) -> list[Box]:
    """Runs of columns that reach high enough, gaps of a few columns bridged; areas from top to bottom."""
    rows = part.shape[0]
    any_there = part.any(axis=0)
    top, bottom = part.argmax(axis=0), rows - part[::-1].argmax(axis=0)
    height = np.where(any_there, bottom - top, 0)
    high = np.flatnonzero(height >= max(2.0, LOW_SHARE * height.max()))
    boxes = []
    for run in np.split(high, np.flatnonzero(np.diff(high) > GAP_PX) + 1):
        if len(run) >= LEAST_WIDTH_PX:
            y0, y1 = y + int(top[run].min()), y + int(bottom[run].max())
            boxes.append(Box(x + int(run[0]), y0, x + int(run[-1]) + 1, y1, float(height[run].sum())))
    return boxes


def _stacked(boxes: Sequence[Box]) -> list[Box]:
    """Boxes with what stands on them: dark glass before a dark wall leaves a roof that hangs in the air."""
    kept: list[Box] = []
    for box in boxes:
        for index, below in enumerate(kept):
            if _stands_on(box, below):
                kept[index] = united([box, below])
                break
        else:
            kept.append(box)
    return kept


def _stands_on(box: Box, other: Box) -> bool:
    across = min(box.x1, other.x1) - max(box.x0, other.x0)
    gap = max(box.y0, other.y0) - min(box.y1, other.y1)
    return across >= STACKED_SHARE * box.width and gap <= STACKED_GAP_PX


def united(boxes: Sequence[Box]) -> Box:
    """The smallest box around all."""
    return Box(
        min(box.x0 for box in boxes),
        min(box.y0 for box in boxes),
        max(box.x1 for box in boxes),
        max(box.y1 for box in boxes),
        sum(box.area_px for box in boxes),
    )
