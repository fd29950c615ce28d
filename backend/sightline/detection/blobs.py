"""What stands before the road as boxes, without the shadow and the light that it throws on the road."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Mask
from sightline.detection.flow import LEAST_STEP_PX, Flow, ways_of

LEAST_AREA_SHARE = 0.004
LOW_SHARE = 0.32
GAP_PX = 8
LEAST_WIDTH_PX = 3
STACKED_SHARE = 0.7
STACKED_GAP_PX = 8
TOUCH_PX = 4


@dataclass(frozen=True)
class Box:
    """A rectangle of the reduced picture, pixels, `x1` and `y1` exclusive; `area_px` of it is not road.

    `way` is 1 or -1 where it is known which way it goes, `step_px` how far to the right since the picture
    before (None: not known). `hidden` are the edges (0: left, 1: right) at which something nearer covers it,
    so that it may reach farther.
    """

    x0: float
    y0: float
    x1: float
    y1: float
    area_px: float
    way: int = 0
    step_px: float | None = None
    hidden: tuple[int, ...] = ()

    @property
    def width(self) -> float:
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        return self.y1 - self.y0

    @property
    def middle(self) -> tuple[float, float]:
        return (self.x0 + self.x1) / 2, (self.y0 + self.y1) / 2


def intersection_area(box: Box, other: Box) -> float:
    """Area that two boxes share, px^2."""
    across = min(box.x1, other.x1) - max(box.x0, other.x0)
    down = min(box.y1, other.y1) - max(box.y0, other.y0)
    return max(0.0, across) * max(0.0, down)


def boxes_of(mask: Mask, solid: Mask, flow: Flow | None = None) -> list[Box]:
    """The things in a foreground, largest first, in pixels: `mask`, `solid` (h, w); `solid` is what of it is
    no light on the road.

    A shadow lies flat on the road: columns in which little stands are cut off at both ends, and where they
    run through the middle, two vehicles are told apart. `flow` (h, w, 2), pixels, tells apart those that
    meet. Own method: connected shapes, cut where the columns are lower than LOW_SHARE of the highest
    (DECISIONS.md 23).
    """
    least = LEAST_AREA_SHARE * mask.size
    boxes: list[Box] = []
    for (x, y, w, h), shape in _shapes(mask > 0, least):
        part = shape & (solid[y : y + h, x : x + w] > 0)
        if flow is None or not part.any():
            boxes += _upright(part, x, y)
            continue
        way, ways = ways_of(flow[y : y + h, x : x + w], shape & _keep_enclosed(part))
        if ways is None:
            boxes += [_going(box, way, flow) for box in _upright(part, x, y)]
        else:
            parts = {side: _parts(ways == side, x, y, least) for side in (1, -1)}
            boxes += _meeting({side: [_going(box, side, flow) for box in parts[side]] for side in parts})
    found = _stacked(sorted(boxes, key=lambda box: -box.area_px))
    return [box for box in found if box.area_px >= least]


def _keep_enclosed(part: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """What has something of the part above and below it: a bright side is no light on the road."""
    down = np.logical_or.accumulate(part, axis=0)
    up = np.logical_or.accumulate(part[::-1], axis=0)[::-1]
    return np.asarray(down & up, np.bool_)


def _shapes(
    mask: NDArray[np.bool_], least: float
) -> list[tuple[tuple[int, int, int, int], NDArray[np.bool_]]]:
    """Connected shapes of at least so many pixels: (x, y, width, height) and the shape in there."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8), connectivity=8)
    shapes = []
    for label, (x, y, w, h, area) in enumerate(stats):
        if label and area >= least:
            place = int(x), int(y), int(w), int(h)
            shapes.append((place, np.asarray(labels[y : y + h, x : x + w] == label, np.bool_)))
    return shapes


def _parts(mask: NDArray[np.bool_], x: int, y: int, least: float) -> list[Box]:
    """Boxes of what goes one way."""
    shapes = _shapes(mask, least)
    return [box for (dx, dy, _, _), part in shapes for box in _upright(part, x + dx, y + dy)]


def _going(box: Box, way: int, flow: Flow) -> Box:
    """The box with its motion: the median of what goes its way in it."""
    along = flow[int(box.y0) : int(box.y1), int(box.x0) : int(box.x1), 0]
    steps = along[along * way > LEAST_STEP_PX]
    return replace(box, way=way, step_px=float(np.median(steps)) if steps.size else None)


def _meeting(ways: dict[int, list[Box]]) -> list[Box]:
    """Boxes that meet; the nearer one, whose foot is lower, hides edges of the other that it touches."""
    all_boxes = []
    for way, boxes in ways.items():
        for box in boxes:
            nearer = [other for other in ways[-way] if other.y1 > box.y1]
            edges = tuple(
                i
                for i, at in enumerate((box.x0, box.x1))
                if any(other.x0 - TOUCH_PX <= at <= other.x1 + TOUCH_PX for other in nearer)
            )
            all_boxes.append(replace(box, hidden=edges))
    return all_boxes


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
                kept[index] = bounding_union([box, below])
                break
        else:
            kept.append(box)
    return kept


def _stands_on(box: Box, other: Box) -> bool:
    if box.way * other.way < 0:
        return False
    across = min(box.x1, other.x1) - max(box.x0, other.x0)
    gap = max(box.y0, other.y0) - min(box.y1, other.y1)
    return across >= STACKED_SHARE * box.width and gap <= STACKED_GAP_PX


def bounding_union(boxes: Sequence[Box]) -> Box:
    """The smallest box around all."""
    left, right = min(boxes, key=lambda box: box.x0), max(boxes, key=lambda box: box.x1)
    ways = {box.way for box in boxes} - {0}
    return Box(
        x0=left.x0,
        y0=min(box.y0 for box in boxes),
        x1=right.x1,
        y1=max(box.y1 for box in boxes),
        area_px=sum(box.area_px for box in boxes),
        way=ways.pop() if len(ways) == 1 else 0,
        step_px=max(boxes, key=lambda box: box.area_px).step_px,
        hidden=tuple(edge for edge, box in enumerate((left, right)) if edge in box.hidden),
    )
