"""The catalogue from a CSV: rows that can be used are stored, the others are named with their reason."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, cast, get_args

from sightline.enums import Category
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.vehicles.catalogue.records import CatalogueRow
from sightline.vehicles.catalogue.store import catalogue_row_problem, import_catalogue_rows

MOST_BYTES = 10_000_000
_NEEDED = ("make", "model")
_LENGTHS = ("height_m", "length_m", "width_m", "wheelbase_m")
_KNOWN = (*_NEEDED, "year_from", "year_to", "category", *_LENGTHS, "source")
# Public size lists leave the unit out of the header; metres are then believed only within a vehicle's range.
_ALSO = {
    "height": "height_m",
    "length": "length_m",
    "width": "width_m",
    "wheelbase": "wheelbase_m",
    "year": "year_from",
    "manufacturer": "make",
}


@dataclass(frozen=True)
class Skipped:
    """A line of the file that was left out, and why."""

    line: int
    reason: str


@dataclass(frozen=True)
class Imported:
    """What came of an import."""

    added: int
    updated: int
    skipped: list[Skipped]


def import_csv(session: Session, data: bytes, name: str, *, actor: int | None) -> Imported:
    """Store the rows of a CSV; its header names the columns (make, model, year_from, height_m, source, ...).

    Raises BadInput for a file that is no such table; a row that cannot be used is skipped with its reason.
    """
    good: list[CatalogueRow] = []
    skipped: list[Skipped] = []
    for line, cells in _lines(data, name):
        try:
            good.append(_row(cells))
        except BadInput as error:
            skipped.append(Skipped(line, error.message))
    if not good and not skipped:
        return Imported(0, 0, [])
    if not good:
        raise BadInput("vehicles-no-row-used-line", name=name, line=skipped[0].line, reason=skipped[0].reason)
    result = import_catalogue_rows(session, good, actor=actor)
    return Imported(result.added, result.updated, skipped)


def _lines(data: bytes, name: str) -> Iterator[tuple[int, dict[str, str]]]:
    """(line number, cells by column) of every row that is not blank."""
    text = _text(data, name)
    first = text.partition("\n")[0]
    semicolons = first.count(";") > first.count(",")
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=";" if semicolons else ",", strict=True)
    try:
        header = _header(next(reader, []), name)
        for cells in reader:
            if any(cell.strip() for cell in cells):
                decimal = [cell.replace(",", ".") for cell in cells] if semicolons else cells
                paired = {
                    column: (changed if column in _LENGTHS else cell).strip()
                    for column, cell, changed in zip(header, cells, decimal, strict=False)
                }
                yield reader.line_num, paired
    except csv.Error as error:
        raise BadInput(
            "vehicles-cannot-read-csv-near-line-save", name=name, line_num=reader.line_num, problem=error
        ) from error


def _text(data: bytes, name: str) -> str:
    if len(data) > MOST_BYTES:
        raise BadInput(
            "vehicles-larger-mb-split-into-several-files", name=name, most_bytes=MOST_BYTES // 1000000
        )
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise BadInput("vehicles-not-utf-8-text-save-csv", name=name) from None


def _header(cells: list[str], name: str) -> list[str]:
    folded = [cell.strip().lower().replace(" ", "_") for cell in cells]
    header = [_ALSO.get(column, column) for column in folded]
    missing = [column for column in _NEEDED if column not in header]
    if missing:
        raise BadInput(
            "vehicles-no-column-first-line-names-columns",
            name=name,
            missing=" and no column ".join(missing),
            known=", ".join(_KNOWN),
        )
    return header


def _row(cells: Mapping[str, str]) -> CatalogueRow:
    """One row, checked. Raises BadInput saying what is wrong with it."""
    values: dict[str, Any] = {column: _number(cells, column) for column in _LENGTHS}
    values |= {column: _year(cells, column) for column in ("year_from", "year_to")}
    category = cells.get("category", "").lower() or None
    if category not in (None, *get_args(Category)):
        raise BadInput(
            "vehicles-not-category-use-one", category=category, categories=", ".join(get_args(Category))
        )
    values |= {column: _undefused(cells.get(column, "")) for column in ("make", "model", "source")}
    row = CatalogueRow(**values, category=cast(Category | None, category))
    problem = catalogue_row_problem(row)
    if problem is not None:
        raise BadInput("said", sentence=problem)
    return row


def _undefused(cell: str) -> str:
    """Take back the apostrophe that our own export puts before what a spreadsheet would run."""
    return cell[1:] if cell[:1] == "'" and cell[1:2] in ("=", "+", "-", "@") else cell


def _number(cells: Mapping[str, str], column: str) -> float | None:
    cell = cells.get(column, "")
    if not cell:
        return None
    try:
        return float(cell)
    except ValueError:
        raise BadInput("vehicles-which-not-number-give-metres", column=column, cell=cell[:40]) from None


def _year(cells: Mapping[str, str], column: str) -> int | None:
    cell = cells.get(column, "")
    if not cell:
        return None
    if not cell.isdigit() or not 1885 <= int(cell[:9]) <= 2100:
        raise BadInput("vehicles-which-not-year-give-four-digits", column=column, cell=cell[:40])
    return int(cell)
