"""Least-recently-used caches bounded in bytes: one in memory, one on disk."""

import os
import threading
import zlib
from collections.abc import Callable, Hashable
from contextlib import suppress
from pathlib import Path
from typing import Generic, TypeVar

from cachetools import LRUCache

from sightline.media.atomic import atomic_file

Value = TypeVar("Value")


class MemoryCache(Generic[Value]):
    """At most `most_bytes` of values, each of `bytes_of(value)`; the least recently used go. Thread-safe."""

    def __init__(self, most_bytes: int, bytes_of: Callable[[Value], int]) -> None:
        self._items: LRUCache[Hashable, Value] = LRUCache(most_bytes, bytes_of)
        self._lock = threading.Lock()

    @property
    def held_bytes(self) -> int:
        return int(self._items.currsize)

    @property
    def most_bytes(self) -> int:
        return int(self._items.maxsize)

    def keys(self) -> list[Hashable]:
        """What is held now."""
        with self._lock:
            return list(self._items)

    def get(self, key: Hashable) -> Value | None:
        with self._lock:
            return self._items.get(key)

    def put(self, key: Hashable, value: Value) -> None:
        """Keep `value`; one larger than the whole bound is not kept."""
        with self._lock, suppress(ValueError):
            self._items[key] = value

    def __contains__(self, key: Hashable) -> bool:
        with self._lock:
            return key in self._items


class DiskCache:
    """Bytes in files, each with its CRC-32 in front so that a spoilt file is a miss and never a wrong
    picture.

    Survives restarts. Never needed: a full disk or a deleted folder costs time, not answers.
    Thread-safe; several processes may share a folder.
    """

    def __init__(self, folder: Path, most_bytes: int) -> None:
        self._folder = folder
        self._most = most_bytes
        self._lock = threading.Lock()
        folder.mkdir(parents=True, exist_ok=True)
        self._held = self._sum()

    @property
    def held_bytes(self) -> int:
        return self._held

    def get(self, key: str) -> bytes | None:
        """The bytes kept under `key` (a relative path without dots), or None."""
        path = self._folder / key
        try:
            data = path.read_bytes()
            os.utime(path)
        except OSError:
            return None
        body = data[4:]
        if zlib.crc32(body) != int.from_bytes(data[:4], "big"):
            path.unlink(missing_ok=True)
            return None
        return body

    def size(self, key: str) -> int | None:
        """Bytes kept under `key`, or None; they are not read, but they count as used."""
        path = self._folder / key
        try:
            os.utime(path)
            return path.stat().st_size - 4
        except OSError:
            return None

    def names(self, folder: str) -> list[str]:
        """The names of what is kept anywhere below `folder`, without their suffix."""
        walked = os.walk(self._folder / folder)
        return [name[:-4] for _, _, names in walked for name in names if name.endswith(".jpg")]

    def put(self, key: str, data: bytes) -> None:
        path = self._folder / key
        try:
            with atomic_file(path, lasting=False) as part:
                part.write_bytes(zlib.crc32(data).to_bytes(4, "big") + data)
        except OSError:
            return
        with self._lock:
            self._held += len(data) + 4
            if self._held > self._most:
                self._evict()

    def _files(self) -> list[tuple[float, int, Path]]:
        files = []
        for path in self._folder.rglob("*"):
            with suppress(OSError):
                if path.is_file():
                    stat = path.stat()
                    files.append((stat.st_mtime, stat.st_size, path))
        return files

    def _sum(self) -> int:
        return sum(size for _, size, _ in self._files())

    def _evict(self) -> None:
        """Down to three quarters of the bound, oldest use first: not every put has to list the folder."""
        files = sorted(self._files())
        self._held = sum(size for _, size, _ in files)
        for _, size, path in files:
            if self._held <= self._most * 3 // 4:
                break
            with suppress(OSError):
                path.unlink()
                self._held -= size
