"""Pairs of lines from an open file (standard input): taken off as they come, whatever is being measured."""

import fcntl
import os
import select
import stat
import threading
from collections import deque
from collections.abc import Iterator
from contextlib import suppress

from sightline.media.lines.source import Ending, Piece, cut_short, pairs_of

WAITING_BYTES = 64 << 20  # six seconds of 2 x 5,000 lines of 1,024 pixels
_READ_BYTES = 1 << 20
_PIECE_BYTES = 4 << 20
_QUIET_S = 0.5


class PipedLines:
    """Lines from descriptor `source`. A thread of its own empties the pipe, so that a sender that cannot wait
    loses none while a vehicle is measured; beyond WAITING_BYTES the sender waits. What lies in the pipe when
    the end is wished is taken still. The lines of a file in its place have all come already, the last of them
    when it was last written.
    """

    broken = False

    def __init__(self, source: int, rows: int, ending: Ending) -> None:
        self.name, self.notes = "The input", list[str]()
        self._source, self._rows, self._ending = source, rows, ending
        self._held: deque[bytes] = deque()
        self._bytes = 0
        self._last = self._over = False
        self.last_at: float | None = None
        self._unread_bytes = 0  # of a file
        told = os.fstat(source)
        if stat.S_ISREG(told.st_mode):
            self.last_at = told.st_mtime
            self._unread_bytes = told.st_size - os.lseek(source, 0, os.SEEK_CUR)
        self._changed = threading.Condition()
        with suppress(OSError):  # no pipe, or a limit of this machine
            fcntl.fcntl(source, fcntl.F_SETPIPE_SZ, _READ_BYTES)

    @property
    def waiting_bytes(self) -> int:
        with self._changed:
            return self._bytes + self._unread_bytes

    def pieces(self) -> Iterator[Piece | None]:
        reader = threading.Thread(target=self._read_pipe, daemon=True)
        reader.start()
        pair, rest = 2 * self._rows, b""
        while (data := self._take()) is not None:
            data = rest + data
            whole = len(data) // pair * pair
            rest = data[whole:]
            yield pairs_of(data[:whole], self._rows) if whole else None
        reader.join()
        if rest:
            self.notes.append(cut_short(self.name, len(rest)))

    def _take(self) -> bytes | None:
        """What has come, a few megabytes at most; nothing where none came for a while, None at the end."""
        with self._changed:
            if not self._held and not self._over:
                self._changed.wait(_QUIET_S)
            taken: list[bytes] = []
            size = 0
            while self._held and size < _PIECE_BYTES:
                taken.append(self._held.popleft())
                size += len(taken[-1])
            self._bytes -= size
            self._changed.notify_all()
            return None if self._over and not taken else b"".join(taken)

    def _read_pipe(self) -> None:
        try:
            while data := self._next():
                with self._changed:
                    self._held.append(data)
                    self._bytes += len(data)
                    self._unread_bytes = max(self._unread_bytes - len(data), 0)
                    self._changed.notify_all()
                    while self._bytes > WAITING_BYTES:
                        self._changed.wait()
        finally:
            with self._changed:
                self._over = True
                self._changed.notify_all()

    def _next(self) -> bytes:
        """What has come; once the end is wished, one pipe's worth at most, and nothing after it."""
        if self._last:
            return b""
        ready, _, _ = select.select([self._source, self._ending.fd], [], [])
        self._last = self._ending.fd in ready
        return os.read(self._source, _READ_BYTES) if self._source in ready else b""
