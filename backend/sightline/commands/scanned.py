"""Scanned vehicles as the commands linescan and stream write them: one table's columns, one object each."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any, TypeVar, get_args

import click

from sightline.commands.clicks import harmless, metres
from sightline.enums import ScanMethod
from sightline.linescan.gaps import gaps
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Gap, Motion, Passage, Rig
from sightline.linescan.rig import BASELINE_M, LINE_RATE_HZ, U_BASELINE_M, U_LINE_RATE_RATIO

Command = TypeVar("Command", bound=Callable[..., Any])

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


def measured(
    passages: Iterable[Passage],
    rig: Rig,
    method: ScanMethod,
    columns: Callable[[Crossings], Crossings] = lambda crossings: crossings,
) -> Iterator[Vehicle]:
    """Every vehicle in order, with its gap to the one before; only one passage is held at a time.

    columns: crossings as lines of what the vehicles were read from, where that counts otherwise.
    """
    before: tuple[Crossings, Motion] | None = None
    for number, passage in enumerate(passages, 1):
        motion = replace(MEASURE[method](passage, rig), profile=None)
        this = (passage.crossings, motion)
        gap = gaps([before, this] if before else [this], rig)[-1]
        yield Vehicle(number, columns(passage.crossings), motion, gap)
        before = this


def rig_options(command: Command) -> Command:
    """Where the two cameras stand, how quick they are, and how their lines become motion."""
    for option in (
        click.option(
            "--method", type=click.Choice(get_args(ScanMethod)), default="direct", show_default=True
        ),
        click.option(
            "--u-line-rate", type=float, default=0.0, help="Of the line rate, as a share (1e-4 is 0.01 %)."
        ),
        click.option(
            "--u-baseline", type=float, default=0.0, help="Standard uncertainty of the baseline, metres."
        ),
        click.option("--line-rate", type=float, required=True, help="Lines a second of either camera, Hz."),
        click.option("--baseline", type=float, required=True, help="Between the scanning planes, metres."),
    ):
        command = option(command)
    return command


def rig_of(baseline: float, line_rate: float, u_baseline: float, u_line_rate: float) -> Rig:
    """The rig that the options give. Raises BadInput naming the option that cannot be."""
    BASELINE_M.require(baseline, "--baseline")
    LINE_RATE_HZ.require(line_rate, "--line-rate")
    replace(U_BASELINE_M, most=baseline).require(u_baseline, "--u-baseline")
    U_LINE_RATE_RATIO.require(u_line_rate, "--u-line-rate")
    return Rig(baseline, line_rate, u_baseline_m=u_baseline, u_line_rate_ratio=u_line_rate)


def row_of(vehicle: Vehicle) -> dict[str, Any]:
    """The columns of vehicles.csv, by name."""
    motion, gap = vehicle.motion, vehicle.gap
    held = {**asdict(vehicle.columns), "id": vehicle.number}
    held |= {"time_gap_s": gap.time_gap_s, "distance_gap_m": gap.distance_gap_m}
    return {name: held[name] if name in held else getattr(motion, name) for name in COLUMNS}


def object_of(vehicle: Vehicle) -> dict[str, Any]:
    """A vehicle as JSON: the columns of the CSV, then what a table has no room for."""
    motion, gap = vehicle.motion, vehicle.gap
    more = ("misalignment_px", "u_misalignment_px", "gain")
    return {
        **row_of(vehicle),
        **{name: getattr(motion, name) for name in more},
        "u_time_gap_s": gap.u_time_gap_s,
        "u_distance_gap_m": gap.u_distance_gap_m,
        "headway_s": gap.headway_s,
        "paper_distance_gap_m": gap.paper_distance_gap_m,
        "gap_reason": gap.reason,
        "budget": [asdict(entry) for entry in motion.budget],
        "warnings": list(motion.warnings),
    }


def left_out(rig: Rig, measured: int) -> list[str]:
    """What the uncertainties of `measured` vehicles do not hold, in words."""
    if not measured or rig.u_baseline_m > 0:
        return []
    return ["The uncertainties leave out the baseline's, which was not given (--u-baseline)."]


def about_rig(rig: Rig) -> dict[str, Any]:
    """What was said of the rig, by name."""
    names = ("baseline_m", "u_baseline_m", "line_rate_hz", "u_line_rate_ratio")
    return {name: getattr(rig, name) for name in names}


def cell_of(value: Any) -> str:
    """A value as a cell: lengths with six decimals, nothing for None."""
    if value is None:
        return ""
    return metres(value) if isinstance(value, float) else harmless(str(value))
