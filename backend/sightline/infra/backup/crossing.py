"""A backup of one kind of database in the terms of the other: the same rows, so that the chains end alike.

Rows go through the program's own tables. Between the two lie the files that COPY writes in its text format
(PostgreSQL's documentation of COPY): what SQLite holds is written as such files, and those are read back.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from datetime import datetime
from itertools import islice
from pathlib import Path
from typing import Any

from sqlalchemy import (
    Boolean,
    Column,
    Connection,
    Float,
    Integer,
    MetaData,
    Table,
    Text,
    insert,
    select,
    text,
    type_coerce,
)
from sqlalchemy.exc import DatabaseError

from sightline.errors import Damaged
from sightline.infra.backup.manifest import CopiedTable
from sightline.infra.backup.postgres_copy import ENDING
from sightline.infra.database.types import CanonicalJson, UtcDateTime, metadata
from sightline.infra.slices import load_tables
from sightline.media.store.local import no_room_told

_NOTHING = r"\N"
_AT_ONCE = 1000
_SIGNS = {"\\": "\\\\", "\t": "\\t", "\n": "\\n", "\r": "\\r", "\b": "\\b", "\f": "\\f", "\v": "\\v"}
_MEANT = {written[1]: sign for sign, written in _SIGNS.items()}
_WRITTEN, _ESCAPED = re.compile(r"[\\\t\n\r\b\f\v]"), re.compile(r"\\(.)", re.DOTALL)
_TRIGGERS = text("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'")


def copy_files_of_sqlite(
    connection: Connection, folder: Path, tell: Callable[[float], None]
) -> dict[str, CopiedTable]:
    """Write a file of each table as PostgreSQL's COPY reads it, out of the connection's snapshot."""
    tables = _tables()
    copied: dict[str, CopiedTable] = {}
    for number, table in enumerate(tables):
        tell(number / len(tables))
        with no_room_told(), (folder / f"{table.name}{ENDING}").open("wb") as file:
            for row in connection.execute(select(*map(_select_as_text, table.columns))).yield_per(_AT_ONCE):
                file.write(("\t".join(map(_written, row)) + "\n").encode())
        columns = [column.name for column in table.columns]
        copied[table.name] = CopiedTable(columns, _counter(connection, table))
    return copied


def fill_sqlite(
    connection: Connection, folder: Path, tables: Mapping[str, CopiedTable], tell: Callable[[float], None]
) -> None:
    """Fill a new SQLite database from COPY's files, in the connection's transaction.

    The tables' triggers are away meanwhile, and every foreign key is held at the end of the transaction. The
    job engine's own tables, which SQLite does not need, are left out. Raises Damaged for rows that do not
    fit.
    """
    triggers = connection.execute(_TRIGGERS).all()
    connection.exec_driver_sql("PRAGMA defer_foreign_keys = ON")
    for trigger in triggers:
        connection.exec_driver_sql(f'DROP TRIGGER "{trigger.name}"')
    for number, table in enumerate(ours := [table for table in _tables() if table.name in tables]):
        tell(number / len(ours))
        columns = [table.c[name] for name in tables[table.name].columns]
        kinds = [Text() if isinstance(one.type, CanonicalJson) else one.type for one in columns]
        bare = Table(table.name, MetaData(), *map(Column, tables[table.name].columns, kinds))
        try:
            # a migration may have put rows of its own there, which are among those that were copied
            connection.execute(table.delete())
            rows = _read_rows(folder / f"{table.name}{ENDING}", columns)
            while some := list(islice(rows, _AT_ONCE)):
                connection.execute(insert(bare), some)
        except (DatabaseError, ValueError) as error:
            raise Damaged("backup-rows-misfit", name=table.name) from error
    for trigger in triggers:
        connection.exec_driver_sql(trigger.sql)


def _tables() -> list[Table]:
    load_tables()
    return sorted(metadata.tables.values(), key=lambda table: table.name)


def _select_as_text(column: Column[Any]) -> Any:
    """JSON as the text that is stored, to the bit."""
    return type_coerce(column, Text()) if isinstance(column.type, CanonicalJson) else column


def _counter(connection: Connection, table: Table) -> dict[str, tuple[int, bool]]:
    """SQLite counts on from the largest number."""
    (column, *others) = table.primary_key.columns
    if others or column.foreign_keys or not isinstance(column.type, Integer):
        return {}
    largest = connection.execute(select(column).order_by(column.desc()).limit(1)).scalar()
    return {column.name: (largest or 1, largest is not None)}


def _written(value: object) -> str:
    """A value in COPY's text format."""
    match value:
        case None:
            return _NOTHING
        case bool():
            return "t" if value else "f"
        case datetime():
            return value.isoformat()
        case float():
            return repr(value)
        case _:
            return _WRITTEN.sub(lambda sign: _SIGNS[sign[0]], str(value))


def _read_rows(path: Path, columns: list[Column[Any]]) -> Iterator[dict[str, object]]:
    """The rows of one of COPY's files. Raises ValueError for what does not fit the columns."""
    with path.open(encoding="utf-8", newline="\n") as file:
        for line in file:
            cells = line.removesuffix("\n").split("\t")
            yield {column.name: _read_cell(cell, column) for column, cell in zip(columns, cells, strict=True)}


def _read_cell(cell: str, column: Column[Any]) -> object:
    if cell == _NOTHING:
        return None
    match column.type:
        case Boolean():
            return {"t": True, "f": False}[cell]
        case Integer():
            return int(cell)
        case Float():
            return float(cell)
        case UtcDateTime():
            return datetime.fromisoformat(cell)
        case _:
            return _ESCAPED.sub(lambda found: _MEANT.get(found[1], found[1]), cell)
