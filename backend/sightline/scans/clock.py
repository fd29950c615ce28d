"""The clock of a line-scan recording: when line 0 was taken, as a person confirmed; when vehicles passed."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from sightline.errors import BadInput
from sightline.linescan.clock import since_start_s, u_passing_s
from sightline.recordings.filming import Filming, start_of

#: What a recording's row, its events and its line in a package call the parts of a clock.
CLOCK = ("started_at", "time_zone", "u_start_s")
MOST_U_START_S = 3600.0


@dataclass(frozen=True, slots=True)
class ScanClock:
    """The instant of line 0, the zone by whose clocks it is told, and its standard uncertainty in seconds."""

    filming: Filming
    u_start_s: float

    def columns(self) -> dict[str, Any]:
        """As they are stored."""
        return {
            "started_at": self.filming.started_at,
            "time_zone": self.filming.time_zone,
            "u_start_s": self.u_start_s,
        }


@dataclass(frozen=True, slots=True)
class Passing:
    """When a front reached camera 1: ISO 8601 with offset; u in seconds, None where there is no motion."""

    filmed_at: str
    u_filmed_at_s: float | None


def clock_of(row: Mapping[Any, Any]) -> ScanClock | None:
    """Of a recording's row or its events; None while nobody has confirmed the start."""
    at = row.get("started_at")
    if at is None:
        return None
    started = datetime.fromisoformat(at) if isinstance(at, str) else at
    return ScanClock(Filming(started, row["time_zone"]), row["u_start_s"])


def clock_said(local: str, zone: str, u_start_s: float, present: datetime) -> ScanClock:
    """What a person said of a start. Raises BadInput: see `start_of`; and an uncertainty beyond an hour."""
    if not 0 < u_start_s <= MOST_U_START_S:
        raise BadInput("scans-start-u-range", u_s=f"{u_start_s:g}")
    return ScanClock(start_of(local, zone, present), u_start_s)


def passing_of(
    clock: ScanClock,
    front_line_1: float,
    speed_mps: float | None,
    u_length_m: float | None,
    rig: Mapping[str, Any],
) -> Passing:
    """When a vehicle passed; `rig` (line_rate_hz, u_line_rate_ratio) is that of its motion."""
    since_s = since_start_s(front_line_1, rig["line_rate_hz"])
    u_s = u_passing_s(since_s, clock.u_start_s, rig["u_line_rate_ratio"], speed_mps, u_length_m)
    return Passing(clock.filming.at(since_s), u_s)
