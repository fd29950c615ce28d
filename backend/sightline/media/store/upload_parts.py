"""Parts of resumable uploads (tus 1.0) on disk: what has arrived is kept, whatever breaks.

An upload is one file in the upload folder, `ID.part`, with the bytes that have arrived. Its length is the
offset; there is no other record that could disagree with it. How many bytes there will be, the caller knows.

One connection writes a part at a time, over all processes: it holds the file's lock. A connection may go
silent for ever, so a newer one at the same offset takes over: it puts its name into `ID.writer`, the older
one sees that with its next chunk (an empty one says only that nothing came) and lets go.
"""

import fcntl
import os
import re
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from uuid import uuid4

from sightline.errors import BadInput, Conflict, NotFound
from sightline.media.atomic import sync_to_disk
from sightline.media.store.local import check_room, no_room_told, sha256_of

SYNC_EVERY_BYTES = 64 << 20
#: how long a newer connection waits until the older one has let go
TAKE_OVER_S = 10.0
LOOK_S = 0.05
_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")


@dataclass(frozen=True)
class FinishedUpload:
    """A whole upload: where it lies until it is moved or discarded, and its content's SHA-256 in hex."""

    path: Path
    sha256: str
    size: int


def create(upload_dir: Path, upload_id: str, size: int) -> None:
    """Begin an upload of `size` bytes. Raises BadInput (of none), NoRoom and Conflict (id taken)."""
    if size < 1:
        raise BadInput("store-file-empty")
    upload_dir.mkdir(parents=True, exist_ok=True)
    check_room(upload_dir, size)
    part = _path(upload_dir, upload_id)
    with no_room_told():
        try:
            part.touch(exist_ok=False)
        except FileExistsError as error:
            raise Conflict("store-upload-name-taken") from error
        sync_to_disk(upload_dir)


def offset(upload_dir: Path, upload_id: str) -> int:
    """How many bytes have arrived. Raises NotFound for one that is not there (finished, discarded, never)."""
    return _part(upload_dir, upload_id).stat().st_size


def silent_s(upload_dir: Path, upload_id: str) -> float | None:
    """How many seconds ago something was added last; None for a part that is not there."""
    try:
        return time.time() - _path(upload_dir, upload_id).stat().st_mtime
    except FileNotFoundError:
        return None


def append(upload_dir: Path, upload_id: str, size: int, at: int, chunks: Iterable[bytes]) -> int:
    """Write the chunks of an upload of `size` bytes behind byte `at` and return the new offset.

    What arrived is on disk when this returns. Who was writing until now ends with Conflict and writes nothing
    more; to be noticed while nothing comes, `chunks` gives empty ones in the meantime.

    Raises Conflict if `at` is not the offset or a newer connection took over, BadInput if more comes than
    was announced (nothing of the chunk that overflows is kept), NoRoom on a full disk. Whatever arrived
    before stays, also if `chunks` itself raises: ask for the offset and go on from there.
    """
    part = _part(upload_dir, upload_id)
    _require_offset(part.stat().st_size, at)  # a stray request takes nothing over
    with _taken_over(part) as (handle, writer):
        have = os.fstat(handle).st_size
        _require_offset(have, at)
        os.lseek(handle, have, os.SEEK_SET)
        synced = have
        try:
            for chunk in chunks:
                _require_last_writer(part, writer)
                if have + len(chunk) > size:
                    raise BadInput("store-upload-too-long", size=size)
                with no_room_told():
                    _write_all(handle, chunk)
                have += len(chunk)
                if have - synced >= SYNC_EVERY_BYTES:
                    os.fsync(handle)
                    synced = have
        finally:
            os.fsync(handle)
    return have


def _require_offset(have: int, at: int) -> None:
    if at != have:
        raise Conflict("store-upload-offset", have=have, at=at)


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
        raise Conflict("store-upload-incomplete", have=have, size=size)
    return FinishedUpload(path, sha256_of(path), size)


def discard(upload_dir: Path, upload_id: str) -> None:
    """Remove an upload and what has arrived of it; nothing happens if it is not there."""
    part = _path(upload_dir, upload_id)
    part.unlink(missing_ok=True)
    _writer(part).unlink(missing_ok=True)


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
    return NotFound("store-no-upload")


def _writer(part: Path) -> Path:
    """Where the connection that came last has its name."""
    return part.with_suffix(".writer")


def _require_last_writer(part: Path, name: str) -> None:
    """Raises Conflict where a newer connection came, NotFound where the upload was given up."""
    try:
        last = _writer(part).read_text("ascii")
    except FileNotFoundError as error:
        raise _not_there() from error
    if last != name:
        raise Conflict("store-upload-superseded")


@contextmanager
def _taken_over(part: Path) -> Iterator[tuple[int, str]]:
    """The part opened for writing by one process and thread at a time, and this writer's name.

    The lock dies with its holder. Raises Conflict where the older writer does not let go, or a still newer
    one came.
    """
    name = uuid4().hex
    handle = os.open(part, os.O_WRONLY)
    try:
        with no_room_told():
            replaced = part.with_suffix(f".{name}")
            try:
                replaced.write_text(name, "ascii")
                replaced.replace(_writer(part))
            finally:
                replaced.unlink(missing_ok=True)
        end = time.monotonic() + TAKE_OVER_S
        while not _is_locked(handle):
            if time.monotonic() >= end:
                raise Conflict("store-upload-busy")
            time.sleep(LOOK_S)
            _require_last_writer(part, name)
        _require_last_writer(part, name)
        yield handle, name
    finally:
        os.close(handle)


def _is_locked(handle: int) -> bool:
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True
