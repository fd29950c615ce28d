"""Traffic of line scans by intervals, from the database or from a package: pure of where they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from math import hypot
from typing import Protocol, TypedDict

import numpy as np

from sightline.enums import ScanDirection
from sightline.linescan.parts import Rig
from sightline.linescan.rig import baseline_of
from sightline.linescan.traffic import Interval, Passed, Stream, intervals, streams_of
from sightline.messages.said import Said
from sightline.recordings.filming import FilmedWithin
from sightline.scans.statistics.service import VehicleMotion, counts
from sightline.statistics.distributions import Percentile, percentiles

#: Of the speeds of an interval; the 85th is what limits are set by.
PERCENTS = (15.0, 50.0, 85.0)


class Clock(Protocol):
    """The clocks of the place."""

    def at(self, seconds: float = 0.0) -> str:
        """What they showed so many seconds after line 0: ISO 8601 with offset, milliseconds."""


@dataclass(frozen=True)
class Watched:
    """A line scan as traffic sees it: its clock (None: the start is not confirmed), how long it is."""

    scan_id: int
    name: str
    clock: Clock | None
    watched_s: float | None


@dataclass(frozen=True, eq=False)
class ShownInterval:
    """An interval with the time at which it begins (ISO 8601 with offset) and its speeds' percentiles."""

    begins_at: str
    interval: Interval
    percentiles: list[Percentile]


@dataclass(frozen=True, eq=False)
class ScanTraffic:
    """The traffic of one line scan in one direction and lane, in intervals of `minutes`; `reason`: why there
    are none.

    An empty road is one that nobody reached camera 1 first on. `unplaced`: vehicles that were never measured
    and so have no place in time; they are in no interval. `lane`: None where the rig has none, or of those
    whose lane is not known.
    """

    scan_id: int
    name: str
    minutes: int
    intervals: tuple[ShownInterval, ...]
    unplaced: int
    reason: Said | None = None
    direction: ScanDirection = "camera_1_first"
    lane: str | None = None


class _Named(TypedDict):
    scan_id: int
    name: str
    minutes: int
    unplaced: int
    direction: ScanDirection
    lane: str | None


def rig_ratio(rig: Rig) -> float:
    """What baseline and line rate give to every speed alike, a share of it (k = 1)."""
    baseline_m, u_baseline_m = baseline_of(rig)
    return hypot(u_baseline_m / baseline_m, rig.u_line_rate_ratio)


def traffic_of_seen(
    watched: Sequence[Watched],
    found: Sequence[VehicleMotion],
    minutes: int,
    *,
    accepted_only: bool,
    filmed: FilmedWithin = FilmedWithin(),
) -> tuple[ScanTraffic, ...]:
    """The traffic of each line scan, direction and lane, in the order given, in intervals of 1, 5, 15 or
    60 min.

    Directions and lanes that nobody was seen in have none; vehicles that were never measured are told with
    the first.
    Every vehicle counts for flow and occupancy; its speed and length where its motion counts. Intervals are
    those that begin within the days and hours `filmed`.
    """
    out = []
    for one in watched:
        for stream, cars in streams_of([car for car in found if car.scan_id == one.scan_id]).items():
            whole = _traffic(one, cars, stream, minutes, accepted_only)
            within = tuple(each for each in whole.intervals if filmed.holds(each.begins_at))
            out.append(replace(whole, intervals=within))
    return tuple(out)


def _traffic(
    scan: Watched,
    found: Sequence[VehicleMotion],
    stream: Stream,
    minutes: int,
    accepted_only: bool,
) -> ScanTraffic:
    passed = [_passed(one, accepted_only) for one in found if one.since_s is not None]
    named: _Named = {
        "scan_id": scan.scan_id,
        "name": scan.name,
        "minutes": minutes,
        "unplaced": len(found) - len(passed),
        "direction": stream[0],
        "lane": stream[1],
    }
    if scan.clock is None or scan.watched_s is None:
        unread, undated = Said("scans-traffic-not-read"), Said("scans-traffic-no-start")
        return ScanTraffic(**named, intervals=(), reason=unread if scan.watched_s is None else undated)
    into_hour_s = _into_hour_s(scan.clock)
    told = intervals(passed, scan.watched_s, into_hour_s, minutes)
    shown = tuple(
        ShownInterval(
            scan.clock.at(one.begin_s),
            one,
            percentiles(np.array(one.speeds_mps, dtype=np.float64), PERCENTS),
        )
        for one in told
    )
    return ScanTraffic(**named, intervals=shown)


def _passed(one: VehicleMotion, accepted_only: bool) -> Passed:
    assert one.since_s is not None and one.occupied_s is not None
    if not counts(one, accepted_only):
        return Passed(one.since_s, one.occupied_s, one.u_filmed_at_s, refused=not one.measured)
    return Passed(
        one.since_s,
        one.occupied_s,
        one.u_filmed_at_s,
        speed_mps=one.values.get("speed_mps"),
        u_speed_mps=one.values.get("u_speed_mps"),
        length_m=one.values.get("length_m"),
        u_length_m=one.values.get("u_length_m"),
        rig_ratio=one.rig_ratio,
        axles=one.axles,
    )


def _into_hour_s(clock: Clock) -> float:
    at = datetime.fromisoformat(clock.at())
    return 60.0 * at.minute + at.second + at.microsecond / 1e6
