"""Which tracks are vehicles that went by, from which frame to which, and where each is seen best."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sightline.detection.blobs import Box
from sightline.detection.stitch import course, enters, leaves
from sightline.detection.tracks import Detection, Track
from sightline.enums import Direction

LEAST_TRAVEL_SHARE = 0.2
LEAST_AREA_SHARE = 0.012
LEAST_AREA_SHARE_FAR = 0.005  # of what goes by straight for long: a road seen from above
LEAST_SIGHTS = 4
LEAST_SIGHTS_DOWN = 10
LEAST_SIGHTS_WITHIN = 15
LEAST_STRAIGHTNESS = 0.6
LEAST_STRAIGHTNESS_DOWN = 0.85  # of what goes down where the traffic goes across
LEAST_STRAIGHTNESS_WITHIN = 0.9
NARROWEST = 1.15  # width over height of what goes across: less is somebody on foot, or several
SHORTEST = 0.65  # height over width of what goes down or up
BORDER_PX = 1.0
SHARP_WEIGHT = 0.1
SHOWN_WEIGHT = 0.3
CLEAR_PX = 4.0
STEPS = 8

Sharpness = Callable[[int, Box], float]


@dataclass(frozen=True)
class FoundPass:
    """One vehicle going by: its span, the way it goes in the picture, and the frame to measure it on.

    `boxes` are (frame, x0, y0, x1, y1) of a few frames in pixels of the upright picture; `whole` says
    whether all of the vehicle is in view on `best_frame`; `score` is 0 to 1, `sharpness` the mean grey
    step between neighbouring pixels of the vehicle there, `luminance` the mean of the picture, 0-255.
    """

    first_frame: int
    last_frame: int
    best_frame: int
    direction: Direction | None
    whole: bool
    score: float
    sharpness: float
    luminance: float
    boxes: tuple[tuple[int, float, float, float, float], ...]


@dataclass(frozen=True)
class View:
    """Size of the reduced picture, its scale to the upright one, where the camera looks square at the road (a
    fraction of the width), and whether rows and columns were exchanged.
    """

    width: int
    height: int
    scale: float
    square_at: float = 0.5
    turned: bool = False

    @property
    def size(self) -> tuple[int, int]:
        return self.width, self.height


def is_vehicle(track: Track, view: View) -> bool:
    """Whether it went by, straight, large enough, and not as narrow as somebody on foot."""
    sights = _seen_detections(track)
    way = course(track, view.size) if len(sights) >= LEAST_SIGHTS else None
    if way is None or abs(way.far_px) < LEAST_TRAVEL_SHARE * view.size[way.axis]:
        return False
    straight = straightness(track, way.axis)
    if not (enters(track, view.size) or leaves(track, view.size)):
        if len(sights) < LEAST_SIGHTS_WITHIN or straight < LEAST_STRAIGHTNESS_WITHIN:
            return False
    elif straight < (LEAST_STRAIGHTNESS_DOWN if way.axis else LEAST_STRAIGHTNESS):
        return False
    if (way.axis == 1 or view.turned) and len(sights) < LEAST_SIGHTS_DOWN:
        return False
    sure = len(sights) >= LEAST_SIGHTS_WITHIN and straight >= LEAST_STRAIGHTNESS_WITHIN
    least = LEAST_AREA_SHARE_FAR if sure else LEAST_AREA_SHARE
    if max(detection.box.area_px for detection in sights) < least * view.width * view.height:
        return False
    across = way.axis == 0 and not view.turned
    return _breadth(sights, view, way.axis) >= (NARROWEST if across else SHORTEST)


def _breadth(seen: list[Detection], view: View, axis: int) -> float:
    """Length along its way over what lies across: the middle of sights with all of it, else the largest."""
    shapes = [one.box.height / one.box.width if axis else one.box.width / one.box.height for one in seen]
    whole = [shape for one, shape in zip(seen, shapes, strict=True) if one.clear and is_whole(one.box, view)]
    return float(np.median(whole)) if len(whole) >= LEAST_SIGHTS else max(shapes)


def score_of(track: Track, whole: bool, view: View) -> float:
    """How much speaks for a vehicle, 0 to 1: straight, driven in and out at the borders, seen whole."""
    marks = enters(track, view.size), leaves(track, view.size), whole
    return round(0.4 * straightness(track, course(track, view.size).axis) + 0.2 * sum(marks), 3)


def straightness(track: Track, axis: int) -> float:
    """Net way of the middle along an axis over the way it went, 0 to 1: what flickers stays where it is.

    Looked at in a few steps, for what is hidden in part makes the middle jump.
    """
    middles = [detection.box.middle[axis] for detection in _seen_detections(track)]
    picked = [middles[i] for i in sorted({round(at) for at in np.linspace(0, len(middles) - 1, STEPS)})]
    went = sum(abs(b - a) for a, b in pairwise(picked))
    return abs(picked[-1] - picked[0]) / went if went else 0.0


def direction_of(track: Track, view: View) -> Direction | None:
    """Which way it goes in the picture; None for one that drives away from the camera or towards it."""
    way = course(track, view.size)
    if way.axis != int(view.turned):
        return None
    return "right" if way.far_px > 0 else "left"


def is_whole(box: Box, view: View) -> bool:
    """Whether nothing of it is cut off by the picture's border."""
    return _margin_px(box, view) >= BORDER_PX


def _margin_px(box: Box, view: View) -> float:
    """How far it stays from the picture's border."""
    return min(box.x0, box.y0, view.width - box.x1, view.height - box.y1)


def best_detection(track: Track, view: View, sharpness: Sharpness) -> tuple[Detection, bool]:
    """The sight to measure on: whole in view, near where the camera looks square at the road, and sharp.

    A vehicle that is never whole is taken where least of it is cut off.
    """
    sights = [detection for detection in _seen_detections(track) if detection.clear] or _seen_detections(
        track
    )
    whole = [detection for detection in sights if detection.clear and is_whole(detection.box, view)]
    sharp = {detection.n: sharpness(detection.n, detection.box) for detection in whole or sights}
    most = max(sharp.values()) or 1.0

    largest = max(detection.box.area_px for detection in whole or sights)

    def worth(detection: Detection) -> float:
        off = abs(detection.box.middle[0] / view.width - view.square_at)
        shown = detection.box.area_px / largest - max(0.0, 1.0 - _margin_px(detection.box, view) / CLEAR_PX)
        return SHARP_WEIGHT * sharp[detection.n] / most + SHOWN_WEIGHT * shown - off

    if whole:
        return max(whole, key=worth), True
    return max(sights, key=lambda one: one.box.area_px / largest + worth(one)), False


def _seen_detections(track: Track) -> list[Detection]:
    return [detection for detection in track.detections if detection.seen]
