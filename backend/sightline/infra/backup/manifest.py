"""What a backup's folder holds and how it is read: `manifest.json`, written last, names every file by hash.

    manifest.json            a folder without one is no backup
    states/TIME/             the database and the keys at one moment, with a manifest of its own; the last two
    media/ab/cd/SHA256       media by the hash of their content
    copied.jsonl             which media an unfinished backup has copied
    backup.lock              held while a backup is made

docs/formats.md describes each field.
"""

import fcntl
import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, get_args

from pydantic import TypeAdapter, ValidationError

from sightline.enums import DatabaseKind, KeyFrom
from sightline.errors import BadInput, Conflict, Damaged
from sightline.infra.audit.hashing import content_hash
from sightline.media.atomic import PART, atomic_file
from sightline.media.store.local import key_of, sha256_of

FORMAT = "sightline-backup-1"
MANIFEST, LOCK, JOURNAL, STATES, MEDIA = "manifest.json", "backup.lock", "copied.jsonl", "states", "media"


@dataclass(frozen=True)
class StoredFile:
    """A file of a backup: its length in bytes and the SHA-256 of its content in hex."""

    size: int
    sha256: str


@dataclass(frozen=True)
class CopiedTable:
    """A table of PostgreSQL as COPY wrote it: the columns in its file, and where their counters stand."""

    columns: list[str]
    counters: dict[str, tuple[int, bool]]


@dataclass(frozen=True)
class Manifest:
    """One whole backup.

    `files`: those of the state's folder. `heads`: the end of every audit chain, (events, hash). `media`: by
    key of the media store. `missing`: keys that the database names and the store did not have.
    """

    format: str
    at: str
    program: str
    revision: str
    database: DatabaseKind
    state: str
    files: dict[str, StoredFile]
    tables: dict[str, CopiedTable]
    keys: dict[str, KeyFrom]
    settings: dict[str, Any]
    heads: dict[str, tuple[int, str]]
    media: dict[str, StoredFile]
    missing: list[str]


_ADAPTER = TypeAdapter(Manifest)


def database_kind(name: str) -> DatabaseKind:
    """The kind of database by the name that its driver has."""
    return next(kind for kind in get_args(DatabaseKind) if kind == name)


def write_manifest(folder: Path, manifest: Manifest) -> None:
    """The backup is whole from here on; the manifest carries the hash of itself."""
    content = asdict(manifest)
    text = json.dumps({**content, "sha256": content_hash(content)}, indent=1, ensure_ascii=False)
    with atomic_file(folder / MANIFEST) as part:
        part.write_text(text + "\n", encoding="utf-8")
        part.chmod(0o600)


def read_manifest(folder: Path) -> Manifest:
    """The manifest of a whole backup. Raises BadInput for a folder without one, Damaged for a changed one."""
    path = folder / MANIFEST
    if not path.is_file():
        raise BadInput("backup-none-here", folder=folder)
    try:
        content = json.loads(path.read_bytes())
        sealed = content.pop("sha256")
        if content.get("format") != FORMAT:
            raise BadInput("backup-other-format", folder=folder)
        manifest = _ADAPTER.validate_python(content)
        whole = content_hash(content) == sealed
    except (ValueError, KeyError, AttributeError, RecursionError, ValidationError) as error:
        raise Damaged("backup-manifest-damaged", path=path) from error
    if not whole or not _names_are_plain(manifest):
        raise Damaged("backup-manifest-damaged", path=path)
    return manifest


def read_earlier(folder: Path) -> Manifest:
    """The manifest of the state before the last. Raises BadInput where there is none, Damaged."""
    last = read_manifest(folder).state
    states = sorted(path.parent for path in (folder / STATES).glob(f"*/{MANIFEST}"))
    earlier = [state for state in states if state.name != last]
    if not earlier:
        raise BadInput("backup-no-earlier", folder=folder)
    return read_manifest(earlier[-1])


def media_file(folder: Path, content_sha256: str) -> Path:
    """Where a backup keeps media with this content."""
    return folder / MEDIA / key_of(content_sha256)


def stored_file(path: Path) -> StoredFile:
    """Length and hash of a file."""
    return StoredFile(path.stat().st_size, sha256_of(path))


def require_whole(folder: Path, path: Path, expected: StoredFile) -> None:
    """Raises Damaged, naming the file, where it is not the one that the manifest names."""
    if not path.is_file():
        raise Damaged("backup-file-missing", name=path.relative_to(folder))
    if stored_file(path) != expected:
        raise Damaged("backup-file-changed", name=path.relative_to(folder))


@contextmanager
def lock_folder(folder: Path) -> Iterator[None]:
    """This process alone writes to the folder, which is made where it is not there, for its owner alone.

    Raises BadInput for a folder with other things in it, Conflict while another backup is written there.
    """
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    if not (folder / LOCK).exists() and any(folder.iterdir()):
        raise BadInput("backup-folder-not-empty", folder=folder)
    with (folder / LOCK).open("ab") as file:
        try:
            fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise Conflict("backup-under-way", folder=folder) from error
        for left in folder.rglob(f".*{PART}"):
            left.unlink()
        yield


def _names_are_plain(manifest: Manifest) -> bool:
    """No name leads out of the backup's folder or out of what is restored."""
    names = [manifest.state, *manifest.files, *manifest.tables, *manifest.keys]
    hashes = [one.sha256 for one in (*manifest.files.values(), *manifest.media.values())]
    return all(name and "/" not in name and name not in (".", "..") for name in names) and all(
        len(one) == 64 and set(one) <= set("0123456789abcdef") for one in hashes
    )
