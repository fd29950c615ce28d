"""The one form of every CSV and JSON file of a package, so that two readers cannot read two things in it.

A CSV has the columns that `datapackage.json` describes, each once, and the text that this program writes for
its cells (line feeds, quotes only where RFC 4180 needs them); a JSON file has the text that `json_bytes`
gives, and no key twice.
"""

import csv
import io
import json
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, open_csv, place_of, read_header, read_whole
from sightline.infra.csv_package.schema import DESCRIPTION, json_bytes

_ROWS_AT_ONCE = 2000


def read_json(files: Files, path: str) -> Any:
    """A JSON file of the package. Raises Damaged where it is none, or has another form."""
    content = read_whole(files, path)
    try:
        found = json.loads(content, object_pairs_hook=_each_once)
        if json_bytes(found) == content:
            return found
    except (json.JSONDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise Damaged("csv_package-no-json", path=path) from error
    except ValueError as error:
        raise Damaged("csv_package-json-form", path=path) from error
    raise Damaged("csv_package-json-form", path=path)


def _each_once(pairs: Sequence[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise ValueError("a key twice")
    return found


def check_forms(files: Files, alike: Mapping[str, str]) -> None:
    """Every CSV and JSON file has its one form. `alike`: folders whose tables are like a described one, by
    that one's key. Raises Damaged.
    """
    described = _described_columns(files)
    for path in sorted(files.paths):
        if path.endswith(".json"):
            read_json(files, path)
        elif path.endswith(".csv"):
            folder = path.rpartition("/")[0] + "/"
            like = path if path in described else place_of(files, alike.get(folder, ""))
            _check_table(files, path, described.get(like, []))


def _described_columns(files: Files) -> dict[str, list[str]]:
    """The columns of each table, as the description has them."""
    found = read_json(files, DESCRIPTION)
    try:
        tables = {one["path"]: one["schema"]["fields"] for one in found["resources"] if "schema" in one}
        return {path: [str(field["name"]) for field in fields] for path, fields in tables.items()}
    except (KeyError, TypeError) as error:
        raise Damaged("export-description-unreadable", description=DESCRIPTION) from error


def _check_table(files: Files, path: str, columns: Sequence[str]) -> None:
    header = read_header(files, path)
    if header != columns or len(set(header)) < len(header):
        odd = sorted(set(header) ^ set(columns)) or [one for one in header if header.count(one) > 1] or header
        raise Damaged("csv_package-columns-differ", path=path, column=(odd or ["none"])[0])
    with open_csv(files, path) as text:
        for at, told, written in _as_written(text, path):
            if told != written:
                raise Damaged("csv_package-csv-form", path=path, at=at)


def _as_written(text: Iterator[str], path: str) -> Iterator[tuple[int, str, str]]:
    """Pieces of a table as they stand and as they would be written, with the number of their first line."""
    lines: list[str] = []
    reader = csv.reader(_keep_lines(text, lines), strict=True)
    at, width = 1, None
    while rows := list(islice(reader, _ROWS_AT_ONCE)):
        width = len(rows[0]) if width is None else width
        if any(len(row) != width for row in rows):
            raise Damaged("csv_package-row-length", path=path)
        out = io.StringIO()
        csv.writer(out, lineterminator="\n").writerows(rows)
        yield at, "".join(lines), out.getvalue()
        at += len(lines)
        lines.clear()


def _keep_lines(text: Iterator[str], lines: list[str]) -> Iterator[str]:
    for line in text:
        lines.append(line)
        yield line
