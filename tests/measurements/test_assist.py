"""The contact assistant over HTTP, and stills that are brightened to look at and never measured on."""

from collections.abc import Callable
from pathlib import Path
from uuid import uuid4

import cv2
import numpy as np
import pytest

from sightline.geometry.camera import Camera
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.video.display import brighten_picture
from sightline.media.video.writer import write_mp4
from tests.simulation.render import render_frame
from tests.simulation.scene import low_light_scene
from tests.simulation.truth import spot_pixel, spots_of
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
def night_id(operator: Client, survey_id: int, night_clip: Path, work: Callable[[], list[Job]]) -> int:
    made = upload(operator, survey_id, night_clip)
    assert [job.state for job in work()] == ["done"]
    return made


def picture(content: bytes) -> np.ndarray:
    return np.asarray(cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR), np.uint8)


def test_a_brightened_still_is_another_picture_of_the_same_frame(viewer: Client, night_id: int) -> None:
    path = f"/recordings/{night_id}/frames/1.jpg"
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

    crop = f"/recordings/{night_id}/frames/1/crop.png?x=300&y=300&w=64&h=48"
    one, two = viewer.get(crop), viewer.get(f"{crop}&display=bright")
    assert picture(two.content).mean() > 1.5 * picture(one.content).mean()
    # local contrast is the whole picture's: the loupe shows what the frame shows
    assert np.abs(picture(two.content).astype(int) - after[300:348, 300:364]).mean() < 6


def test_a_bright_picture_keeps_its_brightness_and_pixels_stay_where_they_are() -> None:
    rng = np.random.default_rng(2)
    flat = np.full((120, 160, 3), 150, np.uint8)
    assert abs(float(brighten_picture(flat).mean()) - 150) < 20
    dark = (rng.uniform(0, 12, (120, 160, 3))).astype(np.uint8)
    dark[40:80, 60:100] += 25
    shown = brighten_picture(dark).astype(float).mean(axis=2)
    assert shown[45:75, 65:95].mean() > shown[:30].mean() + 30
    edge = np.diff(shown[45:75].mean(axis=0))
    assert int(np.argmax(edge)) == 59 and int(np.argmin(edge)) == 99


def give_pose(services: Services, survey_id: int, night_id: int) -> None:
    """The scene's true camera pose."""
    c = SCENE.camera
    size = (c.width_px, c.height_px)
    lens = Camera("drawn", *size, "brown", c.fx_px, c.fy_px, c.cx_px, c.cy_px, np.array(c.distortion))
    _, calibration_id = store_calibration(services, survey_id, lens)
    add_pose(services, night_id, calibration_id, lens, rotation=c.rotation(), translation_m=c.translation_m())


def pixel_of(name: str) -> tuple[float, float]:
    """Where a spot of the vehicle is on frame 1 of the clip."""
    spot = next(one for one in spots_of(VEHICLE) if one.name == name)
    x, y = spot_pixel(SCENE.camera, VEHICLE, spot, FRAME + 1)
    return float(x), float(y)


def test_a_proposal_comes_near_the_truth_and_stores_nothing(
    viewer: Client, services: Services, survey_id: int, night_id: int
) -> None:
    path = f"/recordings/{night_id}/frames/1/contact"
    answer = viewer.post(path, {"pointer": [300, 300]})
    assert answer.status_code == 409 and "camera pose" in error_of(answer)
    give_pose(services, survey_id, night_id)

    px = pixel_of("contact_rear")
    found = viewer.made(path, {"pointer": [float(px[0]) + 5, float(px[1]) - 6]})
    assert found["reason"] is None and len(found["outline"]) > 20
    assert np.hypot(found["contact"][0] - px[0], found["contact"][1] - px[1]) < 1.0
    assert found["words"]["message"].startswith("suggested contact, u = ") and 0.25 < found["radius_m"] < 0.56

    none = viewer.made(path, {"pointer": [40, 460]})
    assert none["contact"] is None and none["reason"]
    assert none["words"]["message"].startswith("No suggestion. ")
    assert viewer.post(path, {"pointer": [40]}).status_code == 422
    assert viewer.post(path.replace("/1/", "/99/"), {"pointer": [40, 40]}).status_code == 404


def test_a_contact_click_goes_to_the_tyre_and_the_record_says_from_where(
    operator: Client, services: Services, survey_id: int, night_id: int
) -> None:
    give_pose(services, survey_id, night_id)
    span = {"first_frame": 0, "last_frame": 3}
    vehicle_id = operator.made(f"/recordings/{night_id}/vehicles", span)["id"]
    (x, y), roof = pixel_of("contact_rear"), pixel_of("roof")
    click = [round(x + 2.0, 2), round(y - 15.0, 2)]
    path = f"/vehicles/{vehicle_id}/frames/1/snap"
    found = operator.made(path, {"click": click})
    assert np.hypot(found["contact"][0] - x, found["contact"][1] - y) < 1.0
    assert found["reason"] is None and found["expected_px"] < 0.9
    none = operator.made(path, {"click": [40, 460]})
    assert none["contact"] is None and none["reason"].startswith("snap-")

    base = {"target": "roof", "frame": 1, "target_point": roof}
    to = f"/vehicles/{vehicle_id}/measurements"
    wrong = operator.post(
        to, {**base, "client_key": str(uuid4()), "contact": [x + 3, y], "snapped_from": click}
    )
    assert wrong.status_code == 409 and "not where Sightline now places" in error_of(wrong)
    lie = {**base, "client_key": str(uuid4()), "contact": found["contact"], "made": "snapped"}
    assert operator.post(to, lie).status_code == 422
    one = {**base, "client_key": str(uuid4()), "contact": found["contact"], "snapped_from": click}
    made = operator.made(to, one)
    assert (made["made"], made["snapped_from_x_px"], made["snapped_from_y_px"]) == ("snapped", *click)
    assert operator.made(to, one)["id"] == made["id"]

    # the target put elsewhere leaves the contact what it is; the contact put elsewhere is a person's
    at = f"/measurements/{made['id']}"
    up = {"frame": 1, "contact": found["contact"], "target_point": [roof[0], roof[1] + 1]}
    up = operator.put(at, {**up, "revision": 1}).json()
    assert (up["made"], up["snapped_from_x_px"]) == ("snapped", click[0])
    aside = {"revision": 2, "frame": 1, "contact": [x + 1, y], "target_point": roof}
    aside = operator.put(at, aside).json()
    assert (aside["made"], aside["snapped_from_x_px"]) == ("moved", None)
    again = {"revision": 3, "frame": 1, "contact": found["contact"], "target_point": roof}
    assert operator.put(at, {**again, "contact": [x, y], "snapped_from": click}).status_code == 409
    again = operator.put(at, {**again, "snapped_from": click}).json()
    assert (again["made"], again["snapped_from_y_px"]) == ("moved", click[1])
