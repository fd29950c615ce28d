"""Pieces of one vehicle put together: a vehicle does not appear in the middle of the picture.

A track that does not begin where traffic drives in, and that at its beginning is beside a track that goes
the same way, is a piece of that one: the boot behind dark glass, the light before the bonnet. Nor does it
vanish there: where a track ends that has not left, one that begins farther on soon after is the same
vehicle, which another hid.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sightline.detection.blobs import Box, bounding_union, intersection_area
from sightline.detection.tracks import Detection, Track

LEAST_SIGHTS = 3
LEAST_TRAVEL_SHARE = 0.03
NEAR_SHARE = 0.5
BORDER_PX = 2.5
HIGH_SHARE = 0.5
HIDDEN_LAPSES = 2.5
BEHIND_SHARE = 0.05
DOUBLE_SHARE = 0.5
RETREAT_SHARE = 0.05


@dataclass(frozen=True)
class Course:
    """Along which axis of the picture a track goes (0: across, 1: down), and how far, px, signed."""

    axis: int
    far_px: float

    def same_way(self, other: Course) -> bool:
        return self.axis == other.axis and (self.far_px > 0) == (other.far_px > 0)


def stitch_tracks(tracks: Sequence[Track], size: tuple[int, int], lapse: int) -> list[Track]:
    """The tracks that move, pieces joined to the whole; a piece may begin `lapse` frames off the other.

    `size` is the picture's width and height, px.
    """
    moving = [_trimmed(track, size) for track in tracks if _moves(track, size)]
    heads = [track for track in moving if enters(track, size)]
    rest = sorted((t for t in moving if not enters(t, size)), key=lambda t: t.detections[0].n)
    for piece in rest:
        owner = max(heads, key=lambda head: _likeness(piece, head, size, lapse), default=None)
        if owner is not None and _likeness(piece, owner, size, lapse) > 0:
            _join(owner, piece)
        else:
            heads.append(piece)
    return [_trimmed(head, size) for head in _without_doubles(heads, size)]


def _trimmed(track: Track, size: tuple[int, int]) -> Track:
    """Without the light that ran ahead of it before it came, and what was taken for it after it left."""
    way = course(track, size)
    if way.axis == 1:
        return track
    right = track.way > 0 if track.way else way.far_px > 0
    lead = np.array([one.box.x1 if right else size[0] - one.box.x0 for one in track.detections])
    trail = np.array([one.box.x0 if right else size[0] - one.box.x1 for one in track.detections])
    coming = np.where(trail <= BORDER_PX, lead, np.inf)
    going = np.where(lead >= size[0] - BORDER_PX, trail, -np.inf)
    first, last = int(np.argmin(coming)), int(np.argmax(going))
    if not (np.isfinite(coming[first]) and lead[0] > lead[first] + RETREAT_SHARE * size[0]):
        first = 0
    if not (np.isfinite(going[last]) and trail[-1] < trail[last] - RETREAT_SHARE * size[0]):
        last = len(track.detections) - 1
    if last - first >= LEAST_SIGHTS:
        track.detections = track.detections[first : last + 1]
    return track


def _without_doubles(tracks: Sequence[Track], size: tuple[int, int]) -> list[Track]:
    """Tracks that go the same way in the same place at the same time are one: cab and body of a lorry."""
    kept: list[Track] = []
    for track in sorted(tracks, key=lambda one: -max(detection.box.area_px for detection in one.detections)):
        owner = next((one for one in kept if _is_inside(track, one, size)), None)
        if owner is None:
            kept.append(track)
        else:
            _join(owner, track)
    return kept


def _is_inside(part: Track, whole: Track, size: tuple[int, int]) -> bool:
    if not course(part, size).same_way(course(whole, size)):
        return False
    there = {detection.n: detection.box for detection in whole.detections if detection.seen}
    pairs = [
        (detection.box, there[detection.n])
        for detection in part.detections
        if detection.seen and detection.n in there
    ]
    if len(pairs) < DOUBLE_SHARE * sum(detection.seen for detection in part.detections):
        return False
    inside = [intersection_area(one, other) / (one.width * one.height) for one, other in pairs]
    return bool(np.median(inside) >= DOUBLE_SHARE)


def _likeness(piece: Track, whole: Track, size: tuple[int, int], lapse: int) -> float:
    """How much speaks for a piece of a track; 0: nothing. What lies beside it goes before what went on."""
    beside = _belongs(piece, whole, size, lapse)
    return 1.0 + beside if beside > 0 else _went_on(piece, whole, size, lapse)


def _went_on(piece: Track, whole: Track, size: tuple[int, int], lapse: int) -> float:
    """How soon a track that ended in the middle of the picture went on as one that began there, 0 to 1."""
    way = course(whole, size)
    apart = piece.detections[0].n - whole.last.n
    longest = HIDDEN_LAPSES * lapse
    if leaves(whole, size) or not way.same_way(course(piece, size)) or not -lapse < apart <= longest:
        return 0.0
    end = 1 if way.far_px > 0 else 0
    ahead = _ends(piece.detections[0].box, way.axis)[end] - _ends(whole.last.box, way.axis)[end]
    far = ahead / size[way.axis] * (1 if way.far_px > 0 else -1)
    return 0.0 if far < -BEHIND_SHARE else max(0.01, 1.0 - abs(apart) / longest)


def course(track: Track, size: tuple[int, int]) -> Course:
    """Where it goes: the axis along which its middle goes farther, and how far its edges went."""
    seen = [detection.box for detection in track.detections if detection.seen]
    middles = np.array([box.middle for box in seen])[:: max(1, len(seen) // 8)]
    went = np.abs(np.diff(middles, axis=0)).sum(axis=0) / size
    first, last = seen[0], seen[-1]
    if went[0] >= went[1]:
        return Course(0, max(last.x0 - first.x0, last.x1 - first.x1, key=abs))
    return Course(1, max(last.y0 - first.y0, last.y1 - first.y1, key=abs))


def enters(track: Track, size: tuple[int, int]) -> bool:
    """Whether it begins at the border from which it comes."""
    way = course(track, size)
    low, high = _ends(track.detections[0].box, way.axis)
    return low <= BORDER_PX if way.far_px > 0 else high >= size[way.axis] - BORDER_PX


def leaves(track: Track, size: tuple[int, int]) -> bool:
    """Whether it ends at the border to which it goes."""
    way = course(track, size)
    low, high = _ends(track.detections[-1].box, way.axis)
    return high >= size[way.axis] - BORDER_PX if way.far_px > 0 else low <= BORDER_PX


def _ends(box: Box, axis: int) -> tuple[float, float]:
    return (box.y0, box.y1) if axis else (box.x0, box.x1)


def _moves(track: Track, size: tuple[int, int]) -> bool:
    seen = [detection for detection in track.detections if detection.seen]
    if len(seen) < LEAST_SIGHTS:
        return False
    way = course(track, size)
    return abs(way.far_px) >= LEAST_TRAVEL_SHARE * size[way.axis]


def _belongs(piece: Track, whole: Track, size: tuple[int, int], lapse: int) -> float:
    """How sure it is that a piece belongs to a track; 0: it does not."""
    way = course(whole, size)
    if not way.same_way(course(piece, size)):
        return 0.0
    n = max(piece.detections[0].n, whole.detections[0].n)
    here, there = _extent_on_frame(piece, n, way.axis, lapse), _extent_on_frame(whole, n, way.axis, lapse)
    if here is None or there is None:
        return 0.0
    gap = max(here[0], there[0]) - min(here[1], there[1])
    near = 1.0 - max(gap, 0.0) / (NEAR_SHARE * max(_longest(piece, way.axis), _longest(whole, way.axis)))
    return max(near, 0.0)


def _longest(track: Track, axis: int) -> float:
    return max(
        high - low
        for low, high in (_ends(detection.box, axis) for detection in track.detections if detection.seen)
    )


def _extent_on_frame(track: Track, n: int, axis: int, lapse: int) -> tuple[float, float] | None:
    """From where to where it reaches on frame n; where it would, if it was lost shortly before."""
    earlier = [detection for detection in track.detections if detection.n <= n]
    if not earlier or n - earlier[-1].n > lapse:
        return None
    last, before = earlier[-1], earlier[-min(len(earlier), 4)]
    low, high = _ends(last.box, axis)
    if axis == 0 and last is track.last:
        return low + track.vx0 * (n - last.n), high + track.vx1 * (n - last.n)
    then = _ends(before.box, axis)
    steps = (n - last.n) / max(1, last.n - before.n)
    move = max(low - then[0], high - then[1], key=abs) * steps
    return low + move, high + move


def _join(whole: Track, piece: Track) -> None:
    there = {detection.n: detection for detection in whole.detections}
    for detection in piece.detections:
        other = there.get(detection.n)
        if other is None or (detection.seen and not other.seen):
            there[detection.n] = detection
        elif detection.seen and detection.box.height >= HIGH_SHARE * other.box.height:
            there[detection.n] = Detection(detection.n, bounding_union([detection.box, other.box]), True)
    whole.detections = [there[n] for n in sorted(there)]
