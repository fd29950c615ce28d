"""Scanned vehicles as the commands linescan and stream write them: one table's columns, one object each."""

import functools
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any, get_args

import click

from sightline.commands.clicks import escape_formula, metres
from sightline.commands.files import read_json
from sightline.commands.options import FILE, choice_option, number_option
from sightline.enums import ScanDirection, ScanMethod
from sightline.errors import BadInput
from sightline.infra.local_time import to_millisecond
from sightline.linescan.clock import u_passing_s
from sightline.linescan.parts import USUAL_SHADOW_SHARE, Lane, Rig
from sightline.linescan.passing import Vehicle
from sightline.linescan.rig import CALIBRATED, require_rig, rig_from

_OF_FILE = (*CALIBRATED, "distance_m", "u_distance_m")
_OPTIONS = {
    "baseline_m": "--baseline",
    "line_rate_hz": "--line-rate",
    "u_baseline_m": "--u-baseline",
    "u_line_rate_ratio": "--u-line-rate",
    "shadow_share": "--shadow-share",
}
_OF_LANE = tuple(one.name for one in fields(Lane))
_NUMBERS = frozenset(_OF_LANE) - {"name", "direction"}

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
    "direction",
    "axles",
    "lane",
)


NO_U_LINE_RATE = "The uncertainty of the line rate is not included, because it was not given (--u-line-rate)."
#: Further columns where it is known when line 0 was taken.
TIMES = ("front_at", "u_front_at_s")
_MOST_U_START_S = 3600.0


@dataclass(frozen=True)
class Start:
    """When line 0 was taken at camera 1, with its offset from UTC; `u_s` (k = 1): None where not given."""

    at: datetime
    u_s: float | None

    def times_of(self, vehicle: Vehicle, rig: Rig) -> dict[str, Any]:
        """The columns of `TIMES`: when its front reached camera 1, and the u of that."""
        motion = vehicle.motion
        at = to_millisecond(self.at + timedelta(seconds=vehicle.front_s))
        u_s = u_passing_s(
            vehicle.front_s, self.u_s, rig.u_line_rate_ratio, motion.speed_mps, motion.u_length_m
        )
        return {"front_at": at.isoformat(timespec="milliseconds"), "u_front_at_s": u_s}


def start_of(text: str | None, u_s: float | None) -> Start | None:
    """--start and --u-start; None where no start was given. Raises BadInput naming the option."""
    if text is None:
        if u_s is not None:
            raise BadInput("commands-u-without-start")
        return None
    if u_s is not None and not 0.0 <= u_s <= _MOST_U_START_S:
        raise BadInput("commands-start-u-range", u_s=u_s)
    return Start(instant_with_offset("--start", text), u_s)


def instant_with_offset(option: str, text: str) -> datetime:
    """A time of day with its offset from UTC, ISO 8601. Raises BadInput naming the option."""
    try:
        at = datetime.fromisoformat(text.strip())
    except ValueError:
        raise BadInput("commands-time-cannot-read", option=option, text=text[:40]) from None
    if at.tzinfo is None:
        raise BadInput("commands-time-no-offset", option=option, text=text[:40])
    if not _FIRST_YEAR <= at.year < _LAST_YEAR:
        raise BadInput("commands-time-cannot-read", option=option, text=text[:40])
    return at


_FIRST_YEAR, _LAST_YEAR = 1990, 2200


U_LINE_RATE = number_option(
    "--u-line-rate", "u_line_rate_ratio", default=0.0, help="Relative u of the line rate (1e-4 is 0.01 %)."
)
_RIG = (
    choice_option(
        "--method",
        of=ScanMethod,
        default="direct",
        help="Direct registration, or block matching as in the paper (Douxchamps et al.).",
    ),
    number_option(
        "--shadow-share",
        default=USUAL_SHADOW_SHARE,
        help="Shadow zone: share of the rows, from the bottom, that is not searched.",
    ),
    U_LINE_RATE,
    number_option("--u-baseline", "u_baseline_m", default=0.0, help="u of the baseline, metres."),
    number_option("--line-rate", "line_rate_hz", required=True, help="Line rate of each camera, Hz."),
    click.option(
        "--rig",
        "rig_file",
        type=FILE,
        help="JSON of `sightline rig calibrate -o`, with the lanes of the rig, instead of --baseline.",
    ),
    number_option("--baseline", "baseline_m", help="Baseline: distance between the scanning planes, metres."),
)


def rig_options(command: Callable[..., None]) -> Callable[..., None]:
    """Where the two cameras stand, how quick they are, and how their lines become motion: what the command
    is given of them are the `rig` and the `method`.
    """

    @functools.wraps(command)
    def with_rig(*, rig_file: Path | None, baseline_m: float | None, **given: Any) -> None:
        stated = {name: given.pop(name) for name in _OPTIONS if name != "baseline_m"}
        command(rig=_rig_of(rig_file, baseline_m, stated), **given)

    return functools.reduce(lambda made, option: option(made), _RIG, with_rig)


def _rig_of(rig_file: Path | None, baseline_m: float | None, stated: dict[str, Any]) -> Rig:
    """The rig that the options give. Raises BadInput naming the option, or the file, that cannot be."""
    if (baseline_m is None) == (rig_file is None) or (rig_file is not None and stated["u_baseline_m"]):
        raise BadInput("commands-baseline-or-rig")
    rig = Rig(1.0 if baseline_m is None else baseline_m, **stated)
    if rig_file is not None:
        return _rig_in(rig_file, rig)
    require_rig(rig, _OPTIONS)
    return rig


def _rig_in(path: Path, given: Rig) -> Rig:
    """A calibrated rig with its lanes; numbers that are not of it are left out."""
    document = read_json(path, "a rig as JSON")
    if not isinstance(document, dict):
        raise BadInput("commands-not-a-rig", path=path)
    held = {name: document[name] for name in _OF_FILE if name in document}
    if "correlation" in document:
        # as `rig calibrate` calls it
        held.setdefault("baseline_correlation", document["correlation"])
    lanes = document.get("lanes", [])
    if "baseline_m" not in held or not isinstance(lanes, list):
        raise BadInput("commands-not-a-rig", path=path)
    rows = []
    for number, lane in enumerate(lanes, 1):
        if not isinstance(lane, dict) or "distance_m" not in lane:
            raise BadInput("commands-not-a-rig", path=path)
        rows.append({"name": str(number), **{name: lane[name] for name in _OF_LANE if name in lane}})
    numbers = [*held.values(), *(value for row in rows for name, value in row.items() if name in _NUMBERS)]
    words = [row.get("direction") for row in rows]
    sound = all(type(one) in (int, float) or one is None for one in numbers)
    if not sound or not set(words) <= {None, *get_args(ScanDirection)}:
        raise BadInput("commands-not-a-rig", path=path)
    rig = rig_from({**asdict(given), **held, "lanes": rows})
    require_rig(rig)
    return rig


def row_of(vehicle: Vehicle) -> dict[str, Any]:
    """The columns of vehicles.csv, by name."""
    motion, gap = vehicle.motion, vehicle.gap
    held = {**asdict(vehicle.columns), "id": vehicle.number}
    if vehicle.rear_s is None:
        held |= {"rear_line_1": None, "rear_line_2": None}
    held |= {"time_gap_s": gap.time_gap_s, "distance_gap_m": gap.distance_gap_m}
    held |= {"direction": motion.crossings.direction, "axles": len(motion.axle_lines or ()) or None}
    held |= {"lane": motion.lane}
    held |= {"reason": motion.reason and str(motion.reason)}
    return {name: held[name] if name in held else getattr(motion, name) for name in COLUMNS}


def object_of(vehicle: Vehicle) -> dict[str, Any]:
    """A vehicle as JSON: the columns of the CSV, then what a table has no room for."""
    motion, gap = vehicle.motion, vehicle.gap
    more = ("misalignment_px", "u_misalignment_px", "gain", "tyres_px")
    return {
        **row_of(vehicle),
        "front_s": vehicle.front_s,
        "rear_s": vehicle.rear_s,
        **{name: getattr(motion, name) for name in more},
        "u_time_gap_s": gap.u_time_gap_s,
        "u_distance_gap_m": gap.u_distance_gap_m,
        "headway_s": gap.headway_s,
        "paper_distance_gap_m": gap.paper_distance_gap_m,
        "gap_reason": gap.reason and str(gap.reason),
        "budget": [asdict(entry) for entry in motion.budget],
        "warnings": [str(one) for one in motion.warnings],
    }


def left_out(rig: Rig, measured: int, start: Start | None = None) -> list[str]:
    """What the uncertainties of `measured` vehicles do not hold, in words."""
    out = []
    if measured and rig.u_baseline_m == 0:
        out.append(
            "The uncertainty of the baseline is not included, because it was not given (--u-baseline)."
        )
    if measured and rig.u_line_rate_ratio == 0:
        out.append(NO_U_LINE_RATE)
    if measured and start is not None and start.u_s is None:
        out.append("Times of day have no uncertainty, because that of the start was not given (--u-start).")
    return out


def about_rig(rig: Rig) -> dict[str, Any]:
    """All that was said of the rig, by name: `rig_from` makes it again."""
    return asdict(rig)


def cell_of(value: Any) -> str:
    """A value as a cell: lengths with six decimals, nothing for None."""
    if value is None:
        return ""
    return metres(value) if isinstance(value, float) else escape_formula(str(value))
