"""The pass finder that a library gives: OpenCV's MOG2 or KNN, blobs, SciPy's assignment. A thing to beat.

Shapes before the learned background are joined to tracks by the cheapest assignment of boxes from frame to
frame; a track that crosses a good part of the picture is a pass.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import cv2
import numpy as np
from scipy.optimize import linear_sum_assignment

from sightline.detection.classify import FoundPass
from sightline.media.video.decode import frames_of

Method = Literal["mog2", "knn"]
WIDTH_PX = 320
LEAST_AREA_SHARE = 0.004
LEAST_TRAVEL_SHARE = 0.25
MOST_GAP_FRAMES = 12
LEAST_SIGHTS = 6
FAR = 1.0

Box = tuple[float, float, float, float]


@dataclass
class Track:
    """Boxes (left, top, right, bottom) of one shape by frame."""

    boxes: dict[int, Box] = field(default_factory=dict)
    step: float = 0.0

    @property
    def last(self) -> int:
        return max(self.boxes)

    def expected(self, frame: int) -> Box:
        """The last box, moved on as fast as it went."""
        left, top, right, bottom = self.boxes[self.last]
        shift = self.step * (frame - self.last)
        return left + shift, top, right + shift, bottom

    def add(self, frame: int, box: Box) -> None:
        if self.boxes:
            before = self.boxes[self.last]
            moved = (box[0] + box[2] - before[0] - before[2]) / 2 / (frame - self.last)
            self.step = 0.7 * self.step + 0.3 * moved if len(self.boxes) > 1 else moved
        self.boxes[frame] = box


def distance(a: Box, b: Box) -> float:
    """1 minus the overlap of two boxes over their union; 1 where they do not meet."""
    width, height = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    if width <= 0 or height <= 0:
        return FAR
    both = (a[2] - a[0]) * (a[3] - a[1]) + (b[2] - b[0]) * (b[3] - b[1]) - width * height
    return 1 - width * height / both


def shapes(mask: np.ndarray) -> list[Box]:
    """Boxes of what stands before the background, from a mask with shadows at 127."""
    solid = cv2.threshold(mask, 200, 255, cv2.THRESH_BINARY)[1]
    solid = cv2.morphologyEx(solid, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    solid = cv2.morphologyEx(solid, cv2.MORPH_CLOSE, np.ones((9, 9), np.uint8))
    _, _, found, _ = cv2.connectedComponentsWithStats(solid)
    least = LEAST_AREA_SHARE * mask.size
    return [(x, y, x + w, y + h) for x, y, w, h, area in found[1:] if area >= least]


def follow(tracks: list[Track], boxes: list[Box], frame: int) -> None:
    """Give each box to the track that expects it; what is left begins a track."""
    alive = [track for track in tracks if frame - track.last <= MOST_GAP_FRAMES]
    left = set(range(len(boxes)))
    if alive and boxes:
        cost = np.array([[distance(track.expected(frame), box) for box in boxes] for track in alive])
        for row, column in zip(*linear_sum_assignment(cost), strict=True):
            if cost[row, column] < FAR:
                alive[row].add(frame, boxes[column])
                left.discard(int(column))
    for index in left:
        tracks.append(Track())
        tracks[-1].add(frame, boxes[index])


def find_passes(path: Path, method: Method) -> tuple[list[FoundPass], int]:
    """The passes of a video, and its number of frames."""
    model = (
        cv2.createBackgroundSubtractorMOG2(history=500, varThreshold=25, detectShadows=True)
        if method == "mog2"
        else cv2.createBackgroundSubtractorKNN(history=500, dist2Threshold=400, detectShadows=True)
    )
    tracks: list[Track] = []
    frame, width = -1, WIDTH_PX
    for frame, _, picture in frames_of(path):
        height = round(picture.shape[0] * WIDTH_PX / picture.shape[1])
        small = cv2.resize(picture, (WIDTH_PX, height), interpolation=cv2.INTER_AREA)
        follow(tracks, shapes(model.apply(small)), frame)
    return [found for track in tracks if (found := as_pass(track, width)) is not None], frame + 1


def as_pass(track: Track, width: int) -> FoundPass | None:
    """A track as a pass, None where it goes nowhere."""
    first, last = min(track.boxes), track.last
    middle = {n: (box[0] + box[2]) / 2 for n, box in track.boxes.items()}
    travel = middle[last] - middle[first]
    if len(track.boxes) < LEAST_SIGHTS or abs(travel) < LEAST_TRAVEL_SHARE * width:
        return None
    best = min(middle, key=lambda n: abs(middle[n] - width / 2))
    return FoundPass(
        first_frame=first,
        last_frame=last,
        best_frame=best,
        direction="right" if travel > 0 else "left",
        whole=False,
        score=1.0,
        sharpness=0.0,
        luminance=0.0,
        boxes=(),
    )
