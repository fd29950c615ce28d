"""Writing H.264: exact frames back, whole or not at all."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.media.video.decode import frames_of, open_container, video_stream
from sightline.media.video.writer import write_mp4
from tests.media.clips import painted, read_number


def test_what_is_written_is_read(tmp_path: Path) -> None:
    path = tmp_path / "new" / "clip.mp4"
    assert write_mp4(path, (painted(n) for n in range(40)), Fraction(30_000, 1001), gop=10) == 40
    read = list(frames_of(path))
    assert [read_number(gray) for _, _, gray in read] == list(range(40))
    with closing(open_container(path, path.name)) as container:
        stream = video_stream(container, path.name)
        codec = stream.codec_context
        assert (codec.width, codec.height, codec.name) == (320, 240, "h264")
        assert float(stream.average_rate or 0) == pytest.approx(29.97, abs=0.01)
    assert [p.name for p in path.parent.iterdir()] == ["clip.mp4"]


def test_crf_trades_size_for_quality(tmp_path: Path) -> None:
    for crf in (12, 30):
        write_mp4(tmp_path / f"{crf}.mp4", (painted(n) for n in range(10)), 25, crf=crf)
    assert (tmp_path / "12.mp4").stat().st_size > 1.5 * (tmp_path / "30.mp4").stat().st_size


def test_a_failing_source_leaves_nothing_and_an_old_file_alone(tmp_path: Path) -> None:
    path = tmp_path / "clip.mp4"
    write_mp4(path, (painted(n) for n in range(5)), 25)
    before = path.read_bytes()

    def failing() -> Iterator[NDArray[np.uint8]]:
        yield painted(0)
        raise RuntimeError("the renderer broke")

    with pytest.raises(RuntimeError):
        write_mp4(path, failing(), 25)
    assert path.read_bytes() == before
    assert [p.name for p in tmp_path.iterdir()] == ["clip.mp4"]


def test_frames_that_do_not_fit_are_refused(tmp_path: Path) -> None:
    for frames in ([], [painted(0, 321, 240)], [painted(0), painted(1, 160, 120)]):
        with pytest.raises(BadInput):
            write_mp4(tmp_path / "clip.mp4", frames, 25)
    assert list(tmp_path.iterdir()) == []
