"""Passes of a staff or board from a CSV (docs/formats.md); a row that tells nothing has its reason."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields

from sightline.errors import BadInput
from sightline.infra.given_csv import given_number, read_given_csv, undefused
from sightline.linescan.rig_calibration import VALUES, Common, RigPass, RigPassError, span_of

MOST_BYTES = 1_000_000
MOST_PASSES = 500
MOST_SIGNS = 60
NAME = "pass"
COLUMNS = (NAME, *(one.name for one in fields(RigPass) if one.name != "name"))


@dataclass(frozen=True)
class RefusedRow:
    """A row that tells nothing of the rig, and why."""

    row: int
    name: str
    reason: str


@dataclass(frozen=True)
class GivenPasses:
    """What a table holds: passes that can be used, rows that cannot."""

    passes: tuple[RigPass, ...]
    refused: tuple[RefusedRow, ...]


def read_rig_passes(data: bytes, name: str, common: Common) -> GivenPasses:
    """The passes of a CSV by its columns' names; other columns are passed over.

    Raises BadInput where it is no table, has no distances or no way whole, or more than MOST_PASSES rows.
    """
    header, lines = read_given_csv(data, name, MOST_BYTES)
    columns = _columns(header, name)
    if len(lines) > MOST_PASSES:
        raise BadInput("rig-passes-too-many", name=name, most=MOST_PASSES)
    passes: list[RigPass] = []
    refused: list[RefusedRow] = []
    for line, cells in lines:
        named = {
            column: undefused(cell.strip()) for column, cell in zip(columns, cells, strict=False) if column
        }
        called = named.pop(NAME, "")[:MOST_SIGNS] or str(line)
        try:
            if len(cells) != len(header):
                raise RigPassError(
                    f"It has {len(cells)} cells, and the header has {len(header)}; correct the row."
                )
            if any(one.name == called for one in passes):
                raise RigPassError("Another row has the same name; name each pass once.")
            one = _pass(called, named)
            span_of(one, common)
        except RigPassError as error:
            refused.append(RefusedRow(line, called, str(error)))
        else:
            passes.append(one)
    return GivenPasses(tuple(passes), tuple(refused))


def _columns(header: Sequence[str], name: str) -> list[str | None]:
    """The name of each column that is known, None for others."""
    found = [one.lower() for one in header]
    twice = sorted({one for one in found if one in COLUMNS and found.count(one) > 1})
    if twice:
        raise BadInput("commands-column-more-once-name-each-column", path=name, twice=", ".join(twice))
    whole = any(set(names) <= set(found) for names in VALUES.values())
    if "distance_m" not in found or not whole:
        ways = " | ".join(", ".join(names) for names in VALUES.values())
        raise BadInput("rig-passes-columns", name=name, ways=ways)
    return [one if one in COLUMNS else None for one in found]


def _pass(called: str, cells: Mapping[str, str]) -> RigPass:
    """Raises RigPassError for a cell that is no number; an empty one is as if its column were not there."""
    values: dict[str, float] = {}
    for column, cell in cells.items():
        if not cell:
            continue
        value = given_number(cell)
        if value is None:
            raise RigPassError(f"The cell {column} is not a number; correct it.")
        values[column] = value
    if "distance_m" not in values:
        raise RigPassError("The value distance_m is missing; fill it in.")
    return RigPass(name=called, **values)
