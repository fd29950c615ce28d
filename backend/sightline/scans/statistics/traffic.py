"""Traffic of line scans by intervals, from the database or from a package: pure of where they are."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from functools import cached_property, partial
from itertools import pairwise
from math import ceil
from typing import Annotated, Any, Protocol

import numpy as np
from pydantic import Field

from sightline.enums import ScanDirection
from sightline.infra.by_name import filled_from
from sightline.linescan.parts import GOES_ON_S, STANDS_S, Rig, may_still_stand, stands_at_end
from sightline.linescan.rig import may_be_one_rig
from sightline.linescan.traffic import Interval, Passed, Stream, intervals, strays_s, streams_of
from sightline.messages.said import Said
from sightline.recordings.filming import FilmedWithin
from sightline.scans.statistics.service import VehicleMotion, counts
from sightline.statistics.distributions import Percentile, percentiles

#: Of the speeds of an interval; the 85th is what limits are set by.
PERCENTS = (15.0, 50.0, 85.0)
#: By so much at most the next recording of a stream begins before the one before it ends, as a person tells.
_SHARED_S = 2.0
#: The clocks of no place are put forward or back, nor do hours begin, at other times, seconds since 1970.
_QUARTER_S = 900
_OF_MOTION = ("speed_mps", "u_speed_mps", "length_m", "u_length_m")


class Clock(Protocol):
    """The clocks of the place."""

    def at(self, seconds: float = 0.0) -> str:
        """What they showed so many seconds after line 0: ISO 8601 with offset, milliseconds."""


@dataclass(frozen=True)
class Watched:
    """A line scan as traffic sees it: its clock (None: the start is not confirmed), how long it is by its
    line rate (None: lines are not counted), its rig (None: not told), at which of several places it was, the
    hash of camera 1's strip, of which video of the place that was cut (empty: not told), whether its end is
    stated, and its lanes where several cameras of the place have each their own (none: not told).
    """

    scan_id: int
    name: str
    clock: Clock | None
    watched_s: float | None
    rig: Rig | None = None
    site: str = ""
    strip_sha256: str = ""
    video: str = ""
    end_stated: bool = True
    lanes: frozenset[str] = frozenset()

    @property
    def span_s(self) -> tuple[float, float] | None:
        """Its beginning and its end, seconds since 1970; None where they are not known."""
        if self.clock is None or self.watched_s is None:
            return None
        begin_s = datetime.fromisoformat(self.clock.at()).timestamp()
        return begin_s, begin_s + self.watched_s

    def may_see_the_road_of(self, other: "Watched") -> bool:
        """Whether the same vehicles may pass both: of one strip or video they do; two rigs are two places."""
        if self.strip_sha256 and self.strip_sha256 == other.strip_sha256:
            return True
        if self.site != other.site or (self.lanes and other.lanes and self.lanes.isdisjoint(other.lanes)):
            return False
        if self.video and self.video == other.video:
            return True
        return self.rig is None or other.rig is None or may_be_one_rig(self.rig, other.rig)


@dataclass(frozen=True)
class StoodBefore:
    """One who may have stood when one just before a recording ended; of unknown lane, in any stream that it
    is not known to be `gone` from. `later_s`: the longest time that nobody watched since it stood; `counts`:
    where it stood, with an end that is stated.
    """

    stream: Stream
    later_s: float = 0.0
    gone: frozenset[Stream] = frozenset()
    counts: bool = True

    def may_stand_in(self, stream: Stream) -> bool:
        """Whether it may stand in a stream as its recording begins."""
        return _may_be_of(self.stream, stream) and stream not in self.gone

    @property
    def may_be_in_view(self) -> bool:
        """Whether those in view as its recording begins may be this one and others beside it, told before."""
        return self.counts and self.later_s <= GOES_ON_S and self.stream not in self.gone


@dataclass(frozen=True, eq=False)
class Seen:
    """A recording and its vehicles; `filmed`: on which days and at which hours its traffic is asked for;
    `stood`: who may have stood when one just before it ended (`find_who_stood`).
    """

    watched: Watched
    vehicles: Sequence[VehicleMotion]
    filmed: FilmedWithin = field(default_factory=FilmedWithin)
    stood: Sequence[StoodBefore] = ()

    @cached_property
    def streams(self) -> dict[Stream, list[VehicleMotion]]:
        """Its vehicles by direction and lane."""
        return streams_of(self.vehicles)

    @cached_property
    def counted(self) -> dict[Stream, list[VehicleMotion]]:
        """Those of them whose traffic is counted."""
        return {
            stream: cars
            for stream, cars in self.streams.items()
            if cars and why_not_counted(self.watched, cars) is None
        }

    @cached_property
    def standing(self) -> dict[Stream, list[VehicleMotion]]:
        """Those that still stood at the end, where that is known."""
        end_s = self.watched.watched_s
        if end_s is None:
            return {}
        found = {
            stream: [car for car in cars if _stands_at_end(car, end_s)]
            for stream, cars in self.streams.items()
        }
        return {stream: cars for stream, cars in found.items() if cars}

    def is_in_view_of_before(self, car: VehicleMotion) -> bool:
        """Whether a vehicle was told of a recording before, from which this one goes on at once."""
        return not car.front_seen and any(one.may_be_in_view for one in self.stood)

    def streams_asked(self, from_s: float, until_s: float) -> set[Stream]:
        """The streams of which a vehicle was in view between two times, seconds since 1970, and counts within
        the days and hours asked for.
        """
        return {
            stream
            for stream, spans in self._in_view_s.items()
            if any(came_s <= until_s and left_s >= from_s for came_s, left_s in spans)
        }

    @cached_property
    def _in_view_s(self) -> dict[Stream, list[tuple[float, float]]]:
        """From when to when each vehicle was in view that counts within the days and hours asked for; one
        whose rear nobody saw to the end.
        """
        if self.watched.span_s is None:
            return {}
        begin_s, end_s = self.watched.span_s
        return {
            stream: [
                (came_s, end_s if car.occupied_s is None else came_s + car.occupied_s)
                for car in cars
                if self._is_asked(car)
                for came_s in [begin_s + (car.since_s or 0.0)]
            ]
            for stream, cars in self.counted.items()
        }

    def _is_asked(self, car: VehicleMotion) -> bool:
        clock = self.watched.clock
        if car.told_before or car.since_s is None or clock is None:
            return False
        return not self.filmed.limits_time or self.filmed.holds(clock.at(car.since_s))


def why_not_counted(scan: Watched, vehicles: Sequence[VehicleMotion]) -> Said | None:
    """Why a line scan's vehicles of one direction and lane have no intervals."""
    if scan.watched_s is None:
        return Said("scans-traffic-not-read")
    if scan.rig and any(one.line_rate_hz not in (None, scan.rig.line_rate_hz) for one in vehicles):
        return Said("scans-traffic-other-rate")
    return None if scan.clock else Said("scans-traffic-no-start")


@dataclass(frozen=True, kw_only=True)
class ShownInterval(Interval):
    """Traffic past camera 1 from `begins_at` on; `partial`: the recording covers only a part of it.

    Every vehicle counts for flow and occupancy, the `measured` ones for speeds. `u`: standard uncertainties
    (k = 1); `reasons` say why a figure is missing.
    """

    begins_at: Annotated[str, Field(description="By the clocks of the place, ISO 8601 with offset.")]
    near_edge: Annotated[
        int | None,
        Field(
            description="Passed so near to an edge that the clock leaves open on which side (95 %); "
            "null: not known."
        ),
    ]
    refused: Annotated[int, Field(description="Those whose motion could not be measured.")]
    flow_low: Annotated[
        float,
        Field(
            description="Ends of the exact 95 % interval for vehicles that come independently of each other."
        ),
    ]
    percentiles: list[Percentile]
    begin_s: Annotated[float, Field(exclude=True)]
    speeds_mps: Annotated[tuple[float, ...], Field(exclude=True)]


@dataclass(frozen=True, eq=False, kw_only=True)
class ScanTraffic:
    """The traffic of one line scan in one direction and lane, in intervals of `minutes`.

    An empty road is one that nobody reached camera 1 first on. `lane`: None where the rig has none, or of
    those whose lane is not known.
    """

    scan_id: int
    name: str
    minutes: int
    direction: Annotated[ScanDirection, Field(description="Which camera its vehicles reached first.")]
    lane: Annotated[
        str | None, Field(description="Of the rig's lanes; null: not known, or the rig has none.")
    ]
    intervals: tuple[ShownInterval, ...]
    unplaced: Annotated[int, Field(description="Never measured, so in no interval.")]
    reason: Annotated[Said | None, Field(description="Why it has no intervals.")]


def seen_in_each(
    watched: Sequence[Watched], vehicles: Sequence[VehicleMotion], filmed: FilmedWithin = FilmedWithin()
) -> list[Seen]:
    """The recordings with their vehicles; see `mark_told_before`."""
    of_scan: dict[int, list[VehicleMotion]] = {one.scan_id: [] for one in watched}
    for car in vehicles:
        of_scan.get(car.scan_id, []).append(car)
    return mark_told_before([Seen(one, of_scan[one.scan_id], filmed) for one in watched])


def mark_told_before(seen: Sequence[Seen]) -> list[Seen]:
    """The recordings with who stood before, and with those vehicles `told_before` that count in another:
    where one that counts stood as a recording ended and the next one goes on at once, all that are in view as
    that begins.
    """
    return [_mark(each) for each in find_who_stood(seen)]


def _mark(seen: Seen) -> Seen:
    cars = [
        replace(car, told_before=True) if seen.is_in_view_of_before(car) else car for car in seen.vehicles
    ]
    return replace(seen, vehicles=cars) if seen.stood else seen


def traffic_of_seen(seen: Sequence[Seen], minutes: int, *, accepted_only: bool) -> tuple[ScanTraffic, ...]:
    """The traffic of each line scan, direction and lane, in the order given, in intervals of 1, 5, 15 or
    60 min.

    Directions and lanes that nobody was seen in have none; vehicles that were never measured are told with
    the first.
    Every vehicle counts for flow and occupancy but those told before; its speed and length where its motion
    counts. Intervals are those that begin within the days and hours asked for. Where one stood when a
    recording ended, the next one, within a minute, tells no occupancy.
    """
    out = []
    for each in seen:
        for stream, cars in each.streams.items():
            before = any(one.may_stand_in(stream) for one in each.stood)
            strayed = [
                car
                for other, passed in each.streams.items()
                if other != stream and _may_be_of(other, stream)
                for car in passed
            ]
            since_s = strays_s(each.streams, stream[0])
            whole = _traffic(each.watched, cars, stream, minutes, accepted_only, before, strayed, since_s)
            within = tuple(one for one in whole.intervals if each.filmed.holds(one.begins_at))
            out.append(replace(whole, intervals=within))
    return tuple(out)


def find_who_stood(seen: Sequence[Seen]) -> list[Seen]:
    """The recordings, each with who may have stood when one just before it ended. One that stands through a
    whole recording leaves no trace in it: it is taken to be gone from a stream once another of that has
    driven through, or was in view at line 0. One that was in view then and stands to the end counts where it
    came, also after a recording whose traffic is not counted.
    """
    found = list(seen)
    stood = list[tuple[Watched, float, StoodBefore]]()
    spans = [(span, at) for at, each in enumerate(seen) if (span := each.watched.span_s) is not None]
    for (begin_s, end_s), at in sorted(spans):
        watched = seen[at].watched
        stood = [one for one in stood if begin_s - one[1] <= STANDS_S]
        before = [
            replace(one, later_s=max(one.later_s, begin_s - until_s))
            for other, until_s, one in stood
            if begin_s - until_s >= -_SHARED_S and watched.may_see_the_road_of(other)
        ]
        own = found[at] = replace(seen[at], stood=before)
        in_view = {stream for stream, cars in own.streams.items() if not all(car.front_seen for car in cars)}
        driven = {stream for stream, cars in own.streams.items() if any(car.measured for car in cars)}
        stand = {
            StoodBefore(
                stream,
                counts=watched.end_stated
                and (stream in own.counted or all(map(own.is_in_view_of_before, standing))),
            )
            for stream, standing in own.standing.items()
        }
        stand |= {
            replace(one, gone=one.gone | driven, counts=one.counts and watched.end_stated)
            for one in before
            if one.stream not in in_view
        }
        stood += [(watched, end_s, one) for one in stand]
    return found


def notes_of_overlaps(seen: Sequence[Seen]) -> list[Said]:
    """Which recordings of one road saw one direction and lane at the same time, by more than starts told by
    people leave open: of each the earlier one that it shares most with, the seconds that the traffic is asked
    for of both, and how many others. Each has a vehicle of that time: one that is in both counts in each.
    """
    notes, before = list[Said](), list[tuple[float, int]]()
    spans = [(span, at) for at, each in enumerate(seen) if (span := each.watched.span_s) is not None]
    for (begin_s, end_s), at in sorted(spans):
        later = seen[at]
        before = [one for one in before if one[0] - begin_s > _SHARED_S]
        shared = [
            (shared_s, seen[other].watched)
            for until_s, other in before
            if min(until_s, end_s) - begin_s > _SHARED_S
            and _is_shared(seen[other], later, begin_s - _SHARED_S, min(until_s, end_s) + _SHARED_S)
            and (shared_s := _asked_s(seen[other], later, begin_s, min(until_s, end_s))) > 0
        ]
        if shared:
            shared_s, earlier = max(shared, key=lambda each: each[0])
            first, second = _told_apart(earlier, later.watched)
            seconds, others = max(1, round(shared_s)), len(shared) - 1
            notes.append(
                Said("scans-traffic-overlap", earlier=first, later=second, seconds=seconds, others=others)
            )
        before.append((end_s, at))
    return notes


def _told_apart(first: Watched, second: Watched) -> tuple[str, str]:
    """Their names, with when they began where these are equal."""
    if first.name != second.name or first.clock is None or second.clock is None:
        return first.name, second.name
    return f"{first.name} ({first.clock.at()})", f"{second.name} ({second.clock.at()})"


def _asked_s(first: Seen, second: Seen, from_s: float, until_s: float) -> float:
    """How much of a time, seconds since 1970, lies in the days and hours that are asked for of both."""
    limiting = [each for each in (first, second) if each.filmed.limits_time]
    if not limiting:
        return until_s - from_s
    quarters = range(_QUARTER_S * int(from_s // _QUARTER_S + 1), ceil(until_s), _QUARTER_S)
    parts: list[tuple[float, float]] = list(pairwise([from_s, *quarters, until_s]))
    return sum((stop - at for at, stop in parts if all(_is_asked(each, at) for each in limiting)), start=0.0)


def _is_asked(seen: Seen, at_s: float) -> bool:
    clock, span_s = seen.watched.clock, seen.watched.span_s
    assert clock is not None and span_s is not None
    return seen.filmed.holds(clock.at(at_s - span_s[0]))


def _is_shared(first: Seen, second: Seen, from_s: float, until_s: float) -> bool:
    """Whether one vehicle may be in both between two times; of unknown lane it may be in any."""
    return first.watched.may_see_the_road_of(second.watched) and any(
        a[0] == b[0] and _may_share_lane(a, b)
        for a in first.streams_asked(from_s, until_s)
        for b in second.streams_asked(from_s, until_s)
    )


def _may_share_lane(first: Stream, second: Stream) -> bool:
    return first[1] == second[1] or None in (first[1], second[1])


def _may_be_of(stream: Stream, lane: Stream) -> bool:
    """Whether vehicles of one stream may be of another: those of unknown lane may be in any lane, and which
    way one that stands goes is not known.
    """
    return stream == lane or (stream[1] is None and lane[1] is not None)


def _traffic(
    scan: Watched,
    vehicles: Sequence[VehicleMotion],
    stream: Stream,
    minutes: int,
    accepted_only: bool,
    stood_before: bool,
    strayed: Sequence[VehicleMotion],
    since_s: Sequence[float],
) -> ScanTraffic:
    passed = [_make_passed(one, accepted_only) for one in vehicles if one.since_s is not None]
    unseen = [one for one in strayed if one.since_s is not None and one.occupied_s is None]
    reason = why_not_counted(scan, vehicles)
    return ScanTraffic(
        scan_id=scan.scan_id,
        name=scan.name,
        minutes=minutes,
        direction=stream[0],
        lane=stream[1],
        intervals=()
        if reason
        else _intervals(
            passed,
            scan.clock,
            scan.watched_s,
            minutes,
            stood_before=stood_before,
            strayed=[_make_passed(one, accepted_only) for one in unseen],
            strays_s=since_s,
        ),
        unplaced=len(vehicles) - len(passed),
        reason=reason,
    )


def _intervals(
    passed: Sequence[Passed],
    clock: Clock | None,
    watched_s: float | None,
    minutes: int,
    *,
    stood_before: bool,
    strayed: Sequence[Passed],
    strays_s: Sequence[float],
) -> tuple[ShownInterval, ...]:
    if clock is None or watched_s is None:
        return ()
    found = intervals(
        passed,
        watched_s,
        partial(_into_hour_s, clock),
        minutes,
        stood_before=stood_before,
        strayed=strayed,
        strays_s=strays_s,
    )
    return tuple(
        filled_from(
            ShownInterval,
            interval,
            begins_at=clock.at(interval.begin_s),
            percentiles=percentiles(np.array(interval.speeds_mps, dtype=np.float64), PERCENTS),
        )
        for interval in found
    )


def _stands_at_end(one: VehicleMotion, watched_s: float) -> bool:
    rear_s = None if one.occupied_s is None or one.since_s is None else one.since_s + one.occupied_s
    return stands_at_end(one.reason, rear_s, watched_s)


def _make_passed(vehicle: VehicleMotion, accepted_only: bool) -> Passed:
    assert vehicle.since_s is not None
    seen = Passed(
        vehicle.since_s,
        vehicle.occupied_s,
        vehicle.u_filmed_at_s,
        front_seen=vehicle.front_seen,
        told_before=vehicle.told_before,
    )
    if not counts(vehicle, accepted_only):
        return replace(seen, refused=not vehicle.measured, stands=may_still_stand(vehicle.reason))
    of_motion: dict[str, Any] = {name: vehicle.values.get(name) for name in _OF_MOTION}
    return replace(seen, **of_motion, rig_ratio=vehicle.rig_ratio, axles=vehicle.axles)


def _into_hour_s(clock: Clock, since_s: float) -> float:
    at = datetime.fromisoformat(clock.at(since_s))
    return 60.0 * at.minute + at.second + at.microsecond / 1e6
