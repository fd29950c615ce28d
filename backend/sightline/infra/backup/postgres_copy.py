"""The rows of an installation's schema in PostgreSQL, out of one snapshot and into an empty schema, by COPY.

Tables, triggers and functions are not copied: this program's migrations make them. DECISIONS.md, 43.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from psycopg import Error as DriverError
from psycopg import sql
from sqlalchemy import Connection, inspect, text
from sqlalchemy.exc import DBAPIError

from sightline.errors import BadInput, Damaged
from sightline.infra.backup.manifest import CopiedTable
from sightline.media.store.local import CHUNK_BYTES, no_room_told

ENDING = ".copy"
#: Made by the migrations, not by people.
_MIGRATIONS_OWN = {"alembic_version"}

_KEYS = text("""
    SELECT conrelid::regclass::text AS place, quote_ident(conname) AS name, pg_get_constraintdef(oid) AS said
    FROM pg_constraint
    WHERE contype = 'f' AND connamespace = (SELECT oid FROM pg_namespace WHERE nspname = current_schema())
    ORDER BY 1, 2
""")
_COUNTERS = text("""
    SELECT attname, pg_get_serial_sequence(place, attname) FROM (
      SELECT a.attname, format('%I.%I', current_schema(), c.relname) AS place
      FROM pg_class c JOIN pg_attribute a ON a.attrelid = c.oid
      WHERE c.relnamespace = (SELECT oid FROM pg_namespace WHERE nspname = current_schema())
        AND c.relname = :table AND a.attnum > 0 AND NOT a.attisdropped
    ) AS columns
    WHERE pg_get_serial_sequence(place, attname) IS NOT NULL
    ORDER BY 1
""")
_SET_COUNTER = """
    SELECT setval(pg_get_serial_sequence(format('%%I.%%I', current_schema(), %s::text), %s), %s, %s)
"""


def copy_out(connection: Connection, folder: Path, tell: Callable[[float], None]) -> dict[str, CopiedTable]:
    """Write a file of each table into `folder`, all as the connection's snapshot has them."""
    tables = _tables(connection)
    copied: dict[str, CopiedTable] = {}
    for number, (name, columns) in enumerate(tables.items()):
        tell(number / len(tables))
        copying = sql.SQL("COPY {} ({}) TO STDOUT").format(sql.Identifier(name), _listed(columns))
        with (
            no_room_told(),
            (folder / f"{name}{ENDING}").open("wb") as file,
            _cursor(connection) as cursor,
            cursor.copy(copying) as rows,
        ):
            for piece in rows:
                file.write(piece)
        copied[name] = CopiedTable(columns, _counters(connection, name))
    return copied


def copy_in(
    connection: Connection, folder: Path, tables: Mapping[str, CopiedTable], tell: Callable[[float], None]
) -> None:
    """Fill the empty tables of a schema from files, in the connection's transaction.

    Foreign keys go before and come back after, which holds every row against them; the tables' triggers sleep
    meanwhile. Raises BadInput for tables that this program does not have, Damaged for rows that do not fit.
    """
    there = _tables(connection)
    if other := sorted(set(tables) - set(there)):
        raise BadInput("backup-other-tables", name=other[0])
    keys = connection.execute(_KEYS).all()
    for key in keys:
        _run(connection, f"ALTER TABLE {key.place} DROP CONSTRAINT {key.name}")
    for number, (name, table) in enumerate(tables.items()):
        tell(number / len(tables))
        try:
            _fill(connection, folder / f"{name}{ENDING}", name, table)
        except (DriverError, DBAPIError) as error:
            raise Damaged("backup-rows-misfit", name=name) from error
    try:
        for key in keys:
            _run(connection, f"ALTER TABLE {key.place} ADD CONSTRAINT {key.name} {key.said}")
    except DBAPIError as error:
        raise Damaged("backup-rows-misfit", name=key.place) from error


def _fill(connection: Connection, path: Path, name: str, table: CopiedTable) -> None:
    identifier = sql.Identifier(name)
    copying = sql.SQL("COPY {} ({}) FROM STDIN").format(identifier, _listed(table.columns))
    with path.open("rb") as file, _cursor(connection) as cursor:
        cursor.execute(sql.SQL("ALTER TABLE {} DISABLE TRIGGER USER").format(identifier))
        # a migration may have put rows of its own there, which are among those that were copied
        cursor.execute(sql.SQL("DELETE FROM {}").format(identifier))
        with cursor.copy(copying) as rows:
            while piece := file.read(CHUNK_BYTES):
                rows.write(piece)
        cursor.execute(sql.SQL("ALTER TABLE {} ENABLE TRIGGER USER").format(identifier))
        for column, (last, called) in table.counters.items():
            cursor.execute(_SET_COUNTER, (name, column, last, called))


def _tables(connection: Connection) -> dict[str, list[str]]:
    """The columns of every table of the schema, by name."""
    found = inspect(connection)
    names = sorted(set(found.get_table_names()) - _MIGRATIONS_OWN)
    return {
        name: [column["name"] for column in found.get_columns(name) if not column.get("computed")]
        for name in names
    }


def _counters(connection: Connection, table: str) -> dict[str, tuple[int, bool]]:
    """Where the counters of a table's columns stand; they may be ahead of the snapshot, never behind."""
    found = connection.execute(_COUNTERS, {"table": table}).all()
    counters: dict[str, tuple[int, bool]] = {}
    for column, sequence in found:
        last, called = connection.execute(text(f"SELECT last_value, is_called FROM {sequence}")).one()
        counters[column] = (last, called)
    return counters


def _listed(columns: list[str]) -> sql.Composed:
    return sql.SQL(", ").join(map(sql.Identifier, columns))


def _run(connection: Connection, statement: str) -> None:
    connection.execute(text(statement.replace(":", "\\:")))


@contextmanager
def _cursor(connection: Connection) -> Iterator[Any]:
    """The driver's own cursor: COPY is beyond SQLAlchemy."""
    driver = connection.connection.driver_connection
    assert driver is not None
    with driver.cursor() as cursor:
        yield cursor
