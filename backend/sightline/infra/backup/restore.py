"""A backup read back: checked where it lies, or restored into an empty place and checked there."""

import os
import shutil
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from sqlalchemy import Connection, inspect
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Damaged
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.records import Verification
from sightline.infra.audit.verification import verify_records
from sightline.infra.backup.crossing import copy_files_of_sqlite, fill_sqlite
from sightline.infra.backup.make import DATABASE, Tell
from sightline.infra.backup.manifest import (
    STATES,
    CopiedTable,
    Manifest,
    read_earlier,
    read_manifest,
    require_whole,
)
from sightline.infra.backup.media_copy import put_back, whole_media
from sightline.infra.backup.postgres_copy import copy_in
from sightline.infra.backup.state import heads_of
from sightline.infra.database.engine import (
    engine_at,
    lift_limits,
    migrate,
    reading,
    session_factory,
    sqlite_file,
    translate_database_errors,
    writing,
)
from sightline.infra.database.migrations import upgrade
from sightline.infra.database.pages import require_whole_pages
from sightline.infra.database.revisions import newest_revision
from sightline.infra.jobs.recovery import deliver_anew
from sightline.media.store.local import MediaStore, check_room, copy_whole
from sightline.media.store.opening import open_store
from sightline.settings import Settings, sqlite_url


@dataclass(frozen=True)
class ReadBackup:
    """A backup that is whole. `audit`: what its chains said; None where no database was there to ask."""

    manifest: Manifest
    audit: Verification | None


def check_backup(folder: Path, tell: Tell, anchors: Anchors | None = None) -> ReadBackup:
    """Read a whole backup and change nothing: every file by its hash, and of SQLite the audit chains, also
    against what was kept of them elsewhere (`anchors`).

    Raises BadInput for what is no backup, or one of PostgreSQL with anchors, Damaged with the name of what
    is not whole.
    """
    manifest = read_manifest(folder)
    if anchors and manifest.database != "sqlite":
        raise BadInput("backup-anchors-of-postgresql")
    for _ in whole_media(folder, manifest, lambda share: tell(0.8 * share, "media")):
        pass
    state = _whole_state(folder, manifest, tell, 0.8)
    if manifest.database != "sqlite":
        tell(1.0, "read")
        return ReadBackup(manifest, None)
    with tempfile.TemporaryDirectory(prefix="sightline-check-") as scratch:
        check_room(Path(scratch), (state / DATABASE).stat().st_size)
        audit = _sqlite_in(state / DATABASE, Path(scratch) / DATABASE, manifest, anchors)
    tell(1.0, "read")
    return ReadBackup(manifest, audit)


def restore_backup(folder: Path, settings: Settings, tell: Tell, *, earlier: bool = False) -> ReadBackup:
    """Restore into an empty data folder, database and media store; after an error they are empty again.

    `earlier`: not the last state, but the one before it.
    The database comes last and is kept only if its audit chains hold and end as they did.
    It may be of the other kind than the one that was backed up: the rows are the same, and so are the chains.
    Raises BadInput (a place that is not empty), Damaged by name, NoRoom.
    """
    manifest = read_earlier(folder) if earlier else read_manifest(folder)
    data_dir, path = settings.data_dir, sqlite_file(settings.database_url)
    _require_empty(settings)
    state = _whole_state(folder, manifest, tell, 0.0)
    was_there = data_dir.is_dir()
    data_dir.mkdir(parents=True, exist_ok=True)
    store: MediaStore | None = None
    try:
        store = _empty_store(settings)
        put_back(folder, manifest, store, lambda share: tell(0.1 + 0.6 * share, "media"))
        tell_database = _part(tell, 0.7, 0.3, "database")
        _put_keys(state, manifest, data_dir)
        if path is None:
            audit = _into_postgresql(state, settings.database_url, manifest, tell_database)
        elif manifest.database == "sqlite":
            audit = _sqlite_in(state / DATABASE, path, manifest)
        else:
            audit = _into_sqlite(state, path, manifest, tell_database)
    except BaseException:
        _empty(data_dir, itself=not was_there)
        if store is not None:
            for key in manifest.media:
                store.delete(key)
        raise
    tell(1.0, "restored")
    return ReadBackup(manifest, audit)


def _part(tell: Tell, start: float, share: float, words: str) -> Callable[[float], None]:
    return lambda done: tell(start + share * done, words)


def _whole_state(folder: Path, manifest: Manifest, tell: Tell, start: float) -> Path:
    """The folder of database and keys, every file of it checked."""
    state = folder / STATES / manifest.state
    for number, (name, one) in enumerate(manifest.files.items()):
        tell(start + 0.1 * number / len(manifest.files), "checking the database's files")
        require_whole(folder, state / name, one)
    return state


def _require_empty(settings: Settings) -> None:
    path = sqlite_file(settings.database_url)
    if settings.data_dir.exists() and any(settings.data_dir.iterdir()):
        raise BadInput("backup-place-not-empty", place=settings.data_dir)
    if path is not None and path.exists():
        raise BadInput("backup-place-not-empty", place=path)
    if path is None:
        with (
            engine_at(settings.database_url) as engine,
            translate_database_errors(),
            engine.connect() as connection,
        ):
            _require_no_tables(connection)


def _require_no_tables(connection: Connection) -> None:
    if inspect(connection).get_table_names():
        raise BadInput("backup-database-not-empty")


def _empty_store(settings: Settings) -> MediaStore:
    store = open_store(settings.media_url, settings.data_dir / "cache" / "media")
    if next(iter(store.listing()), None) is not None:
        raise BadInput("backup-place-not-empty", place=settings.media_url)
    return store


def _empty(folder: Path, *, itself: bool) -> None:
    """Take away what was put into a folder that was empty."""
    for found in folder.iterdir():
        if found.is_dir() and not found.is_symlink():
            shutil.rmtree(found)
        else:
            found.unlink()
    if itself:
        folder.rmdir()


def _put_keys(state: Path, manifest: Manifest, data_dir: Path) -> None:
    for name in (name for name, where in manifest.keys.items() if where == "file"):
        copy_whole(state / name, data_dir / name)
        os.chmod(data_dir / name, 0o600)


@contextmanager
def _named_when_whole(target: Path) -> Iterator[Path]:
    """Where to make a SQLite file; it gets its name at the end, and after an error nothing of it is left."""
    waiting = target.with_name(f"{target.name}.restoring")
    try:
        yield waiting
        os.replace(waiting, target)
    finally:
        for left in target.parent.glob(f"{waiting.name}*"):
            left.unlink()


def _sqlite_in(
    source: Path, target: Path, manifest: Manifest, anchors: Anchors | None = None
) -> Verification:
    """Copy a SQLite database, migrate it, check its chains; only then does it get its name."""
    with _named_when_whole(target) as waiting:
        copy_whole(source, waiting)
        with engine_at(sqlite_url(waiting)) as engine:
            migrate(engine)
            with reading(session_factory(engine)) as session:
                require_whole_pages(session.connection())
                return _verified(session, manifest, anchors)


def _into_postgresql(
    state: Path, url: str, manifest: Manifest, tell: Callable[[float], None]
) -> Verification:
    """Make the backup's schema, fill it, migrate it and check its chains, all in one transaction."""
    with (
        _rows_for_postgresql(state, manifest, tell) as (rows, tables, revision),
        engine_at(url) as engine,
        translate_database_errors(),
        engine.begin() as connection,
    ):
        lift_limits(connection)
        _require_no_tables(connection)
        upgrade(connection, revision)
        copy_in(connection, rows, tables, tell)
        upgrade(connection)
        with Session(connection, autoflush=False) as session:
            found = _verified(session, manifest)
            if manifest.database == "sqlite":
                deliver_anew(session)
            return found


@contextmanager
def _rows_for_postgresql(
    state: Path, manifest: Manifest, tell: Callable[[float], None]
) -> Iterator[tuple[Path, Mapping[str, CopiedTable], str]]:
    """The folder of COPY's files, what is in them, and the schema that they are of."""
    if manifest.database != "sqlite":
        yield state, manifest.tables, manifest.revision
        return
    with tempfile.TemporaryDirectory(prefix="sightline-crossing-") as made:
        scratch = Path(made)
        check_room(scratch, 2 * (state / DATABASE).stat().st_size)
        _sqlite_in(state / DATABASE, scratch / DATABASE, manifest)  # of the newest schema, and whole
        with (
            engine_at(sqlite_url(scratch / DATABASE)) as engine,
            reading(session_factory(engine)) as session,
        ):
            tables = copy_files_of_sqlite(session.connection(), scratch, tell)
        yield scratch, tables, "head"


def _into_sqlite(
    state: Path, target: Path, manifest: Manifest, tell: Callable[[float], None]
) -> Verification:
    """Fill a new SQLite file with PostgreSQL's rows; only when its chains hold does it get its name."""
    if manifest.revision != newest_revision():
        raise BadInput("backup-older-crosses-later")
    with _named_when_whole(target) as waiting, engine_at(sqlite_url(waiting)) as engine:
        migrate(engine)
        with writing(session_factory(engine)) as session:
            fill_sqlite(session.connection(), state, manifest.tables, tell)
            found = _verified(session, manifest)
        with engine.connect() as connection:
            connection.exec_driver_sql("PRAGMA wal_checkpoint(TRUNCATE)")
    return found


def _verified(session: Session, manifest: Manifest, anchors: Anchors | None = None) -> Verification:
    """Raises Damaged where a chain does not hold, or does not end as the manifest says."""
    if heads_of(session) != manifest.heads:
        raise Damaged("backup-chains-end-elsewhere")
    found = verify_records(session, anchors)
    if not found.ok:
        raise Damaged("backup-chain-broken", problem=str(found.problem))
    return found
