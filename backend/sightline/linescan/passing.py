"""Vehicles one after the other as they pass: each measured once, with the gap to the one before."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import astuple, dataclass, replace

from sightline.enums import ScanMethod
from sightline.linescan.gaps import Leaders
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Gap, Motion, Passage, Rig, front_seen, rear_seen

Columns = Callable[[Crossings], Crossings]
#: The vehicles that the next one's gap and headway may run from, in the order in which they were told.
Ahead = tuple[tuple[Crossings, Motion], ...]


@dataclass(frozen=True)
class Vehicle:
    """One vehicle: its number from 1, lines as columns of the files, motion, gap to the one before it of its
    direction and lane.

    `front_s`, `rear_s`: when they reached camera 1, from line 0 on; lines that were lost take their time.
    `rear_s` None: nobody saw its rear.
    """

    number: int
    columns: Crossings
    motion: Motion
    gap: Gap
    front_s: float
    rear_s: float | None


def is_told(passage: Passage, motion: Motion) -> bool:
    """Whether a passage is a vehicle's, and no part of what had stood there and left."""
    return motion.status == "ok" or not passage.leaving


def keep_ahead(ahead: Ahead, crossings: Crossings, motion: Motion) -> Ahead:
    """Who is ahead after another was told: of each direction and lane whose rear came last, whose front did,
    and who was told last.
    """
    this = crossings, replace(motion, profile=None)
    way = crossings.direction, motion.lane
    same = [this, *(one for one in reversed(ahead) if (one[0].direction, one[1].lane) == way)]
    last = [this, max(same, key=lambda one: one[0].rear_line_1)]
    last.append(max(same, key=lambda one: one[0].front_line_1))
    return tuple(
        one
        for one in (*ahead, this)
        if (one[0].direction, one[1].lane) != way or any(one is kept for kept in last)
    )


def move_ahead(ahead: Ahead, by: float) -> Ahead:
    """The same where lines count from another one. A front that was seen may lie before line 0 then."""
    moved = []
    for at, motion in ahead:
        seen = front_seen(motion.reason, at.front_line_1) and rear_seen(motion.reason)
        lines = Crossings(*(line + by for line in astuple(at)))
        moved.append((lines, replace(motion, crossings=lines, reason=None if seen else motion.reason)))
    return tuple(moved)


class Follower:
    """Measures passages in their order; what is kept of the vehicle before is what a gap needs.

    columns: crossings as lines of what the vehicles were read from, where that counts otherwise; ahead: who
    was told before.
    """

    def __init__(
        self,
        rig: Rig,
        method: ScanMethod,
        columns: Columns = lambda crossings: crossings,
        first: int = 1,
        ahead: Ahead = (),
    ) -> None:
        self._rig, self._method, self._columns = rig, method, columns
        self._number, self.ahead = first - 1, ahead
        self._leaders = Leaders(rig)
        for crossings, motion in ahead:
            self._leaders.next(crossings, motion)

    def next(self, passage: Passage, *, counted: bool = True) -> Vehicle | None:
        """The vehicle of a passage, if it is one. One that is not `counted` is only the one before for the
        next.
        """
        motion = MEASURE[self._method](passage, self._rig)
        if not is_told(passage, motion):
            return None
        gap = self._leaders.next(passage.crossings, replace(motion, profile=None), beside=passage.beside)
        self.ahead = keep_ahead(self.ahead, passage.crossings, motion)
        self._number += counted
        at, rate = passage.crossings, self._rig.line_rate_hz
        rear_s = at.rear_line_1 / rate if rear_seen(motion.reason) else None
        return Vehicle(
            number=self._number,
            columns=self._columns(at),
            motion=motion,
            gap=gap,
            front_s=at.front_line_1 / rate,
            rear_s=rear_s,
        )


def measure_passages(
    passages: Iterable[Passage], rig: Rig, method: ScanMethod, columns: Columns = lambda crossings: crossings
) -> Iterator[Vehicle]:
    """Every vehicle in order; only one passage is held at a time."""
    vehicles = map(Follower(rig, method, columns).next, passages)
    return (vehicle for vehicle in vehicles if vehicle is not None)
