"""Reading and writing the small files of the geometry commands: whole or not at all, refusals by name."""

import csv
import errno
import io
import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from sightline.commands.options import in_words
from sightline.errors import BadInput, NoRoom
from sightline.geometry.documents import WrittenTwice, single_keys
from sightline.infra.given_csv import GivenTable, read_table
from sightline.media.atomic import atomic_file

_LARGEST_BYTES = 200_000_000


def read_text(path: Path, what: str) -> str:
    """A UTF-8 text file, its BOM dropped. Raises BadInput naming the file."""
    try:
        return read_bytes(path, what).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise BadInput("commands-not-utf8", path=path, what=what) from None


def read_csv(path: Path, needed: Sequence[str], name: str | None = None) -> GivenTable:
    """A table that somebody brings, with the columns needed. Raises BadInput naming the file, or as told."""
    what = f"a CSV table with the columns {', '.join(needed)}" if needed else "a CSV table"
    table = read_table(read_bytes(path, what), name or path)
    if needed:
        table.require(*needed)
    return table


def read_bytes(path: Path, what: str, most: int | None = None) -> bytes:
    """A file's content, or its beginning of `most` bytes. Raises BadInput naming the file, and where nobody
    said how much of it is read for one that is too large.
    """
    try:
        if most is None and path.stat().st_size > _LARGEST_BYTES:
            raise BadInput("commands-too-large", path=path, what=what)
        with path.open("rb") as file:
            return file.read(most)
    except FileNotFoundError:
        raise BadInput("commands-not-exist-give", path=path, what=what) from None
    except OSError as error:
        raise BadInput("commands-cannot-read-give", path=path, strerror=error.strerror, what=what) from None


def read_json(path: Path, what: str) -> Any:
    """A JSON file. Raises BadInput naming the file."""
    text = read_text(path, what)
    try:
        return json.loads(text, object_pairs_hook=single_keys, parse_int=_whole_number)
    except WrittenTwice as twice:
        raise BadInput("geometry-key-written-twice", file_name=path, key=str(twice)) from None
    except (ValueError, RecursionError):
        raise BadInput("commands-not-json", path=path, what=what) from None


def _whole_number(text: str) -> int | float:
    """Infinite where it is beyond every float, as 1e400 is: whoever reads it says what may be there."""
    number = int(text)
    return number if abs(number) <= sys.float_info.max else float(text)


def write_whole(path: Path, content: str | bytes) -> None:
    """Write a file so that it appears whole or not at all; its folder must be there."""
    try:
        if not path.parent.is_dir():
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
        with atomic_file(path) as part:
            part.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EDQUOT):
            raise NoRoom("commands-disk-full", path=path) from None
        raise BadInput("commands-not-writable", path=path, strerror=error.strerror) from None


def csv_text(
    columns: Sequence[str], rows: Iterable[Mapping[str, Any]], cell: Callable[[Any], Any] = str
) -> str:
    """A table as text, lines ending in a line feed; `cell`: how a value is written."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([cell(row[name]) for name in columns] for row in rows)
    return text.getvalue()


def write_json(path: Path, value: Any) -> None:
    """Write one JSON document, numbers at full precision."""
    write_whole(path, json.dumps(value, indent=1, allow_nan=False, default=in_words) + "\n")
