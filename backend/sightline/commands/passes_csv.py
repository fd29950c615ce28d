"""passes.csv of `sightline adjust` (docs/formats.md): a point a row, lengths on any row of a pass."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sightline.adjustment.adjust import LeftOut
from sightline.adjustment.observed import LENGTHS, POINTS, Known, ObservedPass
from sightline.commands.files import read_csv
from sightline.errors import BadInput
from sightline.infra.given_csv import GivenTable
from sightline.messages.said import Said

NEEDED = ("pass", "frame", "point", "x_px", "y_px")
OPTIONS = ("sigma_px", *(f"{u}{name}_m" for name in LENGTHS for u in ("", "u_")))
_READ = {
    "sigma_px": GivenTable.uncertainty,
    **{f"u_{name}_m": GivenTable.u_length_m for name in LENGTHS},
    **{f"{name}_m": GivenTable.size_m for name in LENGTHS},
    "roof_inset_m": GivenTable.length_m,
}


@dataclass
class _Pass:
    """Rows of one pass so far; the first thing that cannot be read is why it is left out."""

    rows: list[tuple[float, ...]] = field(default_factory=list)
    lengths: dict[str, float] = field(default_factory=dict)
    problem: Said | None = None


def read_passes(path: Path) -> tuple[list[ObservedPass], list[LeftOut]]:
    """The passes of a passes.csv, and those that cannot be read. Raises BadInput where the table cannot."""
    passes: dict[str, _Pass] = {}
    table = read_csv(path, NEEDED, path.name)
    for number, cells in table.sound_rows():
        name = cells["pass"]
        if not name:
            raise BadInput("commands-row-without-pass", path=path, row=number)
        one = passes.setdefault(name, _Pass())
        one.problem = one.problem or _take(table, one, cells, number)
    for one in passes.values():
        one.problem = one.problem or _lone_length(one)
    good = [_observed(name, one) for name, one in passes.items() if one.problem is None]
    return good, [LeftOut(name, one.problem) for name, one in passes.items() if one.problem is not None]


def _take(table: GivenTable, given_pass: _Pass, cells: Mapping[str, str], number: int) -> Said | None:
    """Add a row to its pass, or say what is wrong with it."""
    values: dict[str, float] = {"sigma_px": 1.0}
    for name in ("frame", "x_px", "y_px", *OPTIONS):
        text = cells.get(name, "")
        if not text and name in OPTIONS:
            continue
        try:
            values[name] = _READ.get(name, GivenTable.number)(table, number, name, text)
        except BadInput as error:
            return error.said
    if values["frame"] != round(values["frame"]) or abs(values["frame"]) > 2**53:
        return Said("adjustment-row-frame", row=number)
    if cells["point"] not in POINTS:
        return Said("adjustment-row-point", row=number, points=", ".join(POINTS))
    for name in OPTIONS[1:]:
        if name in values and given_pass.lengths.setdefault(name, values[name]) != values[name]:
            return Said("adjustment-row-another", row=number, column=name)
    point = POINTS.index(cells["point"])
    given_pass.rows.append((values["frame"], point, values["x_px"], values["y_px"], values["sigma_px"]))
    return None


def _lone_length(given_pass: _Pass) -> Said | None:
    for name in LENGTHS:
        value, u = f"{name}_m", f"u_{name}_m"
        if (value in given_pass.lengths) != (u in given_pass.lengths):
            given, lacking = (value, u) if value in given_pass.lengths else (u, value)
            return Said("adjustment-u-lacking", given=given, lacking=lacking)
    return None


def _observed(name: str, given_pass: _Pass) -> ObservedPass:
    table = np.array(given_pass.rows, dtype=np.float64)
    known = {
        length: Known(given_pass.lengths[f"{length}_m"], given_pass.lengths[f"u_{length}_m"])
        for length in LENGTHS
        if f"{length}_m" in given_pass.lengths
    }
    return ObservedPass(
        name=name,
        frame=table[:, 0].astype(np.int64),
        point=table[:, 1].astype(np.int64),
        points_px=table[:, 2:4],
        sigma_px=table[:, 4],
        **known,
    )
