"""Databases that were filled once and are put back for each test, which is quicker than filling them again.

A shelf gives out empty databases and keeps filled ones. On SQLite each test has a file of its own and a
filled one is another file to copy. On PostgreSQL all tests of a process share a schema, and a filled one is a
second schema beside it.
"""

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar
from uuid import uuid4

import pytest
from sqlalchemy import Connection, create_engine, inspect, make_url

from sightline.infra.database.engine import make_engine, migrate, sqlite_file

T = TypeVar("T")
#: Puts a filled database back, in the place of the empty one at this address that nobody has opened yet.
PutBack = Callable[[str], None]


def run_folder(factory: pytest.TempPathFactory) -> Path:
    """A folder that the workers of a run share; what is put there comes whole, by renaming."""
    own = factory.getbasetemp()
    return own.parent if "PYTEST_XDIST_WORKER" in os.environ else own


class SqliteShelf:
    """Files in `folder`."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.migrated = str(folder / "migrated.db")
        engine = make_engine(f"sqlite:///{self.migrated}")
        migrate(engine)
        engine.dispose()

    @contextmanager
    def empty(self, folder: Path) -> Iterator[str]:
        """The address of an empty database for one test."""
        path = folder / "sightline.db"
        shutil.copyfile(self.migrated, path)
        yield f"sqlite:///{path}"

    def keep(self, fill: Callable[[str], T]) -> tuple[T, PutBack]:
        """What `fill` says of the database that it has filled and left, and how to have that again."""
        kept = self._folder / f"{uuid4().hex}.db"
        shutil.copyfile(self.migrated, kept)
        said = fill(f"sqlite:///{kept}")
        assert _left(kept)

        def put_back(url: str) -> None:
            path = sqlite_file(url)
            assert path is not None and _left(path)
            shutil.copyfile(kept, path)

        return said, put_back


def _left(path: Path) -> bool:
    """Whether nobody has the file open: the last one who leaves takes the log into it."""
    return not Path(f"{path}-wal").exists()


class PostgresShelf:
    """Schemas on the server at this address, removed by `close`."""

    def __init__(self, server: str, name: str) -> None:
        self._schema = f"sightline_test_{name}_{uuid4().hex[:8]}"
        self._kept: list[str] = []
        # several statements at once cannot be prepared
        self._server = create_engine(server, connect_args={"prepare_threshold": None})
        with self._server.begin() as connection:
            connection.exec_driver_sql(f'CREATE SCHEMA "{self._schema}"')
        url = make_url(server).update_query_dict({"options": f"-csearch_path={self._schema}"})
        self.migrated = url.render_as_string(hide_password=False)
        engine = make_engine(self.migrated)
        migrate(engine)
        engine.dispose()
        found = inspect(self._server)
        self._tables = sorted(set(found.get_table_names(self._schema)) - {"alembic_version"})
        self._sequences = found.get_sequence_names(self._schema)
        self._emptying = self._without_triggers(
            *(f'DELETE FROM "{name}"' for name in self._tables),
            *(f"SELECT setval('\"{name}\"', 1, false)" for name in self._sequences),
        )

    def _without_triggers(self, *statements: str) -> str:
        """As superuser: tables that refuse changes are changed too, and no row asks for another.

        Deleting a few rows is much quicker than TRUNCATE, which makes new files.
        """
        place = f'SET LOCAL search_path = "{self._schema}"'
        return "; ".join((place, "SET LOCAL session_replication_role = replica", *statements))

    def _run(self, statements: str) -> None:
        with self._server.begin() as connection:
            connection.exec_driver_sql(statements)

    @contextmanager
    def empty(self, _folder: Path) -> Iterator[str]:
        """The address of an empty database for one test, which is emptied after it."""
        yield self.migrated
        self._run(self._emptying)

    def keep(self, fill: Callable[[str], T]) -> tuple[T, PutBack]:
        """What `fill` says of the database that it has filled and left, and how to have that again."""
        schema = f"{self._schema}_{len(self._kept)}"
        with self._server.begin() as connection:
            assert not self._filled(connection), "a test wrote before it asked for what is kept"
            self._kept.append(schema)
            connection.exec_driver_sql(f'CREATE SCHEMA "{schema}"')
        said = fill(self.migrated)
        with self._server.begin() as connection:
            filled = self._filled(connection)
            for name in filled:
                copy = f'CREATE TABLE "{schema}"."{name}" AS TABLE "{self._schema}"."{name}"'
                connection.exec_driver_sql(copy)
            ends = [self._end(connection, name) for name in self._sequences]
        self._run(self._emptying)
        putting = self._without_triggers(
            *(f'INSERT INTO "{name}" SELECT * FROM "{schema}"."{name}"' for name in filled),
            *(end for end in ends if end),
        )
        return said, lambda _url: self._run(putting)

    def _filled(self, connection: Connection) -> list[str]:
        """The tables that hold a row."""
        return [
            name
            for name in self._tables
            if connection.exec_driver_sql(f'SELECT 1 FROM "{self._schema}"."{name}" LIMIT 1').first()
        ]

    def _end(self, connection: Connection, name: str) -> str:
        """The statement that brings a sequence to where it is now; none for one that was not used."""
        query = f'SELECT last_value, is_called FROM "{self._schema}"."{name}"'
        last, used = connection.exec_driver_sql(query).one()
        return f"SELECT setval('\"{name}\"', {last})" if used else ""

    def close(self) -> None:
        """Remove the schemas."""
        with self._server.begin() as connection:
            for schema in (self._schema, *self._kept):
                connection.exec_driver_sql(f'DROP SCHEMA "{schema}" CASCADE')
        self._server.dispose()


Shelf = SqliteShelf | PostgresShelf


def lay_sqlite(shelf: Shelf, data_dir: Path) -> Path:
    """The data folder, made where it is not, with an empty database of SQLite's."""
    data_dir.mkdir(exist_ok=True)
    place = data_dir / "sightline.db"
    if isinstance(shelf, SqliteShelf):
        shutil.copyfile(shelf.migrated, place)
    else:
        engine = make_engine(f"sqlite:///{place}")
        migrate(engine)
        engine.dispose()
    return data_dir
