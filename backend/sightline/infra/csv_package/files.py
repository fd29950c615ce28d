"""A package on its way to the disk and back: written file by file, zipped, put in place whole, read again.

No file is ever in memory whole but the small ones that are handed over so; a million rows pass through.
"""

from __future__ import annotations

import csv
import hashlib
import io
import os
import shutil
import stat
import tempfile
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from functools import cache, cached_property
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Generic, Protocol, TypeVar, cast, get_type_hints

from sightline.errors import BadInput, Damaged
from sightline.infra.csv_package.schema import (
    CHECKSUMS,
    DESCRIPTION,
    TABLES,
    AnyTable,
    Cell,
    Column,
    Record,
    Table,
    Written,
    cell_text,
    safe_text,
    sha256_hex,
    table_key,
)
from sightline.media.store.local import no_room_told

CHUNK_BYTES = 1 << 20
#: Deflate makes text of tables some ten times smaller, never a thousand times; a file of zeros is no table.
MOST_RATIO, _SMALL_BYTES = 300, 10_000_000
#: A package of a million measurements with crops lists two million files in some 200 MB; more is an attack.
MOST_LISTING_BYTES, MOST_FILES = 300_000_000, 3_000_000
_REGULAR = 0o10  # what a regular file's mode begins with
_END_BYTES = 1 << 16  # where a ZIP's directory is pointed at
_PACKED = (".jpg", ".png", ".pdf")  # packing them again costs time and gains nothing

Tick = Callable[[float], None]
Made = TypeVar("Made")


def no_tick(_fraction: float) -> None:
    """Progress that nobody follows."""


class TableWriter(Generic[Record]):
    """Rows into one CSV file (UTF-8, comma, line feed, RFC 4180), hashed and counted on the way; the numbers
    of those who stand in a row are added to `named`.
    """

    def __init__(
        self,
        file: BinaryIO,
        table: Table[Record],
        before: TableWriter[Record] | None = None,
        named: set[str] | None = None,
    ) -> None:
        self._file, self._table = file, table
        self._named = set[str]() if named is None else named
        self._persons = [table.header.index(columns[0]) for columns, of, _ in table.foreign if of == "people"]
        self._columns: list[tuple[Column[Record], Callable[[Record], Cell]]] | None = None
        self._hash, self._size, self.rows = hashlib.sha256(), 0, 0
        self._csv = csv.writer(self, lineterminator="\n")
        if before is None:
            self._csv.writerow(table.header)
        else:
            self._hash, self._size, self.rows = before._hash.copy(), before._size, before.rows

    def write(self, text: str) -> int:
        """What csv hands over."""
        content = text.encode()
        self._hash.update(content)
        self._size += len(content)
        return self._file.write(content)

    def add(self, record: Record) -> None:
        """The row of one record; all of a table are mappings, or none is."""
        if self._columns is None:
            is_mapping = isinstance(record, Mapping)
            self._columns = [
                (one, one.of_mapping if is_mapping else one.of_object) for one in self._table.columns
            ]
        row = [
            "" if (value := value_of(record)) is None else cell_text(column, value)
            for column, value_of in self._columns
        ]
        self._csv.writerow(row)
        self._named.update(row[at] for at in self._persons)
        self.rows += 1

    def written(self) -> Written:
        return Written(self._hash.hexdigest(), self._size)


class Staging:
    """A package being written into a folder of its own; `written` holds each file's hash and size by path,
    `named` the numbers of those who stand in its tables.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.written: dict[str, Written] = {}
        self.named: set[str] = set()

    def add(self, path: str, content: bytes) -> None:
        """One small file. Raises NoRoom."""
        with no_room_told():
            self._place(path).write_bytes(content)
        self.written[path] = Written(sha256_hex(content), len(content))

    @contextmanager
    def file(self, path: str) -> Iterator[BinaryIO]:
        """A file that something else writes. Raises NoRoom."""
        with no_room_told(), self._place(path).open("wb", CHUNK_BYTES) as file:
            yield file
        self.written[path] = sum_of(self.files(), path)

    @contextmanager
    def table(self, table: Table[Made], path: str | None = None) -> Iterator[TableWriter[Made]]:
        """A CSV file to be filled row by row, at the table's path or at another. Raises NoRoom."""
        where = path or table.path
        with no_room_told(), self._place(where).open("wb", CHUNK_BYTES) as file:
            writer = TableWriter(file, table, named=self.named)
            yield writer
        self.written[where] = writer.written()

    @contextmanager
    def continued(self, table: Table[Made], before: TableWriter[Made]) -> Iterator[TableWriter[Made]]:
        """More rows at the end of a table that `before` has written. Raises NoRoom."""
        with no_room_told(), self._place(table.path).open("ab", CHUNK_BYTES) as file:
            writer = TableWriter(file, table, before)
            yield writer
        self.written[table.path] = writer.written()

    def fill(self, table: Table[Made], records: Iterable[Made]) -> int:
        """A whole table; how many rows it has."""
        with self.table(table) as writer:
            for record in records:
                writer.add(record)
        return writer.rows

    def add_checksums(self) -> None:
        """Write the list of all files' sums (the format of sha256sum): the last file of the package."""
        self.add(CHECKSUMS, checksum_lines(self.written))

    def files(self) -> Files:
        """What was written, to be read."""
        return FolderFiles(self.folder)

    def _place(self, path: str) -> Path:
        place = self.folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        return place


def checksum_lines(written: dict[str, Written]) -> bytes:
    """SHA256SUMS of these files, in the order of their paths."""
    return "".join(f"{written[path].sha256}  {path}\n" for path in sorted(written)).encode()


def zip_folder(staging: Staging, target: Path, tick: Tick = no_tick) -> None:
    """The package as a ZIP whose bytes depend on nothing but its content (fixed order, times and modes).

    Raises NoRoom; whatever `tick` raises stops it.
    """
    total = max(sum(one.size for one in staging.written.values()), 1)
    done = 0
    with no_room_told(), zipfile.ZipFile(target, "w", allowZip64=True) as archive:
        for path in [*sorted(set(staging.written) - {CHECKSUMS}), CHECKSUMS]:
            entry = zipfile.ZipInfo(path, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_STORED if path.endswith(_PACKED) else zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            entry.create_system = 3
            entry.file_size = staging.written[path].size
            with (staging.folder / path).open("rb") as source, archive.open(entry, "w") as out:
                while chunk := source.read(CHUNK_BYTES):
                    out.write(chunk)
                    done += len(chunk)
                    tick(done / total)


@contextmanager
def fresh_folder(target: Path) -> Iterator[Path]:
    """A new folder that takes the place of `target`, an earlier export or nothing, when the block ends well.

    Raises BadInput where the place is taken by something else or cannot be written; whatever goes wrong,
    nothing is left behind.
    """
    try:
        _refuse_strangers(target)
        target.parent.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(prefix=f".{target.name}-", dir=target.parent))
    except OSError as error:
        why = error.strerror or str(error)
        raise BadInput("commands-not-writable", path=target, strerror=why) from error
    try:
        yield fresh
        fresh.chmod(0o755)
        _put_in_place(fresh, target)
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _refuse_strangers(target: Path) -> None:
    if target.is_symlink() or (target.exists() and not target.is_dir()):
        raise BadInput("csv_package-target-is-file", target=target)
    if target.is_dir() and any(target.iterdir()) and not _is_export(FolderFiles(target)):
        raise BadInput("csv_package-target-not-empty", target=target)


def _is_export(files: Files) -> bool:
    """Whether these are a package and nothing else: its description, and only what its list names."""
    if not {CHECKSUMS, DESCRIPTION} <= files.paths:
        return False
    try:
        listed = listed_sums(files)
    except Damaged:
        return False
    return all(path in listed or is_stray(path) for path in files.paths - {CHECKSUMS})


def listed_sums(files: Files) -> dict[str, str]:
    """The hash of each file by its path, by a package's list. Raises Damaged for what is no list."""
    listed: dict[str, str] = {}
    for line in read_whole(files, CHECKSUMS).decode("utf-8", "replace").splitlines():
        sum_, _, path = line.partition("  ")
        if len(sum_) != 64 or not is_plain(path):
            raise Damaged("export-checksums-no-list", checksums=CHECKSUMS)
        listed[path] = sum_
    if not listed:
        raise Damaged("export-checksums-no-list", checksums=CHECKSUMS)
    return listed


def _put_in_place(fresh: Path, target: Path) -> None:
    if not target.exists():
        os.rename(fresh, target)
        return
    old = Path(tempfile.mkdtemp(prefix=f".{target.name}-old-", dir=target.parent))
    os.rename(target, old / "export")
    os.rename(fresh, target)
    shutil.rmtree(old, ignore_errors=True)


class Files(Protocol):
    """The files of a package, read in pieces."""

    @property
    def paths(self) -> frozenset[str]: ...

    def open(self, path: str) -> AbstractContextManager[BinaryIO]:
        """One file's bytes from the start. Raises Damaged where it is missing."""


class FolderFiles:
    """The files of a folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    @cached_property
    def paths(self) -> frozenset[str]:
        found = list(islice(_files_below(self._folder), MOST_FILES + 1))
        if len(found) > MOST_FILES:
            raise BadInput("csv_package-too-many-files", place=self._folder)
        return frozenset(found)

    @contextmanager
    def open(self, path: str) -> Iterator[BinaryIO]:
        place = os.path.join(self._folder, path)
        try:
            if not stat.S_ISREG(os.lstat(place).st_mode):
                raise Damaged("csv_package-link", path=path)
            file = open(place, "rb")  # noqa: SIM115 - what the block raises is no missing file
        except OSError as error:
            raise missing(path) from error
        with file:
            yield file


def _files_below(folder: Path) -> Iterator[str]:
    """The path in it, with slashes, of every file below a folder; links are files, followed nowhere; pipes
    and devices too, to be refused.
    """
    waiting = [""]
    while waiting:
        below = waiting.pop()
        with os.scandir(os.path.join(folder, below)) as entries:
            for entry in entries:
                if entry.is_dir(follow_symlinks=False):
                    waiting.append(f"{below}{entry.name}/")
                else:
                    yield f"{below}{entry.name}"


class ZipFiles:
    """The files of a ZIP, read where it lies."""

    def __init__(self, place: Path) -> None:
        _check_listing(place)
        self._archive = zipfile.ZipFile(place)
        entries = [one for one in self._archive.infolist() if not one.is_dir()]
        self.paths = frozenset(entry.filename for entry in entries)
        if len(self.paths) < len(entries):
            raise BadInput("csv_package-file-twice", place=place)
        for entry in entries:
            if not is_plain(entry.filename) or (entry.external_attr >> 28) not in (0, _REGULAR):
                raise BadInput("csv_package-zip-odd-entry", place=place, path=entry.filename[:100])
            if entry.flag_bits & 1:
                raise BadInput("csv_package-zip-encrypted", place=place)
            if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
                raise BadInput("csv_package-zip-odd-entry", place=place, path=entry.filename[:100])
            if entry.file_size > _SMALL_BYTES and entry.file_size > MOST_RATIO * max(entry.compress_size, 1):
                raise BadInput("csv_package-zip-bomb", place=place, path=entry.filename[:100])

    @contextmanager
    def open(self, path: str) -> Iterator[BinaryIO]:
        if path not in self.paths:
            raise missing(path)
        try:
            with self._archive.open(path) as file:
                yield cast(BinaryIO, file)
        except (zipfile.BadZipFile, zlib.error, EOFError, OSError) as error:
            raise Damaged("csv_package-not-unpackable", path=path) from error


def is_plain(path: str) -> bool:
    """Whether a path leads to a file in the package and nowhere else, on any machine."""
    parts = path.split("/")
    return not ({"", ".", ".."} & set(parts) or "\\" in path or "\0" in path or ":" in parts[0])


def _check_listing(place: Path) -> None:
    """Raises BadInput for a ZIP that lists more files than any package has, before the list is read."""
    size = place.stat().st_size
    with place.open("rb") as file:
        file.seek(max(0, size - _END_BYTES))
        end = file.read()
    at = end.rfind(b"PK\x05\x06")
    listed = int.from_bytes(end[at + 12 : at + 16], "little") if at >= 0 else 0
    if listed == 0xFFFFFFFF and (wide := end.rfind(b"PK\x06\x06")) >= 0:
        listed = int.from_bytes(end[wide + 40 : wide + 48], "little")
    if listed > MOST_LISTING_BYTES:
        raise BadInput("csv_package-too-many-files", place=place)


def missing(path: str) -> Damaged:
    return Damaged("csv_package-file-missing", path=path)


#: What Macs and Windows put beside files that they show or pack.
_STRAYS = {".ds_store", "thumbs.db", "desktop.ini"}


def is_stray(path: str) -> bool:
    """Whether a file is one that a system left there by itself, and no part of any package."""
    folders = path.lower().split("/")
    return folders[-1] in _STRAYS or folders[-1].startswith("._") or "__macosx" in folders[:-1]


def package_inside(paths: frozenset[str]) -> str | None:
    """Where the package is that these files hold one level down: its folder, or the only ZIP; else None."""
    own = [path for path in paths if not is_stray(path)]
    folders = [path.partition("/")[0] for path in own if path.count("/") == 1 and path.endswith(CHECKSUMS)]
    zips = [path for path in own if "/" not in path and path.lower().endswith(".zip")]
    found = [name for name in folders if f"{name}/{CHECKSUMS}" in paths] or zips
    return found[0] if len(found) == 1 else None


class InFolder:
    """The files of a package that lies in one folder of a ZIP; those beside the folder keep their paths."""

    def __init__(self, files: Files, folder: str) -> None:
        self._files = files
        self._places = {path.removeprefix(f"{folder}/"): path for path in files.paths}
        self.paths = frozenset(self._places)
        if len(self.paths) < len(files.paths):
            raise BadInput("csv_package-file-twice", place=folder)

    def open(self, path: str) -> AbstractContextManager[BinaryIO]:
        if path not in self._places:
            raise missing(path)
        return self._files.open(self._places[path])


class EarlierFiles:
    """A package of another version of the program, read as though it had the tables of this one: those that
    it lacks have no rows, and the columns that it lacks are empty.
    """

    def __init__(self, files: Files, mine: Sequence[AnyTable], theirs: Sequence[AnyTable]) -> None:
        self._files = files
        self.paths = files.paths
        headers = {table.key: table.header for table in theirs}
        #: The columns of this program that a table lacks, by key; of a table that is not there, all.
        self.lacking = {
            table.key: lacking
            for table in mine
            if (lacking := frozenset(table.header) - set(headers.get(table.key, ())))
        }

    def open(self, path: str) -> AbstractContextManager[BinaryIO]:
        if path not in self.paths and table_key(path) in self.lacking:
            return nullcontext(io.BytesIO())
        return self._files.open(path)


class _EarlierRow(dict[str, str]):
    """A row of a table that lacks columns."""

    def __missing__(self, _name: str) -> str:
        return ""


def columns_lacking(files: Files, path: str) -> frozenset[str]:
    """The columns of this program that a table, by its path or key, lacks."""
    return files.lacking.get(table_key(path), frozenset()) if isinstance(files, EarlierFiles) else frozenset()


def open_package(place: Path) -> Files:
    """The files of an exported folder or ZIP. Raises BadInput for anything else."""
    try:
        return FolderFiles(place) if place.is_dir() else ZipFiles(place)
    except (OSError, zipfile.BadZipFile, RuntimeError) as error:
        raise BadInput("csv_package-not-an-export", place=place) from error


def place_of(files: Files, table: str) -> str:
    """Where a table, by path or key, lies in a package: folder or root. Raises Damaged for one in both."""
    found = [path for path in places_of(table) if path in files.paths]
    if len(found) > 1:
        raise Damaged("csv_package-table-twice", path=table_key(table))
    return found[0] if found else table


def places_of(table: str) -> tuple[str, ...]:
    """The paths that a table, by its path or key, may have; the present format's first."""
    key = table_key(table)
    return (key,) if "/" in key else (f"{TABLES}{key}", key)


def sum_of(files: Files, path: str) -> Written:
    """Hash and size of one file."""
    digest, size = hashlib.sha256(), 0
    with files.open(path) as file:
        while chunk := file.read(CHUNK_BYTES):
            digest.update(chunk)
            size += len(chunk)
    return Written(digest.hexdigest(), size)


def read_whole(files: Files, path: str) -> bytes:
    """One small file's bytes. Raises Damaged where it is missing."""
    with files.open(path) as file:
        return file.read()


@contextmanager
def open_csv(files: Files, path: str) -> Iterator[io.TextIOWrapper]:
    """The text of one CSV for who reads its rows. Raises Damaged where it is missing or no CSV."""
    with files.open(path) as file:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="")
        try:
            yield text
        except (UnicodeDecodeError, csv.Error) as error:
            raise Damaged("csv_package-not-csv", path=path) from error
        finally:
            text.detach()


def read_rows(files: Files, path: str) -> Iterator[dict[str, str]]:
    """The rows of one CSV, by column, wherever it lies (`place_of`). Raises Damaged if missing or no CSV."""
    path = place_of(files, path)
    lacking = columns_lacking(files, path)
    with open_csv(files, path) as text:
        for row in csv.DictReader(text, strict=True):
            if None in row or None in row.values():
                raise Damaged("csv_package-row-length", path=path)
            yield _EarlierRow(row) if lacking else row


def read_header(files: Files, path: str) -> list[str]:
    """The names of one CSV's columns. Raises Damaged where it is missing or no CSV."""
    path = place_of(files, path)
    with files.open(path) as file:
        first = file.readline()
    try:
        return next(csv.reader([first.decode("utf-8")], strict=True), [])
    except (UnicodeDecodeError, csv.Error) as error:
        raise Damaged("csv_package-not-csv", path=path) from error


def read_columns(files: Files, path: str, names: tuple[str, ...]) -> Iterator[list[str]]:
    """Some columns of one CSV, row by row: several times as quick as `read_rows`. Raises Damaged."""
    path = place_of(files, path)
    lacking = columns_lacking(files, path)
    with open_csv(files, path) as text:
        try:
            reader = csv.reader(text, strict=True)
            header = [*next(reader, []), *lacking]
            places = [header.index(name) for name in names]
            added = [""] * len(lacking)
            for row in reader:
                cells = row + added if lacking else row
                yield [cells[place] for place in places]
        except (UnicodeDecodeError, csv.Error, ValueError, IndexError) as error:
            raise Damaged("csv_package-not-as-described", path=path) from error


def undo_safe_text(text: str) -> str:
    """A cell's text without the apostrophe that keeps a spreadsheet from running it."""
    return text[1:] if text.startswith("'") and safe_text(text[1:]) == text else text


def number(text: str) -> float | None:
    """A number, None for an empty cell."""
    return float(text) if text else None


def read_integer(text: str) -> int | None:
    """An integer, None for an empty cell."""
    return int(text) if text else None


def record_in(kind: type[Made], row: Mapping[str, str], **more: object) -> Made:
    """A dataclass of words and numbers out of a row's cells by its fields' names, and `more` besides.

    A cell that is empty gives None where the field may be that, else 0 or no words. Raises KeyError for a
    column that is not there, TypeError for a field of another type.
    """
    record: type = kind
    cells: dict[str, object] = {
        name: _READERS[hint](row[name]) for name, hint in _plain_hints(record) if name not in more
    }
    return kind(**cells, **more)


_READERS: dict[object, Callable[[str], Cell]] = {
    str: undo_safe_text,
    str | None: lambda cell: undo_safe_text(cell) or None,
    int: lambda cell: read_integer(cell) or 0,
    int | None: read_integer,
    float: lambda cell: number(cell) or 0.0,
    float | None: number,
    bool: lambda cell: cell == "true",
}


@cache
def _plain_hints(kind: type) -> tuple[tuple[str, object], ...]:
    return tuple(get_type_hints(kind).items())
