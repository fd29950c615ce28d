"""Media in S3-compatible storage, with a local cache bounded in bytes for what needs a file."""

import io
import os
import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from stat import S_ISREG
from typing import Any, BinaryIO
from urllib.parse import parse_qs, urlsplit
from weakref import WeakValueDictionary

import boto3
from botocore.config import Config
from botocore.exceptions import BotoCoreError, ClientError
from cachetools import TTLCache
from urllib3.exceptions import HTTPError

from sightline.errors import Away, BadInput, NotFound
from sightline.media.atomic import PART, atomic_file
from sightline.media.store.local import check_room, made_of, no_room_told, safe_path

#: tries of one request, and seconds of silence until one has failed
ATTEMPTS, CONNECT_S, READ_S = 3, 5.0, 20.0
#: the same of what is asked while others wait to write: over before PostgreSQL ends a writer (SHORT_IDLE_S)
AT_ONCE_ATTEMPTS, AT_ONCE_CONNECT_S, AT_ONCE_READ_S = 2, 1.0, 2.0
#: how long it is believed what lies under the key of what may be made anew
BELIEVED_S = 2.0
#: nothing was written to a part for so long: who fetched it is gone
SILENT_S = 3600.0
_PIECE_BYTES = 1 << 20


class StorageAway(Away):
    """The object store does not answer, or not as it should."""

    kind = "storage_away"


class _ReplacedMeanwhile(Exception):
    """What was fetched is not what the key had."""


@dataclass(frozen=True)
class _Object:
    """What is under a key: how many bytes, and the entity tag, which is another for other content."""

    size: int
    tag: str


class S3Store:
    """s3://bucket/prefix?endpoint=https://host:port&region=name; the bucket is made if it is not there.

    Uploads above 8 MB go in parts; S3 shows an object whole or not at all. `local_path` fetches into
    `cache_dir`, from which the least recently used files go when the bound is passed. What may be made anew
    lies there by its key and entity tag, so another content is another file.
    """

    def __init__(self, url: str, cache_dir: Path, cache_bytes: int) -> None:
        parts = urlsplit(url)
        query = parse_qs(parts.query)
        if not parts.netloc:
            raise BadInput("store-no-bucket", url=repr(url))
        self._bucket = parts.netloc
        self._prefix = parts.path.strip("/")
        self._cache = cache_dir
        self._cache_bytes = cache_bytes
        self._lock = threading.Lock()  # of the three below and of what is in the cache; held for moments
        #: of whose turn it is to fetch one file; gone when nobody waits for it
        self._fetching: WeakValueDictionary[Path, threading.Lock] = WeakValueDictionary()
        self._believed: TTLCache[str, _Object] = TTLCache(1024, BELIEVED_S)
        self._coming_bytes = 0
        cache_dir.mkdir(parents=True, exist_ok=True)
        place = {
            "endpoint_url": query.get("endpoint", [None])[0],
            "region_name": query.get("region", [os.environ.get("AWS_DEFAULT_REGION", "us-east-1")])[0],
        }
        self._client = _client(place, {"max_attempts": ATTEMPTS}, CONNECT_S, READ_S)
        tries = {"total_max_attempts": AT_ONCE_ATTEMPTS}
        self._client_at_once = _client(place, tries, AT_ONCE_CONNECT_S, AT_ONCE_READ_S)
        self._make_bucket()

    def put_file(self, key: str, path: Path, *, link: bool = False) -> None:
        if made_of(key) is None and self._head(key, self._client) is not None:
            return
        with _translate_store_errors(key):
            self._client.upload_file(str(path), self._bucket, self._name(key))
        self._forget(key)

    def local_path(self, key: str) -> Path:
        while True:
            try:
                return self._local_path(key, None if made_of(key) is None else self._current_object(key))
            except _ReplacedMeanwhile:
                self._forget(key)

    def _local_path(self, key: str, now: _Object | None) -> Path:
        """The file, fetched if it is not here; of what may be made anew, as it is `now`."""
        path = safe_path(self._cache, key)
        if now is not None:
            path = path.with_stem(f"{path.stem}.{now.tag}")
        with self._lock:
            turn = self._fetching.setdefault(path, threading.Lock())
        with turn:  # who wants the same file waits for it, who wants another does not
            if path.is_file():
                os.utime(path)
                return path
            found = now or self._require_object(key)
            with (
                self._room_for(found.size, key),
                _translate_store_errors(key),
                no_room_told(),
                atomic_file(path, lasting=False) as part,
            ):
                self._fetch(key, part)
                if now is not None and self._require_object(key) != now:
                    raise _ReplacedMeanwhile
            return path

    def _current_object(self, key: str) -> _Object:
        """What is under the key of what may be made anew, as seen a moment ago."""
        with self._lock:
            known = self._believed.get(key)
        if known is None:
            known = self._require_object(key)
            with self._lock:
                self._believed[key] = known
        return known

    def _forget(self, key: str) -> None:
        with self._lock:
            self._believed.pop(key, None)

    @contextmanager
    def _room_for(self, size: int, key: str) -> Iterator[None]:
        """Make room in the cache and keep it while a file comes. Raises NoRoom."""
        with self._lock:
            self._evict(keep_free=size + self._coming_bytes)
            check_room(self._cache, size)
            self._coming_bytes += size
        try:
            yield
        finally:
            with self._lock:
                self._coming_bytes -= size

    def exists(self, key: str) -> bool:
        return self._head(key, self._client_at_once) is not None

    def delete(self, key: str) -> None:
        safe_path(self._cache, key).unlink(missing_ok=True)
        with _translate_store_errors(key):
            self._client_at_once.delete_object(Bucket=self._bucket, Key=self._name(key))
        self._forget(key)

    def open(self, key: str) -> BinaryIO:
        try:
            body = self._client.get_object(Bucket=self._bucket, Key=self._name(key))["Body"]
            return io.BufferedReader(_Body(key, body), _PIECE_BYTES)
        except ClientError as error:
            if _code(error) in ("NoSuchKey", "404"):
                raise NotFound("store-file-missing", key=key) from error
            raise _failed(key, error) from error
        except BotoCoreError as error:
            raise _failed(key, error) from error

    def listing(self) -> Iterator[tuple[str, int]]:
        prefix = self._name("")
        with _translate_store_errors(self._bucket):
            pages = self._client.get_paginator("list_objects_v2").paginate(Bucket=self._bucket, Prefix=prefix)
            for page in pages:
                for found in page.get("Contents", ()):
                    yield found["Key"].removeprefix(prefix), int(found["Size"])

    def _name(self, key: str) -> str:
        return f"{self._prefix}/{key}" if self._prefix else key

    def _make_bucket(self) -> None:
        with _translate_store_errors(self._bucket):
            try:
                self._client.head_bucket(Bucket=self._bucket)
            except ClientError as error:
                if _code(error) not in ("404", "NoSuchBucket"):
                    raise
                try:
                    self._client.create_bucket(Bucket=self._bucket)
                except ClientError as refused:
                    why = _code(refused)
                    raise BadInput("store-bucket-missing", bucket=self._bucket, why=why) from refused

    def _require_object(self, key: str) -> _Object:
        found = self._head(key, self._client)
        if found is None:
            raise NotFound("store-file-lost", key=key)
        return found

    def _head(self, key: str, client: Any) -> _Object | None:
        with _translate_store_errors(key):
            try:
                head = client.head_object(Bucket=self._bucket, Key=self._name(key))
            except ClientError as error:
                if _code(error) in ("404", "NoSuchKey"):
                    return None
                raise
            return _Object(int(head["ContentLength"]), re.sub(r"[^A-Za-z0-9-]", "", head["ETag"]))

    def _fetch(self, key: str, path: Path) -> None:
        self._client.download_file(self._bucket, self._name(key), str(path))

    def _evict(self, keep_free: int) -> None:
        files = [one for path in self._cache.rglob("*") if (one := _may_go(path)) is not None]
        held = sum(size for _, size, _ in files)
        for _, size, path in sorted(files):
            if held + keep_free <= self._cache_bytes:
                break
            path.unlink(missing_ok=True)
            held -= size


def _client(place: dict[str, Any], retries: dict[str, int], connect_s: float, read_s: float) -> Any:
    config = Config(retries=retries, connect_timeout=connect_s, read_timeout=read_s)
    return boto3.client("s3", config=config, **place)


def _may_go(path: Path) -> tuple[float, int, Path] | None:
    """When a file was used last, and its size; None while it is on its way. Killed fetches leave parts."""
    try:
        of = path.stat()
    except FileNotFoundError:
        return None  # it has come, under its own name
    # boto3 writes to the name that it is given and a random ending
    coming = PART in path.suffixes and of.st_mtime > time.time() - SILENT_S
    return (of.st_atime, of.st_size, path) if S_ISREG(of.st_mode) and not coming else None


class _Body(io.RawIOBase):
    """An object's bytes as they come; an answer that breaks off is told like one that does not come."""

    def __init__(self, key: str, body: Any) -> None:
        self._key, self._body = key, body

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: Any) -> int:
        try:
            piece = self._body.read(len(buffer))
        except (BotoCoreError, HTTPError) as error:
            raise _failed(self._key, error) from error
        buffer[: len(piece)] = piece
        return len(piece)

    def close(self) -> None:
        self._body.close()
        super().close()


@contextmanager
def _translate_store_errors(key: str) -> Iterator[None]:
    """Turn what the S3 library raises into one sentence."""
    try:
        yield
    except (ClientError, BotoCoreError, boto3.exceptions.Boto3Error) as error:
        raise _failed(key, error) from error


def _failed(key: str, error: Exception) -> StorageAway:
    return StorageAway("store-no-answer", key=key, name=type(error).__name__)


def _code(error: ClientError) -> str:
    return str(error.response.get("Error", {}).get("Code", ""))
