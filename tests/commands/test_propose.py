"""sightline propose: what would be clicked, as proposals."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.geometry.documents import pose_to_dict
from sightline.media.video import passes, proposals
from sightline.media.video.writer import write_mp4
from tests.bench.surveys import pose_of
from tests.simulation import day_scene, render_frame


@pytest.fixture(scope="module")
def survey(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The demonstration's first vehicle on a road that was empty for a while, and its true pose."""
    folder, scene = tmp_path_factory.mktemp("propose"), day_scene()
    frames = [*(131 + n % 10 for n in range(130)), *range(131, scene.vehicles[0].last_frame + 2)]
    write_mp4(folder / "drive.mp4", (render_frame(scene, n) for n in frames), scene.fps, crf=16)
    (folder / "pose.json").write_text(json.dumps(pose_to_dict(pose_of(scene))))
    return folder / "drive.mp4", folder / "pose.json"


def once(search: Callable[..., Any]) -> Callable[..., Any]:
    """What it found the first time: searched once, told in two ways."""
    found: list[Any] = []

    def kept(*given: Any, **more: Any) -> Any:
        if not found:
            found.append(search(*given, **more))
        return found[0]

    return kept


def test_points_and_reasons_are_told(
    survey: tuple[Path, Path], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    video, pose = map(str, survey)
    search, propose = passes.find_passes, proposals.propose_in_video
    monkeypatch.setattr(passes, "find_passes", once(search))
    monkeypatch.setattr(
        proposals, "propose_in_video", once(lambda *given, **more: list(propose(*given, **more)))
    )
    assert main(["propose", video, "--pose", pose, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    (one,) = told["passes"]
    assert set(one) == {"first", "last", "direction", "frame", "reason", "wheelbase_m", "points"}
    assert one["reason"] is None and one["first"] <= one["frame"] <= one["last"]
    points = {point["point"]: point for point in one["points"]}
    assert {"x_px", "y_px", "expected_px"} < set(points["contact_rear"])
    assert {"x_px", "y_px", "expected_px", "expected_m"} < set(points["roof"])
    assert "click it yourself" in points["headlight"]["reason"]
    assert main(["propose", video, "--pose", pose]) == 0
    said = capsys.readouterr().out
    assert "contact rear at (" in said and "headlight: none" in said and " mm" in said


def test_a_pose_for_another_size_is_bad_input(
    survey: tuple[Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = json.loads(survey[1].read_text())
    document["camera"]["width_px"] = 1280
    other = tmp_path / "pose.json"
    other.write_text(json.dumps(document))
    assert main(["propose", str(survey[0]), "--pose", str(other)]) == 2
    assert "1280" in capsys.readouterr().err
