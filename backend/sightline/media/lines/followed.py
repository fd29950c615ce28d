"""Pairs of lines from a file that another program is writing."""

import os
import time
from collections.abc import Iterator
from pathlib import Path

from sightline.errors import BadInput
from sightline.media.lines.source import Ending, Piece, cut_short, describe_replaced, pairs_of

_POLL_S = 0.05
_QUIET_S = 0.5
_PIECE_BYTES = 4 << 20


class FollowedLines:
    """Lines of `path` from pair `begin` on, as the file grows; ends when wished, when nothing was added for
    `idle_s` seconds (None: never), or when the file is replaced, cut or written over.

    Raises BadInput where there is no such file.
    """

    def __init__(
        self, path: Path, rows: int, ending: Ending, *, begin: int = 0, idle_s: float | None = None
    ) -> None:
        self.name, self.notes, self.broken = str(path), list[str](), False
        self._path, self._rows, self._ending = path, rows, ending
        self._at, self._idle_s = 2 * rows * begin, idle_s
        self._known = dict[
            int, bytes
        ]()  # pairs of lines by their place: others there are another recording's
        try:
            self._file = path.open("rb")
        except OSError as error:
            raise BadInput("commands-stream-follow-missing", path=path, strerror=error.strerror) from None

    @property
    def waiting_bytes(self) -> int:
        return max(0, self._size() - self._at)

    @property
    def last_at(self) -> float:
        """When the file was last written: one that grows just now, one at rest long ago."""
        return os.fstat(self._file.fileno()).st_mtime

    def pieces(self) -> Iterator[Piece | None]:
        with self._file:
            pair, grown = 2 * self._rows, time.monotonic()
            quiet = grown
            while not self._ending.wished(0.0):
                there = self._size()
                if there < self._at:
                    self._break(
                        f"{self.name} became shorter than what was read of it; start again for the new file."
                    )
                    return
                whole = min(_PIECE_BYTES, there - self._at) // pair * pair
                data = self._read_bytes(self._at, whole)
                if self._written_over():
                    self._break(
                        f"{self.name} was written over with other lines while it was read; none of them is "
                        "measured. Start again for the new ones."
                    )
                    return
                if whole:
                    self._at += whole
                    self._known = {0: self._read_bytes(0, pair), self._at - pair: data[-pair:]}
                    grown = quiet = time.monotonic()
                    yield pairs_of(data, self._rows)
                    continue
                if self._replaced():
                    self._break(describe_replaced(self.name))
                    break
                if self._idle_s is not None and time.monotonic() - grown > self._idle_s:
                    break
                if time.monotonic() - quiet > _QUIET_S:
                    quiet = time.monotonic()
                    yield None
                self._ending.wished(_POLL_S)
            if rest := (self._size() - self._at) % pair:
                self.notes.append(cut_short(self.name, rest))

    def _size(self) -> int:
        return 0 if self._file.closed else self._file.seek(0, 2)

    def _read_bytes(self, at: int, count: int) -> bytes:
        """As the file is now, past what Python holds of it."""
        return os.pread(self._file.fileno(), count, at)

    def _written_over(self) -> bool:
        return any(self._read_bytes(at, len(pair)) != pair for at, pair in self._known.items())

    def _replaced(self) -> bool:
        try:
            return not os.path.samestat(os.fstat(self._file.fileno()), self._path.stat())
        except OSError:
            return True

    def _break(self, sentence: str) -> None:
        self.notes.append(sentence)
        self.broken = True
