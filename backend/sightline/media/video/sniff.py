"""What a file is by its first bytes, so that a refusal can say so in words.

FFmpeg answers "Invalid data found" to an empty file, a letter and a film cut before its index alike;
people need to be told which of these it is.
"""

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import BinaryIO

HEAD_BYTES = 4096
_MOST_EDITS = 10_000
_MOST_BOXES = 200_000
_STILLS = (
    (b"\x89PNG\r\n\x1a\n", "png"),
    (b"\xff\xd8\xff", "jpeg"),
    (b"GIF8", "gif"),
    (b"BM", "bmp"),
    (b"II*\x00", "tiff"),
    (b"MM\x00*", "tiff"),
    (b"II+\x00", "tiff"),
)
_FIRST_BOXES = (b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip")
STILL_BRANDS = (b"heic", b"heix", b"mif1", b"avif", b"avis", b"msf1")
_PLAYLISTS = (
    b"#EXTM3U",
    b"ffconcat",
    b"<?xml",
    b"<MPD",
    b"[playlist]",
    b"<smil",
    b"<asx",
    b"v=0\r\n",
    b"v=0\n",
)
_OTHERS = (
    (b"PK\x03\x04", "zip"),
    (b"%PDF", "pdf"),
    (b"\x1f\x8b", "gzip"),
    (b"Rar!", "rar"),
    (b"7z\xbc\xaf", "seven_zip"),
    (b"fLaC", "audio"),
    (b"ID3", "audio"),
    (b"OggS", "ogg"),
)


def why_not_video(path: Path) -> str | None:
    """Half a sentence that says why the file is no video ("empty"), or None if its first bytes do not
    tell.

    Raises OSError if the file cannot be read.
    """
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    if not head:
        return "empty"
    return _playlist(head) or _still(head) or _other_kind(head) or _cut_before_index(path, head)


def _playlist(head: bytes) -> str | None:
    start = head.lstrip(b"\xef\xbb\xbf \t\r\n")
    if any(start[:16].lower().startswith(mark.lower()) for mark in _PLAYLISTS):
        return "playlist"
    return None


def _still(head: bytes) -> str | None:
    for mark, what in _STILLS:
        if head.startswith(mark):
            return what
    if head[:4] == b"RIFF" and head[8:12] == b"WEBP":
        return "webp"
    if head[4:8] == b"ftyp" and head[8:12] in STILL_BRANDS:
        return "heif"
    return None


def _other_kind(head: bytes) -> str | None:
    for mark, what in _OTHERS:
        if head.startswith(mark):
            return what
    if head[:4] == b"RIFF" and head[8:12] == b"WAVE":
        return "audio"
    if _is_text(head):
        return "text"
    return None


def _is_text(head: bytes) -> bool:
    if b"\x00" in head:
        return False
    try:
        text = head.decode("utf-8", errors="strict" if len(head) < HEAD_BYTES else "ignore")
    except UnicodeDecodeError:
        return False
    odd = sum(not (c.isprintable() or c in "\r\n\t\f") for c in text)
    return odd <= len(text) // 100


def _cut_before_index(path: Path, head: bytes) -> str | None:
    """An MP4 or MOV without its `moov` box: the recorder was switched off or the copy was broken off."""
    if head[4:8] not in _FIRST_BOXES:
        return None
    end = path.stat().st_size
    for box in boxes(path):
        if box.kind in (b"moov", b"moof"):
            return "cut_in_index" if box.end > end else None
    return "cut_before_index"


@dataclass(frozen=True)
class Box:
    """A part of an MP4 or QuickTime file, in bytes from its start; it holds `inside` to `end`, it states."""

    kind: bytes
    start: int
    inside: int
    end: int


def boxes(path: Path) -> Iterator[Box]:
    """The top-level parts of an MP4 or QuickTime file up to one of impossible size; none of other files."""
    with path.open("rb") as file:
        if file.read(8)[4:] in _FIRST_BOXES:
            yield from _boxes(file, 0, path.stat().st_size)


def _boxes(file: BinaryIO, start: int, end: int) -> Iterator[Box]:
    """Those between two places; one without a size reaches to the second."""
    for _ in range(_MOST_BOXES):
        file.seek(start)
        head = file.read(16) if start < end else b""
        size, inside = int.from_bytes(head[:4], "big"), start + 8
        if size == 1:
            size, inside = int.from_bytes(head[8:], "big"), start + 16
        elif size == 0:
            size = end - start
        if len(head) < 8 or size < inside - start:
            return
        yield Box(head[4:8], start, inside, start + size)
        start += size


def states_no_rate(path: Path) -> bool:
    """Whether an AVI file's video stream states a rate of 0, for which readers take one of their own."""
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    stream = head.find(b"strh")
    if head[:4] != b"RIFF" or stream < 0 or head[stream + 8 : stream + 12] != b"vids":
        return False
    scale, rate = head[stream + 28 : stream + 32], head[stream + 32 : stream + 36]
    return not any(scale) or not any(rate)


@dataclass(frozen=True)
class Extent:
    """Whether a file is as long as it states: `missing` bytes, where it was cut short, and whether it holds
    `another` recording behind its own, which nobody reads.
    """

    missing: int = 0
    another: bool = False


def extent_of(path: Path) -> Extent:
    """The extent of an MP4, QuickTime, AVI or Matroska file, as its own parts state it."""
    length = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(64)
    if head[:4] == b"RIFF":
        return Extent(missing=max(0, 8 + int.from_bytes(head[4:8], "little") - length))
    if head[:4] == b"\x1aE\xdf\xa3":
        return Extent(missing=max(0, _matroska_end(head) - length))
    found = list(boxes(path))
    return Extent(
        missing=max(0, found[-1].end - length) if found else 0,
        another=sum(one.kind == b"moov" for one in found) > 1,
    )


def _matroska_end(head: bytes) -> int:
    """Where a Matroska file's one segment ends, or 0 where it does not say (a live recording)."""
    size, at = _vint(head, 4)
    at += size
    if head[at : at + 4] != b"\x18S\x80g":
        return 0
    size, begin = _vint(head, at + 4)
    return 0 if size < 0 else begin + size


def _vint(data: bytes, at: int) -> tuple[int, int]:
    """EBML's number at a place, and where it ends; -1 for "unknown" and for what is none (RFC 8794, 4)."""
    if at >= len(data) or data[at] == 0:
        return -1, at
    width = 9 - data[at].bit_length()
    value = int.from_bytes(data[at : at + width], "big") & (1 << 7 * width) - 1
    return (-1 if value == (1 << 7 * width) - 1 else value), at + width


def played_in_parts(path: Path) -> frozenset[int]:
    """The numbers of those tracks of an MP4 or QuickTime file whose edit list plays them as several parts,
    with a hole or a jump between them: readers leave out the hole, or let the times run on over the jump.

    An empty beginning or end, and parts that follow each other as they were filmed, are none.
    """
    moov = next((one for one in boxes(path) if one.kind == b"moov"), None)
    if moov is None:
        return frozenset()
    with path.open("rb") as file:
        try:
            inside = _within(file, moov)
            ticks_hz = _after_times(file, inside, b"mvhd")
        except (LookupError, struct.error):
            return frozenset()  # a header that says less than it must
        tracks = (one for one in inside if one.kind == b"trak")
        return frozenset(number for one in tracks if (number := _number_in_parts(file, one, ticks_hz)))


def _number_in_parts(file: BinaryIO, track: Box, ticks_hz: int) -> int | None:
    """A track's number where it is played in parts; None where not, and where its own headers say less than
    they must: what another track's say stands.
    """
    try:
        inside = _within(file, track)
        return _after_times(file, inside, b"tkhd") if _in_parts(file, inside, ticks_hz) else None
    except (LookupError, struct.error, ZeroDivisionError):
        return None


def _in_parts(file: BinaryIO, track: list[Box], ticks_hz: int) -> bool:
    lists = [one for box in track if box.kind == b"edts" for one in _within(file, box) if one.kind == b"elst"]
    if not lists:
        return False
    media = [one for box in track if box.kind == b"mdia" for one in _within(file, box)]
    own_hz = _after_times(file, media, b"mdhd")
    edits = _edits(file, lists[0])
    while edits and edits[0][1] < 0:
        edits.pop(0)
    while edits and edits[-1][1] < 0:
        edits.pop()
    return any(
        begins < 0 or abs((begins - began) / own_hz - lasted / ticks_hz) > 1 / own_hz + 1 / ticks_hz
        for (lasted, began), (_, begins) in pairwise(edits)
    )


def _edits(file: BinaryIO, box: Box) -> list[tuple[int, int]]:
    """How long each edit is, in ticks of the file, and where it begins in its track's; below 0: empty."""
    head = _read_inside(file, box, 8)
    each = struct.Struct(">QqI" if head[0] == 1 else ">IiI")
    count = min(struct.unpack(">I", head[4:])[0], _MOST_EDITS, (box.end - box.inside) // each.size)
    told = _read_inside(file, box, 8 + count * each.size)[8:]
    return [(lasted, begins) for lasted, begins, _ in each.iter_unpack(told)]


def _after_times(file: BinaryIO, among: Sequence[Box], kind: bytes) -> int:
    """What stands in a header behind the times of its making: the ticks a second of a file or a picture, the
    number of a track. Raises KeyError where there is no such header.
    """
    head = _read_inside(file, {box.kind: box for box in among}[kind], 24)
    told: int = struct.unpack_from(">I", head, 20 if head[0] == 1 else 12)[0]
    return told


def _read_inside(file: BinaryIO, box: Box, count: int) -> bytes:
    """The first bytes inside a box."""
    file.seek(box.inside)
    return file.read(count)


def _within(file: BinaryIO, outer: Box) -> list[Box]:
    return list(_boxes(file, outer.inside, outer.end))
