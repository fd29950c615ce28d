"""The one reader of every CSV that people bring. Each line is a row: no cell holds a line feed.

What is wrong with the table as a whole is raised; what is wrong with one row stands in the row, so that a
command that gives each row a status refuses that row alone, and every other raises it (`sound_rows`).
"""

import csv
import math
import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass

from sightline.errors import BadInput

MOST_BYTES = 200_000_000
#: Of a height, a length or a reference of a vehicle.
MOST_M = 20.0
_USUAL_M = 1.6  # about which vehicles' sizes lie: what tells the unit of a number that is too large
USUAL_INSET_M = 0.3
_UNITS_M = {"mm": 0.001, "cm": 0.01, "in": 0.0254, "ft": 0.3048}
_LINE_END = re.compile(r"\r\n|\r|\n")
_QUOTED = re.compile(r'"[^"]*"?')
# what spreadsheets put before the header: the header itself tells the separator
_NAMES_ITS_SEPARATOR = re.compile(r'"?sep=[,;\t]"?', re.IGNORECASE)
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,4})?")
# What separates thousands or decimals in other countries: "1,48", "1.234,5", "1 234.5", "1'234".
_SEPARATED = re.compile(r"[+-]?[0-9]+(?:[.,' \u00a0\u2009\u202f\u2019][0-9]+)+")


@dataclass(frozen=True, slots=True)
class GivenRow:
    """A row that is not blank: its line in the file, a cell for each column, and what is wrong with it."""

    line: int
    cells: list[str]
    problem: BadInput | None = None


@dataclass(frozen=True, slots=True)
class GivenTable:
    """A table as it was given; texts are in NFC, names of columns without blanks about them."""

    name: str
    header: list[str]
    rows: list[GivenRow]

    def require(self, *columns: str) -> None:
        """Raises BadInput where the header lacks a column."""
        if not self.header:
            raise BadInput("csv-empty", name=self.name, needed=", ".join(columns))
        missing = [one for one in columns if one not in self.header]
        if missing:
            raise BadInput(
                "csv-no-column", name=self.name, missing=", ".join(missing), needed=", ".join(columns)
            )

    def sound_rows(self) -> Iterator[tuple[int, dict[str, str]]]:
        """Line and cells by column, without blanks about them. Raises the first row's problem."""
        for row in self.rows:
            if row.problem is not None:
                raise row.problem
            yield row.line, self.by_column(row)

    def by_column(self, row: GivenRow) -> dict[str, str]:
        """A row's cells by column, without blanks about them."""
        return dict(zip(self.header, map(str.strip, row.cells), strict=True))

    def number(self, line: int, column: str, cell: str) -> float:
        """A finite number of ASCII digits and `.`. Raises BadInput naming line and column."""
        value = given_number(cell)
        if value is not None:
            return value
        if not cell:
            raise BadInput("csv-empty-cell", name=self.name, line=line, column=column)
        if is_separated(cell):
            raise BadInput("csv-number-separated", name=self.name, line=line, column=column, cell=cell[:40])
        raise BadInput("csv-not-a-number", name=self.name, line=line, column=column, cell=cell[:40])

    def size_m(self, line: int, column: str, cell: str) -> float:
        """A size that a vehicle can have, metres. Raises BadInput as `length_m`, and for 0 or less."""
        if self.number(line, column, cell) <= 0.0:
            raise BadInput("csv-size-not-positive", name=self.name, line=line, column=column, cell=cell[:40])
        return self.length_m(line, column, cell)

    def uncertainty(self, line: int, column: str, cell: str) -> float:
        """A standard uncertainty. Raises BadInput for one below 0."""
        value = self.number(line, column, cell)
        if value < 0.0:
            raise BadInput(
                "csv-uncertainty-below-0", name=self.name, line=line, column=column, cell=cell[:40]
            )
        return value

    def u_length_m(self, line: int, column: str, cell: str, usual_m: float = _USUAL_M) -> float:
        """The standard uncertainty of a length about a vehicle, metres. Raises BadInput."""
        self.uncertainty(line, column, cell)
        return self.length_m(line, column, cell, usual_m)

    def length_m(self, line: int, column: str, cell: str, usual_m: float = _USUAL_M) -> float:
        """A length about a vehicle, metres, of either sign (an inset, a height that was measured). Raises
        BadInput with the unit that one beyond all vehicles seems to be in, by what is usual.
        """
        value = self.number(line, column, cell)
        if abs(value) <= MOST_M:
            return value
        unit = unit_of(value, usual_m)
        raise BadInput(
            "csv-size-too-large",
            name=self.name,
            line=line,
            column=column,
            cell=cell[:40],
            unit=unit,
            metres=f"{value * _UNITS_M[unit]:.4g}",
        )


def read_table(data: bytes | str, name: object, most_bytes: int = MOST_BYTES) -> GivenTable:
    """A table with commas, or with semicolons or tabs where the whole header has them.

    Raises BadInput for what is no UTF-8 text, or whose header is not sound.
    """
    lines = enumerate(_LINE_END.split(_decode_text(data, str(name), most_bytes)), start=1)
    written = ((at, line) for at, line in lines if line.strip(" \t,;"))
    at, first = next((one for one in written if not _NAMES_ITS_SEPARATOR.fullmatch(one[1])), (0, ""))
    delimiter = _delimiter(first)
    header, problem = _cells(first, delimiter, str(name), at)
    if problem is not None:
        raise problem
    header = [cell.strip() for cell in header]
    while header and not header[-1]:
        header.pop()
    twice = next((one for one in header if one and header.count(one) > 1), None)
    if twice is not None:
        raise BadInput("csv-column-twice", name=str(name), line=at, column=twice[:60])
    return GivenTable(str(name), header, list(_split_rows(lines, str(name), header, delimiter)))


def given_number(cell: str) -> float | None:
    """A finite number of ASCII digits and `.`; None for anything else."""
    if _NUMBER.fullmatch(cell.strip()) is None:
        return None
    value = float(cell)
    return value if math.isfinite(value) else None


def require_standard(title: str, name: object) -> None:
    """Raise BadInput where a column of uncertainties is of expanded ones by its title's U95, or its capital U
    (JCGM 100:2008, 2.3.5); a title in capitals alone tells nothing by its U.
    """
    title = title.strip()
    if title[:3].upper() == "U95" or (title.startswith("U") and not title.isupper()):
        raise BadInput("csv-column-expanded", name=str(name), column=title[:60])


def is_separated(cell: str) -> bool:
    """Whether it is a number but for a decimal comma or for what stands between its thousands."""
    return _SEPARATED.fullmatch(cell.strip()) is not None


def unit_of(value: float, usual_m: float = _USUAL_M) -> str:
    """The unit in which a number is most likely about as large as is usual."""
    return min(_UNITS_M, key=lambda unit: abs(math.log(abs(value) * _UNITS_M[unit] / usual_m)))


def strip_formula_apostrophe(cell: str) -> str:
    """Take back the apostrophe that our own export puts before what a spreadsheet would run."""
    return cell[1:] if cell[:1] == "'" and cell[1:2] in ("=", "+", "-", "@") else cell


def _decode_text(data: bytes | str, name: str, most_bytes: int) -> str:
    if len(data) > most_bytes:
        raise BadInput("csv-too-large", name=name, most_bytes=most_bytes // 1000000)
    try:
        text = data if isinstance(data, str) else data.decode("utf-8")
    except UnicodeDecodeError:
        raise BadInput("csv-not-utf-8", name=name) from None
    return unicodedata.normalize("NFC", text.removeprefix("\ufeff"))


def _delimiter(header: str) -> str:
    """A comma, but where the header has none outside of quotes and only one of the other two."""
    bare = _QUOTED.sub("", header)
    there = [one for one in ",;\t" if one in bare]
    return there[0] if len(there) == 1 else ","


def _split_rows(
    lines: Iterator[tuple[int, str]], name: str, header: list[str], delimiter: str
) -> Iterator[GivenRow]:
    width = len(header)
    opened = 0  # line of a quote that was not closed: a later line with a quote astray may be its end
    for line, text in lines:
        cells, problem = _cells(text, delimiter, name, line)
        if problem is not None:
            opened = line
        elif not any(map(str.strip, cells)):
            continue
        elif opened and _has_a_quote_astray(text, delimiter):
            problem, opened = BadInput("csv-cell-not-closed", name=name, line=line, opened=opened), 0
        elif [cell.strip() for cell in cells[:width]] == header:
            problem = BadInput("csv-header-again", name=name, line=line)
        elif any(map(str.strip, cells[width:])):
            problem = BadInput("csv-more-cells", name=name, line=line, cells=len(cells), columns=width)
        elif len(cells) < width:
            problem = BadInput("csv-fewer-cells", name=name, line=line, cells=len(cells), columns=width)
        yield GivenRow(line, (cells + [""] * width)[:width], problem)


def _cells(text: str, delimiter: str, name: str, line: int) -> tuple[list[str], BadInput | None]:
    """A line's cells, and what is wrong with its quotes."""
    if '"' not in text:
        return text.split(delimiter), None
    try:
        return next(csv.reader([text], delimiter=delimiter, strict=True)), None
    except csv.Error as error:
        if "expected after" in str(error):
            problem = BadInput("csv-after-a-quote", name=name, line=line)
        else:
            problem = BadInput("csv-open-quote", name=name, line=line)
        return text.split(delimiter), problem


def _has_a_quote_astray(text: str, delimiter: str) -> bool:
    """Whether a quote stands elsewhere than about or within a quoted cell."""
    return '"' in re.sub(rf'(?:^|(?<={delimiter}))"(?:[^"]|"")*"(?={delimiter}|$)', "", text)
