"""`sightline flow`: traffic of line-scan results, vehicle by vehicle and in intervals."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sightline.commands.files import csv_text, write_whole
from sightline.commands.options import FILE, json_option, print_json
from sightline.commands.scanned import cell_of
from sightline.errors import BadInput
from sightline.linescan.traffic import (
    LENGTH_LIMITS_M,
    MINUTES,
    class_names,
    headways_s,
    strays_s,
)

if TYPE_CHECKING:
    from sightline.scans.statistics.service import VehicleMotion
    from sightline.scans.statistics.traffic import ScanTraffic, Seen, ShownInterval

_FILE = click.Path(dir_okay=False, path_type=Path)
_SCANS = "line_scans.csv"


@click.command()
@click.argument("places", nargs=-1, required=True, metavar="PLACE...", type=FILE)
@click.option(
    "--interval",
    "lengths",
    metavar="MINUTES,...",
    default="1,5,15,60",
    show_default=True,
    help="Lengths of the intervals, of 1, 5, 15 and 60.",
)
@click.option("-o", "--output", type=_FILE, help="intervals.csv to write (default: print it).")
@click.option("--vehicles", "vehicles_csv", type=_FILE, help="CSV of the vehicles with their headways.")
@json_option
def flow(
    places: tuple[Path, ...], lengths: str, output: Path | None, vehicles_csv: Path | None, as_json: bool
) -> None:
    """Compute the traffic of scanned vehicles in intervals: flow, speeds, headways, occupancy, classes.

    PLACE is a package (only days and hours of its selection limit it), a vehicles.csv or JSON of `sightline
    linescan --start`, the output of `stream`, a folder of these, or an archive of `sightline traffic`. Every
    vehicle counts for flow and occupancy, measured or not; speeds and classes cover the measured ones (in a
    package the accepted ones).
    """
    from sightline.scans.statistics.traffic import notes_of_overlaps

    minutes = _minutes(lengths)
    found = [_of_place(place, minutes) for place in places]
    rows = [row for each in found for one in each.traffic for row in _rows_of_intervals(one)]
    vehicles = [row for each in found for row in each.vehicles]
    notes = [note for each in found for note in each.notes + _notes_of_unplaced(each.traffic, minutes[0])]
    notes += map(str, notes_of_overlaps(_told_apart(places, found)))
    if vehicles_csv is not None:
        write_whole(vehicles_csv, csv_text(VEHICLE_COLUMNS, vehicles, cell_of))
    table = csv_text(COLUMNS, rows, cell_of)
    if output is not None:
        write_whole(output, table)
    if as_json:
        print_json({"intervals": rows, "vehicles": vehicles, "notes": notes})
        return
    if output is None:
        click.echo(table, nl=False)
    else:
        click.echo(f"{len(vehicles)} vehicles, {len(rows)} intervals; written to {output}.")
    for note in notes:
        click.echo(note, err=output is None)


def _minutes(text: str) -> tuple[int, ...]:
    try:
        lengths = tuple(dict.fromkeys(int(one) for one in text.split(",")))
    except ValueError:
        lengths = ()
    if not lengths or not set(lengths) <= set(MINUTES):
        raise BadInput("commands-flow-other-minutes", text=text[:40])
    return lengths


def _notes_of_unplaced(traffic: Sequence[ScanTraffic], minutes: int) -> list[str]:
    return [
        f"{one.name}: {one.unplaced} vehicles were never measured and are in no interval."
        for one in traffic
        if one.minutes == minutes and one.unplaced
    ]


Rows = list[dict[str, Any]]


@dataclass(frozen=True, eq=False)
class OfPlace:
    """The traffic of a place, its vehicles, what is to be said of it, and its recordings."""

    traffic: Sequence[ScanTraffic]
    vehicles: Rows
    notes: list[str]
    seen: list[Seen]


def _told_apart(places: Sequence[Path], found: Sequence[OfPlace]) -> list[Seen]:
    """The recordings of all places; those of equal names with their place."""
    names = Counter(seen.watched.name for each in found for seen in each.seen)
    return [
        replace(seen, watched=replace(seen.watched, name=f"{place}: {seen.watched.name}"))
        if names[seen.watched.name] > 1
        else seen
        for place, each in zip(places, found, strict=True)
        for seen in each.seen
    ]


def _notes_of_ends(seen: Sequence[Seen]) -> list[str]:
    """Of those whose ends are not stated."""
    starts = [datetime.fromisoformat(each.watched.clock.at()) for each in seen if each.watched.clock]
    return [
        f"{each.watched.name} does not say how long was recorded: its first and last interval count as fully "
        "observed."
        + (
            " A vehicle that still stood at its end may count again in the next recording, or be missing in "
            "its occupancy."
            if start < max(starts) and each.standing
            else ""
        )
        for each, start in zip(seen, starts, strict=True)
        if not each.watched.end_stated
    ]


def _of_place(place: Path, minutes: Sequence[int]) -> OfPlace:
    from sightline.infra.csv_package.files import places_of
    from sightline.traffic.results import results_in, traffic_of

    if not place.exists():
        raise BadInput("commands-flow-not-there", place=place)
    if place.suffix.lower() == ".zip" or any((place / path).is_file() for path in places_of(_SCANS)):
        return _of_package(place, minutes)
    results, left = results_in(place)
    seen = [result.seen for result in results]
    traffic = [each for length in minutes for each in traffic_of(results, length)]
    notes = [f"{name} in {place} has no scanned vehicles and is skipped." for name in left]
    notes += _notes_of_ends(seen)
    notes += [
        f"The uncertainties of the times of {result.name} and near_edge are left out, because that of its "
        "start is not stated there."
        for result in results
        if not result.u_start_told
    ]
    return OfPlace(traffic, [row for each in seen for row in _vehicle_rows(each)], notes, seen)


def _of_package(place: Path, minutes: Sequence[int]) -> OfPlace:
    from sightline.export.package_tables import tables_of
    from sightline.export.scans import scanned_motions
    from sightline.export.traffic import seen_in, traffic_of_scans
    from sightline.export.verify.described import read_description
    from sightline.infra.csv_package.files import open_package, place_of

    files = open_package(place)
    if place_of(files, _SCANS) not in files.paths:
        raise BadInput("commands-flow-folder-empty", place=place)
    described = read_description(files)
    files = described.read_in_its_format(files, tables_of(described.most_frames))
    seen = [
        replace(each, watched=replace(each.watched, site=str(place)))
        for each in seen_in(files, list(scanned_motions(files)))
    ]
    traffic = traffic_of_scans(seen, minutes)
    rows = [row for each in seen for row in _vehicle_rows(each) if each.filmed.holds(row["front_at"])]
    notes = {one.scan_id: f"{one.name}: {one.reason}" for one in traffic if one.reason}
    return OfPlace([one for one in traffic if not one.reason], rows, list(notes.values()), seen)


_CLASSES = tuple(f"length_{name.replace(' ', '_')}" for name in class_names(LENGTH_LIMITS_M))
_AXLES = ("axles_2", "axles_3", "axles_4", "axles_5_or_more", "axles_unknown")
_PERCENTS = (15, 50, 85)
COLUMNS = (
    "interval_start",
    "interval_s",
    "vehicles",
    "refused",
    "flow_per_h",
    "speed_mean_mps",
    "speed_harmonic_mean_mps",
    *(f"speed_p{percent}_mps" for percent in _PERCENTS),
    "headway_mean_s",
    "occupancy_percent",
    *_CLASSES,
    "length_unknown",
    *_AXLES,
    "minutes",
    "partial",
    "near_edge",
    "measured",
    "flow_low_per_h",
    "flow_high_per_h",
    "u_speed_mean_mps",
    "u_speed_harmonic_mean_mps",
    "u_occupancy_percent",
    "density_per_km",
    "u_density_per_km",
    "recording",
    "direction",
    "lane",
    "reasons",
)
VEHICLE_COLUMNS = (
    "recording",
    "id",
    "front_at",
    "u_front_at_s",
    "direction",
    "lane",
    "speed_mps",
    "u_speed_mps",
    "length_m",
    "u_length_m",
    "axles",
    "headway_s",
    "occupied_s",
    "state",
    "reason",
)


def _rows_of_intervals(traffic: ScanTraffic) -> Iterator[dict[str, Any]]:
    for shown in traffic.intervals:
        yield _row_of_interval(traffic, shown)


def _row_of_interval(traffic: ScanTraffic, interval: ShownInterval) -> dict[str, Any]:
    by_percent = {each.percent: each.value for each in interval.percentiles}
    axles = [sum(each) for each in zip(*(kind.by_axles for kind in interval.classes), strict=True)]
    row = {
        "interval_start": interval.begins_at,
        "interval_s": interval.watched_s,
        "flow_per_h": interval.flow_per_hour,
        "speed_mean_mps": interval.time_mean_speed_mps.value,
        "u_speed_mean_mps": interval.time_mean_speed_mps.u,
        "speed_harmonic_mean_mps": interval.space_mean_speed_mps.value,
        "u_speed_harmonic_mean_mps": interval.space_mean_speed_mps.u,
        **{f"speed_p{percent}_mps": by_percent.get(percent) for percent in _PERCENTS},
        "headway_mean_s": interval.mean_headway_s,
        "occupancy_percent": interval.occupancy_percent.value,
        "u_occupancy_percent": interval.occupancy_percent.u,
        "density_per_km": interval.density_per_km.value,
        "u_density_per_km": interval.density_per_km.u,
        **dict(zip(_CLASSES, (kind.vehicles for kind in interval.classes), strict=True)),
        "length_unknown": interval.unclassed,
        **dict(zip(_AXLES, axles, strict=True)),
        "minutes": traffic.minutes,
        "partial": str(interval.partial).lower(),
        "flow_low_per_h": interval.flow_low,
        "flow_high_per_h": interval.flow_high,
        "recording": traffic.name,
        "direction": traffic.direction,
        "lane": traffic.lane,
        "reasons": "; ".join([*map(str, interval.reasons), *_too_few(interval)]),
    }
    return {name: row[name] if name in row else getattr(interval, name) for name in COLUMNS}


def _too_few(shown: ShownInterval) -> list[str]:
    """Why percentiles are missing where some speeds count."""
    return [str(each.reason) for each in shown.percentiles if each.reason] if shown.measured else []


def _vehicle_rows(of: Seen) -> Iterator[dict[str, Any]]:
    """Each vehicle that the intervals count, with its headway: from the front before, of its direction and
    lane.
    """
    clock = of.watched.clock
    passings: list[tuple[float, VehicleMotion, float | None]] = []
    for (way, _), stream in of.counted.items():
        placed = [(one.since_s, one) for one in stream if one.since_s is not None]
        fronts_s = [since_s for since_s, _ in placed]
        headways = headways_s(fronts_s, [one.front_seen for _, one in placed], strays_s(of.streams, way))
        passings += [(*each, gap) for each, gap in zip(placed, headways, strict=True)]
    for since_s, vehicle, headway_s in sorted(passings, key=lambda each: each[0]):
        if clock is None or vehicle.told_before:
            continue
        held = {
            "recording": of.watched.name,
            "id": vehicle.number,
            "front_at": clock.at(since_s),
            "u_front_at_s": vehicle.u_filmed_at_s,
            "headway_s": headway_s,
            "reason": vehicle.reason and str(vehicle.reason),
            **{name: vehicle.values.get(name) for name in VEHICLE_COLUMNS if name in vehicle.values},
        }
        yield {name: held[name] if name in held else getattr(vehicle, name) for name in VEHICLE_COLUMNS}
