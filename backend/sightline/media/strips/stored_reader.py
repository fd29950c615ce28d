"""Reading the stored form of a strip: any lines, and pictures of it at any zoom in time."""

import json
import os
import threading
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from cachetools import LRUCache

from sightline.errors import BadInput, Damaged, NotFound
from sightline.media.images import jpeg
from sightline.media.strips.notes import StripNotes, notes_of
from sightline.media.strips.reader import chunk_lines
from sightline.media.strips.sheet import Pixels
from sightline.media.strips.stored_writer import FORMAT, TILE_LINES, level_lines
from sightline.media.strips.tiff import PieceError, Pieces, open_tiff, pieces_of

QUALITY = 90
_MOST_OPEN = 16
_DARK, _BRIGHT = 0.001, 0.999


class StripReader:
    """One stored strip. Safe for threads: nothing is kept but where the tiles are.

    `lines`, `rows`, `dtype` describe the full level; `levels` holds the number of lines of every level, each
    a quarter of the one before; `bits`: of the camera, as whoever stored it says. Raises NotFound, and
    Damaged where the file is not a stored form.
    """

    def __init__(self, path: Path, name: str | None = None, bits: int = 8) -> None:
        self.name, self.bits = name or path.name, bits
        if not path.is_file():
            raise NotFound("strips-stored-missing", name=self.name)
        self._handle = os.open(path, os.O_RDONLY)
        weakref.finalize(self, os.close, self._handle)
        try:
            self._open(path)
        except (BadInput, ValueError, AttributeError, TypeError, IndexError) as error:
            raise self._damaged() from error

    def _open(self, path: Path) -> None:
        with open_tiff(path, self.name) as tiff:
            page = tiff.pages.first
            document = json.loads(page.description)
            if document.get("format") != FORMAT:
                raise ValueError
            self.lines, self.rows = page.imagelength, page.imagewidth
            # series.levels does not list overviews in one direction only; the page's own pages do
            pages = [page, *(page.pages or [])]
            self._pieces: list[Pieces] = [pieces_of(one.aspage(), self._handle, "<") for one in pages]
            self.levels = [one.aspage().imagelength for one in pages]
        self.dtype: np.dtype[Any] = self._pieces[0].native
        if self.levels != level_lines(self.lines):
            raise ValueError
        document["dropped_lines"] = document["filled_lines"]
        self.notes: StripNotes = notes_of(document, self.name)
        self._range: tuple[float, float] | None = None

    def read(self, start: int, stop: int, level: int = 0) -> Pixels:
        """Lines start..stop (exclusive) as (n, rows), cut to what there is; a copy of its own.

        Raises NotFound for a level that is not there, Damaged.
        """
        if not 0 <= level < len(self.levels):
            raise NotFound("strips-no-level", name=self.name, level=level, last=len(self.levels) - 1)
        start, stop = max(0, start), min(self.levels[level], stop)
        out = np.empty((max(0, stop - start), self.rows), self.dtype)
        for index in range(start // TILE_LINES, -(-stop // TILE_LINES) if stop > start else 0):
            first = index * TILE_LINES
            top, bottom = max(start, first), min(stop, first + TILE_LINES)
            tile = self._tile(level, index, bottom - first)
            out[top - start : bottom - start] = tile[top - first :, : self.rows]
        return out

    def chunks(self, lines: int | None = None) -> Iterator[Pixels]:
        """All lines in order, (n, rows) each with n = `lines` (default 1024 or 4 MB) but for the last."""
        lines = lines or chunk_lines(self.rows, self.dtype.itemsize)
        return (self.read(first, first + lines) for first in range(0, self.lines, lines))

    def tile(self, level: int, index: int, gain: float = 1.0) -> bytes:
        """Lines 1024 index .. 1024 (index + 1) of a level as JPEG, time along the width, all rows.

        `gain` makes it brighter, for looking only; 16 bits are shown between the strip's darkest and
        brightest thousandth. Raises NotFound where there is no such tile, BadInput for a gain
        out of 0.1 to 50.
        """
        if not 0.1 <= gain <= 50:
            raise BadInput("strips-gain-range", gain=gain)
        count = -(-self.levels[level] // TILE_LINES) if 0 <= level < len(self.levels) else 0
        if not 0 <= index < count:
            raise NotFound("strips-no-tile", name=self.name, index=index, level=level)
        first = index * TILE_LINES
        rows = min(TILE_LINES, self.levels[level] - first)
        return jpeg(self.shown(self._tile(level, index, rows)[:, : self.rows], gain), QUALITY)

    def shown(self, lines: Pixels, gain: float = 1.0) -> Pixels:
        """Lines (n, rows) as a picture of 8 bits to look at, (rows, n)."""
        low, high = self.shown_range
        scale = 255.0 * gain / (high - low)
        if self.dtype != np.uint8 or scale != 1.0 or low != 0.0:
            lines = cv2.convertScaleAbs(np.maximum(lines, int(low)), alpha=scale, beta=-int(low) * scale)
        return np.asarray(cv2.transpose(np.ascontiguousarray(lines)), np.uint8)

    @property
    def shown_range(self) -> tuple[float, float]:
        """The pixel values that are shown black and white at gain 1."""
        if self.dtype == np.uint8:
            return 0.0, 255.0
        if self._range is None:
            coarse = self.read(0, self.levels[-1], len(self.levels) - 1)
            low, high = (float(v) for v in np.quantile(coarse[:, ::4], (_DARK, _BRIGHT)))
            self._range = (np.floor(low), max(high, np.floor(low) + 16.0))
        return self._range

    def close(self) -> None:
        """Nothing to do: the file is closed when nobody holds the reader any more."""

    def _tile(self, level: int, index: int, rows: int) -> Pixels:
        try:
            return self._pieces[level].read(index, rows)
        except (PieceError, OSError) as error:
            raise self._damaged() from error

    def _damaged(self) -> Damaged:
        return Damaged("strips-stored-damaged", name=self.name)


class ReaderCache:
    """Open readers, the most recently used 16. Stored forms never change, so they stay right. Scans
    that share a strip but not the camera's depth, which a pair tells, have a reader each.

    One that is pushed out is not closed here: another thread may be reading it. It closes its file when
    nobody holds it any more. Thread-safe.
    """

    def __init__(self) -> None:
        self._readers: LRUCache[tuple[Path, int], StripReader] = LRUCache(_MOST_OPEN)
        self._lock = threading.Lock()

    def reader(self, path: Path, name: str | None = None, bits: int = 8) -> StripReader:
        """The reader of a stored strip. Raises like StripReader."""
        with self._lock:
            kept = self._readers.get((path, bits))
        if kept is not None:
            return kept
        fresh = StripReader(path, name, bits)
        with self._lock:
            return self._readers.setdefault((path, bits), fresh)
