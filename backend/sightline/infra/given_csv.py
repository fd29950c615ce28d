"""CSV files that people bring: commas or semicolons between cells, points or commas in numbers."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from typing import Any

from sightline.errors import BadInput

#: (line number in the file, cells) of each row that is not blank.
Lines = list[tuple[int, list[str]]]


def read_given_csv(data: bytes, name: str, most_bytes: int) -> tuple[list[str], Lines]:
    """The header, and (line number, cells) of every row that is not blank. Raises BadInput for no CSV."""
    text = _text(data, name, most_bytes)
    first = text.partition("\n")[0]
    semicolons = first.count(";") > first.count(",")
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=";" if semicolons else ",", strict=True)
    try:
        header = [cell.strip() for cell in next(reader, [])]
        return header, list(_rows(reader))
    except csv.Error as error:
        raise BadInput("csv-cannot-read", name=name, line_num=reader.line_num, problem=error) from error


def given_number(cell: str) -> float | None:
    """A number with a point or a comma; None for anything else."""
    try:
        return float(cell.strip().replace(",", "."))
    except ValueError:
        return None


def undefused(cell: str) -> str:
    """Take back the apostrophe that our own export puts before what a spreadsheet would run."""
    return cell[1:] if cell[:1] == "'" and cell[1:2] in ("=", "+", "-", "@") else cell


def _rows(reader: Any) -> Iterator[tuple[int, list[str]]]:
    for cells in reader:
        if any(cell.strip() for cell in cells):
            yield reader.line_num, cells


def _text(data: bytes, name: str, most_bytes: int) -> str:
    if len(data) > most_bytes:
        raise BadInput("csv-too-large", name=name, most_bytes=most_bytes // 1000000)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise BadInput("csv-not-utf-8", name=name) from None
