"""A strip that grows while it is recorded: a BigTIFF that is whole after every block of lines.

tifffile writes pictures whose height is known; here the directory stands before the pixels, and the three
numbers that tell their extent are written anew after each block (TIFF Revision 6.0, section 8, as BigTIFF),
so that a program that is killed leaves a picture of all lines until then.
"""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

_HEAD = struct.Struct("<2sHHHQ")
_ENTRY = struct.Struct("<HHQQ")
_ASCII, _SHORT, _LONG, _LONG8 = 2, 3, 4, 16
_LENGTH, _STRIP_ROWS, _STRIP_BYTES = 257, 278, 279


class Spool:
    """One camera's lines of 8 bit, written to `path` as they come, time down the picture.

    Raises FileExistsError where the file is there: nothing recorded is written over.
    """

    def __init__(self, path: Path, rows: int, line_rate_hz: float) -> None:
        self.path, self.rows, self.lines = path, rows, 0
        said = json.dumps({"line_rate_hz": line_rate_hz}).encode() + b"\0"
        self._entries = {
            256: (_LONG, 1, rows),
            _LENGTH: (_LONG, 1, 0),
            258: (_SHORT, 1, 8),
            259: (_SHORT, 1, 1),  # not packed
            262: (_SHORT, 1, 1),  # 0 is black
            270: (_ASCII, len(said), 0),
            273: (_LONG8, 1, 0),
            277: (_SHORT, 1, 1),
            _STRIP_ROWS: (_LONG, 1, 0),
            _STRIP_BYTES: (_LONG8, 1, 0),
        }
        words_at = _HEAD.size + 8 + _ENTRY.size * len(self._entries) + 8
        self._entries[270] = (_ASCII, len(said), words_at)
        self._pixels_at = -(-(words_at + len(said)) // 16) * 16
        self._entries[273] = (_LONG8, 1, self._pixels_at)
        self._file = path.open("xb", buffering=0)
        self._file.write(self._directory() + said)
        self._file.seek(self._pixels_at)

    def write(self, lines: NDArray[Any]) -> None:
        """Append lines (n, rows) of 8 bit. Raises OSError where there is no room."""
        data = memoryview(np.ascontiguousarray(lines, np.uint8).tobytes())
        self._file.seek(self._pixels_at + self.lines * self.rows)
        while data:
            data = data[self._file.write(data) :]
        self.lines += len(lines)
        for tag, kind, value in (
            (_LENGTH, _LONG, self.lines),
            (_STRIP_ROWS, _LONG, self.lines),
            (_STRIP_BYTES, _LONG8, self.lines * self.rows),
        ):
            self._entries[tag] = (kind, 1, value)
        self._file.seek(0)
        self._file.write(self._directory())

    def close(self) -> None:
        self._file.close()

    def _directory(self) -> bytes:
        entries = b"".join(_ENTRY.pack(tag, *entry) for tag, entry in sorted(self._entries.items()))
        head = _HEAD.pack(b"II", 43, 8, 0, _HEAD.size) + struct.pack("<Q", len(self._entries))
        return head + entries + struct.pack("<Q", 0)
