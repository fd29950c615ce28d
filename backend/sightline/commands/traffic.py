"""`sightline traffic`: months of line-scanned vehicles as Parquet, and figures of them."""

from __future__ import annotations

import csv
import math
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import asdict
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

import click

from sightline.commands.options import json_option, number_option, print_json, tell
from sightline.coverage import expanded
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.traffic.records import Asked, Recorded, Stood

_FOLDER = click.Path(file_okay=False, path_type=Path)
_DAY_MINUTES = 24 * 60
_WHOLE_S = 1.0


@click.group()
def traffic() -> None:
    """Archive line-scanned vehicles of many days and sites, and compute flows and speeds.

    The archive is a folder of Parquet files by site and day, which DuckDB, Spark and Trino can read directly.
    """


@traffic.command()
@click.argument("archive", type=_FOLDER)
@click.argument("recording", type=click.Path(dir_okay=False, path_type=Path))
@click.option("--site", required=True, help="Name of the site.")
@click.option("--start", required=True, help="Local time of the first line: 2026-05-04T06:00:00.")
@click.option("--zone", required=True, help="Time zone of the site, such as Europe/Paris.")
@number_option(
    "--u-start", "u_start_s", help="u of the start (k = 1), seconds (default: as RECORDING says, or 0)."
)
@click.option("--lane", default="", help="Lane that was measured, if the site has several.")
@number_option("--duration", "duration_s", help="Duration in seconds; only for output of `sightline stream`.")
@json_option
def add(
    archive: Path,
    recording: Path,
    site: str,
    start: str,
    zone: str,
    u_start_s: float | None,
    lane: str,
    duration_s: float | None,
    as_json: bool,
) -> None:
    """Add the vehicles of RECORDING (output of `sightline linescan --json` or `stream`) to ARCHIVE."""
    from sightline.infra.local_time import instant_of
    from sightline.traffic.archive import add_recorded
    from sightline.traffic.records import Stood
    from sightline.traffic.sources import read_recorded

    if u_start_s is not None and not 0.0 <= u_start_s < float("inf"):
        raise BadInput("traffic-no-u-start", u_start_s=u_start_s)
    if duration_s is not None and not 0.0 < duration_s < float("inf"):
        raise BadInput("traffic-duration-not-positive", duration_s=duration_s)
    begun = instant_of(start, zone)
    recorded = read_recorded(recording, duration_s)
    stood = Stood(site, lane, zone, begun, recorded.u_start_s if u_start_s is None else u_start_s)
    days = add_recorded(archive, recorded, stood)
    measured, notes = (
        sum(one.speed_mps is not None for one in recorded.passings),
        _start_notes(recorded, stood),
    )
    tell(
        as_json,
        {"vehicles": len(recorded.passings), "measured": measured, "days": days, "notes": notes},
        f"{recorded.name}: {len(recorded.passings)} vehicles, {measured} measured, added to {archive}; "
        f"days touched: {days}.",
        *notes,
    )


def _start_notes(recorded: Recorded, stood: Stood) -> list[str]:
    """Where the recording speaks of another start than the user, who may have given whole seconds."""
    told = recorded.begun
    if told is None:
        return []
    apart_s = abs((told - stood.start).total_seconds())
    if apart_s <= max(_WHOLE_S, expanded(math.hypot(recorded.u_start_s, stood.u_start_s))):
        return []
    return [
        f"{recorded.name} states the start {told.isoformat(timespec='milliseconds')}, but "
        f"{stood.start.astimezone(told.tzinfo).isoformat(timespec='milliseconds')} was given and used."
    ]


@traffic.command()
@click.argument("archive", type=_FOLDER)
@click.argument("recording")
def remove(archive: Path, recording: str) -> None:
    """Remove RECORDING from ARCHIVE, by its file name or the beginning of its SHA-256."""
    from sightline.traffic.archive import remove_recorded

    days = remove_recorded(archive, recording)
    click.echo(f"{recording} was removed from {archive}; days changed: {days}.")


@traffic.command()
@click.argument("archive", type=_FOLDER)
@json_option
def sites(archive: Path, as_json: bool) -> None:
    """List the contents of ARCHIVE by site and lane."""
    from sightline.traffic.archive import require_archive
    from sightline.traffic.query import ArchiveTables

    require_archive(archive)
    with ArchiveTables(archive) as tables:
        found = tables.sites()
    rows = [{**asdict(one), "first_day": str(one.first_day), "last_day": str(one.last_day)} for one in found]
    if as_json:
        print_json({"sites": rows})
        return
    if not rows:
        click.echo(f"{archive} is empty; add a recording with: sightline traffic add")
        return
    _write(sys.stdout, list(rows[0]), rows)


@traffic.command()
@click.argument("archive", type=_FOLDER)
@click.option("--site", "chosen", multiple=True, help="Only this site. May be repeated.")
@click.option("--from", "first", help="First day, such as 2026-05-04.")
@click.option("--to", "last", help="Last day (included).")
@click.option(
    "--minutes",
    default=60,
    show_default=True,
    help="Length of an interval, minutes: 1, 5, 15, 60 ... From local midnight on: where clocks change by "
    "an hour, intervals such as 120 begin at other hours for the rest of the day.",
)
@click.option(
    "--percentile", "percents", default="15,50,85", show_default=True, help="Percentiles of the speeds."
)
@click.option("--lengths", "limits", default="", help="Limits of the length classes in metres, such as 6,12.")
@click.option(
    "-o",
    "--output",
    type=click.Path(dir_okay=False, path_type=Path),
    help="CSV to write (default: print it).",
)
@json_option
def flows(
    archive: Path,
    chosen: tuple[str, ...],
    first: str | None,
    last: str | None,
    minutes: int,
    percents: str,
    limits: str,
    output: Path | None,
    as_json: bool,
) -> None:
    """Compute flow, speeds and occupancy of ARCHIVE by interval: counts, means and percentiles.

    Vehicles that were seen but could not be measured count in the flow. Intervals without observation are
    omitted; partly observed ones are marked.
    """
    from sightline.traffic.archive import require_archive
    from sightline.traffic.query import ArchiveTables, columns_of

    asked = _read_question(chosen, first, last, minutes, percents, limits)
    require_archive(archive)
    _check_sites(archive, chosen)
    with ArchiveTables(archive) as tables:
        rows = tables.intervals(asked)
        if as_json:
            print_json({"intervals": list(rows)})
            return
        with _target(output) as out:
            _write(out, columns_of(asked), rows)
    if output is not None:
        click.echo(f"Written to {output}.")


def _read_question(
    chosen: tuple[str, ...], first: str | None, last: str | None, minutes: int, percents: str, limits: str
) -> Asked:
    from sightline.traffic.records import Asked

    if minutes < 1 or _DAY_MINUTES % minutes:
        raise BadInput("traffic-no-minutes", minutes=minutes)
    of_speed, of_length = _numbers("--percentile", percents), _numbers("--lengths", limits)
    if not of_speed or not all(0 < one < 100 for one in of_speed) or len(set(of_speed)) < len(of_speed):
        raise BadInput("traffic-no-percents", text=percents)
    if any(not 0 < one < 100 for one in of_length) or sorted(set(of_length)) != of_length:
        raise BadInput("traffic-no-limits", text=limits)
    days = _day("--from", first), _day("--to", last)
    if days[0] and days[1] and days[1] < days[0]:
        raise BadInput("traffic-days-turned", first=days[0], last=days[1])
    return Asked(chosen, *days, minutes, tuple(of_speed), tuple(of_length))


def _numbers(option: str, text: str) -> list[float]:
    try:
        return [float(one) for one in text.split(",") if one.strip()]
    except ValueError:
        raise BadInput("traffic-no-numbers", option=option, text=text) from None


def _day(option: str, text: str | None) -> date | None:
    try:
        return None if text is None else date.fromisoformat(text)
    except ValueError:
        raise BadInput("traffic-no-day", option=option, text=text) from None


def _check_sites(archive: Path, chosen: tuple[str, ...]) -> None:
    from sightline.traffic.archive import sites_of

    there = sites_of(archive)
    for site in chosen:
        if site not in there:
            raise BadInput("traffic-no-such-site", site=site, there=", ".join(there) or "-")


@contextmanager
def _target(output: Path | None) -> Iterator[TextIO]:
    """Standard output, or a file that appears whole or not at all."""
    from sightline.media.atomic import atomic_file

    if output is None:
        yield sys.stdout
        return
    if not output.parent.is_dir():
        raise BadInput("commands-output-folder-missing", output=output)
    with atomic_file(output) as part, part.open("w", encoding="utf-8", newline="") as file:
        yield file


def _write(out: TextIO, columns: list[str], rows: Iterable[dict[str, Any]]) -> None:
    from sightline.commands.scanned import cell_of

    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([cell_of(row[name]) for name in columns] for row in rows)
