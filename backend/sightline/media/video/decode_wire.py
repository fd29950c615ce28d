"""What the server and its decoding process say to each other: a JSON header and bytes, never pickles.

The decoding process reads hostile files, so nothing that it sends may be more than data.
"""

import json
import struct
import threading
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np

from sightline.errors import BadInput, Damaged, NotFound, SightlineError
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import NoLongerWanted

Header = dict[str, Any]
_LENGTH = struct.Struct("<I")
_ERRORS: dict[str, type[SightlineError]] = {
    kind.__name__: kind for kind in (BadInput, Damaged, NotFound, NoLongerWanted, SightlineError)
}


@dataclass(frozen=True)
class Limits:
    """How much a decoding process may have: `memory_bytes` resident, `silence_s` without a sign of getting
    on; a recording that ended it `kills` times is set aside for `aside_s`.
    """

    memory_bytes: int = 2 * 1024**3
    silence_s: float = 30.0
    kills: int = 3
    aside_s: float = 600.0


class Link:
    """One end of the pipe. Any thread may send; one thread receives."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._sending = threading.Lock()

    def send(self, header: Header, body: bytes | memoryview = b"") -> None:
        """Raises OSError when the other end is gone."""
        head = json.dumps(header).encode()
        with self._sending:
            self._connection.send_bytes(_LENGTH.pack(len(body)) + head)
            if len(body):
                self._connection.send_bytes(body)

    def receive(self) -> tuple[Header, bytes]:
        """The next message. Raises EOFError or OSError when the other end is gone."""
        head = self._connection.recv_bytes()
        body = self._connection.recv_bytes() if _LENGTH.unpack_from(head)[0] else b""
        return json.loads(head[_LENGTH.size :]), body

    def close(self) -> None:
        self._connection.close()


def pack_media(media: RecordingMedia) -> tuple[Header, bytes]:
    """A recording's file and frame table as a message."""
    arrays = (media.pts.astype("<i8"), media.crc.astype("<u4"), media.key.astype("u1"))
    header = {"do": "know", "media": media.identity, "path": str(media.path), "count": len(media)}
    header["stream"] = media.stream_number
    return header, b"".join(array.tobytes() for array in arrays)


def unpack_media(header: Header, body: bytes) -> RecordingMedia:
    """The inverse of `pack_media`."""
    count = int(header["count"])
    pts = np.frombuffer(body, "<i8", count)
    crc = np.frombuffer(body, "<u4", count, 8 * count)
    key = np.frombuffer(body, "u1", count, 12 * count).astype(bool)
    path, stream = Path(header["path"]), header["stream"]
    return RecordingMedia(path, pts.astype(np.int64), crc.astype(np.uint32), key, stream)


def error_header(error: Exception) -> Header:
    """An error as data: one of ours by its name, code and values, any other by what it is."""
    if isinstance(error, SightlineError):
        known = next(kind.__name__ for kind in type(error).__mro__ if kind.__name__ in _ERRORS)
        return {"error": known, **error.said.document}
    return {"error": "", "code": f"{type(error).__name__}: {error}"}


def error_of(header: Header) -> Exception:
    """The inverse of `error_header`."""
    kind = _ERRORS.get(str(header["error"]))
    if kind is None:
        return RuntimeError(f"the decoding process broke: {header['code']}")
    return kind(header["code"], **header["values"])
