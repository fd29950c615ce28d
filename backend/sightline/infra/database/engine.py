"""Engines, migrations and the two kinds of transaction: reading and writing.

SQLite runs in WAL mode with foreign keys and a busy timeout; a writing transaction begins IMMEDIATE under
one process-wide lock, so writers queue up in order instead of failing. PostgreSQL takes an advisory lock
instead: one for all writers, or one for the writers of a survey (`writing`).

A transaction is on the disk when `writing` ends. Of `unsynced` ones that holds only once `sync` has returned:
several, each whole, then share one wait for the disk, and nobody may be told of one before.
"""

import errno
import os
import sqlite3
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from sqlalchemy import Connection, Engine, TextClause, create_engine, event, make_url, text
from sqlalchemy.exc import ArgumentError, DatabaseError, OperationalError
from sqlalchemy.orm import Session, sessionmaker

from sightline.errors import Away, BadInput, Damaged, NoRoom, SightlineError
from sightline.infra.database.revisions import newest_revision, stored_revision

# Advisory locks are the database's; an installation's are those of its schema.
_TURN = "pg_advisory_xact_lock{kind}(hashtextextended(current_schema() || :turn, 7419))"
_EXCLUSIVE = text(f"SELECT {_TURN.format(kind='')}")
_LATER = "set_config('synchronous_commit', 'off', true)"
# A writer that does nothing for longer is taken for dead, and its turn goes on to the next.
_IDLE = "set_config('idle_in_transaction_session_timeout', :idle_ms, true)"
# Beside the other surveys, and alone in this one: a lock on nobody's number where there is no such row.
_IN_SURVEY = (
    f"SELECT {_IDLE}, {_TURN.format(kind='_shared')}, "
    "pg_advisory_xact_lock(hashtextextended(current_schema() || '/survey ' || {survey}, 7419))"
)
_ITS_SURVEY = "coalesce((SELECT survey_id FROM {table} WHERE id = :number), 0)"
_ALONE_NOW = text(f"SELECT {_IDLE}, {_TURN.format(kind='')}")
_ALONE_LATER = text(f"SELECT {_IDLE}, {_TURN.format(kind='')}, {_LATER}")
# A migration takes the time that it takes.
_UNLIMITED = text(
    "SELECT set_config('statement_timeout', '0', true), set_config('lock_timeout', '300000', true)"
)
# A commit that writes to the log is waited for, with all that stands in the log before it.
_FLUSH = text("SELECT pg_logical_emit_message(true, 'sightline', '')")
_EVERYTHING = {"turn": "/everything"}
#: seconds that PostgreSQL lets a writer do nothing in a turn: one that answers people, or keeps a survey's
#: turn, and one that works by itself in the turn of all (a worker's job, a command)
SHORT_IDLE_S, LONG_IDLE_S = 8.0, 30.0
# More connections than requests may read at once (infra/web/turns.py), for there are short questions beside.
_POOL: dict[str, Any] = {"pool_size": 10, "max_overflow": 30, "pool_timeout": 10}
_WRITING, _UNSYNCED = "sightline_writing", "sightline_unsynced"
# What SQLite says where pages of its file hold something else; PostgreSQL of a block it cannot read.
_DAMAGED = ("malformed", "Could not decode to UTF-8", "invalid page in block", "could not read block")
# PostgreSQL's codes: an account lacks a right; a writer that did nothing for too long was ended.
_NO_RIGHT, _ENDED = "42501", "25P03"
_sqlite_writer = threading.RLock()


SessionFactory = sessionmaker[Session]


class DatabaseAway(Away):
    """The database does not answer."""

    kind = "database_away"


def sqlite_file(url: str) -> Path | None:
    """The file of a SQLite database by its address; None for an address of another kind."""
    return Path(make_url(url).database or "") if url.startswith("sqlite:///") else None


def make_engine(url: str, *, must_exist: bool = False) -> Engine:
    """An engine for `sqlite:///path` or `postgresql+psycopg://...`. Raises BadInput for any other URL.

    `must_exist` refuses to make a SQLite file that is not there.
    """
    try:
        parsed = make_url(url)
    except ArgumentError:
        raise BadInput("database-address-unreadable") from None
    if parsed.drivername in ("postgresql", "postgres"):
        parsed = parsed.set(drivername="postgresql+psycopg")
    backend = parsed.get_backend_name()
    if backend == "sqlite":
        path = str(parsed.database or "")
        if must_exist and not Path(path).is_file():
            raise BadInput("database-missing", path=path)
        return _sqlite_engine(path, parsed.render_as_string(hide_password=False))
    if backend == "postgresql":
        engine: Engine = _limits().limited_engine(parsed, **_POOL)
        return engine
    raise BadInput("database-not-supported", backend=backend)


@contextmanager
def engine_at(url: str, *, must_exist: bool = False) -> Iterator[Engine]:
    """What `make_engine` makes, with its connections closed at the end."""
    engine = make_engine(url, must_exist=must_exist)
    try:
        yield engine
    finally:
        engine.dispose()


def _sqlite_engine(path: str, url: str) -> Engine:
    if path in ("", ":memory:"):
        raise BadInput("database-in-memory")
    Path(path).absolute().parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    given: dict[str, Any] = {"timeout": 10, "check_same_thread": False}
    if (unchanging := read_only_address(Path(path))) is not None:
        engine = create_engine(
            url, creator=lambda: sqlite3.connect(unchanging, uri=True, isolation_level=None, **given), **_POOL
        )
    else:
        file = Path(path).absolute()
        engine = create_engine(url, creator=lambda: _connect_private(file, given), **_POOL)
        event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


def read_only_address(path: Path) -> str | None:
    """The address by which SQLite reads a file on a medium that nobody can write; None for any other file.

    SQLite then takes no lock and makes no file beside it. Raises DatabaseAway where commits still wait in a
    log beside the file: they would not be seen.
    """
    if not path.is_file() or os.access(path, os.W_OK) or os.access(path.absolute().parent, os.W_OK):
        return None
    log = Path(f"{path}-wal")
    if log.is_file() and log.stat().st_size:
        raise DatabaseAway("database-read-only-log", path=path)
    return f"{path.absolute().as_uri()}?mode=ro&immutable=1"


def _connect_private(path: Path, given: dict[str, Any]) -> sqlite3.Connection:
    """A file that is not there is made for this account alone; SQLite's files beside it get the same mode."""
    with suppress(OSError):
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
    made: sqlite3.Connection = sqlite3.connect(path, **given)
    return made


def _prepare_sqlite(connection: Any, _record: Any) -> None:
    connection.isolation_level = None  # this module begins transactions itself
    cursor = connection.cursor()
    for pragma in ("journal_mode=WAL", "foreign_keys=ON", "busy_timeout=10000", "synchronous=FULL"):
        cursor.execute(f"PRAGMA {pragma}")
    cursor.close()


def _begin_sqlite(connection: Any) -> None:
    options = connection.get_execution_options()
    if not options.get(_WRITING, False):
        connection.exec_driver_sql("BEGIN")
        return
    level = "NORMAL" if options.get(_UNSYNCED, False) else "FULL"
    if connection.info.get("synchronous", "FULL") != level:
        connection.exec_driver_sql(f"PRAGMA synchronous={level}")
        connection.info["synchronous"] = level
    connection.exec_driver_sql("BEGIN IMMEDIATE")


def migrate(engine: Engine) -> None:
    """Bring the database to the newest schema, one process at a time. Raises BadInput if it is newer."""
    with translate_database_errors(), _sqlite_writer, engine.connect() as connection:
        current = stored_revision(connection)
        if current is not None and current == newest_revision():
            return
        connection.rollback()
        from sightline.infra.database.migrations import upgrade

        writer = connection.execution_options(**{_WRITING: True})
        with writer.begin():
            if engine.dialect.name == "postgresql":
                lift_limits(writer)
                writer.execute(_EXCLUSIVE, _EVERYTHING)
            upgrade(writer)


def lift_limits(connection: Connection) -> None:
    """Let what this transaction asks of PostgreSQL take the time that it takes: migrations, restoring."""
    _limits().limit_answers(connection, None)
    connection.execute(_UNLIMITED)


def session_factory(engine: Engine, *, idle_s: float | None = None) -> SessionFactory:
    """The maker of sessions on this engine; hand it to `reading` and `writing`.

    `idle_s`: how long a writer in the turn of all may do nothing before PostgreSQL gives the turn to the
    next (LONG_IDLE_S unless given).
    """
    info = {} if idle_s is None else {"idle_s": idle_s}
    return sessionmaker(engine, expire_on_commit=False, autoflush=False, info=info)


@contextmanager
def reading(factory: SessionFactory) -> Iterator[Session]:
    """A session that only reads one state of the database; whatever it did is rolled back at the end."""
    session = factory()
    try:
        with translate_database_errors():
            if engine_of(factory).dialect.name == "postgresql":
                # SQLite's transactions see one state anyway; here each statement would see another one.
                session.connection(execution_options={"isolation_level": "REPEATABLE READ"})
            yield session
    finally:
        session.rollback()
        session.close()


@dataclass(frozen=True, slots=True)
class SurveyOf:
    """The survey that a row belongs to and never leaves: `survey_id` of row `id` of a table."""

    table: str
    id: int


#: The number of a survey, or whose survey it is: then it is found by what waits for its turn.
InSurvey = int | SurveyOf


@dataclass(frozen=True, slots=True)
class Beside:
    """What is written beside all chains has a turn of its own: nobody is kept out by who writes a survey."""

    turn: str


#: Who signs in is noted; what a request was answered is kept, for when it is sent again.
SIGN_IN, ANSWERS = Beside("/sign-in"), Beside("/answers")


@contextmanager
def writing(
    factory: SessionFactory, within: InSurvey | Beside | None = None, *, unsynced: bool = False
) -> Iterator[Session]:
    """A session that may write; commits at the end, rolls back on any error.

    It is the only one that does. Within a survey (whose rows, chain and nothing else it changes) it is on
    PostgreSQL the only one of that survey, and others are written meanwhile; with `SIGN_IN` or `ANSWERS`
    (which change no chain) the only one of that kind. An `unsynced` one is not yet sure to outlast a power
    cut: call `sync` before anybody is told. Raises DatabaseAway where its turn, or an answer, does not come
    in time.
    """
    if engine_of(factory).dialect.name == "sqlite":
        with _sqlite_writer, _write(factory, within, unsynced) as session:
            yield session
    else:
        with _write(factory, within, unsynced) as session:
            yield session


def sync(factory: SessionFactory) -> None:
    """Wait until what was committed is on the disk. Raises DatabaseAway or NoRoom where it cannot be."""
    engine = engine_of(factory)
    if engine.dialect.name == "postgresql":
        with (
            translate_database_errors(),
            engine.execution_options(isolation_level="AUTOCOMMIT").begin() as connection,
        ):
            connection.execute(_FLUSH)
    else:
        _sync_log(Path(f"{engine.url.database}-wal"))


def _sync_log(log: Path) -> None:
    """SQLite's log, in which a commit is a frame at the end; a checkpoint syncs what it takes out of it.

    A file of its own beside the database's: closing it gives none of SQLite's locks back (those are on the
    database and on its shared memory), and it stays while the pool holds a connection.
    """
    try:
        file = os.open(log, os.O_RDONLY)
        try:
            os.fsync(file) if sys.platform == "darwin" else os.fdatasync(file)
        finally:
            os.close(file)
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EDQUOT):
            raise NoRoom("database-disk-full") from error
        raise DatabaseAway("database-not-writable") from error


@contextmanager
def _write(factory: SessionFactory, within: InSurvey | Beside | None, unsynced: bool) -> Iterator[Session]:
    session = factory()
    try:
        with translate_database_errors():
            session.connection(execution_options={_WRITING: True, _UNSYNCED: unsynced})
            if session.get_bind().dialect.name == "postgresql":
                _await_turn(session, within, unsynced)
            yield session
            session.commit()
    except BaseException:
        session.rollback()
        raise
    finally:
        session.close()


def _await_turn(session: Session, within: InSurvey | Beside | None, unsynced: bool) -> None:
    """Wait for the turn to write; SQLite's BEGIN IMMEDIATE has done it already."""
    limits = _limits()
    idle_s, answer_s = float(session.info.get("idle_s", LONG_IDLE_S)), limits.LONG_WRITE_S
    if within is not None:
        idle_s, answer_s = SHORT_IDLE_S, limits.SHORT_WRITE_S
    limits.limit_answers(session.connection(), answer_s)
    everything = {**_EVERYTHING, "idle_ms": str(round(idle_s * 1000))}
    if within is None:
        session.execute(_ALONE_LATER if unsynced else _ALONE_NOW, everything)
    elif isinstance(within, Beside):
        session.execute(_ALONE_LATER if unsynced else _ALONE_NOW, {**everything, "turn": within.turn})
    else:
        table, number = (within.table, within.id) if isinstance(within, SurveyOf) else (None, within)
        session.execute(_turn_in_survey(table, unsynced), {**everything, "number": number})


@cache
def _turn_in_survey(table: str | None, unsynced: bool) -> TextClause:
    """The statement that waits for the turn in survey `number`, or in that of row `number` of a table."""
    survey = "CAST(:number AS integer)" if table is None else _ITS_SURVEY.format(table=table)
    return text(_IN_SURVEY.format(survey=survey) + (f", {_LATER}" if unsynced else ""))


def _limits() -> ModuleType:
    """Imported where a database of that kind is opened: who keeps a file needs no driver of a server."""
    from sightline.infra.database import postgres

    return postgres


def engine_of(factory: SessionFactory) -> Engine:
    """The engine behind a session factory."""
    engine = factory.kw["bind"]
    assert isinstance(engine, Engine)
    return engine


@contextmanager
def translate_database_errors() -> Iterator[None]:
    """Turn the database's own errors into one sentence: full disk, locked, away, damaged, no database."""
    try:
        yield
    except DatabaseError as error:
        said = explanation(error)
        if said is None:
            raise
        raise said from error


def explanation(error: DatabaseError) -> SightlineError | None:
    """What an error of the database means to the person in front; None for a fault of the program."""
    words = str(error.orig)
    code = getattr(error.orig, "sqlstate", None)
    if code == _NO_RIGHT:
        return BadInput("database-account-lacks-rights")
    if code == _ENDED:
        return DatabaseAway("database-no-answer")
    if (damage := damage_in(words)) is not None:
        return damage
    if not isinstance(error, OperationalError):
        return None
    words = words.lower()
    if "full" in words or "no space" in words:
        return NoRoom("database-disk-full")
    if "locked" in words or "lock timeout" in words:
        return DatabaseAway("database-busy")
    if "unable to open" in words or "readonly" in words:
        return DatabaseAway("database-not-writable")
    return DatabaseAway("database-no-answer")


def damage_in(words: str) -> SightlineError | None:
    """The sentence for a file whose content is not a database's any more, by SQLite's words; else None."""
    if "not a database" in words:
        return BadInput("database-not-a-database")
    if any(sign in words for sign in _DAMAGED):
        return Damaged("database-damaged")
    return None
