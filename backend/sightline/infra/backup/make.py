"""A backup of a running installation into a folder: media, then the database, then the media that came since.

The database needs media. What it names at its moment is in the first pass, or came during it and is in the
second; what is in the store and not in the database is harmless. So the database lies between two passes.

The copy of the database is read back, pages and chains, before it counts as a state. One that is damaged is
none: the last good state stays, and so does the one before a new one.
"""

import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from sqlalchemy.orm import Session

from sightline.enums import KeyFrom
from sightline.errors import BadInput, Damaged
from sightline.infra.audit.checkpoints import known_keys
from sightline.infra.audit.signing import FILE as SIGNING_KEY
from sightline.infra.audit.signing import key_file
from sightline.infra.audit.verification import verify_records
from sightline.infra.backup.manifest import (
    FORMAT,
    JOURNAL,
    MANIFEST,
    STATES,
    CopiedTable,
    Manifest,
    StoredFile,
    database_kind,
    lock_folder,
    read_manifest,
    stored_file,
    write_manifest,
)
from sightline.infra.backup.media_copy import MediaCopies, prune
from sightline.infra.backup.postgres_copy import copy_out
from sightline.infra.backup.sqlite_copy import copy_sqlite, settle
from sightline.infra.backup.state import continues, heads_of, needed_media
from sightline.infra.database.engine import engine_at, reading, session_factory, sqlite_file
from sightline.infra.database.pages import require_whole_pages
from sightline.infra.database.revisions import require_this_version
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.infra.web.secret import FILE as SECRET
from sightline.media.atomic import sync_to_disk
from sightline.media.store.local import no_room_told
from sightline.settings import Settings, sqlite_url

DATABASE = "sightline.db"
Tell = Callable[[float, str], None]


@dataclass(frozen=True)
class MadeBackup:
    """A backup, how many media files were copied for it, and how many older ones were removed."""

    manifest: Manifest
    fresh: int
    pruned: int


@dataclass(frozen=True)
class _State:
    """The database as it was copied."""

    revision: str
    heads: dict[str, tuple[int, str]]
    needed: set[str]
    tables: dict[str, CopiedTable]
    signed_with: str | None


class _Unsound(Exception):
    """The chains of the database that was copied do not hold: why, as a sentence."""


def make_backup(services: Services, folder: Path, tell: Tell, *, pruning: bool = False) -> MadeBackup:
    """Back up into a folder, which stays the backup that it was until this one is whole.

    `pruning` removes media of earlier backups that this one does not name.
    Raises BadInput (a folder with other things, another installation's), Conflict, NoRoom, DatabaseAway, and
    Damaged where the database is: by table, with the state that is kept.
    """
    settings = services.settings
    _require_apart(folder, settings)
    with lock_folder(folder):
        before = read_manifest(folder) if (folder / MANIFEST).is_file() else None
        copies = MediaCopies(folder, before)
        copies.take(services.media, lambda share: tell(0.6 * share, "media"))
        moment = datetime.now(UTC)
        name = moment.strftime("%Y%m%dT%H%M%S.%fZ")
        place = folder / STATES / name
        place.mkdir(parents=True, mode=0o700)
        keys = _copy_keys(settings, place)
        state = _sound_copy(services, folder, place, before, tell)
        _copy_changed_key(settings, place, keys, state.signed_with)
        copies.take(services.media, lambda share: tell(0.9 + 0.1 * share, "media that came meanwhile"))
        manifest = Manifest(
            format=FORMAT,
            at=moment.isoformat(timespec="microseconds"),
            program=code_version(),
            revision=state.revision,
            database=database_kind(services.engine.dialect.name),
            state=name,
            files={path.name: _secure_file(path) for path in sorted(place.iterdir())},
            tables=state.tables,
            keys=keys,
            settings=_told_settings(services),
            heads=state.heads,
            media=dict(sorted(copies.copied.items())),
            missing=sorted(state.needed - set(copies.copied)),
        )
        for made in (place, place.parent):
            sync_to_disk(made)
        write_manifest(place, manifest)
        write_manifest(folder, manifest)
        tell(1.0, "whole")
        return MadeBackup(manifest, copies.fresh, _tidy(folder, manifest, before, pruning))


def _require_apart(folder: Path, settings: Settings) -> None:
    """Neither holds the other: a backup must outlive data folder and media, and not hold itself."""
    ours = folder.absolute().resolve()
    media = settings.media_url.removeprefix("file://")
    for place in (settings.data_dir, *(() if "://" in media else (media,))):
        theirs = Path(place).absolute().resolve()
        if ours.is_relative_to(theirs) or theirs.is_relative_to(ours):
            raise BadInput("backup-folders-nested", folder=folder)


def _sound_copy(services: Services, folder: Path, place: Path, before: Manifest | None, tell: Tell) -> _State:
    """The database copied and read back. Whatever goes wrong, no part of a state is left."""
    try:
        return _copy_database(services, place, before, lambda share: tell(0.6 + 0.3 * share, "database"))
    except BaseException as error:
        shutil.rmtree(place, ignore_errors=True)
        if not isinstance(error, _Unsound | Damaged):
            raise
        if before is None:
            raise Damaged("backup-damaged-none-before", problem=str(error), folder=folder) from error
        raise Damaged(
            "backup-damaged-kept", problem=str(error), at=before.at[:19].replace("T", " "), folder=folder
        ) from error


def _copy_database(
    services: Services, place: Path, before: Manifest | None, tell: Callable[[float], None]
) -> _State:
    """Copy what one moment's database holds into the state's folder."""
    path = sqlite_file(services.settings.database_url)
    if path is None:
        with services.reading() as session:
            return _describe_state(session, before, copy_out(session.connection(), place, tell))
    with no_room_told():
        copy_sqlite(path, place / DATABASE, tell)
    with (
        engine_at(sqlite_url(place / DATABASE)) as engine,
        reading(session_factory(engine)) as session,
    ):
        require_whole_pages(session.connection())
        state = _describe_state(session, before, {})
    settle(place / DATABASE)
    return state


def _describe_state(session: Session, before: Manifest | None, tables: dict[str, CopiedTable]) -> _State:
    revision = require_this_version(session.connection())
    if before is not None and not continues(session, before.heads):
        raise BadInput("backup-of-another-installation")
    if (problem := verify_records(session).problem) is not None:
        raise _Unsound(problem)
    signed_with = next((one["key"] for one in reversed(known_keys(session))), None)
    return _State(revision, heads_of(session), needed_media(session), tables, signed_with)


def _copy_keys(settings: Settings, place: Path) -> dict[str, KeyFrom]:
    """The data folder's keys, readable by their owner alone; those of the environment stay there."""
    key_origins: dict[str, KeyFrom] = {}
    for name, given in ((SIGNING_KEY, settings.signing_key), (SECRET, settings.secret)):
        source = settings.data_dir / name
        key_origins[name] = "environment" if given is not None else "file" if source.is_file() else "none"
        if key_origins[name] == "file":
            _copy_key(source, place / name)
    return key_origins


def _copy_changed_key(settings: Settings, place: Path, keys: dict[str, KeyFrom], public: str | None) -> None:
    """The key that the database was signed with last, where it is not the one that was in force before."""
    source = key_file(settings.data_dir, public) if public and not key_file(place, public) else None
    if source is not None and keys[SIGNING_KEY] != "environment":
        (place / SIGNING_KEY).unlink(missing_ok=True)
        _copy_key(source, place / SIGNING_KEY)
        keys[SIGNING_KEY] = "file"


def _copy_key(source: Path, target: Path) -> None:
    handle = os.open(target, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(handle, "wb") as file:
        file.write(source.read_bytes())


def _told_settings(services: Services) -> dict[str, object]:
    """The settings without any secret: for who sets the restored installation up."""
    told = services.settings.model_dump(mode="json", exclude={"secret", "signing_key"})
    return {**told, "database_url": services.engine.url.render_as_string(hide_password=True)}


def _secure_file(path: Path) -> StoredFile:
    """A file of the state, for its owner alone and safe from a power cut."""
    path.chmod(0o600)
    with path.open("rb") as file:
        os.fsync(file.fileno())
    return stored_file(path)


def _tidy(folder: Path, manifest: Manifest, before: Manifest | None, pruning: bool) -> int:
    """Keep this state and the one before; others, the journal and, if asked, media of neither are removed."""
    kept = {one.state: one for one in (before, manifest) if one is not None}
    for state in (folder / STATES).iterdir():
        if state.name not in kept:
            shutil.rmtree(state)
        elif not (state / MANIFEST).is_file():  # of a version that kept one state only
            write_manifest(state, kept[state.name])
    (folder / JOURNAL).unlink(missing_ok=True)
    return prune(folder, list(kept.values())) if pruning else 0
