"""clicks.csv to heights.csv (docs/formats.md): every column, then the results; a bad row has a reason."""

import csv
import io
import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import cast, get_args

import numpy as np

from sightline.commands.files import read_csv
from sightline.coverage import COVERAGE_95
from sightline.enums import DriverSide, Target
from sightline.errors import BadInput
from sightline.geometry.height import Height, measure_heights
from sightline.geometry.insets import SIDE_UNKNOWN, USUAL_INSETS, inset_name
from sightline.geometry.multiframe import measure_frames
from sightline.geometry.ray_intersection import REASONS
from sightline.geometry.road_pose import RoadPose
from sightline.infra.given_csv import USUAL_INSET_M, GivenRow, GivenTable
from sightline.messages.said import Said

FIRST = ("contact_x_px", "contact_y_px", "target_x_px", "target_y_px")
_FURTHER = re.compile(r"(?:contact|target)([2-9]|[1-9]\d)_[xy]_px")
OPTIONS = ("sigma_px", "inset_m", "u_inset_m")
_READ: dict[str, Callable[[GivenTable, int, str, str], float]] = {
    "sigma_px": GivenTable.uncertainty,
    "inset_m": partial(GivenTable.length_m, usual_m=USUAL_INSET_M),
    "u_inset_m": partial(GivenTable.u_length_m, usual_m=USUAL_INSET_M),
}
WORDS = ("target", "side")
NEEDED = ("id", *FIRST)
OF_HEIGHT = ("height_m", "u_height_m", "U95_height_m", "x_m", "y_m", "distance_m")
RESULTS = (*OF_HEIGHT, "solved_inset_m", "u_solved_inset_m", "status", "reason", "flags")
BETWEEN_FLAGS = " | "
INSET_TAKEN_AS_0 = Said("height-flag-inset-zero")
U_INSET_TAKEN_AS_0 = Said("height-flag-u-inset-zero")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?(nan|inf|infinity)", re.IGNORECASE)


@dataclass
class _Row:
    """One line: its cells as they were, the numbers read from them, or why they could not be."""

    cells: list[str]
    values: dict[str, float] = field(default_factory=dict)
    frames: tuple[int, ...] = ()  # numbers of the further frames that were clicked too
    problem: str | None = None
    flags: tuple[Said, ...] = ()  # what was taken for granted
    results: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Assumed:
    """The inset that a height is computed with, metres, and what was taken for granted of it."""

    inset_m: float
    u_inset_m: float
    flags: tuple[Said, ...]


def assumed_inset(
    target: str, side: str, inset_m: float | None = None, u_inset_m: float | None = None
) -> Assumed | Said:
    """The inset given, else the usual one of the target, else 0; else why there is none: a word that
    is not known, or an eye without the driver's side.
    """
    if inset_m is not None:
        flags = (U_INSET_TAKEN_AS_0,) if u_inset_m is None else ()
        return Assumed(inset_m, u_inset_m or 0.0, flags)
    usual = _usual_inset(target, side)
    return usual if u_inset_m is None or isinstance(usual, Said) else replace(usual, u_inset_m=u_inset_m)


def _usual_inset(target: str, side: str) -> Assumed | Said:
    if not target:
        return Assumed(0.0, 0.0, (INSET_TAKEN_AS_0,))
    if target not in get_args(Target):
        return Said("height-target-unknown", target=target, known=", ".join(get_args(Target)))
    if target == "driver_eye" and side and side not in get_args(DriverSide):
        return Said("height-side-not-known", side=side, known=", ".join(get_args(DriverSide)))
    name = inset_name(cast(Target, target), cast(DriverSide, side) if side else None, None)
    if name is None:
        return SIDE_UNKNOWN
    inset_m, u_inset_m, _ = USUAL_INSETS[name]
    usual = Said("height-flag-usual-inset", target=target)
    if target == "driver_eye":
        usual = Said("height-flag-usual-inset-of-side", target=target, side=side)
    return Assumed(inset_m, u_inset_m, (usual,))


@dataclass(frozen=True)
class Counts:
    """How many rows there were, and how many got a height."""

    rows: int
    measured: int


def heights_csv(pose: RoadPose, path: Path) -> tuple[str, Counts]:
    """The text of heights.csv for a clicks.csv. Raises BadInput where the table as a whole cannot be read."""
    header, rows = _read_clicks(path)
    single = [row for row in rows if row.problem is None and not row.frames]
    _measure_single(pose, single)
    for row in rows:
        if row.problem is not None:
            row.results = {"status": "not_measurable", "reason": row.problem}
        elif row.frames:
            row.results = _measure_several(pose, row)
    measured = sum(row.results["status"] == "ok" for row in rows)
    return _written(header, rows), Counts(len(rows), measured)


def _read_clicks(path: Path) -> tuple[list[str], list[_Row]]:
    table = read_csv(path, NEEDED, path.name)  # reasons are sent on: no folder of ours
    return table.header, [_parsed(table, row) for row in table.rows]


def _parsed(table: GivenTable, given: GivenRow) -> _Row:
    """One row's numbers; the first cell that cannot be read is the row's reason."""
    row = _Row(given.cells)
    try:
        if given.problem is not None:
            raise given.problem
        _take_numbers(table, given, row)
    except BadInput as error:
        row.problem = error.message
        return row
    by_name = table.by_column(given)
    _assume(row, *(by_name.get(name, "") for name in WORDS))
    return row


def _take_numbers(table: GivenTable, given: GivenRow, row: _Row) -> None:
    by_name = table.by_column(given)
    filled = (_FURTHER.fullmatch(name) for name, cell in by_name.items() if cell)
    row.frames = tuple(sorted({int(one[1]) for one in filled if one}))
    further = [name.replace("_", f"{k}_", 1) for k in row.frames for name in FIRST]
    for name in (*FIRST, *further, *OPTIONS):
        cell = by_name.get(name, "")
        if cell or name not in OPTIONS:
            row.values[name] = _READ.get(name, GivenTable.number)(table, given.line, name, cell)
    if reference := by_name.get("reference_height_m"):
        table.size_m(given.line, "reference_height_m", reference)


def _assume(row: _Row, target: str, side: str) -> None:
    """Fill in a row's empty options. Several frames solve for the inset, so none is assumed there."""
    row.values.setdefault("sigma_px", 1.0)
    if row.frames:
        return
    inset = assumed_inset(target, side, row.values.get("inset_m"), row.values.get("u_inset_m"))
    if isinstance(inset, Said):
        row.problem = str(inset)
        return
    row.values |= {"inset_m": inset.inset_m, "u_inset_m": inset.u_inset_m}
    row.flags = inset.flags


def _measure_single(pose: RoadPose, rows: Sequence[_Row]) -> None:
    if not rows:
        return
    table = np.array([[row.values[name] for name in (*FIRST, *OPTIONS)] for row in rows])
    heights = measure_heights(pose, table[:, 0:2], table[:, 2:4], table[:, 4], table[:, 5], table[:, 6])
    columns = (
        heights.height_m,
        heights.u_height_m,
        COVERAGE_95 * heights.u_height_m,
        heights.x_m,
        heights.y_m,
        heights.distance_m,
    )
    for index, row in enumerate(rows):
        code = int(heights.code[index])
        if code:
            row.results = {"status": "not_measurable", "reason": str(REASONS[code])}
            continue
        row.results = {
            name: metres(float(column[index])) for name, column in zip(OF_HEIGHT, columns, strict=True)
        }
        row.results["status"] = "ok"
        row.results["flags"] = _join_flags((*row.flags, *heights.flags(index)))


def _measure_several(pose: RoadPose, row: _Row) -> dict[str, str]:
    """All frames of one vehicle: the inset is solved for, not assumed."""
    frames = ("", *row.frames)
    contacts = [[row.values[f"contact{k}_{axis}_px"] for axis in "xy"] for k in frames]
    targets = [[row.values[f"target{k}_{axis}_px"] for axis in "xy"] for k in frames]
    found = measure_frames(pose, contacts, targets, row.values["sigma_px"])
    out = _of_height(found.height)
    if found.solved_inset_m is not None and found.u_solved_inset_m is not None:
        out["solved_inset_m"] = metres(found.solved_inset_m)
        out["u_solved_inset_m"] = metres(found.u_solved_inset_m)
    return out


def _of_height(height: Height) -> dict[str, str]:
    reason = "" if height.reason is None else str(height.reason)
    out = {"status": height.status, "reason": reason, "flags": _join_flags(height.flags)}
    for name in OF_HEIGHT:
        value = getattr(height, name)
        out[name] = "" if value is None else metres(value)
    return out


def _join_flags(flags: Iterable[Said]) -> str:
    return BETWEEN_FLAGS.join(map(str, flags))


def metres(value: float) -> str:
    """A length with six decimals, never a negative zero; empty where there is none."""
    return "" if not math.isfinite(value) else f"{value:z.6f}"


def escape_formula(cell: str) -> str:
    """A cell that a spreadsheet would run as a formula gets an apostrophe; numbers stay numbers."""
    if cell[:1] in ("=", "+", "-", "@", "\t", "\r") and not _NUMBER.fullmatch(cell.strip()):
        return "'" + cell
    return cell


def _written(header: list[str], rows: list[_Row]) -> str:
    """The table as text: the columns given (but for old results), then the new results."""
    keep = [i for i, name in enumerate(header) if name not in RESULTS]
    out = io.StringIO(newline="")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([*(escape_formula(header[i]) for i in keep), *RESULTS])
    for row in rows:
        results = (row.results.get(name, "") for name in RESULTS)
        writer.writerow([*(escape_formula(row.cells[i]) for i in keep), *results])
    return out.getvalue()
