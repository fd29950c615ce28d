"""Traffic of an export's line scans: from its own rows, as tables of their own."""

from collections.abc import Iterator, Mapping, Sequence
from typing import get_args, get_type_hints

from sightline.enums import ScanDirection
from sightline.export.statistics_rows import Cells, statistics_table
from sightline.infra.csv_package.columns import (
    code_of,
    flag,
    integer,
    key,
    metres,
    number,
    text,
    words_of,
)
from sightline.infra.csv_package.files import Files, read_rows, undo_safe_text
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.schema import CODE, Column, ids_of
from sightline.linescan.traffic import Figure, Interval
from sightline.results.csv import selection_in
from sightline.scans.clock import clock_of
from sightline.scans.csv import LINE_SCANS, rig_of_row
from sightline.scans.statistics.service import VehicleMotion
from sightline.scans.statistics.traffic import (
    PERCENTS,
    ScanTraffic,
    Seen,
    ShownInterval,
    Watched,
    seen_in_each,
    traffic_of_seen,
)

_WAY = text(
    "direction", "which camera its vehicles reached first", required=True, enum=get_args(ScanDirection)
)
_LANE = text("lane", "of the rig's lanes; empty: not known, or it has none")
_BY_AXLES = {
    "axles_2": "2 axles",
    "axles_3": "3 axles",
    "axles_4": "4 axles",
    "axles_5_or_more": "5 axles or more",
    "axles_unknown": "wheels that were not found",
}
_SCAN = key("scan_id", "line-scan recording")
_MINUTES = integer("minutes", "length of an interval", unit="min", required=True)
_BEGINS = Column(
    "begins_at",
    "datetime",
    "when it begins, by the clocks of the place (ISO 8601 with offset)",
    required=True,
)


def _measured(name: str, meaning: str, unit: str) -> tuple[Column, Column]:
    return (
        number(name, meaning, unit),
        number(f"u_{name}", f"standard uncertainty of {name} (k = 1)", unit),
    )


def _percentile(percent: float) -> tuple[Column, ...]:
    name = f"p{percent:g}_speed_mps"
    return (
        number(name, f"{percent:g}th percentile of the speeds that count", "m/s"),
        number(f"{name}_low", "lower end of its distribution-free 95 % interval, where n allows one", "m/s"),
        number(f"{name}_high", "upper end of the same", "m/s"),
    )


INTERVALS = statistics_table(
    "traffic_intervals",
    "Traffic past camera 1 of each line scan with a confirmed start, by direction and lane, in intervals of "
    "1, 5, 15 and 60 minutes by the clocks of the place. Every vehicle that was found counts for flow, "
    "headways and occupancy, also one without a motion or with a rejected one; speeds are of the accepted "
    "ones. Only days and hours of selection.csv limit it: vehicles of every lighting and class count.",
    _SCAN,
    _MINUTES,
    _BEGINS,
    number("watched_s", "how much of it was recorded", "s", required=True),
    flag("partial", "true where the recording covers only a part of it", required=True),
    integer("vehicles", "fronts that passed camera 1", required=True),
    integer(
        "near_edge",
        "those so near to an edge that the clock leaves it open on which side (95 %)",
        required=True,
    ),
    integer("refused", "those whose motion could not be measured", required=True),
    integer("measured", "those with a speed that counts", required=True),
    number("flow_per_hour", "vehicles an hour, over the time watched", "1/h", required=True),
    number(
        "flow_low",
        "lower end of the exact 95 % interval, for vehicles that come independently of each other",
        "1/h",
    ),
    number("flow_high", "upper end of the same", "1/h"),
    number("mean_headway_s", "mean headway of those with a vehicle before", "s"),
    *_measured("time_mean_speed_mps", "mean of the speeds", "m/s"),
    *_measured("space_mean_speed_mps", "harmonic mean of the speeds", "m/s"),
    *(column for percent in PERCENTS for column in _percentile(percent)),
    *_measured("occupancy_percent", "share of the time in which a vehicle stood before camera 1", "%"),
    *_measured("density_per_km", "flow over space mean speed", "1/km"),
    integer("unclassed", "vehicles without a length that counts", required=True),
    text("reasons", "why a figure is missing, separated by semicolons"),
    text(f"reasons{CODE}", "reasons by code and values (JSON)"),
    _WAY,
    _LANE,
    primary=("scan_id", "direction", "lane", "minutes", "begins_at"),
    foreign=ids_of(scan_id="line_scans"),
)
CLASSES = statistics_table(
    "traffic_classes",
    "The vehicles of the same intervals, of every lighting and class, by the length that was measured; an "
    "empty interval has no rows.",
    _SCAN,
    _MINUTES,
    _BEGINS,
    metres("above_m", "longer than this; empty for the shortest class"),
    metres("up_to_m", "up to this long; empty for the longest class"),
    integer("vehicles", "how many", required=True),
    integer(
        "near_limit",
        "those whose 95 % interval contains a limit of the class: they may be of the next class",
        required=True,
    ),
    _WAY,
    *(integer(name, f"those of them with {words}", required=True) for name, words in _BY_AXLES.items()),
    _LANE,
)
TABLES = (INTERVALS, CLASSES)
_PLAIN = [
    name
    for name, kind in get_type_hints(Interval).items()
    if name in INTERVALS.header and kind is not Figure and name != "reasons"
]
_FIGURES = [name for name, kind in get_type_hints(Interval).items() if kind is Figure]


def traffic_of_scans(seen: Sequence[Seen], lengths: Sequence[int]) -> tuple[ScanTraffic, ...]:
    """The traffic of line scans of a package, in intervals of the first of `lengths`, minutes, first."""
    return tuple(one for minutes in lengths for one in traffic_of_seen(seen, minutes, accepted_only=True))


def seen_in(files: Files, vehicles: Sequence[VehicleMotion]) -> list[Seen]:
    """The line scans of a package with their vehicles, `vehicles` all of them.

    Its days and hours alone limit their traffic: without vehicles of other classes, flows and headways would
    be of an emptier road.
    """
    watched = [_watched(row) for row in read_rows(files, LINE_SCANS.key)]
    return seen_in_each(watched, vehicles, selection_in(files))


def _watched(row: Mapping[str, str]) -> Watched:
    clock = clock_of(
        {
            "started_at": row["started_at"] or None,
            "time_zone": undo_safe_text(row["time_zone"]),
            "u_start_s": figure_of(row["u_start_s"]),
        }
    )
    rig = rig_of_row(LINE_SCANS.key, row)
    return Watched(
        scan_id=int(row["id"]),
        name=undo_safe_text(row["name"]),
        clock=clock.filming if clock else None,
        watched_s=int(row["lines"]) / rig.line_rate_hz if row["lines"] else None,
        rig=rig,
        strip_sha256=row["first_sha256"],
        video=row["recording_id"],
    )


def traffic_rows(found: Sequence[ScanTraffic]) -> dict[str, Iterator[Cells]]:
    """The rows of both tables by their paths."""
    return {
        INTERVALS.key: (_interval_row(scan, one) for scan in found for one in scan.intervals),
        CLASSES.key: (row for scan in found for one in scan.intervals for row in _class_rows(scan, one)),
    }


def _key(scan: ScanTraffic, one: ShownInterval) -> Cells:
    key: Cells = {"scan_id": scan.scan_id, "minutes": scan.minutes, "begins_at": one.begins_at}
    return {**key, "direction": scan.direction, "lane": scan.lane}


def _interval_row(scan: ScanTraffic, interval: ShownInterval) -> Cells:
    row: Cells = {**_key(scan, interval), **{name: getattr(interval, name) for name in _PLAIN}}
    for name in _FIGURES:
        figure: Figure = getattr(interval, name)
        row |= {name: figure.value, f"u_{name}": figure.u}
    for each in interval.percentiles:
        name = f"p{each.percent:g}_speed_mps"
        row |= {name: each.value, f"{name}_low": each.low, f"{name}_high": each.high}
    return {**row, "reasons": words_of(interval.reasons), f"reasons{CODE}": code_of(interval.reasons)}


def _class_rows(scan: ScanTraffic, interval: ShownInterval) -> Iterator[Cells]:
    for kind in interval.classes if interval.vehicles else ():
        yield {
            **_key(scan, interval),
            "above_m": kind.above_m,
            "up_to_m": kind.up_to_m,
            "vehicles": kind.vehicles,
            "near_limit": kind.near_limit,
            **dict(zip(_BY_AXLES, kind.by_axles, strict=True)),
        }
