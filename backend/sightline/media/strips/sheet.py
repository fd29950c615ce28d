"""A grey picture of any size, read in pieces: what every reader of line-scan files offers, and its limits."""

import os
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.media.store.local import check_room, no_room_told

Pixels = NDArray[Any]  # uint8 or uint16
Rows = NDArray[np.int64]

PIECE_BYTES = 32 << 20  # the most that one piece of a file (tile, strip, row) may need in memory
BAND_BYTES = 4 << 20
# Deflate cannot pack better than 1:1032; a file that claims more than this holds nothing worth measuring.
LARGEST_RATIO = 1000
ANY_FILE_BYTES = 64 << 20


class Sheet(Protocol):
    """A picture (height, width) that need not fit into memory.

    Both ways of reading raise BadInput, naming the file, where it is damaged or cut off. Native byte order.
    """

    @property
    def name(self) -> str: ...
    @property
    def width_px(self) -> int: ...
    @property
    def height_px(self) -> int: ...
    @property
    def dtype(self) -> np.dtype[Any]: ...

    def bands(self) -> Iterator[Pixels]:
        """(n, width) from the top to the bottom, each within PIECE_BYTES."""

    def slabs(self, columns: int) -> Iterator[Pixels] | None:
        """(height, n) from left to right, about `columns` each; None where it would have to be read whole."""

    def close(self) -> None: ...


def check_claim(name: str, width: int, height: int, item_bytes: int, file_bytes: int) -> None:
    """Refuse a header that claims nothing, or more than a file of its size can hold."""
    if width < 1 or height < 1:
        raise BadInput("strips-size-impossible", name=name, width=width, height=height)
    if width * height * item_bytes > ANY_FILE_BYTES + LARGEST_RATIO * file_bytes:
        raise BadInput(
            "strips-size-over-file",
            name=name,
            width=width,
            height=height,
            file_bytes=format(file_bytes / 1000000.0, ".3g"),
        )


def cut_off(name: str, row: int, height: int) -> BadInput:
    """The refusal of a file that ends too early."""
    return BadInput("strips-cut-off", name=name, row=row, height=height)


def damaged_row_error(name: str, row: int, height: int) -> BadInput:
    """The refusal of a file whose bytes are not what they were."""
    return BadInput("strips-row-damaged", name=name, row=row, height=height)


class RawSheet:
    """Rows of plain pixels in an open file; `offset_of(rows)` is where they begin. Owns the handle."""

    def __init__(
        self, handle: int, name: str, shape: tuple[int, int], dtype: Any, offset_of: Callable[[Rows], Rows]
    ) -> None:
        self.name = name
        self.height_px, self.width_px = shape
        self._stored = np.dtype(dtype)
        self.dtype = self._stored.newbyteorder("=")
        self._offset_of = offset_of
        self._handle: int | None = handle
        row_bytes = self.width_px * self._stored.itemsize
        if row_bytes > PIECE_BYTES:
            self.close()
            raise BadInput("strips-rows-too-long", name=name, width_px=self.width_px)
        self._row_bytes = row_bytes

    def bands(self) -> Iterator[Pixels]:
        most = max(1, BAND_BYTES // self._row_bytes)
        for first in range(0, self.height_px, most):
            yield self._block(first, min(self.height_px, first + most), 0, self.width_px)

    def slabs(self, columns: int) -> Iterator[Pixels] | None:
        return (
            self._block(0, self.height_px, first, min(self.width_px, first + columns))
            for first in range(0, self.width_px, columns)
        )

    def close(self) -> None:
        handle, self._handle = self._handle, None
        if handle is not None:
            os.close(handle)

    def _block(self, top: int, bottom: int, left: int, right: int) -> Pixels:
        size = self._stored.itemsize
        out = np.empty((bottom - top, right - left), self._stored)
        places = self._offset_of(np.arange(top, bottom)) + left * size
        assert self._handle is not None
        if right - left == self.width_px and bool((np.diff(places) == self._row_bytes).all()):
            self._fill(out, int(places[0]), top)
        else:
            for row, place in enumerate(places.tolist()):
                self._fill(out[row : row + 1], place, top + row)
        return out.astype(self.dtype, copy=False)

    def _fill(self, out: NDArray[Any], place: int, row: int) -> None:
        """Fill contiguous rows from the file; a system call may give less than it was asked for."""
        assert self._handle is not None
        room = out.data.cast("B")
        done = 0
        while done < len(room):
            got = os.preadv(self._handle, [room[done:]], place + done)
            if got <= 0:
                raise cut_off(self.name, row + done // self._row_bytes, self.height_px)
            done += got


def unpack_sheet(sheet: Sheet, folder: Path | None) -> RawSheet:
    """The same picture as plain rows in a nameless temporary file, so that its columns can be read too.

    The file is as large as the picture and gone when it is closed, or when the process ends. Raises NoRoom.
    """
    place = folder or Path(tempfile.gettempdir())
    row_bytes = sheet.width_px * sheet.dtype.itemsize
    check_room(place, row_bytes * sheet.height_px)
    with tempfile.TemporaryFile(dir=place) as file, no_room_told():
        for band in sheet.bands():
            file.write(np.ascontiguousarray(band).data)
        file.flush()
        handle = os.dup(file.fileno())
    shape = (sheet.height_px, sheet.width_px)
    return RawSheet(handle, sheet.name, shape, sheet.dtype, lambda rows: rows * row_bytes)
