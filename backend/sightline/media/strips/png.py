"""PNG of any length in bounded memory: inflated row by row, its filters undone a band at a time.

Sizes, chunks and filters: PNG Specification (Third Edition), W3C. The filters refer to the row above only, so
a band together with the last row of the band before is a small PNG of its own, which libpng decodes.
"""

import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

import imagecodecs
import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.media.strips.sheet import BAND_BYTES, Pixels, check_claim, cut_off, damaged_row_error

MAGIC = b"\x89PNG\r\n\x1a\n"
MOST_WIDE_PX = 1_000_000  # libpng's own bound
_READ_BYTES = 1 << 18
_MOST_CHUNKS = 10_000
_KINDS = {
    2: "strips-in-colour",
    3: "strips-palette",
    4: "strips-transparency",
    6: "strips-colour-with-transparency",
}


class PngSheet:
    """A grey PNG (height, width), 8 or 16 bit, not interlaced. Raises BadInput for any other."""

    def __init__(self, path: Path, name: str) -> None:
        self.name = name
        self._path = path
        with path.open("rb") as file:
            head = file.read(33)
        if len(head) < 33 or head[12:16] != b"IHDR":
            raise BadInput("strips-header-cut-off", name=name)
        size = path.stat().st_size
        self.width_px, self.height_px, depth, colour, _, _, interlaced = struct.unpack(
            ">IIBBBBB", head[16:29]
        )
        if colour in _KINDS:
            raise BadInput(_KINDS[colour], name=name)
        if colour != 0 or depth not in (8, 16):
            raise BadInput("strips-bits-pixel", name=name, depth=depth)
        if interlaced:
            raise BadInput("strips-interlaced", name=name)
        self.dtype: np.dtype[Any] = np.dtype(np.uint8 if depth == 8 else np.uint16)
        check_claim(name, self.width_px, self.height_px, depth // 8, size)
        if self.width_px > MOST_WIDE_PX:
            raise BadInput(
                "strips-png-too-wide", name=name, width_px=self.width_px, most_wide_px=MOST_WIDE_PX
            )
        self._depth = depth

    def slabs(self, columns: int) -> Iterator[Pixels] | None:
        return None

    def close(self) -> None:
        return

    def bands(self) -> Iterator[Pixels]:
        row_bytes = 1 + self.width_px * self.dtype.itemsize
        rows = max(1, BAND_BYTES // row_bytes)
        above = bytes(row_bytes)
        done = 0
        pieces = self._inflated(rows * row_bytes)
        while done < self.height_px:
            count = min(rows, self.height_px - done)
            filtered = self._next(pieces, done)
            if len(filtered) < count * row_bytes:
                raise cut_off(self.name, done + len(filtered) // row_bytes, self.height_px)
            band = self._unfiltered(above, filtered[: count * row_bytes], count, done)
            yield band
            above = b"\0" + band[-1].astype(band.dtype.newbyteorder(">")).tobytes()
            done += count

    def _next(self, pieces: Iterator[bytes], row: int) -> bytes:
        try:
            return next(pieces, b"")
        except zlib.error:
            raise damaged_row_error(self.name, row, self.height_px) from None

    def _unfiltered(self, above: bytes, filtered: bytes, count: int, row: int) -> Pixels:
        head = struct.pack(">IIBBBBB", self.width_px, count + 1, self._depth, 0, 0, 0, 0)
        body = zlib.compress(above + filtered, 0)
        small = MAGIC + _chunk(b"IHDR", head) + _chunk(b"IDAT", body) + _chunk(b"IEND", b"")
        try:
            band: NDArray[Any] = imagecodecs.png_decode(small)
        except imagecodecs.PngError:
            raise damaged_row_error(self.name, row, self.height_px) from None
        return band[1:]

    def _inflated(self, size: int) -> Iterator[bytes]:
        """The filtered rows in pieces of `size` bytes; the last may be shorter."""
        inflate = zlib.decompressobj()
        held = bytearray()
        for packed in self._packed():
            while packed:
                held += inflate.decompress(packed, size - len(held))
                packed = inflate.unconsumed_tail
                if len(held) == size:
                    yield bytes(held)
                    held.clear()
        yield bytes(held)

    def _packed(self) -> Iterator[bytes]:
        """The content of the IDAT chunks, in small pieces, checksums looked at."""
        with self._path.open("rb") as file:
            file.seek(len(MAGIC))
            others = 0
            while True:
                head = file.read(8)
                if len(head) < 8 or head[4:] == b"IEND":
                    return
                length = int.from_bytes(head[:4], "big")
                if head[4:] == b"IDAT" and length:
                    yield from self._content(file, length)
                    continue
                others += 1
                if head[4:] == b"acTL" or others > _MOST_CHUNKS:
                    raise BadInput("strips-not-plain", name=self.name)
                file.seek(length + 4, 1)

    def _content(self, file: BinaryIO, length: int) -> Iterator[bytes]:
        crc = zlib.crc32(b"IDAT")
        while length:
            piece = file.read(min(length, _READ_BYTES))
            if not piece:
                return
            crc = zlib.crc32(piece, crc)
            length -= len(piece)
            yield piece
        said = file.read(4)
        if len(said) == 4 and int.from_bytes(said, "big") != crc:
            raise BadInput("strips-checksum-wrong", name=self.name)


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
