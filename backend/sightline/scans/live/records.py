"""Records of a live stream: what is told of a vehicle, and how the stream is."""

from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from sightline.enums import LiveState, MeasurementStatus, ScanDirection
from sightline.linescan.passing import Vehicle
from sightline.messages.said import Said

#: What a stream without a file or cameras is called in its journal.
STANDARD_INPUT = "standard input"


@dataclass(frozen=True, eq=False)
class LiveVehicle:
    """A vehicle with the segment in whose strips it is, and the time of day of its front at camera 1.

    `begin`: the line of the stream that is line 0 of the segment.
    """

    segment: int
    begin: int
    vehicle: Vehicle
    at: datetime


@dataclass(frozen=True, slots=True)
class LiveHealth:
    """How a stream is at the moment. Counts are of its present segment, lost lines those of either camera.

    `light_dn`: mean of the empty road, 0 to 255, per camera (None: not yet seen); `saturated`: share of the
    picture; `clock_offset_s`: time that has passed minus the time that the lines make; `memory_mib`: of the
    process; `waiting_mib`: lines that came and are not yet looked at; `words`: what is to be said.
    """

    lines: int
    lost_lines: tuple[int, int]
    light_dn: tuple[float | None, float | None]
    saturated: tuple[float, float]
    clock_offset_s: float
    memory_mib: float
    waiting_mib: float
    words: tuple[Said, ...]


@dataclass(frozen=True)
class SegmentFacts:
    """A segment as it begins: its number, the stream's sign, source, and the time of its line 0."""

    number: int
    stream: str
    source: str
    began_at: datetime

    @property
    def name(self) -> str:
        """Of its line-scan recording."""
        return f"Live {self.began_at:%Y-%m-%d %H:%M:%S} UTC"


@dataclass(frozen=True, slots=True)
class LiveSegment:
    """A recording of a segment's stream and moment, whether it has ended and whether a person deleted it."""

    scan_id: int
    ended: bool
    deleted: bool


class Keeper:
    """Where a stream's vehicles go besides being told: here nowhere; a survey `keeps` them."""

    keeps = False

    def begin(self, segment: SegmentFacts, belongs_to: Callable[[int | None], None]) -> None:
        """A segment begins; `belongs_to` takes the number of its line-scan recording, None until that is
        stored.
        """

    def take_up(self, segment: SegmentFacts | None, scan_id: int | None, told: int) -> None:
        """A segment that a killed stream left is the present one, until its end (None: not kept here);
        `scan_id`: its recording, if that was stored; `told`: how many of its vehicles were told.
        """

    def add(self, vehicle: LiveVehicle) -> None:
        """A vehicle was told."""

    def hear(self, health: LiveHealth) -> None:
        """How the stream is, once a second."""

    def end(self, paths: tuple[Path, Path] | None, notes: list[Said], moved: Callable[[], None]) -> None:
        """The segment has ended; its strips (None: not kept) and what is to be said of them. `moved`: is told
        once they are where they belong.
        """
        moved()


@dataclass(frozen=True, slots=True)
class LiveScan:
    """A recording that a stream makes or made; `ready`: its picture can be looked at; `line_rate_hz`: by
    which its lines were counted, whatever is said of its cameras later; `source`: the file or the cameras,
    None of a pipe.
    """

    scan_id: int
    name: str
    ready: bool
    line_rate_hz: float
    stream: str
    source: str | None
    began_at: datetime
    heard_at: datetime
    ended_at: datetime | None
    health: LiveHealth | None


@dataclass(frozen=True, slots=True, kw_only=True)
class LivePassing:
    """One of the last vehicles; `front_at`: when its front reached camera 1. U95 = 1.96 u."""

    id: int
    number: int
    front_at: datetime
    direction: ScanDirection | None = None
    lane: str | None = None
    axles: int | None = None
    speed_mps: float | None = None
    U95_speed_mps: float | None = None
    length_m: float | None = None
    U95_length_m: float | None = None
    time_gap_s: float | None = None
    status: MeasurementStatus | None = None
    reason: Said | None = None


@dataclass(frozen=True, slots=True)
class FlowMinute:
    """Vehicles whose front reached camera 1 in the minute from `begin` on; `whole`: it was watched whole."""

    begin: datetime
    vehicles: int
    whole: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class LiveStream(LiveScan):
    """A stream by its newest recording; `until`: the time of the last line; `earlier`: recordings before."""

    state: LiveState
    until: datetime
    vehicles: tuple[LivePassing, ...]
    flow: tuple[FlowMinute, ...]
    earlier: tuple[LiveScan, ...]
