"""Small strips and the files that hold them, for the tests of reading."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import tifffile
from numpy.typing import NDArray

from sightline.enums import TimeAxis
from sightline.media.strips.reader import open_strip
from sightline.media.strips.sheet import Pixels


def pattern(lines: int, rows: int, dtype: Any = np.uint8) -> Pixels:
    """(lines, rows): smooth with noise, every line and row different."""
    rng = np.random.default_rng(3)
    wave = 100 + 60 * np.sin(np.arange(lines) / 37)[:, None] + 40 * np.cos(np.arange(rows) / 9)[None]
    scale = 1 if np.dtype(dtype) == np.uint8 else 250
    return np.clip((wave + rng.normal(0, 3, (lines, rows))) * scale, 0, np.iinfo(dtype).max).astype(dtype)


def as_picture(strip: Pixels, time_axis: TimeAxis) -> Pixels:
    return np.ascontiguousarray(strip.T if time_axis == "width" else strip)


def png(path: Path, picture: NDArray[Any]) -> Path:
    assert cv2.imwrite(str(path), picture)
    return path


def tiff(path: Path, picture: NDArray[Any], **how: Any) -> Path:
    tifffile.imwrite(path, picture, **how)
    return path


def png_header(width: int, height: int, depth: int = 8, colour: int = 0, interlaced: int = 0) -> bytes:
    """A PNG that ends after its header."""
    content = b"IHDR" + struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, interlaced)
    return b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + content + struct.pack(">I", zlib.crc32(content))


def chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def read(path: Path, time_axis: TimeAxis = "width", lines: int | None = None) -> Pixels:
    """The whole strip, read in chunks."""
    strip = open_strip(path, time_axis)
    try:
        return np.concatenate(list(strip.chunks(lines)))
    finally:
        strip.close()
