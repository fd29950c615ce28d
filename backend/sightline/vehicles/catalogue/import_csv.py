"""The catalogue from a CSV: what its columns are taken for, what each line would do, and doing it.

`plan_import` stores nothing. `import_csv` stores what the plan says, and nothing at all where a column's
unit is doubtful: lengths in feet that pass for metres are wrong numbers that look right.
"""

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from statistics import median
from typing import Any, cast, get_args

from sightline.enums import CatalogueChange, Category, ModelSize, OnConflict, SizeUnit
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.infra.given_csv import (
    GivenRow,
    GivenTable,
    given_number,
    read_table,
    require_standard,
    strip_formula_apostrophe,
)
from sightline.messages import write_fixed
from sightline.messages.said import Said, with_commas
from sightline.vehicles.catalogue.records import (
    SIZES,
    CatalogueEntry,
    CatalogueRow,
    ImportColumn,
    Imported,
    ImportPlan,
    ImportRow,
)
from sightline.vehicles.catalogue.store import (
    METRES,
    UNIT_WORDS,
    Key,
    changes,
    import_catalogue_rows,
    is_same_cell,
    key_of,
    known_models,
    merge,
    require_possible,
)

MOST_BYTES = 20_000_000
MOST_ROWS_SHOWN = 500
FIELDS = tuple(one.name for one in fields(CatalogueRow))
_NEEDED = ("make", "model")
_LENGTHS = frozenset([*(f"{name}_m" for name in SIZES), *(f"u_{name}_m" for name in SIZES)])
_YEARS = ("year_from", "year_to")
# Other names of columns; sizes may have their unit behind them, in brackets or not: "Height (mm)",
# "height_ft".
_ALSO = {
    "manufacturer": "make",
    "brand": "make",
    "year": "year_from",
    "first_year": "year_from",
    "last_year": "year_to",
    "class": "category",
    "roof": "height",
    "roof_height": "height",
    "overall_height": "height",
    "overall_length": "length",
    "overall_width": "width",
    "taillight_lower_edge": "taillight",
    "tail_lamp": "taillight",
    "headlight_lower_edge": "headlight",
    "head_lamp": "headlight",
}
# Half of a list's models lie below a size within these, metres: what tells its unit.
_USUAL_M: dict[ModelSize, tuple[float, float]] = {
    "height": (1.1, 3.3),
    "length": (2.3, 7.4),
    "width": (1.3, 2.7),
    "wheelbase": (1.7, 5.5),
    "taillight": (0.35, 1.2),
    "headlight": (0.35, 1.2),
}
_SIZED = re.compile(rf"^(u_|u95_)?(.+?)(?:_({'|'.join(get_args(SizeUnit))}))?$")


@dataclass(frozen=True)
class Choices:
    """How a file is read: fields by header ("" leaves one out), and the unit of sizes that name none or m."""

    columns: Mapping[str, str]
    unit: SizeUnit | None = None
    on_conflict: OnConflict = "keep"


NO_CHOICES = Choices({})


def columns_chosen(given: Iterable[str]) -> dict[str, str]:
    """Fields by header of choices like "make=Hersteller". Raises BadInput."""
    fields_by_header: dict[str, str] = {}
    for choice in given:
        field, equals, header = choice.partition("=")
        if not equals:
            raise BadInput("catalogue-column-choice", column=choice[:100])
        fields_by_header[header] = field
    return fields_by_header


@dataclass(frozen=True)
class _Planned:
    plan: ImportPlan
    rows: list[CatalogueRow]
    known: Mapping[Key, CatalogueEntry]


def plan_import(session: Session, data: bytes, name: str, choices: Choices = NO_CHOICES) -> ImportPlan:
    """What an import of this file would do. Raises BadInput for a file that is no such table."""
    return _planned(session, data, name, choices).plan


def import_csv(
    session: Session, data: bytes, name: str, choices: Choices = NO_CHOICES, *, actor: int | None
) -> Imported:
    """Store the rows of a CSV that can be used; its header names the columns.

    Raises BadInput for a file that is no such table, whose units are doubtful, or of which no row can be
    used.
    """
    planned = _planned(session, data, name, choices)
    if (problem := planned.plan.problem) is not None:
        raise BadInput(problem.code, **problem.values)
    if not planned.rows:
        return Imported(0, 0, planned.plan)
    done = import_catalogue_rows(session, planned.rows, known=planned.known, actor=actor)
    return Imported(done.added, done.updated, planned.plan)


def _planned(session: Session, data: bytes, name: str, choices: Choices) -> _Planned:
    table = read_table(data, name, MOST_BYTES)
    lines = table.rows
    columns = _columns(table, choices)
    known = known_models(session)
    sorter = _Sorter(known, choices.on_conflict)
    missing = _missing(columns, name)
    for line in () if missing else lines:
        sorter.sort(table, line, columns)
    doubtful = missing or next((one.problem for one in columns if one.problem), None)
    if doubtful is None and not lines:
        doubtful = Said("catalogue-no-rows", name=name)
    refused = sorter.counts["refused"]
    if doubtful is None and refused and refused == len(lines):
        first = next(one for one in sorter.rows if one.change == "refused")
        doubtful = Said("vehicles-no-row-used-line", name=name, line=first.line, reason=first.words)
    rows = sorted(sorter.rows, key=lambda one: (_ORDER[one.change], one.line))[:MOST_ROWS_SHOWN]
    plan = ImportPlan(
        columns=tuple(columns),
        counts={word: sorter.counts[word] for word in get_args(CatalogueChange)},
        rows=tuple(rows),
        stored=len(sorter.to_store),
        problem=doubtful,
    )
    return _Planned(plan, sorter.to_store, known)


# Those to look at come first.
_ORDER: dict[CatalogueChange, int] = {
    "refused": 0,
    "conflict": 1,
    "duplicate": 2,
    "update": 3,
    "new": 4,
    "same": 5,
}
Words = Callable[[], Said | None]


class _Sorter:
    """Lines of a file, one after the other: what becomes of each."""

    def __init__(self, known: Mapping[Key, CatalogueEntry], on_conflict: OnConflict) -> None:
        self._known, self._on_conflict = known, on_conflict
        self._first: dict[Key, tuple[int, CatalogueRow]] = {}
        self.counts: Counter[CatalogueChange] = Counter()
        self.rows: list[ImportRow] = []
        self.to_store: list[CatalogueRow] = []

    def sort(self, table: GivenTable, given: GivenRow, columns: Sequence[ImportColumn]) -> None:
        named = {
            one.field: " ".join(cell.split())
            for one, cell in zip(columns, given.cells, strict=True)
            if one.field is not None
        }
        try:
            if given.problem is not None:
                raise given.problem
            row = _read_row(table, given.line, named, columns)
        except BadInput as error:
            who = (named.get("make", ""), named.get("model", ""), None)
            refused = error.said
            self._note(given.line, who, "refused", lambda: refused)
            return
        change, words = self._change(given.line, row)
        self._note(given.line, (row.make, row.model, row.year_from), change, words)

    def _change(self, line: int, row: CatalogueRow) -> tuple[CatalogueChange, Words]:
        key = key_of(row)
        if key in self._first:
            first_line, first = self._first[key]
            if differs(first, row):
                return "duplicate", lambda: Said(
                    "catalogue-duplicate-differs", line=first_line, differences=_differences(first, row)
                )
            return "duplicate", lambda: Said("catalogue-duplicate", line=first_line)
        self._first[key] = (line, row)
        before = self._known.get(key)
        if before is None:
            self.to_store.append(row)
            return "new", _say_nothing
        if differs(before, row):
            theirs = self._on_conflict == "replace"
            kept = row if theirs else merge(row, before)
            if changes(before, kept):
                self.to_store.append(kept)
            if theirs:
                return "conflict", lambda: Said(
                    "catalogue-conflict-replace", differences=_differences(before, row)
                )
            return "conflict", lambda: Said("catalogue-conflict-keep", differences=_differences(before, row))
        gained = [
            name for name in _GAINED if _empty(getattr(before, name)) and not _empty(getattr(row, name))
        ]
        if not gained:
            return "same", _say_nothing
        self.to_store.append(row)
        return "update", lambda: Said("catalogue-fills-in", columns=", ".join(gained))

    def _note(
        self, line: int, who: tuple[str, str, int | None], change: CatalogueChange, words: Words
    ) -> None:
        """Words cost more than all the rest, so they are made for those that are shown alone."""
        self.counts[change] += 1
        if change == "same" or self.counts[change] > MOST_ROWS_SHOWN:
            return
        make, model, year = who
        self.rows.append(
            ImportRow(
                line=line, make=make[:100], model=model[:200], year_from=year, change=change, words=words()
            )
        )


_GAINED = tuple(name for name in FIELDS if not name.endswith("source"))


def _say_nothing() -> None:
    """Said of a line that needs no words."""


def differs(before: CatalogueRow, row: CatalogueRow) -> bool:
    """Whether a size, its u, the last year or the class is known on both sides and not the same."""
    pairs = ((getattr(before, name), getattr(row, name)) for name in _COMPARED)
    return any(not (_empty(old) or _empty(new)) and not is_same_cell(old, new) for old, new in pairs)


_UNCERTAINTIES = tuple(f"u_{name}_m" for name in SIZES)
_COMPARED = (*(f"{name}_m" for name in SIZES), *_UNCERTAINTIES, "category", "year_to")


def _differences(before: CatalogueRow, row: CatalogueRow) -> Said:
    """What `differs`."""
    differences = []
    for name in SIZES:
        old, new = before.size(name), row.size(name)
        if old is not None and new is not None and not is_same_cell(old, new):
            source = before.source_of(name)
            said = f"{name} {write_fixed(old, 3)} m" + (f" ({source})" if source else "")
            differences.append(Said("catalogue-differs", here=f"{write_fixed(new, 3)} m", there=said))
    for field in (*_UNCERTAINTIES, "category", "year_to"):
        old, new = getattr(before, field), getattr(row, field)
        if not _empty(old) and not _empty(new) and not is_same_cell(old, new):
            differences.append(Said("catalogue-differs", here=str(new), there=f"{field} {old}"))
    return with_commas(differences)


def _empty(value: object) -> bool:
    return value is None or value == ""


def _columns(table: GivenTable, choices: Choices) -> list[ImportColumn]:
    """What each column is taken for, by choice or by its name; doubtful where two are taken for one field.
    A u that names no unit has that of its size.
    """
    taken: dict[str, str] = {}
    columns: list[ImportColumn] = []
    unnamed: set[str] = set()
    for at, title in enumerate(table.header):
        field, unit = _field(title, choices)
        problem = _expanded(title, table.name) if field is not None else None
        if problem is not None:
            columns.append(ImportColumn(header=title, field=None, unit=None, problem=problem))
            continue
        if field is not None and field in taken:
            twice = Said("catalogue-column-twice", field=field, first=taken[field], second=title)
            columns.append(ImportColumn(header=title, field=None, unit=None, problem=twice))
            continue
        if field is not None:
            taken[field] = title
            if unit is None and field.startswith("u_"):
                unnamed.add(field)
        cells = (row.cells[at] for row in table.rows if row.problem is None)
        columns.append(_column(title, field, unit, cells, choices.unit))
    unit_of = {f"u_{one.field}": one.unit for one in columns}
    return [
        replace(one, unit=unit_of.get(one.field, one.unit)) if one.field in unnamed else one
        for one in columns
    ]


def _missing(columns: Sequence[ImportColumn], name: str) -> Said | None:
    """Which column is needed that none is taken for. Raises BadInput where the file has no columns at all."""
    taken = {one.field for one in columns}
    missing = " and no column ".join(column for column in _NEEDED if column not in taken)
    if not missing:
        return None
    if len(columns) < len(_NEEDED):
        raise BadInput("vehicles-column-missing", name=name, missing=missing, known=", ".join(FIELDS))
    return Said("catalogue-say-the-columns", name=name, missing=missing)


def _expanded(title: str, name: str) -> Said | None:
    """Why a column that is taken for a field cannot be: it is named as an expanded uncertainty of a size."""
    u, size, _ = _parts(_folded(title))
    if u is None or size not in SIZES:
        return None
    try:
        require_standard(title, name)
    except BadInput as error:
        return error.said
    return None


def _folded(title: str) -> str:
    return re.sub(r"[\s()\[\]]+", "_", title.strip().lower()).strip("_")


def _parts(folded: str) -> tuple[str | None, str, str | None]:
    """ "u_", "u95_" or nothing, the name by which its size is known, and its unit, of a folded header."""
    matched = _SIZED.match(folded)
    u, plain, unit = matched.groups() if matched else (None, folded, None)
    return u, _ALSO.get(plain, plain), unit


def _field(title: str, choices: Choices) -> tuple[str | None, SizeUnit | None]:
    """The field of a header, and the unit that it names."""
    folded = _folded(title)
    u, plain, unit = _parts(folded)
    chosen = choices.columns.get(title)
    if chosen is not None:
        if chosen and chosen not in FIELDS:
            raise BadInput("catalogue-no-such-field", field=chosen, known=", ".join(FIELDS))
        return chosen or None, cast(SizeUnit | None, unit) if chosen in _LENGTHS else None
    if plain in SIZES:
        return f"{u or ''}{plain}_m", cast(SizeUnit | None, unit)
    folded = _ALSO.get(folded, folded)
    return (folded if folded in FIELDS else None), None


def _column(
    title: str, field: str | None, named: SizeUnit | None, cells: Iterator[str], chosen: SizeUnit | None
) -> ImportColumn:
    """A column with its unit; doubtful where its values are usual in another unit than the one it names."""
    if field not in _LENGTHS or field is None:
        return ImportColumn(header=title, field=field, unit=None, problem=None)
    unit: SizeUnit = chosen if chosen is not None and named in (None, "m") else named or "m"
    size = cast(ModelSize, field.removesuffix("_m"))
    problem = None
    if chosen is None and size in _USUAL_M:
        problem = _doubt(
            title, size, unit, [number for cell in cells if (number := given_number(cell)) is not None]
        )
    return ImportColumn(header=title, field=field, unit=unit, problem=problem)


def _doubt(title: str, size: ModelSize, unit: SizeUnit, values: Sequence[float]) -> Said | None:
    if len(values) < 2:
        return None  # one value tells no unit; its row is looked at by itself
    low, high = _USUAL_M[size]
    middle = median(values)
    if low <= METRES[unit] * middle <= high:
        return None
    other = next((one for one in get_args(SizeUnit) if low <= METRES[one] * middle <= high), None)
    if other is None:
        return None
    return Said(
        "catalogue-unit-doubtful",
        column=title,
        middle=f"{middle:g}",
        unit=UNIT_WORDS[unit],
        other=UNIT_WORDS[other],
        sign=other,
    )


def _read_row(
    table: GivenTable, line: int, cells: Mapping[str, str], columns: Sequence[ImportColumn]
) -> CatalogueRow:
    """One row, checked. Raises BadInput saying what is wrong with it."""
    of = {one.field: one for one in columns}
    values: dict[str, Any] = {}
    for field, cell in cells.items():
        if field in _LENGTHS:
            value = table.number(line, of[field].header, cell) if cell else None
            unit = of[field].unit or "m"
            values[field] = value if value is None or unit == "m" else round(value * METRES[unit], 6)
        elif field in _YEARS:
            values[field] = _year(cell, field)
        elif field == "category":
            values[field] = cell.lower() or None
        else:
            values[field] = strip_formula_apostrophe(cell) or (None if field.endswith("_source") else "")
    values["category"] = cast(Category | None, values.get("category"))
    row = CatalogueRow(**{"make": "", "model": "", **values})
    require_possible(row)
    return row


def _year(cell: str, column: str) -> int | None:
    if not cell:
        return None
    if not (cell.isascii() and cell.isdigit()) or not 1885 <= int(cell[:9]) <= 2100:
        raise BadInput("vehicles-not-a-year", column=column, cell=cell[:40])
    return int(cell)
