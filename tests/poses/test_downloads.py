"""camera.json and pose.json as they are downloaded: the command line computes the same height from them."""

import json
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.geometry.documents import camera_from_dict
from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import add_vehicle, flat_camera, lay_ground, measure


def test_a_downloaded_pose_gives_the_stored_height(
    operator: Client,
    viewer: Client,
    services: Services,
    survey_id: int,
    recording_id: int,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    ground = lay_ground(services, survey_id, recording_id)
    made = measure(operator, add_vehicle(operator, recording_id)["id"], inset_m=0.2, u_inset_m=0.05)
    answer = viewer.get(f"/poses/{ground.pose_id}/pose.json")
    assert f'filename="pose-{ground.pose_id}.json"' in answer.headers["content-disposition"]
    place = tmp_path / "pose.json"
    place.write_bytes(answer.content)
    contact, target = (",".join(map(str, made[name])) for name in ("contact", "target_point"))
    asked = ["height", "--pose", str(place), "--contact", contact, "--target", target]
    assert main([*asked, "--inset", "0.2", "--u-inset", "0.05", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["height_m"] == pytest.approx(made["height_m"], abs=1e-12)
    assert told["u_height_m"] == pytest.approx(made["u_height_m"], abs=1e-12)


def test_a_downloaded_camera_is_the_calibration(
    viewer: Client, services: Services, survey_id: int, recording_id: int
) -> None:
    ground = lay_ground(services, survey_id, recording_id)
    answer = viewer.get(f"/calibrations/{ground.calibration_id}/camera.json")
    assert f'filename="camera-{ground.calibration_id}.json"' in answer.headers["content-disposition"]
    read, stored = camera_from_dict(json.loads(answer.content)), flat_camera()
    assert (read.fx_px, read.fy_px, read.cx_px, read.cy_px) == (
        stored.fx_px,
        stored.fy_px,
        stored.cx_px,
        stored.cy_px,
    )
    assert "checks" not in json.loads(answer.content)
    assert viewer.get("/calibrations/999/camera.json").status_code == 404
    assert viewer.get("/poses/999/pose.json").status_code == 404
