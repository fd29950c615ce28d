"""Finding the vehicle passes of a recording: every picture once, first to last, in bounded memory.

Luminance is reduced to `WIDTH_PX`; what stands before the empty road is followed from frame to frame; a
track that goes by is a pass. The road of a moment is known only when some seconds after it have been
seen, so pictures wait in a queue until then.
"""

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import WINDOW_S, Background, Sampler, Small, foreground, gain_of
from sightline.detection.blobs import LEAST_AREA_SHARE, Box, boxes_of
from sightline.detection.classify import FoundPass, View, best_detection, direction_of, is_vehicle, score_of
from sightline.detection.flow import LEAST_STEP_PX, Flow, Motion
from sightline.detection.long_vehicles import FullPicture, join_long_vehicles
from sightline.detection.steadiness import WIDTH_PX as STEADY_PX
from sightline.detection.steadiness import Steadiness, Transform, Wander, map_back, warp_onto_first
from sightline.detection.stitch import stitch_tracks
from sightline.detection.tracks import Detection, Track, Tracker

WIDTH_PX = 160
SHARP_PX = 40
CHUNK_S = 3.0
LAPSE_S = 0.4
BOXES_KEPT = 7


@dataclass(frozen=True, eq=False)
class Downsampled:
    """Frame n, small: luminance (h, w), the mean grey step between neighbours (h', w'), mean luminance, and
    what tells whether the camera stands: `wide`, STEADY_PX across.
    """

    n: int
    small: Small
    sharp: Small
    luminance: float
    wide: Small


def downsample(n: int, gray: Small) -> Downsampled:
    """Frame n, small; `gray` (height_px, width_px) is its luminance, 8 bits.

    Own method: means of areas (OpenCV's INTER_AREA) of the picture and of its steps from pixel to pixel along
    the rows.
    """
    height, width = gray.shape
    wide = _reduced(gray, STEADY_PX)
    small = _reduced(gray, WIDTH_PX)
    rows = np.ascontiguousarray(gray[::4])
    steps = cv2.absdiff(rows[:, 1:], rows[:, :-1])
    size = (SHARP_PX, max(1, round(SHARP_PX * height / width)))
    sharp = np.asarray(cv2.resize(steps, size, interpolation=cv2.INTER_AREA), np.uint8)
    return Downsampled(n, small, sharp, float(cv2.mean(small)[0]), wide)


def _reduced(gray: Small, most_px: int) -> Small:
    height, width = gray.shape
    w = min(most_px, width)
    h = max(1, round(height * w / width))
    return np.asarray(cv2.resize(gray, (w, h), interpolation=cv2.INTER_AREA), np.uint8)


class PassFinder:
    """Takes reduced pictures in order, one frame in `stride`; `finish` gives the passes."""

    def __init__(
        self,
        size_px: tuple[int, int],
        rate_hz: float,
        stride: int = 1,
        square_at: float = 0.5,
        turned: bool = False,
    ) -> None:
        """`turned`: the pictures come with rows and columns exchanged, for the traffic runs down them."""
        width_px, height_px = size_px
        w = min(WIDTH_PX, width_px)
        self._view = View(w, max(1, round(height_px * w / width_px)), width_px / w, square_at, turned)
        self._ahead = max(1, round(WINDOW_S * rate_hz / stride))
        self._chunk = max(1, round(CHUNK_S * rate_hz / stride))
        self._lapse = max(3, round(LAPSE_S * rate_hz))
        self._sampler = Sampler(rate_hz / stride)
        self._tracker = Tracker(self._view.width, self._view.height, rate_hz)
        self._waiting: deque[Downsampled] = deque()
        # what is remembered of frames after their pictures are gone
        self._sharp: dict[int, Small] = {}
        self._luminance: dict[int, float] = {}
        self._place: dict[int, Transform] = {}
        self._gain = 1.0
        self._motion = Motion()
        self._before: Small | None = None
        self._steadiness = Steadiness(rate_hz / stride)
        self._went = np.zeros(2)
        self._full = FullPicture(rate_hz)

    @property
    def wander(self) -> Wander:
        """How far the camera wandered so far."""
        return self._steadiness.wander()

    @property
    def runs_down(self) -> bool:
        """Whether what moves goes down or up these pictures rather than across."""
        return bool(self._went[1] > self._went[0])

    def offer(self, picture: Downsampled) -> None:
        """The next picture."""
        place = self._steadiness.place(picture.wide)
        picture = replace(picture, wide=picture.wide[:0])
        if place is not None:
            self._place[picture.n] = place
            picture = replace(picture, small=warp_onto_first(picture.small, place))
        self._sampler.offer(picture.small)
        self._waiting.append(picture)
        if len(self._waiting) >= self._ahead + self._chunk:
            self._look(self._chunk)

    def finish(self) -> tuple[FoundPass, ...]:
        """All passes, when there are no more pictures."""
        self._look(len(self._waiting))
        tracks = stitch_tracks(self._tracker.finish(), self._view.size, self._lapse)
        found = [self._make_pass(track) for track in tracks if is_vehicle(track, self._view)]
        found = join_long_vehicles(found, self._full.spans(), self._view)
        return tuple(sorted(found, key=lambda one: (one.first_frame, one.last_frame)))

    def _look(self, count: int) -> None:
        """Follow what moves on the oldest pictures."""
        road = self._sampler.background()
        for _ in range(count):
            picture = self._waiting.popleft()
            boxes = [box for box in self._boxes(picture, road) if self._in_view(picture.n, box)]
            self._before = picture.small
            self._tracker.step(picture.n, boxes)
            if boxes:
                self._sharp[picture.n] = picture.sharp
                self._luminance[picture.n] = picture.luminance

    def _boxes(self, picture: Downsampled, road: Background) -> list[Box]:
        small = picture.small
        self._gain = gain_of(small, road, self._gain)
        mask, solid = foreground(small, road, self._gain)
        moving = self._before is not None and cv2.countNonZero(mask) >= LEAST_AREA_SHARE * mask.size
        flow = self._motion.between(small, self._before) if moving and self._before is not None else None
        if flow is not None and self._before is not None:
            self._count_way(flow, solid)
            self._full.see(picture.n, -flow, small, self._before)
        return boxes_of(mask, solid, None if flow is None else -flow)

    def _count_way(self, flow: Flow, solid: Small) -> None:
        """Add up how far what stands before the road went, across and down."""
        moved = np.abs(flow[solid > 0])
        self._went += moved[moved.max(axis=1, initial=0.0) > LEAST_STEP_PX].sum(axis=0)

    def _make_pass(self, track: Track) -> FoundPass:
        best, whole = best_detection(track, self._view, self._sharpness)
        return FoundPass(
            first_frame=track.detections[0].n,
            last_frame=max(detection.n for detection in track.detections if detection.seen),
            best_frame=best.n,
            direction=direction_of(track, self._view),
            whole=whole,
            score=score_of(track, whole, self._view),
            sharpness=round(self._sharpness(best.n, best.box), 2),
            luminance=round(self._luminance.get(best.n, 0.0), 1),
            boxes=tuple(self._box(detection) for detection in _spread_detections(track.detections, best)),
        )

    def _box(self, detection: Detection) -> tuple[int, float, float, float, float]:
        """In pixels of the upright picture."""
        edges = np.clip(self._as_seen(detection.n, detection.box), 0, (*self._view.size, *self._view.size))
        x0, y0, x1, y1 = (round(float(v) * self._view.scale, 1) for v in edges)
        return (detection.n, y0, x0, y1, x1) if self._view.turned else (detection.n, x0, y0, x1, y1)

    def _in_view(self, n: int, box: Box) -> bool:
        """Whether its middle lies in frame n itself: beside a picture that was moved is nothing to see."""
        if n not in self._place:
            return True
        x0, y0, x1, y1 = self._as_seen(n, box)
        return 0 <= x0 + x1 <= 2 * self._view.width and 0 <= y0 + y1 <= 2 * self._view.height

    def _as_seen(self, n: int, box: Box) -> tuple[float, float, float, float]:
        """Where a box of the steadied picture lies on frame n itself, x0, y0, x1, y1."""
        place = self._place.get(n)
        if place is None:
            return box.x0, box.y0, box.x1, box.y1
        w = self._view.width
        (x0, y0), (x1, y1) = map_back(place, box.x0 / w, box.y0 / w), map_back(place, box.x1 / w, box.y1 / w)
        return w * x0, w * y0, w * x1, w * y1

    def _sharpness(self, n: int, box: Box) -> float:
        sharp = self._sharp.get(n)
        if sharp is None:
            return 0.0
        k = sharp.shape[1] / self._view.width
        left, top, right, bottom = (v * k for v in self._as_seen(n, box))
        x0, y0 = max(0, int(left)), max(0, int(top))
        part: NDArray[np.uint8] = sharp[y0 : max(y0 + 1, round(bottom)), x0 : max(x0 + 1, round(right))]
        return float(part.mean()) if part.size else 0.0


def _spread_detections(detections: list[Detection], best: Detection) -> Iterator[Detection]:
    """A few sights spread over the track, the best among them."""
    picked = {round(i) for i in np.linspace(0, len(detections) - 1, BOXES_KEPT)}
    for index, detection in enumerate(detections):
        if index in picked or detection is best:
            yield detection
