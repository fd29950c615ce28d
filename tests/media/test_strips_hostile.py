"""Line-scan files that are wrong, cut, bombs or something else: a sentence each, at once, without hunger."""

from __future__ import annotations

import resource
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import tifffile

from sightline.enums import TimeAxis
from sightline.errors import BadInput
from tests.media.strips import chunk, pattern, png, png_header, read, tiff

STRIP = pattern(600, 40)


def refusal(path: Path, time_axis: TimeAxis = "width") -> str:
    with pytest.raises(BadInput) as refused:
        read(path, time_axis)
    said = refused.value.message
    assert said.startswith(path.name) and said.endswith(".") and "\n" not in said
    return said


def written(data: bytes) -> Callable[[Path], object]:
    return lambda path: path.write_bytes(data)


def huge_tiff(path: Path) -> None:
    """A header that claims 100,000 x 100,000 pixels over a file of a few bytes."""
    tiff(path, np.zeros((64, 64), np.uint8))
    with tifffile.TiffFile(path, mode="r+b") as file:
        for name in ("ImageWidth", "ImageLength"):
            file.pages.first.tags[name].overwrite(100_000)


def pages(path: Path) -> None:
    with tifffile.TiffWriter(path) as file:
        for _ in range(3):
            file.write(STRIP, contiguous=False)


@pytest.mark.parametrize(
    ("make", "word"),
    [
        (written(b""), "empty"),
        (written(b"lines\n" * 99), "text file"),
        (written(png_header(600, 40)[:20]), "cut off in its header"),
        (written(png_header(100_000, 100_000)), "states 100000 x 100000"),
        (written(png_header(0, 0)), "0 x 0"),
        (written(png_header(600, 40, depth=1)), "1 bits"),
        (written(png_header(600, 40, colour=2)), "colour"),
        (written(png_header(600, 40, colour=3)), "palette"),
        (written(png_header(600, 40, colour=4)), "transparency"),
        (written(png_header(600, 40, interlaced=1)), "interlaced"),
        (written(png_header(1_000_001, 40)), "1000001 pixels wide"),
        (written(png_header(600, 40)), "cut off: it ends in row 0"),
        (written(png_header(600, 40) + chunk(b"acTL", bytes(8))), "animation"),
        (written(png_header(600, 40) + chunk(b"IDAT", b"not deflate at all")), "damaged at row 0"),
        (written(png_header(600, 40) + chunk(b"IDAT", zlib.compress(b"\7" * 601 * 40))), "damaged"),
        (written(b"\xff\xd8\xff\xe0" + bytes(99)), "JPEG"),
        (written(b"PK\3\4" + bytes(99)), "zip archive"),
        (written(b"II*\0" + b"\xff" * 40), "directory"),
        (written(b"II+\0" + bytes(60)), "directory"),
        (huge_tiff, "states 100000 x 100000"),
        (pages, "several images"),
        (lambda p: tiff(p, np.zeros((40, 600, 3), np.uint8), photometric="rgb"), "colour"),
        (lambda p: tiff(p, np.zeros((40, 600), np.float32)), "floating-point"),
        (lambda p: tiff(p, np.zeros((40, 600), np.int16)), "signed"),
        (lambda p: tiff(p, np.zeros((40, 600), np.uint32)), "32 bits"),
        (lambda p: tiff(p, STRIP.T, compression="jpeg"), "compressed with JPEG"),
        (
            lambda p: tiff(p, STRIP.T, photometric="palette", colormap=np.zeros((3, 256), np.uint16)),
            "palette",
        ),
        (lambda p: tiff(p, np.zeros((4, 600), np.uint8)), "600 lines of 4 pixels"),
        (
            lambda p: tiff(p, np.zeros((17_000, 600), np.uint8)),
            "if time runs along its height, choose that time axis",
        ),
        (
            lambda p: tiff(p, np.zeros((9000, 4096), np.uint8), compression="zstd", rowsperstrip=9000),
            "pieces",
        ),
    ],
)
def test_what_is_no_strip_is_refused_in_a_sentence(
    tmp_path: Path, make: Callable[[Path], object], word: str
) -> None:
    path = tmp_path / "first.tif"
    make(path)
    assert word in refusal(path)


def test_a_place_without_a_file_is_refused(tmp_path: Path) -> None:
    assert "not a file" in refusal(tmp_path)
    assert "not a file" in refusal(tmp_path / "nowhere.png")


@pytest.mark.parametrize("time_axis", ["width", "height"])
@pytest.mark.parametrize("share", [0.3, 0.7, 0.98])
@pytest.mark.parametrize("kind", ["png", "none", "zstd", "zlib", "lzw"])
def test_a_file_cut_in_the_middle_says_where(
    tmp_path: Path, kind: str, share: float, time_axis: TimeAxis
) -> None:
    path = tmp_path / "first"
    picture = np.ascontiguousarray(STRIP.T) if time_axis == "width" else STRIP
    if kind == "png":
        png(tmp_path / "a.png", picture).rename(path)
    else:
        how = {} if kind == "none" else {"compression": kind, "rowsperstrip": 5}
        tiff(path, picture, **how)
    data = path.read_bytes()
    path.write_bytes(data[: int(share * len(data))])
    said = refusal(path, time_axis)
    assert "cut off: it ends in row" in said and f"of {picture.shape[0]}" in said


@pytest.mark.parametrize("kind", ["png", "zstd", "zlib", "lzw", "tile"])
def test_changed_bytes_give_a_sentence_or_pixels_never_more(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "first"
    how = (
        {"compression": "zlib", "tile": (16, 32)}
        if kind == "tile"
        else {"compression": kind, "rowsperstrip": 5}
    )
    png(tmp_path / "a.png", STRIP.T).rename(path) if kind == "png" else tiff(path, STRIP.T, **how)
    data = path.read_bytes()
    rng = np.random.default_rng(5)
    refused = 0
    for trial in range(60):
        changed = bytearray(data)
        # every other trial spoils the directory or header, where the sizes are
        near = len(data) if trial % 2 else 300
        for place in rng.integers(4, near, 3):
            changed[place if kind == "png" or trial % 4 else -place] = rng.integers(256)
        path.write_bytes(changed)
        try:
            got = read(path)
        except BadInput as error:
            refused += 1
            assert error.message.startswith("first") and "\n" not in error.message
        else:
            assert got.ndim == 2 and got.shape[1] <= 16_384
    assert refused > 10


def test_a_bomb_is_refused_before_it_goes_off(tmp_path: Path) -> None:
    row = zlib.compressobj(6)
    packed = b"".join(row.compress(bytes(1 << 20)) for _ in range(8)) + row.flush()
    path = tmp_path / "first.png"
    path.write_bytes(png_header(900_000, 16_000) + chunk(b"IDAT", packed) + chunk(b"IEND", b""))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert "MB of file can hold" in refusal(path)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 50_000
