"""passes.csv of `sightline adjust` (docs/formats.md): a point a row, lengths on any row of a pass."""

import csv
import io
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sightline.adjustment.adjust import LeftOut
from sightline.adjustment.observed import POINTS, Known, ObservedPass
from sightline.commands.files import read_text
from sightline.errors import BadInput

NEEDED = ("pass", "frame", "point", "x_px", "y_px")
LENGTHS = ("wheelbase", "roof", "roof_inset")
OPTIONS = ("sigma_px", *(f"{u}{name}_m" for name in LENGTHS for u in ("", "u_")))
_WHAT = f"a CSV table with the columns {', '.join(NEEDED)}"


@dataclass
class _Pass:
    """Rows of one pass so far; the first thing that cannot be read is why it is left out."""

    rows: list[tuple[float, ...]] = field(default_factory=list)
    lengths: dict[str, float] = field(default_factory=dict)
    problem: str | None = None


def read_passes(path: Path) -> tuple[list[ObservedPass], list[LeftOut]]:
    """The passes of a passes.csv, and those that cannot be read. Raises BadInput where the table cannot."""
    found: dict[str, _Pass] = {}
    for number, cells in _rows(path):
        name = cells["pass"]
        if not name:
            raise BadInput("commands-row-without-pass", path=path, row=number)
        one = found.setdefault(name, _Pass())
        one.problem = one.problem or _take(one, cells, number)
    for one in found.values():
        one.problem = one.problem or _lone_length(one)
    good = [_observed(name, one) for name, one in found.items() if one.problem is None]
    return good, [LeftOut(name, one.problem) for name, one in found.items() if one.problem is not None]


def _rows(path: Path) -> list[tuple[int, dict[str, str]]]:
    text = read_text(path, _WHAT)
    try:
        lines = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    except csv.Error as error:
        raise BadInput("commands-not-readable-csv-table-give", path=path, problem=error, what=_WHAT) from None
    numbered = [
        (number, cells) for number, cells in enumerate(lines, 1) if any(cell.strip() for cell in cells)
    ]
    if not numbered:
        raise BadInput("commands-empty-give", path=path, what=_WHAT)
    header = [name.strip() for name in numbered[0][1]]
    missing = [name for name in NEEDED if name not in header]
    if missing:
        hint = "; separate its columns by commas" if ";" in numbered[0][1][0] else ""
        raise BadInput(
            "commands-no-column-give", path=path, missing=", ".join(missing), what=_WHAT, hint=hint
        )
    twice = sorted({name for name in header if header.count(name) > 1})
    if twice:
        raise BadInput("commands-column-more-once-name-each-column", path=path, twice=", ".join(twice))
    out = []
    for number, cells in numbered[1:]:
        if len(cells) != len(header):
            raise BadInput("commands-row-cells", path=path, row=number, cells=len(cells), columns=len(header))
        out.append((number, dict(zip(header, (cell.strip() for cell in cells), strict=True))))
    return out


def _take(one: _Pass, cells: Mapping[str, str], number: int) -> str | None:
    """Add a row to its pass, or say what is wrong with it."""
    values: dict[str, float] = {"sigma_px": 1.0}
    for name in ("frame", "x_px", "y_px", *OPTIONS):
        text = cells.get(name, "")
        if not text and name in OPTIONS:
            continue
        try:
            values[name] = float(text)
        except ValueError:
            return f"Row {number}: the cell {name} is {'empty' if not text else 'not a number'}."
        if not math.isfinite(values[name]):
            return f"Row {number}: the cell {name} is not a finite number."
    if values["frame"] != round(values["frame"]) or abs(values["frame"]) > 2**53:
        return f"Row {number}: the cell frame is not a whole number."
    if cells["point"] not in POINTS:
        return f"Row {number}: the cell point is none of {', '.join(POINTS)}."
    for name in OPTIONS[1:]:
        if name in values and one.lengths.setdefault(name, values[name]) != values[name]:
            return f"Row {number}: another {name} was given for the same pass."
    point = POINTS.index(cells["point"])
    one.rows.append((values["frame"], point, values["x_px"], values["y_px"], values["sigma_px"]))
    return None


def _lone_length(one: _Pass) -> str | None:
    for name in LENGTHS:
        value, u = f"{name}_m", f"u_{name}_m"
        if (value in one.lengths) != (u in one.lengths):
            given, lacking = (value, u) if value in one.lengths else (u, value)
            return f"{given} is given without {lacking}."
    return None


def _observed(name: str, one: _Pass) -> ObservedPass:
    table = np.array(one.rows, dtype=np.float64)
    known = {
        length: Known(one.lengths[f"{length}_m"], one.lengths[f"u_{length}_m"])
        for length in LENGTHS
        if f"{length}_m" in one.lengths
    }
    return ObservedPass(
        name=name,
        frame=table[:, 0].astype(np.int64),
        point=table[:, 1].astype(np.int64),
        points_px=table[:, 2:4],
        sigma_px=table[:, 4],
        **known,
    )
