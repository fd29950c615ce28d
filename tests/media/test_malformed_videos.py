"""Videos broken in ways that the readers' author had not thought of: a sentence, or notes that say it."""

from __future__ import annotations

from pathlib import Path

import pytest

from sightline.cli import main
from sightline.errors import BadInput
from sightline.media.video.ingest import ingest
from tests.support.malformed import videos

REFUSED = {
    "encrypted.mp4": "cannot be decoded here",
    "huge_samples.mp4": "no frame that can be decoded",
    "mail_header.mp4": "not a video that can be read",
    "text_mode.mp4": "no frame that can be decoded",
    "two_sizes.ts": "changes its frame size partway",
    "unknown_codec.mp4": "cannot be decoded here",
}
NOTED = {
    "a_tick_a_second.mp4": "50 frames, 1 could be decoded",
    "backward_deltas.mp4": "12800 frames per second, which no camera films",
    "byte_more.ts": "do not measure there",
    "clock_set_back.ts": "its times are unreliable",
    "every_frame_at_once.mp4": "infinitely many frames per second",
    "front_cut.mp4": "truncated: 16\u202f027 bytes",
    "hours_missing.ts": "its times are unreliable",
    "killed.mkv": "29 frames (1.12 s) were imported",
    "million_a_second.avi": "1000000 frames per second",
    "million_frames.mp4": "2\u202f147\u202f483\u202f647 frames, 50 could be decoded",
    "mirrored.mp4": "mirrored",
    "no_rate.avi": "states no frame rate",
    "no_timescale.mp4": "50 frames, 1 could be decoded",
    "packets_lost.ts": "0.0400 to 0.0800 s between frames",
    "started_again.ts": "its times are unreliable",
    "turned_by_30.mp4": "by 30 degrees",
    "two_in_one.mp4": "another recording after this one",
    "zeroed.mkv": "1.00 s after frame 23",
}
SOUND = {"one_frame.mp4"}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return videos(tmp_path_factory.mktemp("malformed"))


def test_every_malformed_video_is_tried(made: dict[str, Path]) -> None:
    assert set(made) == set(REFUSED) | set(NOTED) | SOUND


@pytest.mark.parametrize("name", [*REFUSED, *NOTED, *SOUND])
def test_a_malformed_video_is_refused_or_says_what_is_wrong(
    name: str, made: dict[str, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status = main(["passes", str(made[name]), "--json"])
    said = capsys.readouterr().err
    if name in REFUSED:
        with pytest.raises(BadInput, match=REFUSED[name]):
            ingest(made[name], lambda _: None, lambda: False, tmp_path / "thumbs", work_dir=tmp_path)
        assert status == (0 if name == "two_sizes.ts" else 2) and said.count("\n") == (status == 2)
        return
    assert (status, said) == (0, "")
    found = ingest(made[name], lambda _: None, lambda: False, tmp_path / "thumbs", work_dir=tmp_path)
    notes = found.report.notes
    assert any(NOTED[name] in note for note in map(str, notes)) if name in NOTED else notes == (), notes
