"""From clicks to stored heights: live and stored alike, append-only revisions, nothing stored twice."""

from uuid import uuid4

import pytest

from sightline.infra.services import Services
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, Client, error_of
from tests.support.ground import (
    FOCAL_PX,
    Ground,
    add_pose,
    add_vehicle,
    clicks,
    flat_camera,
    measure,
    pixel,
)

pytestmark = pytest.mark.dialect


@pytest.fixture
def vehicle_id(operator: Client, ground: Ground) -> int:
    return int(add_vehicle(operator, ground.recording_id)["id"])


def test_a_height_is_the_truth_and_the_stored_one_is_the_live_one(
    operator: Client, viewer: Client, ground: Ground, vehicle_id: int
) -> None:
    shown = clicks(1.2, inset_m=0.3, u_inset_m=0.1)
    shown["target_point"] = pixel(0.6, 0.3, 1.2)
    live = viewer.post(f"/recordings/{ground.recording_id}/geometry/height", shown).json()
    assert live["height_m"] == pytest.approx(1.2, abs=1e-9)
    assert live["uncorrected_height_m"] == pytest.approx(1.5 - 0.3 * 3.0 / 3.3, abs=1e-9)
    stored = operator.made(f"/vehicles/{vehicle_id}/measurements", {**shown, "client_key": str(uuid4())})
    for name in (
        "height_m",
        "u_height_m",
        "U95_height_m",
        "uncorrected_height_m",
        "distance_m",
        "budget",
        "flags",
    ):
        assert stored[name] == live[name], name
    assert stored["pose_id"] == ground.pose_id and stored["calibration_id"] == ground.calibration_id
    assert stored["frame_crc32"] > 0 and stored["code_version"].startswith("0.")
    assert stored["review"]["verdict"] == "to_review"


@pytest.mark.parametrize(
    ("category", "height_m", "of_class"),
    [
        (None, 1.45, True),
        (None, 3.8, True),
        (None, 0.4, False),
        ("hatchback", 1.45, True),
        ("hatchback", 3.8, False),
        ("hatchback", 0.3, False),
        ("van", 2.4, True),
        ("lorry", 3.8, True),
    ],
)
def test_a_height_that_no_target_of_the_class_has_is_told(
    operator: Client, ground: Ground, category: str | None, height_m: float, of_class: bool
) -> None:
    """The page then shows a dash at the pointer: on grass or sky it would be a number of nothing."""
    vehicle = add_vehicle(operator, ground.recording_id, category=category)
    said = operator.made(
        f"/recordings/{ground.recording_id}/geometry/height",
        {**clicks(height_m), "vehicle_id": vehicle["id"]},
    )
    assert (said["of_class"], said["height_m"]) == (of_class, pytest.approx(height_m, abs=1e-9))


def test_what_is_left_out_comes_from_the_survey(operator: Client, ground: Ground, vehicle_id: int) -> None:
    survey = operator.seen(f"/surveys/{ground.survey_id}")
    survey["insets"]["roof_unknown"] = {"inset_m": 0.1234567, "u_inset_m": 0.05, "note": "measured here"}
    body = {key: survey[key] for key in ("name", "site", "description", "version", "insets")}
    assert operator.put(f"/surveys/{ground.survey_id}", body).status_code == 200
    stored = measure(operator, vehicle_id, inset_m=None, u_inset_m=None)
    # kept to the micrometre that the CSV carries, so that an export computes the same height
    assert (stored["inset_m"], stored["u_inset_m"], stored["sigma_px"]) == (0.123457, 0.05, 1.0)


@pytest.mark.once
def test_axes_and_ladder_go_through_the_contact(viewer: Client, ground: Ground) -> None:
    contact = pixel(0.2, 0.0, 0.0)
    body = {"contact": contact, "target": "roof", "inset_m": 0.0}
    found = viewer.post(f"/recordings/{ground.recording_id}/geometry/axes", body).json()
    assert found["ok"] and found["axes"]["origin_px"] == contact
    assert (found["x_m"], found["y_m"]) == pytest.approx((0.2, 0.0), abs=1e-9)
    rung = next(one for one in found["ladder"] if one["height_m"] == 1.0)
    assert rung["label"] and rung["points"][0][1] == pytest.approx(pixel(0.2, 0.0, 1.0)[1], abs=0.05)
    bent = found["axes"]["vertical"]
    assert bent[-1][1] < bent[0][1] - 30


@pytest.mark.once
def test_a_click_above_the_horizon_is_answered_and_stored_with_its_reason(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    sky = [160.0, 5.0]
    axes = operator.post(f"/recordings/{ground.recording_id}/geometry/axes", {"contact": sky}).json()
    assert not axes["ok"] and axes["reason"] and axes["axes"] is None
    stored = measure(operator, vehicle_id, contact=sky)
    assert (stored["status"], stored["height_m"]) == ("not_measurable", None)
    assert stored["reason"] == axes["reason"]


@pytest.mark.once
def test_without_a_road_pose_the_way_to_one_is_told(operator: Client, recording_id: int) -> None:
    vehicle_id = add_vehicle(operator, recording_id)["id"]
    answer = operator.post(f"/vehicles/{vehicle_id}/measurements", {**clicks(), "client_key": str(uuid4())})
    assert answer.status_code == 409
    assert "camera pose" in error_of(answer)
    body = {"contact": [10.0, 200.0]}
    assert operator.post(f"/recordings/{recording_id}/geometry/axes", body).status_code == 409


@pytest.mark.once
def test_a_pose_for_pictures_of_another_size_gives_no_height(
    operator: Client, services: Services, ground: Ground, vehicle_id: int
) -> None:
    """Its pixels mean something else, so that every height would be wrong and look right."""
    camera = flat_camera(2 * FRAME_WIDTH, 2 * FRAME_HEIGHT, 2 * FOCAL_PX)
    other = add_pose(services, ground.recording_id, ground.calibration_id, camera, attach=False)
    refused = operator.put(f"/recordings/{ground.recording_id}", {"pose_id": other})
    assert refused.status_code == 422 and "640 x 480" in error_of(refused)
    # Also where it came in by another way: before the ingest knew the size, say.
    add_pose(services, ground.recording_id, ground.calibration_id, camera)
    live = operator.post(f"/recordings/{ground.recording_id}/geometry/height", clicks())
    body = {"client_key": str(uuid4()), **clicks()}
    stored = operator.post(f"/vehicles/{vehicle_id}/measurements", body)
    for answer in (live, stored):
        assert answer.status_code == 409 and "640 x 480" in error_of(answer)


def test_the_same_key_is_stored_once(operator: Client, ground: Ground, vehicle_id: int) -> None:
    body = {**clicks(), "client_key": str(uuid4())}
    first = operator.made(f"/vehicles/{vehicle_id}/measurements", body)
    again = operator.made(f"/vehicles/{vehicle_id}/measurements", body)
    assert again == first
    assert len(operator.seen(f"/vehicles/{vehicle_id}")["measurements"]) == 1


def test_one_target_of_a_vehicle_is_measured_once(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    # else its height would be counted twice
    first = measure(operator, vehicle_id)
    path = f"/vehicles/{vehicle_id}/measurements"
    refused = reviewer.post(path, {"client_key": str(uuid4()), **clicks(1.4)})
    assert refused.status_code == 409 and "already" in error_of(refused)
    # as every other answer shows it: the page that asks whose counts reads the one shape
    assert refused.json()["current"] == operator.seen(f"/measurements/{first['id']}") == first
    assert [one["id"] for one in operator.seen(f"/vehicles/{vehicle_id}")["measurements"]] == [first["id"]]
    late = reviewer.put(f"/vehicles/{vehicle_id}", {"version": 99, "make": "Lindo"})
    assert late.status_code == 409 and late.json()["current"] == operator.seen(f"/vehicles/{vehicle_id}")

    assert operator.delete(f"/measurements/{first['id']}?revision=1").status_code == 200
    second = measure(reviewer, vehicle_id)
    refused = operator.post(f"/measurements/{first['id']}/restore", {"revision": 2})
    assert refused.status_code == 409 and refused.json()["current"] == second

    other = measure(operator, vehicle_id, target="taillight")
    refused = operator.put(f"/measurements/{other['id']}", {**clicks(), "revision": 1})
    assert refused.status_code == 409 and refused.json()["current"] == second


def test_a_correction_is_a_new_revision_and_an_old_sight_is_a_conflict(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    first = measure(operator, vehicle_id)
    path = f"/measurements/{first['id']}"
    changed = operator.put(path, {**clicks(1.3), "revision": 1}).json()
    assert (changed["revision"], changed["height_m"]) == (2, pytest.approx(1.3, abs=1e-9))
    late = reviewer.put(path, {**clicks(1.4), "revision": 1})
    assert late.status_code == 409 and "Operator" in error_of(late)
    gone = operator.delete(f"{path}?revision=2").json()
    assert gone["withdrawn"] and gone["revision"] == 3
    assert operator.seen(f"/vehicles/{vehicle_id}")["measurements"] == []
    back = operator.post(f"{path}/restore", {"revision": 3}).json()
    assert not back["withdrawn"] and back["height_m"] == changed["height_m"]
    history = operator.seen(f"{path}/history")
    assert [one["revision"] for one in history["revisions"]] == [1, 2, 3, 4]
    assert history["revisions"][0]["height_m"] == pytest.approx(1.2, abs=1e-9)


NO_CLICKS: tuple[dict[str, object], ...] = (
    {"frame": 999},
    {"sigma_px": 0.0},
    {"sigma_px": -1.0},
    {"contact": [1.0]},
    {"contact": [1e308, 2.0]},
    {"target": "bumper"},
    {"inset_m": 99.0},
    {"u_inset_m": -0.1},
    {"surprise": 1},
)


@pytest.mark.once
def test_what_cannot_be_a_click_is_refused_in_words(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    for wrong in NO_CLICKS:
        body = {**clicks(), "client_key": str(uuid4()), **wrong}
        answer = operator.post(f"/vehicles/{vehicle_id}/measurements", body)
        assert answer.status_code in (404, 422), (wrong, answer.text)
        error_of(answer)
    assert operator.seen(f"/vehicles/{vehicle_id}")["measurements"] == []
