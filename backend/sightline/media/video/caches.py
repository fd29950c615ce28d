"""Least-recently-used caches bounded in bytes: one in memory, one on disk."""

from __future__ import annotations

import os
import threading
import zlib
from collections import OrderedDict
from collections.abc import Hashable
from contextlib import suppress
from pathlib import Path
from typing import Generic, TypeVar

from sightline.media.atomic import atomic_file

Value = TypeVar("Value")


class MemoryCache(Generic[Value]):
    """Values with their size in bytes; the least recently used go when the bound is passed. Thread-safe."""

    def __init__(self, most_bytes: int) -> None:
        self._most = most_bytes
        self._held = 0
        self._items: OrderedDict[Hashable, tuple[Value, int]] = OrderedDict()
        self._lock = threading.Lock()

    @property
    def held_bytes(self) -> int:
        return self._held

    @property
    def most_bytes(self) -> int:
        return self._most

    def keys(self) -> list[Hashable]:
        """What is held now."""
        with self._lock:
            return list(self._items)

    def get(self, key: Hashable) -> Value | None:
        with self._lock:
            item = self._items.get(key)
            if item is None:
                return None
            self._items.move_to_end(key)
            return item[0]

    def put(self, key: Hashable, value: Value, size: int) -> None:
        """Keep `value`; one larger than the whole bound is not kept."""
        if size > self._most:
            return
        with self._lock:
            old = self._items.pop(key, None)
            self._held += size - (old[1] if old else 0)
            self._items[key] = (value, size)
            while self._held > self._most:
                _, (_, freed) = self._items.popitem(last=False)
                self._held -= freed

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
