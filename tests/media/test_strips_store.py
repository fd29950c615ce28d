"""The stored form of a strip: the same pixels, overviews, pictures at every zoom, whole or not at all."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
import tifffile

from sightline.errors import BadInput, Damaged, NotFound, Stopped
from sightline.media.store.local import LocalStore, key_of
from sightline.media.strips.reader import Strip, open_strip
from sightline.media.strips.stored_reader import ReaderCache, StripReader
from sightline.media.strips.stored_writer import (
    SUFFIX,
    StoredStrip,
    average_four_lines,
    level_lines,
    store_strip,
)
from tests.media.strips import pattern, png, tiff

LINES, ROWS = 5003, 47


def stored(tmp_path: Path, dtype: Any = np.uint8, lines: int = LINES) -> tuple[StoredStrip, Any]:
    strip = pattern(lines, ROWS, dtype)
    source = open_strip(tiff(tmp_path / "a.tif", strip), "height")
    made = store_strip(source, tmp_path / "kept" / "a.strip.tif")
    source.close()
    return made, strip


def picture(data: bytes) -> np.ndarray:
    return cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_any_lines_come_back(tmp_path: Path, dtype: Any) -> None:
    made, strip = stored(tmp_path, dtype)
    reader = StripReader(made.path)
    assert (reader.lines, reader.rows, reader.dtype) == (LINES, ROWS, dtype)
    assert (made.lines, made.rows, made.bits) == (LINES, ROWS, 8 * np.dtype(dtype).itemsize)
    for start, stop in ((0, 1), (1000, 1100), (1024, 2048), (2000, 5003), (4990, 9999), (-5, 3), (70, 60)):
        np.testing.assert_array_equal(reader.read(start, stop), strip[max(0, start) : max(0, stop)])
    np.testing.assert_array_equal(np.concatenate(list(reader.chunks(1500))), strip)
    assert made.sha256 == hashlib.sha256(made.path.read_bytes()).hexdigest()


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_overviews_are_means_of_four_lines(tmp_path: Path, dtype: Any) -> None:
    made, strip = stored(tmp_path, dtype)
    reader = StripReader(made.path)
    assert reader.levels == [5003, 1251, 313] == level_lines(LINES) and made.levels == 3
    expected = strip
    for level in (1, 2):
        groups = [expected[i : i + 4].mean(axis=0) for i in range(0, len(expected), 4)]
        got = reader.read(0, LINES, level)
        assert np.abs(got - np.array(groups)).max() <= 0.5
        expected = got
    np.testing.assert_array_equal(
        average_four_lines(np.array([[1], [2], [2], [2], [9]], np.uint8)), [[2], [9]]
    )


def test_tiles_show_time_along_the_width(tmp_path: Path) -> None:
    made, strip = stored(tmp_path)
    reader = StripReader(made.path)
    last = picture(reader.tile(0, 4))
    assert last.shape == (ROWS, LINES - 4096)
    assert np.abs(last.astype(int) - strip[4096:].T).mean() < 3
    bright = picture(reader.tile(0, 0, gain=1.5))
    assert np.abs(bright.astype(int) - np.minimum(255, 1.5 * strip[:1024].T)).mean() < 3
    assert picture(reader.tile(2, 0)).shape == (ROWS, 313)
    for level, index in ((0, 5), (3, 0), (-1, 0), (0, -1)):
        with pytest.raises(NotFound, match="strip"):
            reader.tile(level, index)
    with pytest.raises(BadInput, match="gain"):
        reader.tile(0, 0, float("nan"))


def test_sixteen_bits_are_shown_between_dark_and_bright(tmp_path: Path) -> None:
    made, strip = stored(tmp_path, np.uint16)
    shown = picture(StripReader(made.path).tile(0, 0))
    assert shown.dtype == np.uint8 and shown.min() < 20 and shown.max() > 235
    low, high = np.quantile(strip, (0.001, 0.999))
    expected = np.clip((strip[:1024].T - low) / (high - low) * 255, 0, 255)
    assert np.abs(shown - expected).mean() < 6


def test_other_programs_read_it(tmp_path: Path) -> None:
    made, strip = stored(tmp_path)
    np.testing.assert_array_equal(tifffile.imread(made.path), strip)


def test_it_is_a_strip_again_and_the_same_content_makes_the_same_file(tmp_path: Path) -> None:
    made, _ = stored(tmp_path)
    again = open_strip(made.path, "height")
    assert store_strip(again, tmp_path / "b.strip.tif").sha256 == made.sha256
    again.close()
    other = open_strip(png(tmp_path / "a.png", pattern(LINES, ROWS).T))
    assert store_strip(other, tmp_path / "c.strip.tif").sha256 == made.sha256


def test_it_lies_in_the_media_store(tmp_path: Path) -> None:
    made, strip = stored(tmp_path)
    media = LocalStore(tmp_path / "media")
    key = key_of(made.sha256, SUFFIX)
    media.put_file(key, made.path, link=True)
    readers = ReaderCache()
    reader = readers.reader(media.local_path(key), "lane 1")
    assert readers.reader(media.local_path(key)) is reader
    assert [readers.reader(media.local_path(key), bits=bits).bits for bits in (12, 8, 16)] == [12, 8, 16]
    np.testing.assert_array_equal(reader.read(10, 20), strip[10:20])


@pytest.mark.parametrize(("bits", "share"), [(10, 10 / ROWS), (12, 10 / ROWS), (16, 10 / ROWS), (0, 0.0)])
def test_saturation_is_that_of_the_cameras_bits(tmp_path: Path, bits: int, share: float) -> None:
    """Also where a dark beginning has fewer; 10 bits that end at 1022 are not saturated."""
    top = (1 << bits) - 1 if bits else 1022
    strip = np.full((20_000, ROWS), top // 2, np.uint16)
    strip[:2000] = 255
    strip[2000:, :10] = top
    made = store_strip(open_strip(tiff(tmp_path / "a.tif", strip), "height"), tmp_path / "b.tif")
    assert made.saturated == pytest.approx(share * 0.9, rel=0.01)


def test_threads_read_one_strip_side_by_side(tmp_path: Path) -> None:
    made, strip = stored(tmp_path)
    reader = StripReader(made.path)
    with ThreadPoolExecutor(8) as pool:
        for start, got in pool.map(lambda i: (i, reader.read(i, i + 1500)), range(0, 3500, 50)):
            np.testing.assert_array_equal(got, strip[start : start + 1500])


def test_lost_lines_and_saturation_are_told(tmp_path: Path) -> None:
    strip = pattern(2000, ROWS)
    strip[:, :10] = 255
    (tmp_path / "a.tif.json").write_text('{"line_rate_hz": 50000, "dropped_lines": [[7, 5]]}')
    made = store_strip(open_strip(tiff(tmp_path / "a.tif", strip), "height"), tmp_path / "b.tif")
    assert made.lines == 2005 and made.saturated == pytest.approx(10 / ROWS, rel=0.02)
    notes = StripReader(made.path).notes
    assert notes == made.notes and notes.line_rate_hz == 50000
    assert open_strip(made.path, "height").lines == 2005  # they are not put in twice


class Ending:
    """A strip that ends or is given up on the way."""

    def __init__(self, whole: Strip, error: Exception) -> None:
        self.name, self.lines, self.rows, self.dtype = whole.name, whole.lines, whole.rows, whole.dtype
        self.notes, self._whole, self._error = whole.notes, whole, error

    def chunks(self, lines: int | None = None) -> Iterator[Any]:
        chunks = self._whole.chunks(lines)
        yield next(chunks)
        raise self._error

    def close(self) -> None: ...


def test_it_appears_whole_or_not_at_all(tmp_path: Path) -> None:
    source = open_strip(tiff(tmp_path / "a.tif", pattern(LINES, ROWS)), "height")
    home = tmp_path / "kept"
    with pytest.raises(BadInput, match="gone"):
        store_strip(Ending(source, BadInput("said", sentence="It is gone.")), home / "a.strip.tif")
    assert not list(home.iterdir())
    seen: list[float] = []
    with pytest.raises(Stopped):
        store_strip(source, home / "a.strip.tif", seen.append, lambda: len(seen) > 2)
    assert not list(home.iterdir()) and len(seen) == 3
    store_strip(source, home / "a.strip.tif", seen.append)
    assert seen[-1] == 1.0 and [p.name for p in home.iterdir()] == ["a.strip.tif"]


def test_a_spoilt_stored_form_is_told(tmp_path: Path) -> None:
    made, _ = stored(tmp_path)
    data = made.path.read_bytes()
    cases = {"cut": data[: len(data) // 2], "text": b"no strip", "none": b""}
    for name, content in cases.items():
        path = tmp_path / name
        path.write_bytes(content)
        with pytest.raises(Damaged, match="backup"):
            StripReader(path).read(0, LINES)
    with pytest.raises(Damaged):
        StripReader(tmp_path / "a.tif")
    with pytest.raises(NotFound, match="missing"):
        StripReader(tmp_path / "nowhere")
