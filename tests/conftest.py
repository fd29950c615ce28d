"""Databases for tests: SQLite, or PostgreSQL where SIGHTLINE_TEST_DATABASE_URL names a server.

The database is made once a session by running the migrations; each test gets an empty one. On PostgreSQL
every worker of pytest-xdist has a schema of its own, which is removed at the end.
"""

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
from hypothesis import settings
from sqlalchemy import Engine, create_engine, inspect, make_url, text
from sqlalchemy.orm import Session

from sightline.infra.database import engine as engines
from sightline.infra.database.engine import SessionFactory, make_engine, migrate, session_factory, writing

pytest_plugins = ["tests.support.app"]

# A busy machine is slow, not wrong; and the same commit draws the same examples every time.
settings.register_profile("sightline", deadline=None, derandomize=True)
settings.load_profile("sightline")

SERVER = os.environ.get("SIGHTLINE_TEST_DATABASE_URL", "")


@pytest.fixture(scope="session", autouse=True)
def sql_compiled_once() -> Iterator[None]:
    """Engines share the texts of their statements, which one alone would forget with each test."""
    first: dict[str, Engine] = {}

    def alike(*words: Any, **options: Any) -> Engine:
        made = create_engine(*words, **options)
        shared = first.setdefault(made.dialect.name, made)
        made.dialect = made.pool._dialect = shared.dialect
        made._compiled_cache = shared._compiled_cache
        return made

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engines, "create_engine", alike)
        yield


@pytest.fixture(scope="session")
def migrated(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A migrated database: the file to copy on SQLite, the schema to empty on PostgreSQL."""
    if not SERVER:
        path = tmp_path_factory.mktemp("database") / "migrated.db"
        _migrate(f"sqlite:///{path}")
        yield str(path)
        return
    schema = f"sightline_test_{os.environ.get('PYTEST_XDIST_WORKER', 'main')}_{uuid4().hex[:8]}"
    server = create_engine(SERVER, isolation_level="AUTOCOMMIT")
    with server.connect() as connection:
        connection.execute(text(f'CREATE SCHEMA "{schema}"'))
    url = make_url(SERVER).update_query_dict({"options": f"-csearch_path={schema}"})
    address = url.render_as_string(hide_password=False)
    _migrate(address)
    yield address
    with server.connect() as connection:
        connection.execute(text(f'DROP SCHEMA "{schema}" CASCADE'))
    server.dispose()


@pytest.fixture
def database_url(migrated: str, tmp_path: Path) -> Iterator[str]:
    """The address of an empty, migrated database of this test's own."""
    if SERVER:
        yield migrated
        _empty(migrated)
        return
    path = tmp_path / "sightline.db"
    shutil.copyfile(migrated, path)
    yield f"sqlite:///{path}"


@pytest.fixture
def engine(database_url: str) -> Iterator[Engine]:
    """An engine on the test's own database."""
    made = make_engine(database_url)
    yield made
    made.dispose()


@pytest.fixture
def factory(engine: Engine) -> SessionFactory:
    """The session factory to hand to `reading` and `writing`."""
    return session_factory(engine)


@pytest.fixture
def session(factory: SessionFactory) -> Iterator[Session]:
    """A write transaction that is rolled back in the end, for tests that need no second one."""
    with pytest.raises(_RollBack), writing(factory) as opened:
        yield opened
        raise _RollBack


class _RollBack(Exception):
    """Ends the `session` fixture's transaction without a commit."""


def _migrate(url: str) -> None:
    engine = make_engine(url)
    migrate(engine)
    if engine.dialect.name == "sqlite":
        with engine.connect() as connection:
            connection.exec_driver_sql("COMMIT")
            connection.exec_driver_sql("PRAGMA wal_checkpoint(TRUNCATE)")
            connection.exec_driver_sql("BEGIN")
    engine.dispose()


def _empty(url: str) -> None:
    """Empty every table of the schema, the ones that refuse it too (as superuser, triggers switched off).

    Deleting a few rows is much quicker than TRUNCATE, which makes new files.
    """
    engine = create_engine(url)
    with engine.begin() as connection:
        found = inspect(connection)
        names = [name for name in found.get_table_names() if name != "alembic_version"]
        sequences = found.get_sequence_names()
        statements = ["SET LOCAL session_replication_role = replica"]
        statements += [f'DELETE FROM "{name}"' for name in names]
        statements += [f"SELECT setval('\"{name}\"', 1, false)" for name in sequences]
        connection.execute(text("; ".join(statements)))
    engine.dispose()
