"""Still pictures: sizes are looked up before decoding; what is no picture is refused with its name."""

from __future__ import annotations

import struct
import tracemalloc
import zlib
from pathlib import Path

import cv2
import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.media.images import image_size, jpeg, png, read_image, read_image_bgr
from tests.media.clips import painted


@pytest.mark.parametrize("suffix", [".png", ".jpg", ".bmp", ".tiff", ".webp", ".pgm", ".ppm"])
@pytest.mark.parametrize("size", [(64, 48), (301, 257)])
def test_size_by_header_is_that_of_the_picture(suffix: str, size: tuple[int, int], tmp_path: Path) -> None:
    image = painted(9, *size)
    if suffix == ".pgm":
        image = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    data = cv2.imencode(suffix, image)[1].tobytes()
    assert image_size(data) == size
    path = tmp_path / f"board{suffix}"
    path.write_bytes(data)
    gray = read_image(path)
    assert gray.shape == (size[1], size[0]) and gray.dtype == np.uint8
    assert np.array_equal(gray, read_image(data))
    assert read_image_bgr(data).shape == (size[1], size[0], 3)


@pytest.mark.parametrize("kind", [cv2.IMWRITE_WEBP_QUALITY])
@pytest.mark.parametrize("quality", [80, 101])
def test_both_kinds_of_webp_tell_their_size(kind: int, quality: int) -> None:
    data = cv2.imencode(".webp", painted(1, 131, 97), [kind, quality])[1].tobytes()
    assert image_size(data) == (131, 97)


def bomb(width: int, height: int) -> bytes:
    """A small PNG whose header claims width x height pixels of one colour."""

    def chunk(kind: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)
    rows = zlib.compress(b"\x00" * min(height * (width // 8 + 2), 20_000_000), 9)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


@pytest.mark.parametrize("size", [(100_000, 100_000), (16_384, 16_384), (1, 20_000), (2**31 - 1, 2)])
def test_bombs_are_refused_before_decoding(size: tuple[int, int]) -> None:
    data = bomb(*size)
    tracemalloc.start()
    with pytest.raises(BadInput, match=r"^lens7.png states .* pixels") as caught:
        read_image(data, "lens7.png")
    assert tracemalloc.get_traced_memory()[1] < 1_000_000
    tracemalloc.stop()
    assert caught.value.exit_status == 2


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "is empty"),
        (b"hello", "not an image"),
        (b"\x00\x00\x00\x20ftypisom", "not an image"),
        (b"\x00\x00\x00\x18ftypheic\x00\x00\x00\x00", "is a HEIC or AVIF image"),
        (b"\x89PNG\r\n\x1a\n", "damaged"),
        (b"\xff\xd8\xff\xe0\x00\x10JFIF", "damaged"),
        (b"II*\x00\xff\xff\xff\xff", "damaged"),
        (b"RIFF\x00\x00\x00\x00WAVEfmt ", "damaged"),
        (b"P5 x y\n", "damaged"),
        (b"P5 0 0\n255\n", "damaged"),
    ],
)
def test_what_is_no_picture_is_named(data: bytes, words: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=words) as caught:
        read_image(data, "IMG_7.jpg")
    assert caught.value.message.startswith("IMG_7.jpg")


@pytest.mark.parametrize("suffix", [".png", ".jpg", ".tiff", ".webp", ".bmp"])
def test_cut_and_flipped_pictures_are_read_or_refused(suffix: str) -> None:
    whole = cv2.imencode(suffix, painted(3, 120, 90))[1].tobytes()
    rng = np.random.default_rng(1)
    for _ in range(40):
        data = bytearray(whole[: rng.integers(1, len(whole) + 1)])
        for at in rng.integers(0, len(data), 3):
            data[at] = int(rng.integers(0, 256))
        try:
            image = read_image(bytes(data), "x")
        except BadInput as error:
            assert error.message.startswith("x ")
        else:
            assert image.ndim == 2 and image.size <= 100_000_000


def test_missing_files_are_named(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=r"^no.png cannot be read"):
        read_image(tmp_path / "no.png")
    with pytest.raises(BadInput, match="cannot be read"):
        read_image(tmp_path)


def test_png_is_lossless_and_jpeg_close() -> None:
    image = painted(77)
    assert np.array_equal(read_image_bgr(png(image)), image)
    assert np.abs(read_image_bgr(jpeg(image, 95)).astype(int) - image.astype(int)).mean() < 2
    assert len(jpeg(image, 50)) < len(jpeg(image, 95))
