"""Media into a backup, only what it does not hold yet, and out of it."""

import hashlib
import json
import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import IO
from uuid import uuid4

from sightline.errors import NotFound
from sightline.infra.backup.manifest import JOURNAL, MEDIA, Manifest, StoredFile, media_file, require_whole
from sightline.media.atomic import PART, sync_to_disk
from sightline.media.store.local import CHUNK_BYTES, MediaStore, check_room, no_room_told

Told = Callable[[float], None]


class MediaCopies:
    """What a backup's folder holds of the media store, by key; `fresh` counts what came in this time.

    Each file that was copied is noted in the journal, so that a killed backup does not copy it again.
    """

    def __init__(self, folder: Path, before: Manifest | None) -> None:
        self._folder = folder
        self._held = dict(before.media) if before else {}
        self._held |= _journal(folder / JOURNAL)
        self.copied: dict[str, StoredFile] = {}
        self.fresh = 0

    def take(self, store: MediaStore, tell: Told) -> None:
        """Copy every file of the store that is not there yet. What goes meanwhile is passed over."""
        listed = [(key, size) for key, size in store.listing() if key not in self.copied]
        whole, done = sum(size for _, size in listed) or 1, 0
        with (self._folder / JOURNAL).open("a", encoding="utf-8") as journal:
            for key, size in listed:
                tell(done / whole)
                self._take_one(store, key, size, journal)
                done += size

    def _take_one(self, store: MediaStore, key: str, size: int, journal: IO[str]) -> None:
        held = self._held.get(key)
        if held is None or held.size != size or not self._is_there(held):
            try:
                held = self._copy(store, key, size)
            except NotFound:
                return
            json.dump([key, held.size, held.sha256], journal)
            journal.write("\n")
            journal.flush()
            self.fresh += 1
        self.copied[key] = held

    def _is_there(self, held: StoredFile) -> bool:
        path = media_file(self._folder, held.sha256)
        return path.is_file() and path.stat().st_size == held.size

    def _copy(self, store: MediaStore, key: str, size: int) -> StoredFile:
        check_room(self._folder, size)
        part = self._folder / f".{uuid4().hex}{PART}"
        try:
            with store.open(key) as read, no_room_told(), part.open("xb") as write:
                digest, length = hashlib.sha256(), 0
                while piece := read.read(CHUNK_BYTES):
                    digest.update(piece)
                    length += write.write(piece)
                write.flush()
                os.fsync(write.fileno())
            target = media_file(self._folder, digest.hexdigest())
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(part, target)
            sync_to_disk(target.parent)
        finally:
            part.unlink(missing_ok=True)
        return StoredFile(length, digest.hexdigest())


def _journal(path: Path) -> dict[str, StoredFile]:
    """What an unfinished backup copied; a torn last line is ended, so that it spoils no other."""
    if not path.is_file():
        return {}
    copied = {}
    text = path.read_text(encoding="utf-8", errors="replace")
    if text and not text.endswith("\n"):
        with path.open("a", encoding="utf-8") as file:
            file.write("\n")
    for line in text.splitlines():
        try:
            key, size, sha256 = json.loads(line)
            copied[str(key)] = StoredFile(int(size), str(sha256))
        except (ValueError, TypeError):
            continue
    return copied


def prune(folder: Path, manifests: Sequence[Manifest]) -> int:
    """Remove media that no manifest names; how many."""
    named = {media_file(folder, one.sha256) for manifest in manifests for one in manifest.media.values()}
    gone = [path for path in (folder / MEDIA).glob("??/??/*") if path not in named]
    for path in gone:
        path.unlink()
    return len(gone)


def put_back(folder: Path, manifest: Manifest, store: MediaStore, told: Told) -> None:
    """Put every file into an empty store, after its hash was held against the manifest. Raises Damaged."""
    for key, path in whole_media(folder, manifest, told):
        store.put_file(key, path)


def whole_media(folder: Path, manifest: Manifest, told: Told) -> Iterator[tuple[str, Path]]:
    """Every key of the manifest with its file, read back. Raises Damaged with the first that is not whole."""
    whole, done = sum(one.size for one in manifest.media.values()) or 1, 0
    for key, stored in manifest.media.items():
        told(done / whole)
        path = media_file(folder, stored.sha256)
        require_whole(folder, path, stored)
        yield key, path
        done += stored.size
