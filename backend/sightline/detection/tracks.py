"""Boxes of one vehicle followed from frame to frame; vehicles that hide each other go on as they went."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from sightline.detection.blobs import Box, bounding_union, intersection_area

COAST_S = 0.5
SMOOTH = 0.5
PIECE_SHARE = 0.6
COURSE_SIGHTS = 4
COURSE_SHARE = 0.05
WAYS_KEPT = 6


@dataclass(frozen=True)
class Detection:
    """Where a vehicle is on frame n; `seen` is false where another hides it and its place is guessed, `clear`
    where another hides a part of it.
    """

    n: int
    box: Box
    seen: bool
    clear: bool = True


@dataclass
class Track:
    """One thing that moves; its sights in order, and its speed in pixels a frame of each edge."""

    detections: list[Detection] = field(default_factory=list)
    vx0: float = 0.0
    vx1: float = 0.0
    vy: float = 0.0
    ways: int = 0

    @property
    def last(self) -> Detection:
        return self.detections[-1]

    @property
    def way(self) -> int:
        """Which way it goes: 1, -1, or 0 as long as that is not known."""
        return max(-1, min(1, self.ways))

    def predicted(self, n: int) -> Box:
        """Where it should be on frame n, if it goes on."""
        box, step = self.last.box, n - self.last.n
        return Box(
            box.x0 + self.vx0 * step,
            box.y0 + self.vy * step,
            box.x1 + self.vx1 * step,
            box.y1 + self.vy * step,
            box.area_px,
        )

    def see(self, n: int, box: Box, speed_px: float | None, cut: tuple[int, ...] = ()) -> None:
        """It is there on frame n; an edge that is hidden or cut off by the picture's border goes on at the
        speed (px a frame) of what is seen.
        """
        step = n - self.last.n
        old, clear = self.last.box, not box.hidden
        box = self._completed(n, box)
        self.ways = max(-WAYS_KEPT, min(WAYS_KEPT, self.ways + box.way))
        v0, v1 = (box.x0 - old.x0) / step, (box.x1 - old.x1) / step
        if speed_px is not None:
            v0 = speed_px if 0 in (*box.hidden, *cut) else v0
            v1 = speed_px if 1 in (*box.hidden, *cut) else v1
        share = SMOOTH if len(self.detections) > 1 else 1.0
        self.vx0 += share * (v0 - self.vx0)
        self.vx1 += share * (v1 - self.vx1)
        self.vy += share * ((box.middle[1] - old.middle[1]) / step - self.vy)
        self.detections.append(Detection(n, box, True, clear))

    def _completed(self, n: int, box: Box) -> Box:
        if not box.hidden or len(self.detections) < COURSE_SIGHTS:
            return box
        at = self.predicted(n)
        x0 = min(box.x0, at.x0) if 0 in box.hidden else box.x0
        x1 = max(box.x1, at.x1) if 1 in box.hidden else box.x1
        return replace(box, x0=x0, x1=x1)

    def guess(self, n: int, box: Box) -> None:
        """Another hides it on frame n; it is taken to go on as it went."""
        drift = (self.vx0 + self.vx1) / 2
        self.vx0 = self.vx1 = drift
        self.detections.append(Detection(n, box, False))


class Tracker:
    """Feed it the boxes of each frame in order; what has left is in `finished`."""

    def __init__(self, width: int, height: int, rate_hz: float) -> None:
        self._width, self._height = width, height
        self._coast = max(2, round(COAST_S * rate_hz))
        self._n = 0
        self._open: list[Track] = []
        self.finished: list[Track] = []

    def step(self, n: int, boxes: Sequence[Box]) -> None:
        """The boxes seen on frame n."""
        expected = [(track, self._clipped(track.predicted(n))) for track in self._open]
        claims: dict[int, list[tuple[Track, Box]]] = {}
        for track, at in expected:
            likely = [intersection_area(at, box) * (box.way * track.way >= 0) for box in boxes]
            best = max(range(len(boxes)), key=likely.__getitem__, default=None)
            if best is not None and likely[best] > 0:
                claims.setdefault(best, []).append((track, at))
        keepers: set[int] = set()
        pieces = {i: _pieces(i, boxes, claims) for i in claims}
        for index, claimants in claims.items():
            whole = bounding_union([boxes[index], *(boxes[i] for i in pieces[index])])
            keepers |= self._share(n, whole, claimants)
        taken = set(claims).union(*pieces.values())
        self._open += [self._begun(n, box) for i, box in enumerate(boxes) if i not in taken]
        self._n = n
        self._retire(n, keepers)

    def _begun(self, n: int, box: Box) -> Track:
        speed = self._speed_px(n, box) or 0.0
        return Track([Detection(n, box, True, not box.hidden)], vx0=speed, vx1=speed, ways=box.way)

    def _speed_px(self, n: int, box: Box) -> float | None:
        return None if box.step_px is None else box.step_px / max(1, n - self._n)

    def _cut(self, box: Box) -> tuple[int, ...]:
        """Edges (0: left, 1: right) at the picture's border."""
        return tuple(i for i, at in enumerate((box.x0 <= 1, box.x1 >= self._width - 1)) if at)

    def finish(self) -> list[Track]:
        """All tracks, when there are no more frames."""
        self.finished += self._open
        self._open = []
        return self.finished

    def _share(self, n: int, box: Box, claimants: list[tuple[Track, Box]]) -> set[int]:
        """Give a box to the track whose it is, or to all that may be hidden in it."""
        moving = [pair for pair in claimants if self._is_about(pair[0], n)]
        if box.way == 0 and len(moving) > 1 and _opposed([track for track, _ in moving]):
            for track, at in moving:
                track.guess(n, at)
            return {id(track) for track, _ in moving}
        keeper = max(
            claimants, key=lambda pair: (round(intersection_area(pair[1], box)), len(pair[0].detections))
        )[0]
        keeper.see(n, box, self._speed_px(n, box), self._cut(box))
        return {id(keeper)}

    def _is_about(self, track: Track, n: int) -> bool:
        """Whether it has a course, and has not left yet."""
        first, last = track.detections[0].box, track.last.box
        moved = max(abs(last.x0 - first.x0), abs(last.x1 - first.x1))
        on_its_way = len(track.detections) >= COURSE_SIGHTS and moved >= COURSE_SHARE * self._width
        return on_its_way and not self._outside(track.predicted(n))

    def _retire(self, n: int, told: set[int]) -> None:
        kept = []
        for track in self._open:
            silent = n - max((s.n for s in track.detections if s.seen), default=n)
            gone = id(track) not in told and self._outside(track.predicted(n))
            if gone or silent > self._coast:
                self.finished.append(track)
            else:
                kept.append(track)
        self._open = kept

    def _outside(self, box: Box) -> bool:
        return box.x1 <= 2 or box.x0 >= self._width - 2 or box.y1 <= 2 or box.y0 >= self._height - 2

    def _clipped(self, box: Box) -> Box:
        x0, x1 = max(box.x0, 0.0), min(box.x1, float(self._width))
        y0, y1 = max(box.y0, 0.0), min(box.y1, float(self._height))
        return Box(x0, y0, max(x1, x0 + 1), max(y1, y0 + 1), box.area_px)


def _pieces(index: int, boxes: Sequence[Box], claims: Mapping[int, Sequence[tuple[Track, Box]]]) -> list[int]:
    """Boxes that nobody claims and that lie where one track is expected: pieces of the same vehicle."""
    if len(claims[index]) != 1 or len(claims[index][0][0].detections) < 3:
        return []
    track, at = claims[index][0]
    free = [i for i in range(len(boxes)) if i not in claims and boxes[i].way * track.way >= 0]
    return [
        i for i in free if intersection_area(at, boxes[i]) >= PIECE_SHARE * boxes[i].width * boxes[i].height
    ]


def _opposed(tracks: Sequence[Track]) -> bool:
    """Whether some go one way and some the other."""
    speeds = [(track.vx0 + track.vx1) / 2 for track in tracks]
    return min(speeds) < -0.5 and max(speeds) > 0.5
