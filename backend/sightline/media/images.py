"""Still pictures in and out; sizes are checked before anything is decoded."""

import struct
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput, SightlineError
from sightline.media.video.picture import Bgr, Gray
from sightline.media.video.sniff import STILL_BRANDS

MAX_SIDE_PX = 16_384
MAX_PIXELS = 100_000_000
MAX_BYTES = 200_000_000
HEIF = "media-heif-picture"


def read_image(source: bytes | Path, name: str | None = None) -> Gray:
    """A picture as luminance, (height, width); orientation tags are applied, colours are reduced.

    `name` is what people call the file. Raises BadInput, naming it, if it is empty, no picture, damaged, or
    larger than 16384 pixels on a side or 100 million in all (looked up in the header, before decoding).
    """
    return _decode_image(source, name, cv2.IMREAD_GRAYSCALE)


def read_image_bgr(source: bytes | Path, name: str | None = None) -> Bgr:
    """Like `read_image`, but (height, width, 3) in BGR."""
    return _decode_image(source, name, cv2.IMREAD_COLOR)


def _decode_image(source: bytes | Path, name: str | None, flags: int) -> NDArray[np.uint8]:
    name = name or (source.name if isinstance(source, Path) else "The picture")
    data = _bytes_of(source, name)
    width, height = image_size(data, name)
    if max(width, height) > MAX_SIDE_PX or width * height > MAX_PIXELS:
        raise BadInput(
            "media-image-too-large",
            name=name,
            width=width,
            height=height,
            max_side_px=MAX_SIDE_PX,
            max_pixels=MAX_PIXELS // 1000000,
        )
    try:
        image = cv2.imdecode(np.frombuffer(data, np.uint8), flags)
    except cv2.error:
        image = None
    if image is None:
        raise BadInput("media-not-decodable", name=name)
    return np.asarray(image, np.uint8)


def _bytes_of(source: bytes | Path, name: str) -> bytes:
    if isinstance(source, bytes):
        data = source
    else:
        try:
            if source.stat().st_size > MAX_BYTES:
                raise BadInput("media-file-too-large", name=name, max_bytes=MAX_BYTES // 1000000)
            data = source.read_bytes()
        except OSError as error:
            raise BadInput("media-unreadable", name=name, strerror=error.strerror) from error
    if not data:
        raise BadInput("media-empty-choose-picture", name=name)
    return data


def image_size(data: bytes, name: str = "The picture") -> tuple[int, int]:
    """Width and height by the header of a PNG, JPEG, BMP, TIFF, WebP or PGM/PPM file, without decoding it.

    Raises BadInput for other files: what cannot be measured is not decoded.
    """
    if data[4:8] == b"ftyp" and data[8:12] in STILL_BRANDS:
        raise BadInput("media-heif-picture", name=name)
    reader = next((read for magic, read in _READERS if data.startswith(magic)), None)
    size = None
    if reader is not None:
        try:
            size = reader(data)
        except (struct.error, IndexError, ValueError):
            size = None
    if reader is None:
        raise BadInput("media-not-an-image", name=name)
    if size is None or min(size) < 1:
        raise BadInput("media-header-damaged", name=name)
    return size


def _png_size(data: bytes) -> tuple[int, int]:
    width, height = struct.unpack(">II", data[16:24])
    return width, height


def _jpeg_size(data: bytes) -> tuple[int, int] | None:
    offset = 2
    while offset + 9 < len(data):
        if data[offset] != 0xFF:
            offset += 1
            continue
        marker = data[offset + 1]
        if 0xC0 <= marker <= 0xCF and marker not in (0xC4, 0xC8, 0xCC):
            height, width = struct.unpack(">HH", data[offset + 5 : offset + 9])
            return width, height
        bare = marker in (0x00, 0x01, 0xFF) or 0xD0 <= marker <= 0xD8
        offset += (
            1 if marker == 0xFF else 2 if bare else 2 + struct.unpack(">H", data[offset + 2 : offset + 4])[0]
        )
    return None


def _bmp_size(data: bytes) -> tuple[int, int]:
    width, height = struct.unpack("<ii", data[18:26])
    return abs(width), abs(height)


def _webp_size(data: bytes) -> tuple[int, int] | None:
    if data[8:12] != b"WEBP":
        return None
    kind = data[12:16]
    if kind == b"VP8X":
        return 1 + int.from_bytes(data[24:27], "little"), 1 + int.from_bytes(data[27:30], "little")
    if kind == b"VP8L":
        bits = int.from_bytes(data[21:25], "little")
        return 1 + (bits & 0x3FFF), 1 + (bits >> 14 & 0x3FFF)
    width, height = struct.unpack("<HH", data[26:30])
    return width & 0x3FFF, height & 0x3FFF


def _tiff_size(data: bytes) -> tuple[int, int] | None:
    order = "<" if data[:2] == b"II" else ">"
    (offset,) = struct.unpack(order + "I", data[4:8])
    (count,) = struct.unpack(order + "H", data[offset : offset + 2])
    tags: dict[int, int] = {}
    for i in range(count):
        entry = data[offset + 2 + 12 * i : offset + 14 + 12 * i]
        tag, kind = struct.unpack(order + "HH", entry[:4])
        value = entry[8:10] if kind == 3 else entry[8:12]
        tags[tag] = struct.unpack(order + ("H" if kind == 3 else "I"), value)[0]
    return (tags[256], tags[257]) if 256 in tags and 257 in tags else None


def _pnm_size(data: bytes) -> tuple[int, int]:
    lines = [line.split(b"#")[0] for line in data[:1000].splitlines()]
    words = b" ".join(lines).split()
    return int(words[1]), int(words[2])


_READERS = (
    (b"\x89PNG\r\n\x1a\n", _png_size),
    (b"\xff\xd8\xff", _jpeg_size),
    (b"BM", _bmp_size),
    (b"RIFF", _webp_size),
    (b"II*\x00", _tiff_size),
    (b"MM\x00*", _tiff_size),
    (b"P5", _pnm_size),
    (b"P6", _pnm_size),
)


def no_larger(image: NDArray[np.uint8], most_px: int) -> NDArray[np.uint8]:
    """The picture, (h, w) or (h, w, 3), made smaller if a side is longer than `most_px`."""
    height, width = image.shape[:2]
    scale = most_px / max(height, width)
    if scale >= 1.0:
        return image
    size = (max(1, round(scale * width)), max(1, round(scale * height)))
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)


def jpeg(bgr: NDArray[np.uint8], quality: int = 95, *, half_chroma: bool = False) -> bytes:
    """JPEG of BGR (h, w, 3) or luminance (h, w), its colours at 4:4:4 or, in half the time, at 4:2:0."""
    sampling = cv2.IMWRITE_JPEG_SAMPLING_FACTOR_420 if half_chroma else cv2.IMWRITE_JPEG_SAMPLING_FACTOR_444
    options = [cv2.IMWRITE_JPEG_QUALITY, quality, cv2.IMWRITE_JPEG_SAMPLING_FACTOR, sampling]
    return _encode(".jpg", bgr, options)


def png(bgr: NDArray[np.uint8]) -> bytes:
    """PNG, quick rather than small; BGR (h, w, 3) or luminance (h, w)."""
    return _encode(".png", bgr, [cv2.IMWRITE_PNG_COMPRESSION, 1])


def _encode(suffix: str, image: NDArray[np.uint8], options: list[int]) -> bytes:
    done, data = cv2.imencode(suffix, image, options)
    if not done:
        raise SightlineError("media-not-encodable", shape=image.shape, suffix=suffix[1:].upper())
    return data.tobytes()
