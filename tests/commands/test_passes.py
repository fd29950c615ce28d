"""sightline passes, as the contract has it."""

import json
from pathlib import Path

import numpy as np
import pytest

from sightline.cli import main
from sightline.media.video.writer import write_mp4
from tests.media.street import car, street


def test_passes_are_listed_by_frame_numbers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    video, mover = tmp_path / "street.mp4", car(20)
    write_mp4(video, (np.repeat(gray[..., None], 3, 2) for gray in street(70, [mover])), 30, crf=18)
    assert main(["passes", str(video), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["notes"] == []
    (one,) = told["passes"]
    assert set(one) == {"first", "best", "last", "direction"} and one["direction"] == "right"
    assert abs(one["first"] - 20) <= 2 and mover.whole(one["best"])
    assert one["first"] < one["best"] < one["last"] < 70
    assert main(["passes", str(video)]) == 0
    assert "1 found in 70 frames" in capsys.readouterr().out


def test_what_is_no_video_is_bad_input(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = tmp_path / "notes.mp4"
    text.write_text("no video")
    for path in (text, tmp_path / "absent.mp4"):
        assert main(["passes", str(path), "--json"]) == 2
        said = capsys.readouterr()
        assert said.out == "" and path.name in said.err
