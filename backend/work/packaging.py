"""The shape of an exported package: described tables, safe CSV, checksums, and whole-or-nothing writing.

Nothing here knows what is exported (`exporting_tables.py` does); this file knows how a table becomes CSV
(contract.md, "Files"), how a Frictionless Data Package describes it, and how bytes reach the disk.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import os
import shutil
import tempfile
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from backend.errors import BadInput, NoRoom
from backend.media.store import check_room

Cell = str | int | float | bool | None
Row = Mapping[str, Cell]

CHECKSUMS = "SHA256SUMS"
DESCRIPTION = "datapackage.json"
_FORMULA_STARTS = ("=", "+", "-", "@", "＝", "＋", "－", "＠")


@dataclass(frozen=True)
class Column:
    """One column: `type` is a Frictionless type, `unit` is empty for text and counts."""

    name: str
    type: str
    meaning: str
    unit: str = ""
    required: bool = False
    enum: tuple[str, ...] = ()
    minimum: float | None = None

    def described(self) -> dict[str, Any]:
        """The field descriptor of the Table Schema (specs.frictionlessdata.io/table-schema)."""
        constraints: dict[str, Any] = {"required": True} if self.required else {}
        if self.enum:
            constraints["enum"] = list(self.enum)
        if self.minimum is not None:
            constraints["minimum"] = self.minimum
        described: dict[str, Any] = {"name": self.name, "type": self.type, "description": self.meaning}
        if self.unit:
            described["unit"] = self.unit
        if self.type == "datetime":
            described["format"] = "any"
        if constraints:
            described["constraints"] = constraints
        return described


@dataclass(frozen=True)
class Table:
    """One CSV file of the package; `foreign` is (my columns, table, its columns)."""

    name: str
    meaning: str
    columns: tuple[Column, ...]
    primary: tuple[str, ...] = ()
    foreign: tuple[tuple[tuple[str, ...], str, tuple[str, ...]], ...] = ()

    @property
    def path(self) -> str:
        return f"{self.name}.csv"

    def schema(self) -> dict[str, Any]:
        """The Table Schema: every column, the missing value, the keys."""
        schema: dict[str, Any] = {
            "fields": [column.described() for column in self.columns],
            "missingValues": [""],
        }
        if self.primary:
            schema["primaryKey"] = list(self.primary)
        if self.foreign:
            schema["foreignKeys"] = [
                {"fields": list(mine), "reference": {"resource": table, "fields": list(theirs)}}
                for mine, table, theirs in self.foreign
            ]
        return schema


@dataclass(frozen=True)
class Package:
    """All files of one export by relative path, in the order in which they are written."""

    files: Mapping[str, bytes] = field(repr=False)

    def total_bytes(self) -> int:
        return sum(len(content) for content in self.files.values())


def safe_text(text: str) -> str:
    """The text, with an apostrophe before anything that a spreadsheet would run as a formula.

    Spreadsheets skip leading blanks and control characters before they look for the sign, so this does too.
    """
    bare = text.lstrip(" \t\r\n\x00\ufeff\xa0")
    if bare.startswith(_FORMULA_STARTS) or text[:1] in ("\t", "\r", "\n"):
        return "'" + text
    return text


def cell_text(column: Column, value: Cell) -> str:
    """One cell: empty for missing, six decimals for lengths, full precision otherwise (contract.md)."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return _number_text(value, column.unit)
    if isinstance(value, int):
        return str(value)
    return safe_text(value)


def _number_text(value: float, unit: str) -> str:
    if unit == "m":
        text = f"{value:.6f}"
        return text[1:] if float(text) == 0.0 and text.startswith("-") else text
    return repr(float(value))


def csv_bytes(table: Table, rows: Iterable[Row]) -> bytes:
    """The table as UTF-8 CSV: comma, line feed, one header row (RFC 4180)."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([column.name for column in table.columns])
    for row in rows:
        writer.writerow([cell_text(column, row.get(column.name)) for column in table.columns])
    return out.getvalue().encode("utf-8")


def json_bytes(value: object) -> bytes:
    """JSON for people and machines: keys as given, two blanks, one line feed at the end, no NaN."""
    return (json.dumps(value, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode("utf-8")


def sha256_hex(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def describe(
    title: str, description: str, created: str | None, tables: Sequence[Table], files: Mapping[str, bytes]
) -> bytes:
    """`datapackage.json`: one tabular resource a table, with the hash and size of its bytes."""
    resources = [_resource(table, files[table.path]) for table in tables]
    package: dict[str, Any] = {
        "profile": "tabular-data-package",
        "name": "sightline-survey",
        "title": title,
        "description": description,
        "resources": resources,
    }
    if created is not None:
        package["created"] = created
    return json_bytes(package)


def _resource(table: Table, content: bytes) -> dict[str, Any]:
    return {
        "name": table.name,
        "path": table.path,
        "profile": "tabular-data-resource",
        "title": table.name.replace("_", " "),
        "description": table.meaning,
        "format": "csv",
        "mediatype": "text/csv",
        "encoding": "utf-8",
        "dialect": {"delimiter": ",", "lineTerminator": "\n", "header": True},
        "bytes": len(content),
        "hash": f"sha256:{sha256_hex(content)}",
        "schema": table.schema(),
    }


def with_checksums(files: Mapping[str, bytes]) -> Package:
    """The files in order of path, and last the list of their SHA-256 sums (the format of sha256sum)."""
    ordered = {path: files[path] for path in sorted(files)}
    lines = [f"{sha256_hex(content)}  {path}\n" for path, content in ordered.items()]
    return Package(files={**ordered, CHECKSUMS: "".join(lines).encode("utf-8")})


def zip_bytes(package: Package) -> bytes:
    """The package as a ZIP whose bytes depend on nothing but its content (fixed times and modes)."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=6) as archive:
        for path, content in package.files.items():
            entry = zipfile.ZipInfo(path, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            entry.create_system = 3
            archive.writestr(entry, content)
    return out.getvalue()


def write_directory(package: Package, target: Path) -> None:
    """Write the package as a folder that appears whole or not at all.

    Raises:
        BadInput: the place is taken by something that is not an earlier export.
        NoRoom: the disk is full (nothing is left behind).
    """
    _refuse_strangers(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    check_room(target.parent, sum(map(len, package.files.values())), "this export")
    fresh = Path(tempfile.mkdtemp(prefix=f".{target.name}-", dir=target.parent))
    try:
        for path, content in package.files.items():
            place = fresh / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content)
        fresh.chmod(0o755)
        _put_in_place(fresh, target)
    except OSError as error:
        raise NoRoom(
            f"{target} could not be written ({error.strerror}); free some space and export again."
        ) from error
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _refuse_strangers(target: Path) -> None:
    if target.is_symlink() or (target.exists() and not target.is_dir()):
        raise BadInput(f"{target} is a file; name a folder for the export that does not exist yet.")
    if target.is_dir() and any(target.iterdir()) and not (target / CHECKSUMS).is_file():
        raise BadInput(f"{target} holds other files; name a folder that is empty or does not exist yet.")


def _put_in_place(fresh: Path, target: Path) -> None:
    if not target.exists():
        os.rename(fresh, target)
        return
    old = Path(tempfile.mkdtemp(prefix=f".{target.name}-old-", dir=target.parent))
    os.rename(target, old / "export")
    os.rename(fresh, target)
    shutil.rmtree(old, ignore_errors=True)
