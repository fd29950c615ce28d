"""The contact assistant over HTTP, and stills that are brightened to look at and never measured on."""

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from sightline.geometry.camera import Camera
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.video.display import brightened
from sightline.media.video.writer import write_mp4
from sightline.simulation.render import render_frame
from sightline.simulation.scene import low_light_scene
from sightline.simulation.truth import spot_pixel, spots_of
from tests.support.app import Client, error_of, upload
from tests.support.ground import add_pose, store_calibration

pytestmark = pytest.mark.once

SCENE = low_light_scene()
VEHICLE = SCENE.vehicles[1]
FRAME = (VEHICLE.first_frame + VEHICLE.last_frame) // 2


@pytest.fixture(scope="session")
def night_clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("night") / "night.mp4"
    write_mp4(path, (render_frame(SCENE, FRAME + n) for n in range(4)), 30, crf=14, gop=4)
    return path


@pytest.fixture
def recording_id(operator: Client, survey_id: int, night_clip: Path, work: Callable[[], list[Job]]) -> int:
    made = upload(operator, survey_id, night_clip)
    assert [job.state for job in work()] == ["done"]
    return made


def picture(content: bytes) -> np.ndarray:
    return np.asarray(cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR), np.uint8)


def test_a_brightened_still_is_another_picture_of_the_same_frame(viewer: Client, recording_id: int) -> None:
    path = f"/recordings/{recording_id}/frames/1.jpg"
    plain, bright = viewer.get(path), viewer.get(f"{path}?display=bright")
    assert plain.headers["ETag"] != bright.headers["ETag"]
    for name in ("Sightline-Frame", "Sightline-Pts"):
        assert plain.headers[name] == bright.headers[name]
    before, after = picture(plain.content), picture(bright.content)
    assert before.shape == after.shape and after.mean() > 1.6 * before.mean()
    # what is cached for the eye never answers for the frame itself, in whichever order they are asked for
    assert viewer.get(path).content == plain.content
    assert (
        viewer.get(f"{path}?display=bright", headers={"If-None-Match": plain.headers["ETag"]}).status_code
        == 200
    )
    assert viewer.get(f"{path}?display=sepia").status_code == 422

    crop = f"/recordings/{recording_id}/frames/1/crop.png?x=300&y=300&w=64&h=48"
    one, two = viewer.get(crop), viewer.get(f"{crop}&display=bright")
    assert picture(two.content).mean() > 1.5 * picture(one.content).mean()
    # local contrast is the whole picture's: the loupe shows what the frame shows
    assert np.abs(picture(two.content).astype(int) - after[300:348, 300:364]).mean() < 6


def test_a_bright_picture_keeps_its_brightness_and_pixels_stay_where_they_are() -> None:
    rng = np.random.default_rng(2)
    flat = np.full((120, 160, 3), 150, np.uint8)
    assert abs(float(brightened(flat).mean()) - 150) < 20
    dark = (rng.uniform(0, 12, (120, 160, 3))).astype(np.uint8)
    dark[40:80, 60:100] += 25
    shown = brightened(dark).astype(float).mean(axis=2)
    assert shown[45:75, 65:95].mean() > shown[:30].mean() + 30
    edge = np.diff(shown[45:75].mean(axis=0))
    assert int(np.argmax(edge)) == 59 and int(np.argmin(edge)) == 99


def test_a_proposal_comes_near_the_truth_and_stores_nothing(
    viewer: Client, services: Services, survey_id: int, recording_id: int
) -> None:
    path = f"/recordings/{recording_id}/frames/1/contact"
    answer = viewer.post(path, {"pointer": [300, 300]})
    assert answer.status_code == 409 and "road pose" in error_of(answer)
    c = SCENE.camera
    size = (c.width_px, c.height_px)
    lens = Camera("drawn", *size, "brown", c.fx_px, c.fy_px, c.cx_px, c.cy_px, np.array(c.distortion))
    _, calibration_id = store_calibration(services, survey_id, lens)
    add_pose(
        services, recording_id, calibration_id, lens, rotation=c.rotation(), translation_m=c.translation_m()
    )

    spot = next(one for one in spots_of(VEHICLE) if one.name == "contact_rear")
    px = spot_pixel(c, VEHICLE, spot, FRAME + 1)
    found = viewer.made(path, {"pointer": [float(px[0]) + 5, float(px[1]) - 6]})
    assert found["reason"] is None and len(found["outline"]) > 20
    assert np.hypot(found["contact"][0] - px[0], found["contact"][1] - px[1]) < 1.0
    assert found["words"].startswith("proposal: expect about") and 0.25 < found["radius_m"] < 0.56

    none = viewer.made(path, {"pointer": [40, 460]})
    assert none["contact"] is None and none["words"].startswith("No proposal: ") and none["reason"]
    assert viewer.post(path, {"pointer": [40]}).status_code == 422
    assert viewer.post(path.replace("/1/", "/99/"), {"pointer": [40, 40]}).status_code == 404
