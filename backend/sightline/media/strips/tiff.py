"""TIFF and BigTIFF of any length in bounded memory: strips or tiles, zstd, deflate, LZW or none, 8 or 16 bit.

tifffile reads the tags; the pieces are read and unpacked one by one (TIFF Revision 6.0, sections 13 to 15).
"""

import logging
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import imagecodecs
import numpy as np
import tifffile
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.media.strips.sheet import (
    PIECE_BYTES,
    Pixels,
    RawSheet,
    Sheet,
    check_claim,
    cut_off,
    damaged_row_error,
)

MAGICS = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
_UNPACK: dict[int, Any] = {
    5: imagecodecs.lzw_decode,
    8: imagecodecs.deflate_decode,
    32946: imagecodecs.deflate_decode,
    34926: imagecodecs.zstd_decode,
    50000: imagecodecs.zstd_decode,
}
_MOST_IN_16_BITS = 0xFFFF
_PACKED = (imagecodecs.ZstdError, imagecodecs.DeflateError, imagecodecs.LzwError)


class PieceError(Exception):
    """A piece that cannot be read; `cut` where the file ends inside it."""

    def __init__(self, cut: bool) -> None:
        super().__init__("cut off" if cut else "damaged")
        self.cut = cut


@dataclass(frozen=True, eq=False)
class Pieces:
    """Where the strips or tiles of one picture lie in a file, and how each is unpacked.

    Every piece is `length` rows of `width` pixels as `stored`; `across` of them stand side by side. Of the
    last strip only the rows that the picture has need be there.
    """

    handle: int
    offsets: NDArray[np.int64]
    counts: NDArray[np.int64]
    length: int
    width: int
    across: int
    stored: np.dtype[Any]
    compression: int
    predictor: int

    def read(self, index: int, rows: int) -> NDArray[Any]:
        """Piece `index`, at least its first `rows` rows, (rows, width). Raises PieceError."""
        count = int(self.counts[index])
        if count > 2 * PIECE_BYTES:
            raise PieceError(cut=False)
        data = os.pread(self.handle, count, int(self.offsets[index]))
        if len(data) < count or not data:
            raise PieceError(cut=True)
        flat = self._unpacked(data)
        if len(flat) < rows * self.width:
            raise PieceError(cut=False)
        piece = flat[: rows * self.width].reshape(rows, self.width).astype(self.native, copy=False)
        if self.predictor == 2:
            piece = imagecodecs.delta_decode(piece, axis=-1, out=piece if piece.flags.writeable else None)
        return piece

    @property
    def native(self) -> np.dtype[Any]:
        return self.stored.newbyteorder("=")

    def _unpacked(self, data: bytes) -> NDArray[Any]:
        if self.compression == 1:
            return np.frombuffer(data, self.stored, len(data) // self.stored.itemsize)
        room = np.empty(self.length * self.width * self.stored.itemsize, np.uint8)
        try:
            found = _UNPACK[self.compression](data, out=room)
        except _PACKED:
            raise PieceError(cut=False) from None
        return np.frombuffer(found, self.stored, len(found) // self.stored.itemsize)


def pieces_of(page: tifffile.TiffPage, handle: int, byteorder: str) -> Pieces:
    """The pieces of a page that was checked. Raises BadInput, without the file's name, for too few."""
    width, length = page.imagewidth, page.imagelength
    tiled = page.is_tiled
    piece_width = page.tilewidth if tiled else width
    piece_length = page.tilelength if tiled else _rows_per_strip(page)
    across, down = -(-width // max(1, piece_width)), -(-length // max(1, piece_length))
    offsets, counts = np.asarray(page.dataoffsets, np.int64), np.asarray(page.databytecounts, np.int64)
    if min(piece_width, piece_length) < 1 or min(len(offsets), len(counts)) < max(1, across * down):
        raise BadInput("strips-index-size")
    stored = np.dtype(f"{byteorder}u{page.bitspersample // 8}")
    return Pieces(
        handle=handle,
        offsets=offsets,
        counts=counts,
        length=piece_length,
        width=piece_width,
        across=across,
        stored=stored,
        compression=int(page.compression),
        predictor=int(page.predictor),
    )


def _rows_per_strip(page: tifffile.TiffPage) -> int:
    """Lines in a strip: all of them where there is one strip whose lines 16 bits could not count."""
    length, told = page.imagelength, page.rowsperstrip
    overflown = length > _MOST_IN_16_BITS and told in (_MOST_IN_16_BITS, length % (_MOST_IN_16_BITS + 1))
    return int(length if overflown and len(page.dataoffsets) == 1 else min(told, length))


def open_tiff(path: Path, name: str) -> tifffile.TiffFile:
    """The tags of a TIFF. Raises BadInput for whatever tifffile makes of a damaged one."""
    logging.getLogger("tifffile").setLevel(logging.CRITICAL)
    try:
        tiff = tifffile.TiffFile(path)
        if not len(tiff.pages):
            raise ValueError
    except Exception:  # damaged tags end in errors of a dozen kinds
        raise BadInput("strips-tiff-cut-off", name=name) from None
    return tiff


def tiff_sheet(path: Path, name: str) -> tuple[Sheet, str]:
    """The one grey picture in a TIFF, and its description. Raises BadInput for any other content."""
    with open_tiff(path, name) as tiff:
        try:
            page = tiff.pages.first
            further = any(not one.aspage().is_reduced for one in tiff.pages[1:3])
            _check(name, page, further, path.stat().st_size)
            handle = os.open(path, os.O_RDONLY)
            try:
                return _sheet(page, handle, name, tiff.byteorder), str(page.description)
            except BaseException:
                os.close(handle)
                raise
        except BadInput as error:
            if error.message.startswith(name):
                raise
            raise BadInput("strips-problem-2", name=name, message=error.message) from None
        except Exception:  # as above
            raise BadInput("strips-tiff-damaged", name=name) from None


def _check(name: str, page: Any, further: bool, file_bytes: int) -> None:
    if further:
        raise BadInput("strips-several-images", name=name)
    if page.photometric == 3:
        raise BadInput("strips-palette", name=name)
    if page.samplesperpixel != 1 or page.photometric not in (0, 1):
        raise BadInput("strips-not-grey", name=name)
    if page.sampleformat not in (1, 4):
        raise BadInput("strips-number-kind", name=name)
    if page.bitspersample not in (8, 16):
        raise BadInput("strips-bits-pixel-2", name=name, bitspersample=page.bitspersample)
    if int(page.compression) not in (1, *_UNPACK):
        kind = getattr(page.compression, "name", str(page.compression))
        raise BadInput("strips-packing-unsupported", name=name, kind_name=kind)
    if page.predictor not in (1, 2) or page.fillorder != 1:
        raise BadInput("strips-packing-unusual", name=name)
    turned = page.tags.get("Orientation")
    if turned is not None and turned.value != 1:
        raise BadInput("strips-not-upright", name=name)
    check_claim(name, page.imagewidth, page.imagelength, page.bitspersample // 8, file_bytes)


def _sheet(page: Any, handle: int, name: str, byteorder: str) -> Sheet:
    pieces = pieces_of(page, handle, byteorder)
    if pieces.compression == 1 and not page.is_tiled and pieces.predictor == 1 and page.photometric == 1:
        row_bytes = pieces.width * pieces.stored.itemsize
        starts, length = pieces.offsets, pieces.length
        return RawSheet(
            handle,
            name,
            (page.imagelength, page.imagewidth),
            pieces.stored,
            lambda rows: np.asarray(starts[rows // length] + rows % length * row_bytes, np.int64),
        )
    return PackedSheet(
        name, page.imagewidth, page.imagelength, pieces, tiled=page.is_tiled, negative=page.photometric == 0
    )


class PackedSheet:
    """A TIFF's picture in strips or tiles (height, width). Owns the handle of its pieces."""

    def __init__(
        self, name: str, width: int, height: int, pieces: Pieces, *, tiled: bool, negative: bool
    ) -> None:
        self.name, self.width_px, self.height_px = name, width, height
        self.dtype = pieces.native
        self._pieces, self._tiled, self._negative = pieces, tiled, negative
        self._open = True
        if pieces.length * pieces.width * self.dtype.itemsize > PIECE_BYTES:
            raise BadInput("strips-pieces-too-large", name=name, piece_bytes=PIECE_BYTES >> 20)

    def bands(self) -> Iterator[Pixels]:
        pieces = self._pieces
        if pieces.length * self.width_px * self.dtype.itemsize > 2 * PIECE_BYTES:
            raise BadInput("strips-tiles-too-large", name=self.name, piece_bytes=PIECE_BYTES >> 19)
        for top in range(0, self.height_px, pieces.length):
            rows = min(pieces.length, self.height_px - top)
            beside = [self._piece(top, i, rows) for i in range(pieces.across)]
            yield beside[0] if len(beside) == 1 else np.hstack(beside)

    def slabs(self, columns: int) -> Iterator[Pixels] | None:
        pieces = self._pieces
        if not self._tiled or pieces.width * self.height_px * self.dtype.itemsize > 2 * PIECE_BYTES:
            return None
        return self._tile_columns(columns)

    def close(self) -> None:
        if self._open:
            self._open = False
            os.close(self._pieces.handle)

    def _tile_columns(self, columns: int) -> Iterator[Pixels]:
        pieces = self._pieces
        tops = range(0, self.height_px, pieces.length)
        for i in range(pieces.across):
            slab = np.vstack([self._piece(top, i, min(pieces.length, self.height_px - top)) for top in tops])
            for left in range(0, slab.shape[1], columns):
                yield slab[:, left : left + columns]

    def _piece(self, top: int, i: int, rows: int) -> Pixels:
        pieces = self._pieces
        try:
            piece = pieces.read(top // pieces.length * pieces.across + i, rows)
        except PieceError as error:
            raise (cut_off if error.cut else damaged_row_error)(self.name, top, self.height_px) from None
        right = min(pieces.width, self.width_px - i * pieces.width)
        piece = piece[:, :right]
        return np.invert(piece) if self._negative else piece
