"""The command linescan (docs/formats.md): vehicles from a pair of strips, read once from front to back."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from contextlib import closing
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, get_args

import click

from sightline.commands.clicks import harmless, metres
from sightline.commands.files import write_whole
from sightline.commands.options import json_option
from sightline.enums import ScanMethod, TimeAxis
from sightline.errors import BadInput
from sightline.linescan import faults
from sightline.linescan.finding import Finder
from sightline.linescan.gaps import gaps
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Gap, Motion, Passage, Rig
from sightline.linescan.rig import BASELINE_M, LINE_RATE_HZ, U_BASELINE_M, U_LINE_RATE_RATIO
from sightline.media.strips.notes import column_of, lost_lines
from sightline.media.strips.reader import Strip, check_pair, open_strip

COLUMNS = (
    "id",
    "front_line_1",
    "rear_line_1",
    "front_line_2",
    "rear_line_2",
    "speed_mps",
    "u_speed_mps",
    "acceleration_mps2",
    "u_acceleration_mps2",
    "length_m",
    "u_length_m",
    "fit_error_percent",
    "time_gap_s",
    "distance_gap_m",
    "status",
    "reason",
)


@dataclass(frozen=True)
class Vehicle:
    """One vehicle as it is written: lines as columns of the files, motion without its profile, gap."""

    number: int
    columns: Crossings
    motion: Motion
    gap: Gap


@click.command()
@click.argument("first", type=click.Path(path_type=Path))
@click.argument("second", type=click.Path(path_type=Path))
@click.option("--baseline", type=float, required=True, help="Between the scanning planes, metres.")
@click.option("--line-rate", type=float, required=True, help="Lines a second of either camera, Hz.")
@click.option("--u-baseline", type=float, default=0.0, help="Standard uncertainty of the baseline, metres.")
@click.option("--u-line-rate", type=float, default=0.0, help="Of the line rate, as a share (1e-4 is 0.01 %).")
@click.option("--time-axis", type=click.Choice(get_args(TimeAxis)), default="width", show_default=True)
@click.option("--method", type=click.Choice(get_args(ScanMethod)), default="direct", show_default=True)
@click.option("-o", "--output", type=click.Path(path_type=Path), help="vehicles.csv; else it is printed.")
@json_option
def linescan(
    first: Path,
    second: Path,
    baseline: float,
    line_rate: float,
    u_baseline: float,
    u_line_rate: float,
    time_axis: TimeAxis,
    method: ScanMethod,
    output: Path | None,
    as_json: bool,
) -> None:
    """Vehicles from a line-scan pair: speed, acceleration, length and gaps.

    FIRST and SECOND are PNG or TIFF pictures, FIRST of the camera that vehicles reach first. A file named
    FIRST.json beside it may tell lines that the recorder lost: {"dropped_lines": [[line, count], ...]}.
    """
    rig = _rig(baseline, line_rate, u_baseline, u_line_rate)
    if output is not None and not output.parent.is_dir():
        raise BadInput("commands-cannot-written-folder-not-exist-choose", output=output)
    with closing(_opened(first, time_axis)) as one, closing(_opened(second, time_axis)) as two:
        if first.samefile(second):
            raise BadInput("commands-given-twice-give-strips-both-cameras", first=first)
        check_pair(one, two)
        notes = _rate_notes((one, two), rig)
        finder = Finder(one.rows, rig)
        table = _Table(as_json)
        for vehicle in _vehicles(one, two, finder, method):
            table.add(vehicle)
        said = {"method": method, "lines": one.lines, "rows": one.rows, **_of_rig(rig)}
    notes += faults.notes_of(finder)
    if table.measured and rig.u_baseline_m == 0:
        notes.append("The uncertainties leave out the baseline's, which was not given (--u-baseline).")
    if output is not None:
        write_whole(output, table.csv())
    if as_json:
        click.echo(table.json({**said, "notes": notes}))
    elif output is None:
        click.echo(table.csv(), nl=False)
    else:
        click.echo(f"{table.found} vehicles, {table.measured} measured; written to {output}.")
    if not as_json:
        for note in notes:
            click.echo(note, err=output is None)


class _Table:
    """What is written of the vehicles, kept as text: hours of traffic hold thousands."""

    def __init__(self, as_json: bool) -> None:
        self.found = self.measured = 0
        self._text = io.StringIO(newline="")
        self._writer = csv.writer(self._text, lineterminator="\n")
        self._writer.writerow(COLUMNS)
        self._objects: list[str] | None = [] if as_json else None

    def add(self, vehicle: Vehicle) -> None:
        self.found += 1
        self.measured += vehicle.motion.status == "ok"
        self._writer.writerow([_cell(value) for value in _row(vehicle).values()])
        if self._objects is not None:
            self._objects.append(json.dumps(_of_vehicle(vehicle), allow_nan=False))

    def csv(self) -> str:
        return self._text.getvalue()

    def json(self, about: dict[str, Any]) -> str:
        """One object: what is said about all, then the vehicles."""
        return f'{json.dumps(about, allow_nan=False)[:-1]}, "vehicles": [{", ".join(self._objects or [])}]}}'


def _rig(baseline: float, line_rate: float, u_baseline: float, u_line_rate: float) -> Rig:
    BASELINE_M.require(baseline, "--baseline")
    LINE_RATE_HZ.require(line_rate, "--line-rate")
    replace(U_BASELINE_M, most=baseline).require(u_baseline, "--u-baseline")
    U_LINE_RATE_RATIO.require(u_line_rate, "--u-line-rate")
    return Rig(baseline, line_rate, u_baseline_m=u_baseline, u_line_rate_ratio=u_line_rate)


def _opened(path: Path, time_axis: TimeAxis) -> Strip:
    return open_strip(path, time_axis, name=str(path))


def _rate_notes(strips: tuple[Strip, Strip], rig: Rig) -> list[str]:
    """Where the recorder speaks of another line rate than the user."""
    return [
        f"{strip.name} says that its line rate is {told:g} Hz, {rig.line_rate_hz:g} Hz was given and used."
        for strip in strips
        if (told := strip.notes.line_rate_hz) is not None and abs(told / rig.line_rate_hz - 1) > 1e-3
    ]


def _vehicles(one: Strip, two: Strip, finder: Finder, method: ScanMethod) -> Iterator[Vehicle]:
    """Every vehicle in order, with its gap to the one before; only one pair is held at a time."""
    before: tuple[Crossings, Motion] | None = None
    for number, passage in enumerate(_passages(one, two, finder), 1):
        motion = replace(MEASURE[method](_without_losses(passage, one, two), finder.rig), profile=None)
        this = (passage.crossings, motion)
        gap = gaps([before, this] if before else [this], finder.rig)[-1]
        yield Vehicle(number, _columns(passage.crossings, one, two), motion, gap)
        before = this


def _passages(one: Strip, two: Strip, finder: Finder) -> Iterator[Passage]:
    for first, second in zip(one.chunks(), two.chunks(), strict=True):
        yield from finder.push(first, second)
    yield from finder.finish()


def _without_losses(passage: Passage, one: Strip, two: Strip) -> Passage:
    """A vehicle during which lines were lost has its reason."""
    lost = {
        strip.name: lost_lines(strip.notes.dropped, start, start + len(picture))
        for strip, start, picture in (
            (one, passage.start_1, passage.first),
            (two, passage.start_2, passage.second),
        )
    }
    said = [f"{count} lines of {name}" for name, count in lost.items() if count]
    if not said or passage.reason:
        return passage
    return replace(passage, reason=f"The recorder lost {' and '.join(said)} while the vehicle passed.")


def _columns(crossings: Crossings, one: Strip, two: Strip) -> Crossings:
    first, second = one.notes.dropped, two.notes.dropped
    return Crossings(
        column_of(crossings.front_line_1, first),
        column_of(crossings.rear_line_1, first),
        column_of(crossings.front_line_2, second),
        column_of(crossings.rear_line_2, second),
    )


def _row(vehicle: Vehicle) -> dict[str, Any]:
    motion, gap = vehicle.motion, vehicle.gap
    held = {**asdict(vehicle.columns), "id": vehicle.number}
    held |= {"time_gap_s": gap.time_gap_s, "distance_gap_m": gap.distance_gap_m}
    return {name: held[name] if name in held else getattr(motion, name) for name in COLUMNS}


def _of_vehicle(vehicle: Vehicle) -> dict[str, Any]:
    """A vehicle as JSON: the columns of the CSV, then what a table has no room for."""
    motion, gap = vehicle.motion, vehicle.gap
    more = ("misalignment_px", "u_misalignment_px", "gain")
    return {
        **_row(vehicle),
        **{name: getattr(motion, name) for name in more},
        "u_time_gap_s": gap.u_time_gap_s,
        "u_distance_gap_m": gap.u_distance_gap_m,
        "headway_s": gap.headway_s,
        "paper_distance_gap_m": gap.paper_distance_gap_m,
        "gap_reason": gap.reason,
        "budget": [asdict(entry) for entry in motion.budget],
        "warnings": list(motion.warnings),
    }


def _of_rig(rig: Rig) -> dict[str, Any]:
    names = ("baseline_m", "u_baseline_m", "line_rate_hz", "u_line_rate_ratio")
    return {name: getattr(rig, name) for name in names}


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return metres(value) if isinstance(value, float) else harmless(str(value))
