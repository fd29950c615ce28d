"""Strips cut from a video along two columns or rows of pixels."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from sightline.enums import CutAlong
from sightline.errors import BadInput
from sightline.media.strips.video import cut_strips, line_rate
from sightline.media.video.decode import frames_of
from sightline.media.video.writer import write_mp4

RATE, COUNT = 240, 300


@pytest.fixture(scope="module")
def video(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A bright bar that travels 2 px a frame over a grey picture of 320 x 64."""

    def frames() -> object:
        for n in range(COUNT):
            image = np.full((64, 320, 3), 90, np.uint8)
            image[10:40, max(0, 2 * n - 100) : max(0, 2 * n)] = 210
            yield image

    path = tmp_path_factory.mktemp("cut") / "bar.mp4"
    write_mp4(path, frames(), RATE, crf=10)  # type: ignore[arg-type]
    return path


def even(count: int = COUNT, rate: float = RATE) -> np.ndarray:
    return np.arange(count) / rate


def test_a_line_a_frame_of_either_column(video: Path, tmp_path: Path) -> None:
    seen: list[float] = []
    strips = cut_strips(video, (100, 140), even(), work_dir=tmp_path, on_progress=seen.append)
    grays = np.stack([gray for _, _, gray in frames_of(video)])
    for strip, column in zip(strips, (100, 140), strict=True):
        assert (strip.lines, strip.rows, strip.notes.line_rate_hz) == (COUNT, 64, pytest.approx(RATE))
        got = np.concatenate(list(strip.chunks(64)))
        np.testing.assert_array_equal(got, grays[:, :, column])
    one, two = (np.concatenate(list(strip.chunks()))[:, 25].astype(float) for strip in strips)
    # the bar reaches the second column 40 px or 20 frames after the first
    assert np.argmax(two > 150) - np.argmax(one > 150) == 20
    assert seen[-1] == 1.0 and not list(tmp_path.iterdir())
    for strip in strips:
        strip.close()


@pytest.mark.parametrize("along", ["rows_left_up", "rows_right_up"])
def test_rows_are_lines_with_the_roofs_first(video: Path, tmp_path: Path, along: CutAlong) -> None:
    strips = cut_strips(video, (12, 30), even(), work_dir=tmp_path, along=along)
    grays = np.stack([gray for _, _, gray in frames_of(video)])
    for strip, row in zip(strips, (12, 30), strict=True):
        assert (strip.lines, strip.rows) == (COUNT, 320)
        got = np.concatenate(list(strip.chunks(64)))
        np.testing.assert_array_equal(got, grays[:, row, :: 1 if along == "rows_left_up" else -1])
        strip.close()
    with pytest.raises(BadInput, match="rows 0 and 64 cannot be cut"):
        cut_strips(video, (0, 64), even(), along=along)


@pytest.mark.parametrize("columns", [(100, 100), (-1, 5), (0, 320)])
def test_columns_have_to_be_two_of_the_picture(video: Path, columns: tuple[int, int]) -> None:
    with pytest.raises(BadInput, match="different ones from 0 to 319"):
        cut_strips(video, columns, even())


def test_another_number_of_frames_is_told(video: Path) -> None:
    with pytest.raises(BadInput, match=f"now has {COUNT} frames, not {COUNT - 1}"):
        cut_strips(video, (1, 2), even(COUNT - 1))


def missing(times: np.ndarray) -> np.ndarray:
    return np.delete(times, 150)


def slower(times: np.ndarray) -> np.ndarray:
    return np.where(times > 0.6, 1.1 * times - 0.06, times)


def jumping(times: np.ndarray) -> np.ndarray:
    return times + np.random.default_rng(1).uniform(0, 0.5 / RATE, len(times))


@pytest.mark.parametrize("spoil", [missing, slower, jumping])
def test_an_uneven_frame_rate_is_refused(video: Path, spoil: Callable[[np.ndarray], np.ndarray]) -> None:
    with pytest.raises(BadInput, match="no constant frame rate"):
        line_rate(spoil(even()), "bar.mp4", tick_s=1 / 15360)


def test_rounded_time_stamps_are_even(video: Path) -> None:
    rounded = np.round(even(rate=239.76) * 1000) / 1000
    assert line_rate(rounded, "bar.mkv") == pytest.approx(239.76, rel=1e-3)
    with pytest.raises(BadInput, match="too few"):
        line_rate(even(5), "bar.mp4")
