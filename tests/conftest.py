"""Databases for tests: SQLite, or PostgreSQL where SIGHTLINE_TEST_DATABASE_URL names a server.

The database is made once a session by running the migrations; each test gets an empty one. On PostgreSQL
every worker of pytest-xdist has a schema of its own, which is removed at the end.
"""

import atexit
import gc
import os
import sys
from collections.abc import Iterator
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from hypothesis.internal.conjecture import providers
from hypothesis.internal.constants_ast import Constants
from sqlalchemy import Engine, create_engine
from sqlalchemy.orm import Session

from sightline.infra.database import engine as engines
from sightline.infra.database.engine import SessionFactory, make_engine, session_factory, writing
from tests.support.kept import PostgresShelf, Shelf, SqliteShelf
from tests.support.proofs import PROOFS

pytest_plugins = ["tests.support.processor_time"]
#: Fixtures of who runs tests; who only hands them to workers need not import the program, nor does who asks a
#: server by a browser.
GROUND = ("tests.support.app", "tests.support.drawn")
pytest.register_assert_rewrite(*GROUND)  # a folder's conftest may import them first

# A busy machine is slow, not wrong. The same commit draws the same few examples every time; `make proofs`
# draws new ones, and many.
settings.register_profile("sightline", deadline=None, derandomize=True, max_examples=30)
settings.register_profile("proofs", deadline=None, max_examples=500)
settings.load_profile("proofs" if PROOFS else "sightline")

# Nothing of what is imported goes away again; looking for that takes a quarter of the time.
gc.disable()

SERVER = os.environ.get("SIGHTLINE_TEST_DATABASE_URL", "")


def pytest_configure(config: pytest.Config) -> None:
    browsers_alone = all(Path(one).parts[:2] == ("tests", "browser") for one in config.args)
    hands_out = "PYTEST_XDIST_WORKER" not in os.environ and config.getoption("numprocesses", None)
    if not browsers_alone and not hands_out:
        for name in GROUND:
            config.pluginmanager.import_plugin(name)


@pytest.hookimpl(tryfirst=True)
def pytest_collection(session: pytest.Session) -> None:
    """Each worker begins to import at another place of the circle of files, so that pytest compiles each of
    them once: in a new checkout that takes as long as all else of collecting.
    """
    worker = os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw")
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    if workers == 1 or sys.dont_write_bytecode:
        return
    root, ignored = session.config.rootpath, session.config.getoption("ignore") or ()
    asked = [root / one.partition("::")[0] for one in session.config.args]
    left_out = [root / one for one in ignored]
    found = [file for one in asked for file in ([one] if one.is_file() else sorted(one.rglob("test_*.py")))]
    files = [file for file in found if not any(file.is_relative_to(one) for one in left_out)]
    first = int(worker) * len(files) // workers
    for file in files[first:] + files[:first]:
        with suppress(Exception, pytest.skip.Exception):  # collecting says it
            import_module(".".join(file.relative_to(root).with_suffix("").parts))


@pytest.hookimpl(tryfirst=True)
def pytest_runtestloop() -> None:
    """What is imported by now stays to the end: the collector need not go through it again and again, nor
    once for the little that it would find (half a second of each worker).
    """
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)
    gc.enable()


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """A worker has told all by now: it ends without taking apart what it imported, which takes two seconds.
    Elsewhere libraries would complain that what they made is still there.
    """
    if hasattr(config, "workerinput"):
        atexit._run_exitfuncs()
        os._exit(0)
    gc.unfreeze()


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


@pytest.fixture(scope="session", autouse=True)
def nothing_waits_for_the_disk() -> Iterator[None]:
    """No test cuts the power off, and what was written outlives a killed process all the same."""
    prepare = engines._prepare_sqlite

    def unsynced(connection: Any, record: Any) -> None:
        prepare(connection, record)
        connection.execute("PRAGMA synchronous=OFF")

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engines, "_prepare_sqlite", unsynced)
        for name in ("fsync", "fdatasync"):
            patch.setattr(os, name, lambda _file: None)
        yield


@pytest.fixture(scope="session", autouse=True)
def numbers_of_no_source() -> Iterator[None]:
    """Hypothesis draws numbers that stand in sources too: each worker would parse all that it has loaded, and
    draw others where it has loaded others. `make proofs` does.
    """
    with pytest.MonkeyPatch.context() as patch:
        if not PROOFS:
            patch.setattr(providers, "_get_local_constants", Constants)
        yield


@pytest.fixture(scope="session")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shelf]:
    """Where empty databases come from, and where filled ones are kept."""
    if not SERVER:
        yield SqliteShelf(tmp_path_factory.mktemp("database"))
        return
    made = PostgresShelf(SERVER, os.environ.get("PYTEST_XDIST_WORKER", "main"))
    yield made
    made.close()


@pytest.fixture(scope="session")
def migrated(shelf: Shelf) -> str:
    """A migrated database: SQLite's is a file to copy, PostgreSQL's an address where it is emptied."""
    return shelf.migrated


@pytest.fixture
def database_url(shelf: Shelf, tmp_path: Path) -> Iterator[str]:
    """The address of an empty, migrated database of this test's own."""
    with shelf.empty(tmp_path) as url:
        yield url


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
