"""Vehicles one after the other as they pass: each measured once, with the gap to the one before."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace

from sightline.enums import ScanMethod
from sightline.linescan.gaps import Leaders
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Gap, Motion, Passage, Rig, rear_seen

Columns = Callable[[Crossings], Crossings]


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


class Follower:
    """Measures passages in their order; what is kept of the vehicle before is what a gap needs.

    columns: crossings as lines of what the vehicles were read from, where that counts otherwise.
    """

    def __init__(
        self, rig: Rig, method: ScanMethod, columns: Columns = lambda crossings: crossings, first: int = 1
    ) -> None:
        self._rig, self._method, self._columns = rig, method, columns
        self._number = first - 1
        self._leaders = Leaders(rig)

    def next(self, passage: Passage, *, counted: bool = True) -> Vehicle | None:
        """The vehicle of a passage, if it is one. One that is not `counted` is only the one before for the
        next.
        """
        motion = MEASURE[self._method](passage, self._rig)
        if not is_told(passage, motion):
            return None
        gap = self._leaders.next(passage.crossings, replace(motion, profile=None), beside=passage.beside)
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
