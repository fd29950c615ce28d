"""Pieces of one vehicle put together: a vehicle does not appear in the middle of the picture.

A track that does not begin where traffic drives in, and that at its beginning is beside a track that goes
the same way, is a piece of that one: the boot behind dark glass, the light before the bonnet, or
the vehicle itself after its track was lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from backend.media.passes_blobs import Box, united
from backend.media.passes_tracks import Sight, Track

LEAST_SIGHTS = 3
LEAST_TRAVEL_SHARE = 0.03
NEAR_SHARE = 0.3
BORDER_PX = 2.5
HIGH_SHARE = 0.5


@dataclass(frozen=True)
class Course:
    """Along which axis of the picture a track goes (0: across, 1: down), and how far, px, signed."""

    axis: int
    far_px: float

    def same_way(self, other: Course) -> bool:
        return self.axis == other.axis and (self.far_px > 0) == (other.far_px > 0)


def stitched(tracks: Sequence[Track], size: tuple[int, int], lapse: int) -> list[Track]:
    """The tracks that move, pieces joined to the whole; a piece may begin `lapse` frames off the other.

    `size` is the picture's width and height, px.
    """
    moving = [track for track in tracks if _moves(track, size)]
    heads = [track for track in moving if enters(track, size)]
    rest = sorted((t for t in moving if not enters(t, size)), key=lambda t: t.sights[0].n)
    for piece in rest:
        owner = max(heads, key=lambda head: _belongs(piece, head, size, lapse), default=None)
        if owner is not None and _belongs(piece, owner, size, lapse) > 0:
            _join(owner, piece)
        else:
            heads.append(piece)
    return heads


def course(track: Track, size: tuple[int, int]) -> Course:
    """Where it goes: the axis along which it covers more of the picture, by the edge that moved more."""
    seen = [sight.box for sight in track.sights if sight.seen]
    first, last = seen[0], seen[-1]
    across = max(last.x0 - first.x0, last.x1 - first.x1, key=abs)
    down = max(last.y0 - first.y0, last.y1 - first.y1, key=abs)
    return Course(0, across) if abs(across) / size[0] >= abs(down) / size[1] else Course(1, down)


def enters(track: Track, size: tuple[int, int]) -> bool:
    """Whether it begins at the border from which it comes."""
    way = course(track, size)
    low, high = _ends(track.sights[0].box, way.axis)
    return low <= BORDER_PX if way.far_px > 0 else high >= size[way.axis] - BORDER_PX


def leaves(track: Track, size: tuple[int, int]) -> bool:
    """Whether it ends at the border to which it goes."""
    way = course(track, size)
    low, high = _ends(track.sights[-1].box, way.axis)
    return high >= size[way.axis] - BORDER_PX if way.far_px > 0 else low <= BORDER_PX


def _ends(box: Box, axis: int) -> tuple[float, float]:
    return (box.y0, box.y1) if axis else (box.x0, box.x1)


def _moves(track: Track, size: tuple[int, int]) -> bool:
    seen = [sight for sight in track.sights if sight.seen]
    if len(seen) < LEAST_SIGHTS:
        return False
    way = course(track, size)
    return abs(way.far_px) >= LEAST_TRAVEL_SHARE * size[way.axis]


def _belongs(piece: Track, whole: Track, size: tuple[int, int], lapse: int) -> float:
    """How sure it is that a piece belongs to a track; 0: it does not."""
    way = course(whole, size)
    if not way.same_way(course(piece, size)):
        return 0.0
    n = max(piece.sights[0].n, whole.sights[0].n)
    here, there = _at(piece, n, way.axis, lapse), _at(whole, n, way.axis, lapse)
    if here is None or there is None:
        return 0.0
    gap = max(here[0], there[0]) - min(here[1], there[1])
    near = 1.0 - max(gap, 0.0) / (NEAR_SHARE * max(here[1] - here[0], there[1] - there[0]))
    return max(near, 0.0)


def _at(track: Track, n: int, axis: int, lapse: int) -> tuple[float, float] | None:
    """From where to where it reaches on frame n; where it would, if it was lost shortly before."""
    earlier = [sight for sight in track.sights if sight.n <= n]
    if not earlier or n - earlier[-1].n > lapse:
        return None
    last, before = earlier[-1], earlier[-min(len(earlier), 4)]
    low, high = _ends(last.box, axis)
    then = _ends(before.box, axis)
    steps = (n - last.n) / max(1, last.n - before.n)
    move = max(low - then[0], high - then[1], key=abs) * steps
    return low + move, high + move


def _join(whole: Track, piece: Track) -> None:
    there = {sight.n: sight for sight in whole.sights}
    for sight in piece.sights:
        other = there.get(sight.n)
        if other is None or (sight.seen and not other.seen):
            there[sight.n] = sight
        elif sight.seen and sight.box.height >= HIGH_SHARE * other.box.height:
            there[sight.n] = Sight(sight.n, united([sight.box, other.box]), True)
    whole.sights = [there[n] for n in sorted(there)]
