"""Parts of resumable uploads (tus 1.0) on disk: what has arrived is kept, whatever breaks.

An upload is one file in the upload folder, `ID.part`, with the bytes that have arrived. Its length is the
offset; there is no other record that could disagree with it. How many bytes there will be, the caller knows.
"""

from __future__ import annotations

import fcntl
import os
import re
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from sightline.errors import BadInput, Conflict, NotFound
from sightline.media.store.local import check_room, no_room_told, sha256_of, sync_folder

SYNC_EVERY_BYTES = 64 << 20
_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")


@dataclass(frozen=True)
class FinishedUpload:
    """A whole upload: where it lies until it is moved or discarded, and its content's SHA-256 in hex."""

    path: Path
    sha256: str
    size: int


def create(upload_dir: Path, upload_id: str, size: int) -> None:
    """Begin an upload of `size` bytes.

    Raises BadInput (nothing to send), NoRoom (before a byte is sent) and Conflict (id taken).
    """
    if size < 1:
        raise BadInput("store-file-empty-choose-video-file")
    upload_dir.mkdir(parents=True, exist_ok=True)
    check_room(upload_dir, size, "this upload")
    part = _path(upload_dir, upload_id)
    with no_room_told("this upload"):
        try:
            part.touch(exist_ok=False)
        except FileExistsError as error:
            raise Conflict("store-upload-name-already-under-way-start") from error
        sync_folder(upload_dir)


def offset(upload_dir: Path, upload_id: str) -> int:
    """How many bytes have arrived. Raises NotFound for one that is not there (finished, discarded, never)."""
    return _part(upload_dir, upload_id).stat().st_size


def append(upload_dir: Path, upload_id: str, size: int, at: int, chunks: Iterable[bytes]) -> int:
    """Write the chunks of an upload of `size` bytes behind byte `at` and return the new offset.

    What arrived is on disk when this returns.

    Raises Conflict if `at` is not the offset or somebody else is writing, BadInput if more comes than
    was announced (nothing of the chunk that overflows is kept), NoRoom on a full disk. Whatever arrived
    before stays, also if `chunks` itself raises: ask for the offset and go on from there.
    """
    with _locked(_part(upload_dir, upload_id)) as handle:
        have = os.fstat(handle).st_size
        if at != have:
            raise Conflict("store-upload-stands-byte-not-continue", have=have, at=at)
        os.lseek(handle, have, os.SEEK_SET)
        synced = have
        try:
            for chunk in chunks:
                if have + len(chunk) > size:
                    raise BadInput("store-more-bytes-came-announced-start-upload", size=size)
                with no_room_told("the rest of this upload"):
                    _write_all(handle, chunk)
                have += len(chunk)
                if have - synced >= SYNC_EVERY_BYTES:
                    os.fsync(handle)
                    synced = have
        finally:
            os.fsync(handle)
    return have


def _write_all(handle: int, chunk: bytes) -> None:
    view = memoryview(chunk)
    while view:
        view = view[os.write(handle, view) :]


def finish(upload_dir: Path, upload_id: str, size: int) -> FinishedUpload:
    """The whole file of `size` bytes and its SHA-256.

    The part stays until `discard`, so that a killed server can finish again. Raises Conflict while bytes
    are missing.
    """
    path = _part(upload_dir, upload_id)
    have = path.stat().st_size
    if have != size:
        raise Conflict("store-upload-not-complete-bytes-arrived-continue", have=have, size=size)
    return FinishedUpload(path, sha256_of(path), size)


def discard(upload_dir: Path, upload_id: str) -> None:
    """Remove an upload and what has arrived of it; nothing happens if it is not there."""
    _path(upload_dir, upload_id).unlink(missing_ok=True)


def sweep(upload_dir: Path, older_than_s: float) -> list[str]:
    """Discard uploads to which nothing was added for `older_than_s` seconds; their ids are returned."""
    before = time.time() - older_than_s
    gone = []
    for path in sorted(upload_dir.glob("*.part")) if upload_dir.is_dir() else []:
        if path.stat().st_mtime < before:
            discard(upload_dir, path.stem)
            gone.append(path.stem)
    return gone


def _path(upload_dir: Path, upload_id: str) -> Path:
    if not _ID.fullmatch(upload_id):
        raise _not_there()
    return upload_dir / f"{upload_id}.part"


def _part(upload_dir: Path, upload_id: str) -> Path:
    part = _path(upload_dir, upload_id)
    if not part.is_file():
        raise _not_there()
    return part


def _not_there() -> NotFound:
    return NotFound("store-no-such-upload-finished-given-up")


@contextmanager
def _locked(part: Path) -> Iterator[int]:
    """The part opened for writing by one process and thread at a time; the lock dies with its holder."""
    handle = os.open(part, os.O_WRONLY)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise Conflict("store-upload-being-written-another-connection-try") from error
        yield handle
    finally:
        os.close(handle)
