"""What an archive of traffic holds, and what is asked of it."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import date, datetime

from sightline.enums import ScanDirection


@dataclass(frozen=True, slots=True)
class Passing:
    """One vehicle of a recording: when its front and rear (None: nobody saw it) reached camera 1, and how it
    went.

    `number`: its number in the recording; seconds count from the recording's first line, lines as in
    vehicles.csv. Numbers are None where they could not be measured, for which `reason` stands. `lane`: of a
    rig that has several; `direction`: which camera it reached first; `axles`: wheels found. `told_before`: in
    view where a segment of a stream began, it was told of the one before.
    """

    number: int
    front_s: float
    rear_s: float | None
    front_line_1: float
    rear_line_1: float | None
    speed_mps: float | None
    u_speed_mps: float | None
    acceleration_mps2: float | None
    u_acceleration_mps2: float | None
    length_m: float | None
    u_length_m: float | None
    time_gap_s: float | None
    distance_gap_m: float | None
    status: str
    reason: str | None
    lane: str | None = None
    direction: ScanDirection | None = None
    axles: int | None = None
    told_before: bool = False

    @property
    def occupied_s(self) -> float | None:
        """How long it stood before camera 1."""
        return None if self.rear_s is None else self.rear_s - self.front_s


@dataclass(frozen=True, slots=True)
class Recorded:
    """What one recording saw: `duration_s` of one lane, or of each of `lanes`, from its first line to its
    last.

    `sha256`: of the file it was read from, which names it in the archive. `lanes`: those of the rig that are
    told of; none: vehicles are of the lane that it stood at. `u_start_s`, `u_line_rate_ratio`: of its start
    and its line rate (k = 1), as the file says; 0: it does not. `begun`: its start as the file says.
    """

    name: str
    sha256: str
    duration_s: float
    passings: tuple[Passing, ...]
    lanes: tuple[str, ...] = ()
    u_start_s: float = 0.0
    u_line_rate_ratio: float = 0.0
    begun: datetime | None = None

    def lane_of(self, one: Passing, stood: Stood) -> str:
        """A vehicle's lane in the archive; empty where the rig has lanes and its own is not known."""
        return (one.lane or "") if self.lanes else stood.lane

    def lanes_at(self, stood: Stood) -> tuple[str, ...]:
        """The lanes that were watched; one without a name only where a vehicle's is not known."""
        if not self.lanes:
            return (stood.lane,)
        return (*self.lanes, *([""] if any(one.lane is None for one in self.passings) else []))


@dataclass(frozen=True, slots=True)
class Stood:
    """Where and when a recording was made. `start`: UTC, of its first line; `u_start_s`: k = 1."""

    site: str
    lane: str
    zone: str
    start: datetime
    u_start_s: float


@dataclass(frozen=True, slots=True)
class Asked:
    """What is asked of an archive. Empty `sites`: all. Days are the sites' own, both included.

    `minutes`: of an interval, a divisor of a day; `percents`: of speeds, above 0 and below 100;
    `limits_m`: rising lengths that part the classes, none for all vehicles together.
    """

    sites: tuple[str, ...] = ()
    first_day: date | None = None
    last_day: date | None = None
    minutes: int = 60
    percents: tuple[float, ...] = (15.0, 50.0, 85.0)
    limits_m: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Site:
    """What an archive has of one lane of a site."""

    site: str
    lane: str
    zone: str
    recordings: int
    first_day: date
    last_day: date
    days: int
    watched_s: float
    vehicles: int
    measured: int
