"""A strip that grows while it is recorded: a BigTIFF that is whole after every block of lines.

tifffile writes pictures whose height is known; here the directory stands before the pixels, and the three
numbers that tell their extent are written anew after each block (TIFF Revision 6.0, section 8, as BigTIFF),
so that a program that is killed leaves a picture of all lines until then. The description, which lists the
lines that were lost, has two places in turn: the directory points to the new one once it is written.
"""

import json
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.media.strips.notes import Dropped, notes_of, with_gaps
from sightline.media.strips.reader import rebatch_lines

_HEAD = struct.Struct("<2sHHHQ")
_ENTRY = struct.Struct("<HHQQ")
_ASCII, _SHORT, _LONG, _LONG8 = 2, 3, 4, 16
_LENGTH, _DESCRIPTION, _STRIP_ROWS, _STRIP_BYTES = 257, 270, 278, 279
_ENTRIES = 10
_WORDS_AT = _HEAD.size + 8 + _ENTRY.size * _ENTRIES + 8
_PIXELS_AT = 1 << 18
_WORDS_BYTES = (_PIXELS_AT - _WORDS_AT) // 2


class Spool:
    """One camera's lines of 8 bit, written to `path` as they come, time down the picture.

    `lines` counts those that are in the file; lost ones are listed, not filled in. Raises FileExistsError
    where the file is there: nothing recorded is written over.
    """

    def __init__(self, path: Path, rows: int, line_rate_hz: float) -> None:
        self.path, self.rows, self.lines = path, rows, 0
        self._rate, self._dropped = line_rate_hz, list[list[int]]()
        self._slot = 0
        self._words = _encode_description(self._rate, self._dropped)
        self._file = path.open("xb", buffering=0)
        try:
            self._file.write(_directory(rows, 0, self._place()))
            self._put_words()
            self._file.truncate(_PIXELS_AT)
        except OSError:
            self.discard()
            raise

    @property
    def full(self) -> bool:
        """Whether the list of lost lines has no more room: time for another file."""
        return len(self._words) > _WORDS_BYTES - 4096

    @property
    def dropped(self) -> tuple[Dropped, ...]:
        """The lost lines, as `StripNotes` has them."""
        return tuple(Dropped(line, count) for line, count in self._dropped)

    def write(self, lines: NDArray[Any], lost: Sequence[Dropped] = ()) -> None:
        """Append lines (n, rows) of 8 bit. `lost`: how many before line 0..n. Raises OSError: no room."""
        data = memoryview(np.ascontiguousarray(lines, np.uint8).tobytes())
        self._file.seek(_PIXELS_AT + self.lines * self.rows)
        while data:
            data = data[self._file.write(data) :]
        for gap in lost:
            self._note(self.lines + gap.line, gap.count)
        if lost:
            self._slot = 1 - self._slot
            self._words = _encode_description(self._rate, self._dropped)
            self._put_words()
        self.lines += len(lines)
        self._file.seek(0)
        self._file.write(_directory(self.rows, self.lines, self._place()))

    def close(self) -> None:
        self._file.close()

    def discard(self) -> None:
        """Close the file and delete it."""
        self.close()
        self.path.unlink()

    def _note(self, line: int, count: int) -> None:
        if self._dropped and self._dropped[-1][0] == line:
            self._dropped[-1][1] += count
        else:
            self._dropped.append([line, count])

    def _put_words(self) -> None:
        self._file.seek(self._place()[1])
        self._file.write(self._words)

    def _place(self) -> tuple[int, int]:
        return len(self._words), _WORDS_AT + self._slot * _WORDS_BYTES


class SpooledLines:
    """The lines that a spool holds, also one whose program was killed; read in place.

    `lines` counts those in the file, `dropped` those that were lost. Raises BadInput where it is no spool.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            with path.open("rb") as file:
                head = file.read(_WORDS_AT)
                entries = dict(_read_entries(head))
                self.rows, self.lines = entries[256], entries[_LENGTH]
                _, _, count, self._words_at = _ENTRY.unpack_from(head, _HEAD.size + 8 + _ENTRY.size * 5)
                file.seek(self._words_at)
                notes = notes_of(json.loads(file.read(count).rstrip(b"\0")), str(path))
        except (OSError, ValueError, KeyError, struct.error):
            raise BadInput("strips-spool-damaged", path=path) from None
        self.dropped, self._rate = notes.dropped, notes.line_rate_hz

    @property
    def total_lines(self) -> int:
        """Lines in the file and lost ones before them."""
        return self.lines + sum(gap.count for gap in self.dropped if gap.line < self.lines)

    def shorten(self, total: int) -> None:
        """Leave only the first `total` lines (lost ones counted): what one camera has beyond the other."""
        lines, _ = _within_file(total, self.dropped)
        self.dropped = tuple(gap for gap in self.dropped if gap.line < lines)
        words = _encode_description(self._rate, [[gap.line, gap.count] for gap in self.dropped])
        slot = int(self._words_at == _WORDS_AT)
        place = (len(words), _WORDS_AT + slot * _WORDS_BYTES)
        with self.path.open("r+b") as file:
            file.seek(place[1])
            file.write(words)
            file.seek(0)
            file.write(_directory(self.rows, lines, place))
        self.lines, self._words_at = lines, place[1]

    def chunks(self, start: int) -> Iterator[NDArray[np.uint8]]:
        """Lines from number `start` on (numbers that count the lost ones), lost ones put in as copies, in
        blocks that are the same of both cameras.
        """
        begin, dropped = _within_file(start, self.dropped)
        if begin >= self.lines:
            return
        pixels = np.memmap(self.path, np.uint8, "r", _PIXELS_AT, (self.lines, self.rows))
        pieces = (pixels[at : at + _CHUNK_LINES] for at in range(begin, self.lines, _CHUNK_LINES))
        for piece in rebatch_lines(with_gaps(pieces, dropped, _CHUNK_LINES), _CHUNK_LINES):
            yield np.array(piece, np.uint8)


_CHUNK_LINES = 1024


def _within_file(start: int, dropped: Sequence[Dropped]) -> tuple[int, list[Dropped]]:
    """Where in the file the line `start` is, and the gaps from there on."""
    lost = 0
    for number, gap in enumerate(dropped):
        begin = gap.line + lost
        if start < begin + gap.count:
            inside = max(0, start - begin)
            at = min(start - lost, gap.line)
            first = Dropped(gap.line - at, gap.count - inside)
            return at, [first, *(Dropped(one.line - at, one.count) for one in dropped[number + 1 :])]
        lost += gap.count
    return start - lost, []


def _encode_description(line_rate_hz: float | None, dropped: list[list[int]]) -> bytes:
    said = {"line_rate_hz": line_rate_hz, "dropped_lines": dropped}
    return json.dumps(said, separators=(",", ":")).encode() + b"\0"


def _directory(rows: int, lines: int, words: Sequence[int]) -> bytes:
    entries = {
        256: (_LONG, 1, rows),
        _LENGTH: (_LONG, 1, lines),
        258: (_SHORT, 1, 8),
        259: (_SHORT, 1, 1),  # not packed
        262: (_SHORT, 1, 1),  # 0 is black
        _DESCRIPTION: (_ASCII, *words),
        273: (_LONG8, 1, _PIXELS_AT),
        277: (_SHORT, 1, 1),
        _STRIP_ROWS: (_LONG, 1, lines),
        _STRIP_BYTES: (_LONG8, 1, lines * rows),
    }
    packed = b"".join(_ENTRY.pack(tag, *entry) for tag, entry in sorted(entries.items()))
    head = _HEAD.pack(b"II", 43, 8, 0, _HEAD.size) + struct.pack("<Q", len(entries))
    return head + packed + struct.pack("<Q", 0)


def _read_entries(head: bytes) -> Iterator[tuple[int, int]]:
    if head[:4] != b"II+\0":
        raise ValueError
    for number in range(_ENTRIES):
        tag, _, _, value = _ENTRY.unpack_from(head, _HEAD.size + 8 + _ENTRY.size * number)
        yield tag, value
