"""`sightline height --tracks`: a followed pass in, one vehicle out, one sentence per error."""

import json
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.geometry.documents import pose_to_dict
from tests.geometry.passing import NEAR, Drawn, frames_of, look
from tests.geometry.scenes import pose_of

NAMES = ("contact", "second_contact", "target")


def run(*arguments: object) -> int:
    return main([str(a) for a in arguments])


@pytest.fixture
def pose_file(tmp_path: Path) -> Path:
    path = tmp_path / "pose.json"
    path.write_text(json.dumps(pose_to_dict(pose_of(NEAR))))
    return path


@pytest.fixture
def tracks_file(tmp_path: Path) -> Path:
    frame, point, t = frames_of(NEAR, Drawn())
    rows = [
        f"{f},{s},{NAMES[p]},{x},{y}"
        for f, s, p, (x, y) in zip(frame, t, point, look(NEAR, Drawn(), point, t), strict=True)
    ]
    path = tmp_path / "tracks.csv"
    path.write_text("\n".join(["frame,time_s,point,x_px,y_px", *rows, ""]))
    return path


def test_a_followed_pass(pose_file, tracks_file, capsys) -> None:
    assert run("height", "--pose", pose_file, "--tracks", tracks_file, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["height_m"] == pytest.approx(1.16, abs=1e-6)
    assert found["solved_inset_m"] == pytest.approx(0.45, abs=1e-5)
    assert found["wheelbase_m"] == pytest.approx(2.6, abs=1e-5)
    assert found["speed_mps"] == pytest.approx(9.0, abs=1e-4)
    assert found["acceleration_mps2"] is None and found["dropped"] == []
    assert {entry["source"] for entry in found["budget"]} >= {"following", "confirmed points", "heading"}
    assert len(found["covariance"]) == len(found["solved_for"]) == 8


def test_in_words_with_what_was_left_out(pose_file, tracks_file, capsys) -> None:
    lines = tracks_file.read_text().splitlines()
    cells = lines[1].split(",")
    lines[1] = ",".join([*cells[:3], "-4", cells[4]])
    tracks_file.write_text("\n".join(lines))
    assert run("height", "--pose", pose_file, "--tracks", tracks_file) == 0
    out = capsys.readouterr().out
    assert out.startswith("1.160 m ± ") and "followed on " in out
    assert "It lies outside the frame." in out


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("1.5,0,target,3,4", "the frame is not a whole number"),
        ("1,0,roof,3,4", "the point roof is not one of contact, second_contact, target"),
        ("1,,target,3,4", "line 2: time_s is empty"),
        ("1,0,target,3", "4 cells"),
    ],
)
def test_rows_that_cannot_be_read(row, words, pose_file, tmp_path, capsys) -> None:
    path = tmp_path / "tracks.csv"
    path.write_text(f"frame,time_s,point,x_px,y_px\n{row}\n")
    assert run("height", "--pose", pose_file, "--tracks", path) != 0
    assert words in capsys.readouterr().err


def test_options_without_effect_are_refused(pose_file, tracks_file, capsys) -> None:
    given = ("height", "--pose", pose_file)
    for more, words in (
        (("--tracks", tracks_file, "--inset", "0.4"), "--inset"),
        (("--tracks", tracks_file, "--contact", "3,4"), "only one of these"),
        (("--contact", "3,4", "--target", "3,2", "--drift", "0.1"), "--drift"),
    ):
        assert run(*given, *more) != 0
        assert words in capsys.readouterr().err


@pytest.mark.parametrize("stated", [("--drift", "-1"), ("--u-time", "nan"), ("--exposure", "1e300")])
def test_what_cannot_be_said_of_following_is_bad_input(pose_file, tracks_file, stated, capsys) -> None:
    assert run("height", "--pose", pose_file, "--tracks", tracks_file, *stated) == 2
    said = capsys.readouterr()
    assert "negative or too large; correct it" in said.err and said.err.count("\n") == 1 and not said.out
