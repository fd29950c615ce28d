"""The command linescan (docs/formats.md): vehicles from a pair of strips, read once from front to back.

Strips of more than 8 bits are read twice: the whole strip tells the camera's depth.
"""

import csv
import io
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import click

from sightline.commands.files import write_whole
from sightline.commands.options import (
    FILE,
    choice_option,
    json_option,
    json_text,
    number_option,
    output_option,
)
from sightline.commands.scanned import (
    COLUMNS,
    TIMES,
    Start,
    about_rig,
    cell_of,
    left_out,
    object_of,
    rig_options,
    row_of,
    start_of,
)
from sightline.enums import ScanMethod, TimeAxis
from sightline.errors import BadInput
from sightline.infra.local_time import to_millisecond
from sightline.linescan import faults
from sightline.linescan.finding import Finder
from sightline.linescan.parts import Passage, Rig
from sightline.linescan.passing import Vehicle, measure_passages
from sightline.media.strips.notes import columns_of
from sightline.media.strips.reader import Strip, bits_of, check_pair, open_strip
from sightline.scans.losses import without_losses


@click.command()
@click.argument("first", type=FILE)
@click.argument("second", type=FILE)
@rig_options
@click.option(
    "--start", help="Time of line 0 at camera 1 with its offset from UTC: 2026-05-04T06:00:00.000+02:00."
)
@number_option("--u-start", "u_start_s", help="u of the start (k = 1), seconds.")
@choice_option("--time-axis", of=TimeAxis, default="width", help="Axis of the images along which time runs.")
@output_option("vehicles.csv to write (default: print it).", required=False)
@json_option
def linescan(
    first: Path,
    second: Path,
    rig: Rig,
    start: str | None,
    u_start_s: float | None,
    time_axis: TimeAxis,
    method: ScanMethod,
    output: Path | None,
    as_json: bool,
) -> None:
    """Measure vehicles from two line-scan strips: speed, acceleration, length and gaps.

    FIRST and SECOND are PNG or TIFF images; FIRST is from the camera that vehicles reach first. Vehicles of
    the other direction are measured too (column direction). A file FIRST.json beside FIRST may list the
    lines that the recorder lost: {"dropped_lines": [[line, count], ...]}. With --start every vehicle has the
    time of day at which its front reached camera 1 (columns front_at, u_front_at_s).
    """
    begun = start_of(start, u_start_s)
    if output is not None and not output.parent.is_dir():
        raise BadInput("commands-output-folder-missing", output=output)
    with (
        closing(_open_strip(first, time_axis)) as first_strip,
        closing(_open_strip(second, time_axis)) as second_strip,
    ):
        if first.samefile(second):
            raise BadInput("commands-strip-twice", first=first)
        check_pair(first_strip, second_strip)
        notes = _rate_notes((first_strip, second_strip), rig)
        finder = Finder(first_strip.rows, rig, max(bits_of(first_strip), bits_of(second_strip)))
        table = _Table(as_json, begun, rig)
        lost = first_strip.notes.dropped, second_strip.notes.dropped
        passages = (without_losses(passage, lost) for passage in _passages(first_strip, second_strip, finder))
        for vehicle in measure_passages(passages, rig, method, lambda lines: columns_of(lines, *lost)):
            table.add(vehicle)
        facts = {"method": method, "lines": first_strip.lines, "rows": first_strip.rows, **about_rig(rig)}
        facts["duration_s"] = first_strip.lines / rig.line_rate_hz
        if begun is not None:
            start = to_millisecond(begun.at).isoformat(timespec="milliseconds")
            facts |= {"start": start, "u_start_s": begun.u_s}
    notes += map(str, faults.notes_of(finder))
    notes += left_out(rig, table.measured, begun)
    if output is not None:
        write_whole(output, table.csv())
    if as_json:
        click.echo(table.json({**facts, "notes": notes}))
    elif output is None:
        click.echo(table.csv(), nl=False)
    else:
        click.echo(f"{table.found} vehicles, {table.measured} measured; written to {output}.")
    if not as_json:
        for note in notes:
            click.echo(note, err=output is None)


class _Table:
    """What is written of the vehicles, kept as text: hours of traffic hold thousands."""

    def __init__(self, as_json: bool, start: Start | None, rig: Rig) -> None:
        self.found = self.measured = 0
        self._start, self._rig = start, rig
        self._text = io.StringIO(newline="")
        self._writer = csv.writer(self._text, lineterminator="\n")
        self._writer.writerow(COLUMNS if start is None else (*COLUMNS, *TIMES))
        self._objects: list[str] | None = [] if as_json else None

    def add(self, vehicle: Vehicle) -> None:
        self.found += 1
        self.measured += vehicle.motion.status == "ok"
        times = {} if self._start is None else self._start.times_of(vehicle, self._rig)
        self._writer.writerow([cell_of(value) for value in (row_of(vehicle) | times).values()])
        if self._objects is not None:
            self._objects.append(json_text(object_of(vehicle) | times))

    def csv(self) -> str:
        return self._text.getvalue()

    def json(self, about: dict[str, Any]) -> str:
        """One object: what is said about all, then the vehicles."""
        return f'{json_text(about)[:-1]}, "vehicles": [{", ".join(self._objects or [])}]}}'


def _open_strip(path: Path, time_axis: TimeAxis) -> Strip:
    return open_strip(path, time_axis, name=str(path))


def _rate_notes(strips: tuple[Strip, Strip], rig: Rig) -> list[str]:
    """Where the recorder speaks of another line rate than the user."""
    return [
        f"{strip.name} states a line rate of {told:g} Hz, but {rig.line_rate_hz:g} Hz was given and used."
        for strip in strips
        if (told := strip.notes.line_rate_hz) is not None and abs(told / rig.line_rate_hz - 1) > 1e-3
    ]


def _passages(one: Strip, two: Strip, finder: Finder) -> Iterator[Passage]:
    for first, second in zip(one.chunks(), two.chunks(), strict=True):
        yield from finder.push(first, second)
    yield from finder.finish()
