"""sightline follow: a vehicle followed through its pass from points on one frame."""

import csv
import json
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.geometry.documents import pose_to_dict
from sightline.media.video.writer import write_mp4
from tests.bench.bench_whole_pass_pictures import begun_on
from tests.bench.surveys import pose_of
from tests.simulation import PassTruth, day_scene, render_frame, truth

SCENE = day_scene()


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> tuple[PassTruth, list[str]]:
    """A compressed clip of the sixth vehicle alone, and the command that follows it."""
    folder, true = tmp_path_factory.mktemp("follow"), truth(SCENE)[5]
    first = begun_on(SCENE, true, "driver_eye")
    assert first is not None
    start, end = true.frames[0].frame, true.frames[-1].frame
    write_mp4(
        folder / "drive.mp4", (render_frame(SCENE, n) for n in range(start, end + 1)), SCENE.fps, crf=16
    )
    (folder / "pose.json").write_text(json.dumps(pose_to_dict(pose_of(SCENE))))
    at = {name: ",".join(map(str, first.pixels[name])) for name in first.pixels}
    options = ["--contact", at["contact_rear"], "--second", at["contact_front"], "--target", at["driver_eye"]]
    return true, ["follow", str(folder / "drive.mp4"), "--pose", str(folder / "pose.json"), "--frame",
                  str(first.frame - start), *options]  # fmt: skip


def test_a_pass_is_measured_and_its_tracks_give_the_same_height(
    clip: tuple[PassTruth, list[str]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    true, command = clip
    table = tmp_path / "tracks.csv"
    known = ["--kind", "driver_eye", "--side", "near", "--sigma", "0"]
    assert main([*command, *known, "-o", str(table), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["height_m"] == pytest.approx(true.spot("driver_eye").height_m, abs=0.01)
    assert told["wheelbase_m"] == pytest.approx(true.vehicle.model.wheelbase_m, abs=0.02)
    assert told["frames"] >= 12 and told["following"]["begun_on"] == int(command[5])
    assert any("left the frame" in one["reason"] for one in told["lost"])
    with table.open() as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == len(told["tracks"]) and rows[0]["point"] == told["tracks"][0]["point"]
    following = told["following"]
    again = ["height", "--pose", command[3], "--tracks", str(table), "--json"]
    again += ["--confirmed", str(following["confirmed_px"]), "--begun-on", str(following["begun_on"])]
    again += ["--view", str(following["view_px"]), "--depth-share", str(following["u_depth_share"])]
    again += ["--matched"]
    assert following["matched"] is True
    assert main(again) == 0
    assert json.loads(capsys.readouterr().out)["height_m"] == pytest.approx(told["height_m"], abs=0.002)


def test_in_words_each_dropped_point_has_its_reason(
    clip: tuple[PassTruth, list[str]], capsys: pytest.CaptureFixture[str]
) -> None:
    _, command = clip
    assert main([*command, "--inset", "0.5", "--u-inset", "0.1"]) == 0
    said = capsys.readouterr().out
    assert "followed on" in said and "not followed: target on frame" in said


def test_what_cannot_be_followed_is_bad_input(
    clip: tuple[PassTruth, list[str]], capsys: pytest.CaptureFixture[str]
) -> None:
    _, command = clip
    assert main([*command, "--kind", "driver_eye"]) == 2
    assert "near or far" in capsys.readouterr().err
    assert main([*command, "--kind", "roof"]) == 2
    assert "two frames" in capsys.readouterr().err
    for pass_ in (["--first", str(int(command[5]) + 1)], ["--last", "0"]):
        assert main([*command, *pass_]) == 2
        assert "outside the pass" in capsys.readouterr().err
