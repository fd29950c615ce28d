"""Traffic of line-scan results: tables and JSON of `sightline linescan`, lines of `stream`, and archives.

Each recording has a clock of its own. A table and the lines of `stream` do not say how long was recorded:
their intervals count as watched whole, from that of the first front to that of the last vehicle. The share of
the speeds' u that the rig gives to all alike is known from JSON alone; elsewhere the smallest relative u of
the recording's vehicles of that direction and lane stands for it, which it cannot exceed.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from datetime import datetime, timedelta
from functools import cached_property
from itertools import pairwise
from math import ceil, sqrt
from pathlib import Path
from statistics import median
from typing import Any

from sightline.errors import BadInput
from sightline.infra.given_csv import GivenTable, read_table
from sightline.infra.local_time import to_millisecond
from sightline.linescan.clock import u_passing_s
from sightline.linescan.parts import Rig, front_seen
from sightline.linescan.rig import at_lane, sound_rig_from, speed_ratio_of
from sightline.linescan.traffic import USUAL_DIRECTION, Stream
from sightline.messages.said import Said
from sightline.recordings.filming import Filming
from sightline.scans.statistics.service import VehicleMotion
from sightline.scans.statistics.traffic import (
    Clock,
    ScanTraffic,
    Seen,
    StoodBefore,
    Watched,
    mark_told_before,
    traffic_of_seen,
)
from sightline.traffic.archive import WATCHED, require_archive, sites_of
from sightline.traffic.records import Passing
from sightline.traffic.sources import (
    bytes_of,
    check_passings,
    instant_told,
    is_of_nobody,
    passing_of,
    u_told,
    vehicles_in,
)
from sightline.traffic.standing import watched_of

ENDINGS = (".csv", ".json", ".jsonl")
#: A table that spans more is of several recordings, or has a wrong date.
MOST_S = 366 * 86400.0
_FIRST_YEAR, _LAST_YEAR = 1990, 2200
#: In the beginning of a file that speaks of scanned vehicles, and of one that may say that nobody passed.
_OF_VEHICLES, _OF_DURATION = b"front_line_1", b"duration_s"
_NEEDED = ("id", "front_line_1", "rear_line_1", "speed_mps", "length_m", "status")
_NUMBERS = tuple(one.name for one in fields(Passing) if one.type == "float | None")


@dataclass(frozen=True, slots=True)
class StatedClock:
    """A clock with the offset from UTC that a start was written with."""

    start: datetime

    def at(self, seconds: float = 0.0) -> str:
        at = to_millisecond(self.start + timedelta(seconds=seconds))
        return at.isoformat(timespec="milliseconds")


@dataclass(frozen=True, eq=False)
class Results:
    """The vehicles of one recording, from `clock`'s start on; `watched_s` None: it is not said how long;
    `u_start_told`: whether the u of its start is known, without which its times of day have none; `rig` None:
    not told; `lanes`: see `Watched`; `stood`: who may have stood when another just before it ended.
    """

    name: str
    clock: Clock
    watched_s: float | None
    vehicles: tuple[VehicleMotion, ...]
    site: str = ""
    u_start_told: bool = True
    rig: Rig | None = None
    lanes: frozenset[str] = frozenset()
    stood: Sequence[StoodBefore] = ()

    @cached_property
    def seen(self) -> Seen:
        """What was watched for sure: until its last vehicle had passed where it is not said how long."""
        known_s = max(((one.since_s or 0.0) + (one.occupied_s or 0.0) for one in self.vehicles), default=None)
        return self._on_clock(self.clock, known_s if self.watched_s is None else self.watched_s, 0.0)

    def seen_in_intervals(self, minutes: int) -> Seen:
        """What was watched for intervals of `minutes`: whole ones where it is not said how long."""
        if self.watched_s is not None:
            return self.seen
        start, long_s = datetime.fromisoformat(self.clock.at()), 60.0 * minutes
        before_s = (60 * start.minute + start.second + start.microsecond / 1e6) % long_s
        last_s = max(one.since_s or 0.0 for one in self.vehicles)
        whole_s = long_s * max(1, ceil((before_s + last_s + 1e-6) / long_s))
        return self._on_clock(StatedClock(start - timedelta(seconds=before_s)), whole_s, before_s)

    def _on_clock(self, clock: Clock, watched_s: float | None, by_s: float) -> Seen:
        cars = [replace(one, since_s=(one.since_s or 0.0) + by_s) for one in self.vehicles]
        stated = self.watched_s is not None
        watched = Watched(
            0, self.name, clock, watched_s, rig=self.rig, site=self.site, end_stated=stated, lanes=self.lanes
        )
        return Seen(watched, cars, stood=self.stood)


def traffic_of(results: Sequence[Results], minutes: int) -> tuple[ScanTraffic, ...]:
    """By recording, direction and lane, in intervals of `minutes`. Speeds need no review here."""
    return traffic_of_seen([one.seen_in_intervals(minutes) for one in results], minutes, accepted_only=False)


def results_in(place: Path) -> tuple[list[Results], list[str]]:
    """The recordings of a file, of a folder's files, or of an archive, those vehicles `told_before` that
    another of them counts; and names of files that are none.

    Raises BadInput: nothing there, or a recording that cannot be read or has no start.
    """
    if not place.is_dir():
        return [_of_data(place, bytes_of(place))], []
    if (place / WATCHED).is_dir():
        results, others = list(_of_archive(place)), list[str]()
    else:
        results, others = _in_folder(place)
    seen = mark_told_before([one.seen for one in results])
    marked = [
        replace(one, vehicles=tuple(each.vehicles), stood=each.stood)
        for one, each in zip(results, seen, strict=True)
    ]
    return marked, others


def _in_folder(place: Path) -> tuple[list[Results], list[str]]:
    paths = [one for one in sorted(place.iterdir()) if one.is_file() and one.suffix.lower() in ENDINGS]
    ours, others = list[Results](), list[str]()
    for path in paths:
        if data := _bytes_of_ours(path):
            ours.append(_of_data(path, data))
        else:
            others.append(path.name)
    if not ours:
        raise BadInput("commands-flow-folder-empty", place=place)
    return ours, others


def _bytes_of_ours(path: Path) -> bytes:
    """Nothing of a file that speaks of no scanned vehicles, nor says that nobody passed."""
    data = bytes_of(path, _OF_VEHICLES)
    if data or path.suffix.lower() != ".json":
        return data
    data = bytes_of(path, _OF_DURATION)
    return data if is_of_nobody(data) else b""


def _of_data(path: Path, data: bytes) -> Results:
    if path.suffix.lower() == ".csv":
        return _of_table(path, read_table(data, path))
    whole, rows = vehicles_in(path, data)
    passings = [passing_of(path, one, at) for at, one in enumerate(rows, 1)]
    if whole is None:
        if not rows:
            raise BadInput("commands-flow-no-vehicles", path=path)
        begun = _start(path, rows[0].get("front_at"))
        begun -= timedelta(seconds=passings[0].front_s)
        return Results(path.name, StatedClock(begun), None, _motions(passings), u_start_told=False)
    check_passings(path, passings, whole["duration_s"])
    u_start_s = u_told(whole, "u_start_s") or None
    rig = _rig_told(whole)
    motions = _motions(passings, u_start_s=u_start_s, u_rate=u_told(whole, "u_line_rate_ratio"), rig=rig)
    clock = StatedClock(_start(path, whole.get("start")))
    watched_s, told = float(whole["duration_s"]), u_start_s is not None
    return Results(path.name, clock, watched_s, motions, u_start_told=told, rig=rig)


def _rig_told(whole: Mapping[str, Any]) -> Rig | None:
    """The rig that a recording's JSON tells of; None where it does not tell all that belongs to one."""
    if not all(one.name in whole for one in fields(Rig)):
        return None
    return sound_rig_from({one.name: whole[one.name] for one in fields(Rig)})


def _start(path: Path, said: object) -> datetime:
    at = instant_told(said)
    if at is None or not _FIRST_YEAR <= at.year < _LAST_YEAR:
        raise BadInput("commands-flow-no-start", path=path)
    return at


def _of_table(path: Path, table: GivenTable) -> Results:
    """Of vehicles.csv. Its lines become seconds by the table's own clock."""
    table.require(*_NEEDED)
    if "front_at" not in table.header:
        raise BadInput("commands-flow-no-start", path=path)
    rows = [(line, row, _start(path, row["front_at"])) for line, row in table.sound_rows()]
    if not rows:
        raise BadInput("commands-flow-no-vehicles", path=path)
    start = min(at for _line, _row, at in rows)
    passings = _occupying(path, [_passing(path, table, start, *one) for one in rows])
    check_passings(path, passings, MOST_S)
    given = [
        table.uncertainty(line, "u_front_at_s", row["u_front_at_s"]) if row.get("u_front_at_s") else None
        for line, row, _at in rows
    ]
    found = [replace(one, u_filmed_at_s=u_s) for one, u_s in zip(_motions(passings), given, strict=True)]
    told = any(u_s is not None for u_s in given)
    return Results(path.name, StatedClock(start), None, tuple(found), u_start_told=told)


def _occupying(path: Path, passings: Sequence[Passing]) -> list[Passing]:
    """With the time of each rear: lines are as many a second as the motions say, in the median, or without
    any the fronts of neighbours. Raises BadInput for a single vehicle without a motion.

    A measured vehicle lost no line; between two of them lines may be lost, and fronts are told to whole ms.
    """
    in_time = sorted(passings, key=lambda one: one.front_s)
    between = (
        (one.front_line_1 - before.front_line_1, one.front_s - before.front_s)
        for before, one in pairwise(in_time)
    )
    rates = [rate for passing in passings if (rate := _lines_per_s(passing)) is not None] or [
        lines / seconds for lines, seconds in between if lines > 0 and seconds > 0
    ]
    if not rates:
        raise BadInput("commands-flow-no-rate", path=path)
    per_s = median(rates)
    return [
        passing
        if passing.rear_line_1 is None
        else replace(passing, rear_s=passing.front_s + (passing.rear_line_1 - passing.front_line_1) / per_s)
        for passing in passings
    ]


def _lines_per_s(passing: Passing) -> float | None:
    """How many lines a second a motion says; None without one."""
    if passing.rear_line_1 is None:
        return None
    lines, length_m = passing.rear_line_1 - passing.front_line_1, passing.length_m or 0.0
    v, a = passing.speed_mps or 0.0, passing.acceleration_mps2 or 0.0
    if not min(lines, length_m, v) > 0:
        return None
    # the root of length = v t + a t^2 / 2 that stays there without an acceleration
    under = max(v * v + 2 * a * length_m, 0.0)
    return lines * (v + sqrt(under)) / (2 * length_m)


def _passing(
    path: Path, table: GivenTable, start: datetime, line: int, row: Mapping[str, str], at: datetime
) -> Passing:
    """A line as a vehicle of the JSON; when its rear passed is found later."""
    since_s = (at - start).total_seconds()
    said: dict[str, Any] = {name: row.get(name) or None for name in ("reason", "lane", "direction")}
    said |= {name: table.number(line, name, row[name]) for name in ("id", "front_line_1")}
    said |= {name: table.number(line, name, row[name]) for name in ("axles", *_NUMBERS) if row.get(name)}
    said |= {"status": row["status"], "front_s": since_s}
    return passing_of(path, said, row["id"])


def _of_archive(folder: Path) -> Iterator[Results]:
    """Each recording of each site, of all its lanes."""
    from sightline.traffic.query import ArchiveTables

    require_archive(folder)
    with ArchiveTables(folder) as tables:
        for site in sites_of(folder):
            for row, vehicles in tables.recordings(site):
                watched, first = watched_of(row, site), row["first"]
                yield Results(
                    watched.name,
                    Filming(first["start_at"], first["zone"]),
                    watched.watched_s,
                    _motions(
                        [_passing_of_row(one) for one in vehicles],
                        u_start_s=first["u_start_s"] or None,
                        u_rate=u_told(first, "u_line_rate_ratio"),
                    ),
                    site,
                    u_start_told=first["u_start_s"] > 0,
                    lanes=watched.lanes,
                )


def _passing_of_row(row: Mapping[str, Any]) -> Passing:
    named: dict[str, Any] = {one.name: row.get(one.name) for one in fields(Passing)}
    return Passing(**{**named, "lane": row["lane"] or None})


def _motions(
    passings: Sequence[Passing],
    *,
    u_start_s: float | None = None,
    u_rate: float = 0.0,
    rig: Rig | None = None,
) -> tuple[VehicleMotion, ...]:
    least = dict[Stream, float]()
    for passing in passings:
        if passing.speed_mps and passing.u_speed_mps:
            ratio, stream = passing.u_speed_mps / passing.speed_mps, _stream_of(passing)
            least[stream] = min(ratio, least.get(stream, ratio))
    return tuple(
        VehicleMotion(
            vehicle_id=passing.number,
            scan_id=0,
            number=passing.number,
            state="to_review" if passing.status == "ok" else "not_measurable",
            measured=passing.status == "ok" and passing.speed_mps is not None,
            lighting="unknown",
            values={name: getattr(passing, name) for name in _NUMBERS},
            status=passing.status,
            reason=Said.read(passing.reason) if passing.reason else None,
            since_s=passing.front_s,
            occupied_s=passing.occupied_s,
            front_seen=front_seen(passing.reason, passing.front_line_1),
            told_before=passing.told_before,
            u_filmed_at_s=u_passing_s(
                passing.front_s, u_start_s, u_rate, passing.speed_mps, passing.u_length_m
            ),
            rig_ratio=(
                least.get(_stream_of(passing), 0.0)
                if rig is None
                else speed_ratio_of(at_lane(rig, passing.lane, _stream_of(passing)[0]))
            ),
            direction=_stream_of(passing)[0],
            lane=passing.lane,
            axles=passing.axles,
        )
        for passing in passings
    )


def _stream_of(one: Passing) -> Stream:
    """A vehicle's direction and lane."""
    return one.direction or USUAL_DIRECTION, one.lane
