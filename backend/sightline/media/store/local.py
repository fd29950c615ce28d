"""Where media files are kept: a local folder or S3-compatible storage, behind one small interface."""

import errno
import hashlib
import os
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO, Protocol

from sightline.errors import NoRoom, NotFound
from sightline.media.atomic import atomic_file

CHUNK_BYTES = 1 << 20
RESERVE_BYTES = 64 << 20
THUMBS, COPY = "thumbs", "work"
_MADE = re.compile(rf"../../([0-9a-f]{{64}})\.(?:{THUMBS}|{COPY})(?:-(\d+))?\.\w+")


class MediaStore(Protocol):
    """Files by key; keys are made by `key_of`, so the same content has the same key and is stored once.

    What was made of content (`made_key_of`) may be made anew: then it takes the place of what is there.
    """

    def put_file(self, key: str, path: Path, *, link: bool = False) -> None:
        """Store the file's content, whole; nothing is written if it is there. Raises NoRoom.

        With `link` the store may share the bytes on disk with the given file instead of copying them: no time
        and no room are needed, but the given file must never be changed in place (deleting it is fine).
        """

    def local_path(self, key: str) -> Path:
        """A local file with the content, for reading only. Raises NotFound, NoRoom."""

    def exists(self, key: str) -> bool:
        """Whether the file is there; others may wait to write, so this takes seconds, or raises Away."""

    def delete(self, key: str) -> None:
        """Remove the file, if it is there; others wait to write, so this takes seconds, or raises Away."""

    def open(self, key: str) -> BinaryIO:
        """The content from its start, for reading; the caller closes it. Raises NotFound."""

    def listing(self) -> Iterator[tuple[str, int]]:
        """Key and size in bytes of every file, in the order of keys."""


def key_of(sha256: str, suffix: str = "") -> str:
    """The key of content by its SHA-256 (hex): two levels of folders, the hash, a suffix like ".mp4"."""
    return f"{sha256[:2]}/{sha256[2:4]}/{sha256}{suffix}"


def made_key_of(sha256: str, what: str, picture: int | None, suffix: str) -> str:
    """The key of what was made of content, or of one of its pictures: THUMBS or a working COPY."""
    number = "" if picture is None else f"-{picture}"
    return key_of(sha256, f".{what}{number}{suffix}")


def made_of(key: str) -> tuple[str, int | None] | None:
    """The content (and picture) that a file was made of; None of a key that tells its own content."""
    found = _MADE.fullmatch(key)
    return None if found is None else (found[1], None if found[2] is None else int(found[2]))


def sha256_of(path: Path) -> str:
    """SHA-256 of a file's content in hex, read in pieces."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def check_room(folder: Path, size: int) -> None:
    """Raise NoRoom, before anything is written, if `size` more bytes would use up the disk's reserve."""
    free = free_bytes(folder)
    if size > free:
        raise NoRoom("store-no-room", needed_mb=size / 1e6, free_mb=max(0, free) / 1e6)


def free_bytes(folder: Path) -> int:
    """How many bytes a folder's disk still takes before its reserve."""
    return shutil.disk_usage(folder).free - RESERVE_BYTES


@contextmanager
def no_room_told() -> Iterator[None]:
    """Turn the system's "no space left" and "quota exceeded" into NoRoom."""
    try:
        yield
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
            raise
        raise NoRoom("database-disk-full") from error


class LocalStore:
    """A folder. Files appear whole (written aside, synced, renamed) or not at all."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder.resolve()
        self._folder.mkdir(parents=True, exist_ok=True)

    def put_file(self, key: str, path: Path, *, link: bool = False) -> None:
        target = self._path(key)
        if (target.exists() and made_of(key) is None) or (link and link_whole(path, target)):
            return
        check_room(self._folder, path.stat().st_size)
        with no_room_told():
            copy_whole(path, target)

    def local_path(self, key: str) -> Path:
        path = self._path(key)
        if not path.is_file():
            raise NotFound("store-file-lost", key=key)
        return path

    def exists(self, key: str) -> bool:
        return self._path(key).is_file()

    def delete(self, key: str) -> None:
        self._path(key).unlink(missing_ok=True)

    def open(self, key: str) -> BinaryIO:
        return self.local_path(key).open("rb")

    def listing(self) -> Iterator[tuple[str, int]]:
        for path in sorted(self._folder.rglob("*")):
            with suppress(FileNotFoundError):  # it may go while the others are told
                if path.is_file() and not path.name.startswith("."):
                    yield path.relative_to(self._folder).as_posix(), path.stat().st_size

    def _path(self, key: str) -> Path:
        return safe_path(self._folder, key)


def safe_path(folder: Path, key: str) -> Path:
    """The key as a path inside `folder`. Raises NotFound for one that would lead out of it."""
    parts = key.split("/")
    if not key or any(part in ("", ".", "..") or "\\" in part or "\x00" in part for part in parts):
        raise NotFound("store-no-media-file", key=repr(key))
    return folder.joinpath(*parts)


def copy_whole(source: Path, target: Path) -> None:
    """Copy a file so that `target` is whole on disk or not there; a killed copy leaves only a .part."""
    with atomic_file(target) as part, source.open("rb") as read, part.open("xb") as write:
        shutil.copyfileobj(read, write, CHUNK_BYTES)


def link_whole(source: Path, target: Path) -> bool:
    """Give the file a second name, whole or not at all; False where disks or file system say no."""
    try:
        with atomic_file(target) as part:
            os.link(source, part)
    except OSError:
        return False
    return True
