"""Line-scan files come back pixel by pixel, whatever packs them and whichever way time runs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile

from sightline.enums import TimeAxis
from sightline.errors import BadInput
from sightline.media.strips import sheet
from sightline.media.strips.notes import Dropped, column_of, lost_lines
from sightline.media.strips.reader import check_pair, open_strip
from tests.media.strips import as_picture, pattern, png, read, tiff

PACKINGS: tuple[dict[str, Any], ...] = (
    {},
    {"bigtiff": True, "byteorder": ">"},
    {"rowsperstrip": 7},
    {"tile": (64, 128)},
    {"compression": "zstd", "predictor": True, "tile": (1024, 48), "bigtiff": True},
    {"compression": "zstd", "rowsperstrip": 5},
    {"compression": "zlib", "predictor": True, "rowsperstrip": 6, "byteorder": ">"},
    {"compression": "lzw", "tile": (32, 16)},
    {"compression": "lzw", "rowsperstrip": 4, "photometric": "miniswhite"},
)


@pytest.mark.parametrize("time_axis", ["width", "height"])
@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize("how", PACKINGS, ids=str)
def test_every_packing_gives_the_same_lines(
    tmp_path: Path, how: dict[str, Any], dtype: Any, time_axis: TimeAxis
) -> None:
    strip = pattern(1203, 47, dtype)
    picture = as_picture(strip, time_axis)
    if how.get("photometric") == "miniswhite":
        picture = np.invert(picture)
    got = read(tiff(tmp_path / "a.tif", picture, **how), time_axis, 500)
    assert got.dtype == dtype
    np.testing.assert_array_equal(got, strip)


@pytest.mark.parametrize("told", [70_000 - 65_536, 65_535])
@pytest.mark.parametrize("compression", [None, "zlib"])
def test_more_lines_than_16_bits_can_count_are_all_read(
    tmp_path: Path, compression: str | None, told: int
) -> None:
    strip = pattern(70_000, 9, np.uint8)
    path = tiff(tmp_path / "long.tif", strip, rowsperstrip=70_000, compression=compression)
    with tifffile.TiffFile(path, mode="r+") as file:
        file.pages.first.tags["RowsPerStrip"].overwrite(told, dtype="H")
    np.testing.assert_array_equal(read(path, "height", 8_192), strip)


@pytest.mark.parametrize("time_axis", ["width", "height"])
@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_png_is_read_a_band_at_a_time(
    tmp_path: Path, dtype: Any, time_axis: TimeAxis, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sightline.media.strips.png.BAND_BYTES", 9000)
    strip = pattern(1203, 47, dtype)
    got = read(png(tmp_path / "a.png", as_picture(strip, time_axis)), time_axis)
    assert got.dtype == dtype
    np.testing.assert_array_equal(got, strip)


def test_content_tells_the_format_not_the_name(tmp_path: Path) -> None:
    strip = pattern(300, 20)
    png(tmp_path / "a.png", strip.T).rename(tmp_path / "a.tif")
    np.testing.assert_array_equal(read(tmp_path / "a.tif"), strip)


def test_chunks_have_the_length_asked_for_and_can_be_read_again(tmp_path: Path) -> None:
    strip = open_strip(tiff(tmp_path / "a.tif", pattern(1203, 47), rowsperstrip=10), "height")
    for _ in range(2):
        assert [len(chunk) for chunk in strip.chunks(250)] == [250, 250, 250, 250, 203]
    strip.close()


def test_turning_leaves_no_file_behind(tmp_path: Path) -> None:
    path = png(tmp_path / "a.png", pattern(300, 20).T)
    work = tmp_path / "work"
    work.mkdir()
    strip = open_strip(path, work_dir=work)
    chunks = strip.chunks(100)
    next(chunks)
    assert not list(work.iterdir())


@pytest.mark.parametrize("beside", [True, False])
def test_lost_lines_are_put_back_so_that_time_goes_on(tmp_path: Path, beside: bool) -> None:
    whole = pattern(1000, 20)
    kept = np.delete(whole, [*range(300, 310), 500], axis=0)
    notes = json.dumps({"line_rate_hz": 4882.8, "dropped_lines": [[300, 10], [490, 1]]})
    path = tiff(tmp_path / "a.tif", kept, **({} if beside else {"description": notes, "metadata": None}))
    if beside:
        (tmp_path / "a.tif.json").write_text(notes)
    strip = open_strip(path, "height")
    assert strip.lines == 1000 and strip.notes.line_rate_hz == 4882.8
    got = np.concatenate(list(strip.chunks(64)))
    strip.close()
    put_back = [*range(300, 310), 500]
    np.testing.assert_array_equal(np.delete(got, put_back, axis=0), kept)
    assert (got[300:310] == whole[299]).all() and (got[500] == whole[499]).all()


def test_line_numbers_lead_back_to_the_columns_of_the_file() -> None:
    gaps = (Dropped(300, 10), Dropped(490, 1))
    told = {0.0: 0.0, 299.4: 299.4, 305.0: 299.5, 310.0: 300.0, 499.25: 489.25, 500.0: 489.5, 501.0: 490.0}
    assert {line: column_of(line, gaps) for line in told} == told


@pytest.mark.parametrize(
    ("notes", "said"),
    [
        ("[]", "not a JSON object"),
        ("{", "not readable JSON"),
        ('{"line_rate_hz": -1}', "line_rate_hz"),
        ('{"dropped_lines": [[5, 1], [3, 1]]}', "dropped_lines"),
        ('{"dropped_lines": 7}', "dropped_lines"),
        ('{"dropped_lines": [[5, 1e9]]}', "dropped_lines"),
        ('{"dropped_lines": [[5, 1000000000]]}', "lost"),
        ('{"dropped_lines": [[5000, 3]]}', "ends at 300"),
    ],
)
def test_notes_that_make_no_sense_are_named(tmp_path: Path, notes: str, said: str) -> None:
    path = tiff(tmp_path / "a.tif", pattern(300, 20))
    (tmp_path / "a.tif.json").write_text(notes)
    with pytest.raises(BadInput, match=said) as refused:
        open_strip(path, "height")
    assert "a.tif" in refused.value.message and refused.value.message.endswith(".")


def test_a_system_that_reads_in_small_bits_is_asked_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    strip = pattern(200, 33)
    path = tiff(tmp_path / "a.tif", strip)
    whole = sheet.os.preadv
    monkeypatch.setattr(
        sheet.os, "preadv", lambda handle, buffers, place: whole(handle, [buffers[0][:100]], place)
    )
    np.testing.assert_array_equal(read(path, "height"), strip)


def test_lost_lines_are_counted_where_a_vehicle_passes() -> None:
    gaps = (Dropped(300, 10), Dropped(490, 1))
    spans = {(0, 300): 0, (295, 305): 5, (250, 400): 10, (309, 501): 2, (501, 900): 0, (304.2, 304.9): 1}
    assert {span: lost_lines(gaps, *span) for span in spans} == spans


def test_a_pair_has_lines_of_one_kind(tmp_path: Path) -> None:
    first = open_strip(tiff(tmp_path / "a.tif", pattern(300, 20)), "height")
    for name, other, said in (
        ("b.tif", pattern(300, 24), "24"),
        ("c.tif", pattern(299, 20), "299"),
        ("d.tif", pattern(300, 20, np.uint16), "16"),
    ):
        with pytest.raises(BadInput, match=f"a.tif.*{name} .*{said}"):
            check_pair(first, open_strip(tiff(tmp_path / name, other), "height"))
    check_pair(first, open_strip(png(tmp_path / "e.png", pattern(300, 20)), "height"))
