"""The stored form of a strip: one BigTIFF, line-major, made for reading in order and for looking at.

Tiles of 1024 lines by the full height (padded to a multiple of 16, as TIFF wants), zstd level 1 with
horizontal predictor; overviews as SubIFDs of the one page, each with a quarter of the lines of the one
before (means of four) and all rows, down to one tile. Over Zarr, HDF5 and lossless video: DECISIONS.md.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any, BinaryIO

import imagecodecs
import numpy as np
import tifffile

from sightline.linescan.depth import brightest_of, depth_of
from sightline.media.atomic import atomic_file
from sightline.media.cancelling import Cancelled, check_cancelled
from sightline.media.store.local import check_room, no_room_told, sha256_of
from sightline.media.strips.notes import StripNotes
from sightline.media.strips.reader import Strip
from sightline.media.strips.sheet import Pixels

TILE_LINES = 1024
STEP = 4  # lines of a level that make one of the next
SUFFIX = ".strip.tif"
FORMAT = "sightline-strip-1"
_LOOKED_AT = 16  # every so many lines count for the share of saturated pixels
Progress = Callable[[float], None]


@dataclass(frozen=True)
class StoredStrip:
    """A stored form, whole on disk: what is in it, and its SHA-256 (hex).

    `bits`: of the camera, as its brightest pixel tells; `saturated`: share of pixels at the largest value
    of so many bits, from every 16th line; `notes`: what the recorder said, the lost lines of which are
    filled in and counted in `lines`.
    """

    path: Path
    sha256: str
    lines: int
    rows: int
    bits: int
    levels: int
    saturated: float
    notes: StripNotes


def store_strip(
    strip: Strip,
    target: Path,
    on_progress: Progress = lambda _: None,
    is_cancelled: Cancelled = lambda: False,
) -> StoredStrip:
    """Write the stored form of a strip, read once from its start; `target` appears whole or not at all.

    Memory does not grow with the length. `on_progress` gets a fraction 0..1, `is_cancelled` is asked every
    1024 lines. Raises BadInput (damaged or cut off on the way), NoRoom, Stopped.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    check_room(target.parent, strip.lines * strip.rows * strip.dtype.itemsize)
    with (
        no_room_told(),
        TemporaryFile(dir=target.parent) as spool,
        atomic_file(target) as part,
    ):
        pyramid = _Pyramid(strip.lines, strip.rows, strip.dtype, spool)
        _write(part, strip, pyramid, on_progress, is_cancelled)
        sha256 = sha256_of(part)
    on_progress(1.0)
    return StoredStrip(
        path=target,
        sha256=sha256,
        lines=strip.lines,
        rows=strip.rows,
        bits=depth_of(pyramid.brightest),
        levels=len(pyramid.lines),
        saturated=pyramid.saturated / max(1, pyramid.looked_at),
        notes=strip.notes,
    )


def level_lines(lines: int) -> list[int]:
    """How many lines each level has, the full one first, the last fitting into one tile."""
    out = [lines]
    while out[-1] > TILE_LINES:
        out.append(-(-out[-1] // STEP))
    return out


@dataclass
class _Pyramid:
    """Packs tiles, and gathers the overviews' tiles in `spool` while the full level goes by."""

    full_lines: int
    rows: int
    dtype: np.dtype[Any]
    spool: BinaryIO
    lines: list[int] = field(init=False)
    places: list[list[tuple[int, int]]] = field(init=False)
    saturated: int = 0
    brightest: int = 0
    looked_at: int = 0

    def __post_init__(self) -> None:
        self.lines = level_lines(self.full_lines)
        self.places = [[] for _ in self.lines]
        self._waiting: list[list[Pixels]] = [[] for _ in self.lines]
        self._end = 0

    @property
    def tile_shape(self) -> tuple[int, int]:
        return TILE_LINES, -(-self.rows // 16) * 16

    def packed(self, tile: Pixels, level: int = 0) -> bytes:
        """One tile of `level` as it goes into the file; its overview is kept for later."""
        if level + 1 < len(self.lines):
            self._offer(level + 1, average_four_lines(tile))
        if level == 0:
            bits, self.brightest = depth_of(self.brightest), max(self.brightest, brightest_of(tile))
            if depth_of(self.brightest) > bits:
                self.saturated = 0  # what was the largest value until here was none
            some = tile[::_LOOKED_AT]
            self.saturated += int(np.count_nonzero(some == (1 << depth_of(self.brightest)) - 1))
            self.looked_at += some.size
        if tile.shape != self.tile_shape:
            room = np.zeros(self.tile_shape, self.dtype)
            room[: tile.shape[0], : tile.shape[1]] = tile
            tile = room
        differences = imagecodecs.delta_encode(np.ascontiguousarray(tile), axis=-1)
        return bytes(imagecodecs.zstd_encode(differences, level=1))  # type: ignore[arg-type]

    def finish(self) -> None:
        """Pack what is left of every overview, the finest first."""
        for level in range(1, len(self.lines)):
            self._flush(level)

    def kept(self, level: int) -> Iterator[bytes]:
        """The packed tiles of an overview."""
        for offset, count in self.places[level]:
            self.spool.seek(offset)
            yield self.spool.read(count)

    def _offer(self, level: int, block: Pixels) -> None:
        self._waiting[level].append(block)
        if sum(len(one) for one in self._waiting[level]) >= TILE_LINES:
            self._flush(level)

    def _flush(self, level: int) -> None:
        blocks, self._waiting[level] = self._waiting[level], []
        if not blocks:
            return
        data = self.packed(np.concatenate(blocks), level)
        self.spool.seek(self._end)
        self.spool.write(data)
        self.places[level].append((self._end, len(data)))
        self._end += len(data)


def average_four_lines(block: Pixels) -> Pixels:
    """Means of four lines each; what is left at the end makes one line of its own."""
    whole = len(block) // STEP * STEP
    parts = []
    if whole:
        groups = block[:whole].reshape(whole // STEP, STEP, -1)
        sums = np.add.reduce(groups, axis=1, dtype=np.uint16 if block.dtype == np.uint8 else np.uint32)
        parts.append(np.right_shift(sums + STEP // 2, 2).astype(block.dtype))
    if whole < len(block):
        parts.append(np.round(block[whole:].mean(axis=0, keepdims=True)).astype(block.dtype))
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _write(
    part: Path, strip: Strip, pyramid: _Pyramid, on_progress: Progress, is_cancelled: Cancelled
) -> None:
    def full() -> Iterator[bytes]:
        done = 0
        for chunk in strip.chunks(TILE_LINES):
            check_cancelled(is_cancelled, strip.name)
            yield pyramid.packed(chunk)
            done += len(chunk)
            on_progress(0.95 * done / strip.lines)

    how: dict[str, Any] = {
        "dtype": strip.dtype,
        "tile": pyramid.tile_shape,
        "compression": "zstd",
        "predictor": True,
        "photometric": "minisblack",
        "software": False,
        "metadata": None,
    }
    with tifffile.TiffWriter(part, bigtiff=True, byteorder="<") as tiff:
        shape = (strip.lines, strip.rows)
        said = json.dumps(description_of(strip.notes))
        tiff.write(full(), shape=shape, subifds=len(pyramid.lines) - 1, description=said, **how)
        pyramid.finish()
        for level, lines in enumerate(pyramid.lines[1:], 1):
            tiff.write(pyramid.kept(level), shape=(lines, strip.rows), subfiletype=1, **how)


def description_of(notes: StripNotes) -> dict[str, Any]:
    """What stands in the stored form beside the pixels. The lost lines are in it already, so they go by
    another name than the one that would have them put in again.
    """
    filled = [[gap.line, gap.count] for gap in notes.dropped]
    return {"format": FORMAT, "line_rate_hz": notes.line_rate_hz, "filled_lines": filled}
