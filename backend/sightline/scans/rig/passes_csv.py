"""Passes of a staff or board from a CSV (docs/formats.md); a row that tells nothing has its reason."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields

from sightline.errors import BadInput
from sightline.infra.given_csv import GivenTable, read_table, strip_formula_apostrophe
from sightline.linescan.rig_calibration import VALUES, Common, RigPass, RigPassError, span_of
from sightline.messages.said import Said

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
    reason: Said


@dataclass(frozen=True)
class GivenPasses:
    """What a table holds: passes that can be used, rows that cannot."""

    passes: tuple[RigPass, ...]
    refused: tuple[RefusedRow, ...]


def read_rig_passes(data: bytes, name: str, common: Common) -> GivenPasses:
    """The passes of a CSV by its columns' names; other columns are passed over.

    Raises BadInput where it is no table, has no distances or no way whole, or more than MOST_PASSES rows.
    """
    table = read_table(data, name, MOST_BYTES)
    columns = _columns(table.header, name)
    if len(table.rows) > MOST_PASSES:
        raise BadInput("rig-passes-too-many", name=name, most=MOST_PASSES)
    passes: list[RigPass] = []
    refused: list[RefusedRow] = []
    for row in table.rows:
        named = {column: strip_formula_apostrophe(row.cells[at].strip()) for column, at in columns.items()}
        called = named.pop(NAME, "")[:MOST_SIGNS] or str(row.line)
        try:
            if row.problem is not None:
                raise row.problem
            if any(one.name == called for one in passes):
                raise RigPassError("rig-pass-twice")
            rig_pass = _pass(table, row.line, called, named)
            span_of(rig_pass, common)
        except BadInput as error:
            refused.append(RefusedRow(row.line, called, error.said))
        else:
            passes.append(rig_pass)
    return GivenPasses(tuple(passes), tuple(refused))


def _columns(header: Sequence[str], name: str) -> dict[str, int]:
    """Where each column stands that is known."""
    titles = [one.lower() for one in header]
    twice = sorted({one for one in titles if one in COLUMNS and titles.count(one) > 1})
    if twice:
        raise BadInput("csv-column-twice", name=name, line=1, column=twice[0])
    whole = any(set(names) <= set(titles) for names in VALUES.values())
    if "distance_m" not in titles or not whole:
        ways = " | ".join(", ".join(names) for names in VALUES.values())
        raise BadInput("rig-passes-columns", name=name, ways=ways)
    return {one: at for at, one in enumerate(titles) if one in COLUMNS}


def _pass(table: GivenTable, line: int, called: str, cells: Mapping[str, str]) -> RigPass:
    """Raises BadInput for a cell that is no number; an empty one is as if its column were not there."""
    values = {column: table.number(line, column, cell) for column, cell in cells.items() if cell}
    if "distance_m" not in values:
        raise RigPassError("rig-pass-lacks", column="distance_m")
    return RigPass(name=called, **values)
