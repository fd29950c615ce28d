"""Checks of a survey by its own vehicles: tyre contacts, turned poses, insets offered with their origin."""

from typing import Any

import numpy as np
import pytest

from sightline.geometry.camera import project
from sightline.geometry.road_pose import RoadPose
from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from sightline.measurements.sheets.query import list_sheets
from sightline.measurements.store import list_measurements
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure, pixel, pose_above_road

TURN_RAD = 0.05


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def tyres(angle_rad: float, x_m: float = -1.0, y_m: float = 0.0) -> dict[str, Any]:
    """Clicks on both tyres of a vehicle that travels at this angle to the road's X axis."""
    end = (x_m + 2.0 * np.cos(angle_rad), y_m + 2.0 * np.sin(angle_rad))
    return {"frame": 2, "first": pixel(x_m, y_m, 0.0), "second": pixel(*end, 0.0)}


def traffic(client: Client, survey_id: int) -> Any:
    return client.seen(f"/surveys/{survey_id}/checks/traffic")


def test_tyre_contacts_are_stored_undone_and_audited(
    operator: Client, services: Services, ground: Ground
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)
    path = f"/vehicles/{vehicle['id']}/wheel-pair"
    first = operator.made(path, tyres(0.0))
    second = operator.made(path, tyres(0.01))
    shown = traffic(operator, ground.survey_id)
    assert [pair["id"] for pair in shown["pairs"]] == [second["id"]] and first["id"] < second["id"]
    one = shown["poses"][0]["vehicles"][0]
    assert one["source"] == "tyres" and one["heading_rad"] == pytest.approx(0.01, abs=1e-9)
    assert 0.001 < one["u_heading_rad"] < 0.05 and one["base_m"] == pytest.approx(2.0)
    (pose,) = shown["poses"]
    assert pose["mean_rad"] is None and "at least 3 vehicles" in pose["verdict"][0]["message"]
    gone = operator.delete(path)
    assert gone.status_code == 200 and gone.json()["withdrawn"]
    assert traffic(operator, ground.survey_id)["pairs"] == []
    assert operator.delete(path).status_code == 404
    with services.reading() as session:
        assert verify_records(session).ok


def test_a_pair_changed_meanwhile_is_a_conflict_and_is_not_overwritten(
    operator: Client, admin: Client, ground: Ground
) -> None:
    path = f"/vehicles/{add_vehicle(operator, ground.recording_id)['id']}/wheel-pair"
    first = operator.made(path, {**tyres(0.0), "seen": 0})
    again = operator.post(path, {**tyres(0.0), "seen": 0})
    assert again.status_code == 409 and "meanwhile" in error_of(again)
    second = admin.made(path, {**tyres(0.01), "seen": first["id"]})
    assert operator.delete(f"{path}?seen={first['id']}").status_code == 409
    assert operator.delete(f"{path}?seen={second['id']}").status_code == 200
    assert operator.delete(f"{path}?seen={second['id']}").status_code == 409
    assert operator.made(path, {**tyres(0.0), "seen": 0})["id"] > second["id"]


def test_contacts_that_give_no_direction_are_refused_in_a_sentence(
    operator: Client, viewer: Client, services: Services, ground: Ground
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, first_frame=1)
    path = f"/vehicles/{vehicle['id']}/wheel-pair"
    good = tyres(0.0)
    near = operator.post(path, {**good, "second": pixel(-0.5, 0.0, 0.0)})
    assert near.status_code == 422 and "0.50 m apart" in error_of(near)
    far = operator.post(path, {**good, "first": pixel(-30.0, 60.0, 0.0), "second": pixel(30.0, 60.0, 0.0)})
    assert far.status_code == 422 and "one vehicle" in error_of(far)
    sky = operator.post(path, {**good, "second": [300.0, 20.0]})
    assert sky.status_code == 422 and error_of(sky).startswith("The second tyre contact")
    crc = operator.post(path, {**good, "frame_crc32": 1})
    assert crc.status_code == 409 and "not the image" in error_of(crc)
    frame = operator.post(path, {**good, "frame": 0})
    assert frame.status_code == 422 and "passes in frames 1 to 8" in error_of(frame)
    assert operator.post(path, {**good, "first": [300.0]}).status_code == 422
    assert viewer.post(path, good).status_code == 403
    assert traffic(viewer, ground.survey_id)["pairs"] == []


def test_without_a_road_pose_it_says_where_to_make_one(
    operator: Client, recording_id: int, survey_id: int
) -> None:
    vehicle = add_vehicle(operator, recording_id)
    refused = operator.post(f"/vehicles/{vehicle['id']}/wheel-pair", tyres(0.0))
    assert refused.status_code == 409 and "no camera pose" in error_of(refused)
    assert traffic(operator, survey_id) == {"poses": [], "pairs": []}
    insets = operator.seen(f"/surveys/{survey_id}/checks/insets")
    assert insets["camera_height_m"] == 1.5
    assert all(one["reason"] for target in insets["targets"] for one in target["estimates"])


def test_traffic_turns_a_pose_and_choosing_the_old_one_undoes_it(
    operator: Client, viewer: Client, services: Services, ground: Ground
) -> None:
    rng = np.random.default_rng(3)
    made = []
    for index in range(6):
        vehicle = add_vehicle(operator, ground.recording_id)
        angle = TURN_RAD + rng.normal(0, 0.001)
        operator.made(f"/vehicles/{vehicle['id']}/wheel-pair", tyres(angle, -1.0, 0.1 * index))
        made.append(measure(operator, vehicle["id"]))
    check = traffic(operator, ground.survey_id)["poses"][0]
    assert check["proposed"] and check["used"] == 6
    assert check["mean_rad"] == pytest.approx(TURN_RAD, abs=0.002)
    turned, changes = (one["message"] for one in check["verdict"])
    assert "rotated by 2.8" in turned and "6 stored heights" in changes
    # h = Hc + (h - Hc)(...): the target is 0.4 m ahead, so the side plane there moves by 0.4 m x angle
    expected = (1.2 - 1.5) / 3.0 * 0.4 * np.tan(check["mean_rad"])
    changes = check["changes"]
    assert changes["count"] == 6
    assert changes["listed"][0]["difference_m"] == pytest.approx(expected, rel=0.05)
    path = f"/poses/{ground.pose_id}/turn"
    preview = viewer.seen(path)
    assert preview["turn_rad"] == check["mean_rad"] and len(preview["overlay"]["grid"]) > 5
    assert preview["summary"][0]["message"].startswith("Rotated by 2.8")
    wanted = {"turn_rad": check["mean_rad"]}
    assert viewer.post(path, wanted).status_code == 403
    stale = operator.post(path, {"turn_rad": check["mean_rad"] + 0.001})
    assert stale.status_code == 409 and "reload the page" in error_of(stale)
    new = operator.made(path, wanted)
    assert operator.seen(f"/surveys/{ground.survey_id}/recordings")[0]["pose_id"] == new["id"]
    after = traffic(operator, ground.survey_id)["poses"][0]
    assert (after["pose_id"], after["turned_from"]) == (new["id"], ground.pose_id)
    assert abs(after["mean_rad"]) < 1e-4 and not after["proposed"]
    assert after["changes"]["count"] == 0  # the stored heights are of the pose before
    assert operator.post(path, wanted).status_code == 409
    for one in made:  # what is stored stays as it was measured
        assert operator.seen(f"/measurements/{one['id']}")["height_m"] == one["height_m"]
    again = measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    assert again["pose_id"] == new["id"]
    assert again["height_m"] == pytest.approx(changes["listed"][0]["turned_height_m"], abs=2e-4)
    back = operator.put(f"/recordings/{ground.recording_id}", {"pose_id": ground.pose_id})
    assert back.status_code == 200
    assert traffic(operator, ground.survey_id)["poses"][0]["pose_id"] == ground.pose_id
    with services.reading() as session:
        assert verify_records(session).ok


def test_rejected_clicks_turn_no_road(operator: Client, reviewer: Client, ground: Ground) -> None:
    """Three tyre pairs along the road; a fourth heading is of clicks that a reviewer rejected."""
    for index in range(3):
        vehicle = add_vehicle(operator, ground.recording_id)
        operator.made(f"/vehicles/{vehicle['id']}/wheel-pair", tyres(0.0, -1.0, 0.1 * index))
    there = {"contact": pixel(-1.0, 0.0, 0.0), "target_point": pixel(-0.6, 0.4, 1.2)}
    then = {"frame": 7, "contact": pixel(0.8, 0.18, 0.0), "target_point": pixel(1.2, 0.58, 1.2)}
    vehicle = add_vehicle(operator, ground.recording_id)
    made = measure(operator, vehicle["id"], **there, more_frames=[then], inset_m=None, u_inset_m=None)
    (pose,) = traffic(operator, ground.survey_id)["poses"]
    assert pose["used"] == 4 and pose["mean_rad"] > 0.01
    verdict = {"revision": 1, "verdict": "rejected", "reason": "Another vehicle's tyre."}
    reviewer.made(f"/measurements/{made['id']}/reviews", verdict)
    (pose,) = traffic(operator, ground.survey_id)["poses"]
    assert pose["used"] == 3 and pose["mean_rad"] == pytest.approx(0.0, abs=1e-6)


def roof(pose: RoadPose, height_m: float, inset_m: float, across_m: float, rng: np.random.Generator) -> Any:
    """Clicks of 0.3 px on a roof edge behind the side plane."""
    points = np.array([[-0.5, across_m, 0.0], [-0.2, across_m + inset_m, height_m]])
    clicks = project(pose.camera, pose.to_camera(points)) + rng.normal(0, 0.3, (2, 2))
    return {"contact": clicks[0].tolist(), "target_point": clicks[1].tolist()}


def test_roofs_of_known_height_offer_the_inset_with_its_origin(
    operator: Client, services: Services, ground: Ground
) -> None:
    rng, true_m = np.random.default_rng(4), 0.45
    for index, height_m in enumerate(rng.uniform(1.85, 2.6, 12)):
        wrong = 0.30 if index == 7 else 0.0
        vehicle = add_vehicle(
            operator,
            ground.recording_id,
            category="suv",
            manufacturer_height_m=height_m + wrong,
            u_manufacturer_height_m=0.005,
        )
        where = roof(pose_above_road(), height_m, true_m, rng.uniform(0.0, 2.0), rng)
        measure(operator, vehicle["id"], **where, sigma_px=0.3, inset_m=None, u_inset_m=None)
    check = operator.seen(f"/surveys/{ground.survey_id}/checks/insets")
    target = next(one for one in check["targets"] if one["target"] == "roof")
    assert target["is_default"] and target["in_force"]["inset_m"] == 0.3
    known = target["estimates"][0]
    assert known["method"] == "known_heights" and known["vehicles"] == 11
    assert [one["number"] for one in known["left_out"]] == [8]
    assert known["inset_m"] == pytest.approx(true_m, abs=2.5 * known["u_inset_m"])
    assert known["u_inset_m"] < 0.15
    offer = known["offer"]
    assert offer["u_inset_m"] >= np.hypot(known["u_inset_m"], 0.10) - 1e-9
    assert "manufacturers' heights of 11 vehicles" in offer["note"]
    # larger insets lower what is read too high: here roofs above the camera, so they rise
    assert known["difference_m"] == pytest.approx(
        (target["typical_height_m"] - 1.5) / target["typical_distance_m"] * (known["inset_m"] - 0.3), rel=0.25
    )
    survey = operator.seen(f"/surveys/{ground.survey_id}")
    words = {name: survey[name] for name in ("name", "site", "description", "version")}
    assert (
        operator.put(f"/surveys/{ground.survey_id}", {**words, "insets": {"roof": offer}}).status_code == 200
    )
    assert (
        operator.put(f"/surveys/{ground.survey_id}", {**words, "insets": {"roof": offer}}).status_code == 409
    )
    after = operator.seen(f"/surveys/{ground.survey_id}/checks/insets")
    target = next(one for one in after["targets"] if one["target"] == "roof")
    assert not target["is_default"] and target["in_force"] == {**offer, "code": None}
    # it says what holds already, no better: nothing to press
    again = target["estimates"][0]
    assert again["offer"] is None and again["caution"]["code"] == "inset-no-gain"
    assert target["measured"] == 12  # measured with the inset before: they still count
    with services.reading() as session:
        stored = list_measurements(session, ground.survey_id)
        assert {one.values.inset_m for one in stored} == {0.3}
        assert len(list_sheets(session, ground.survey_id)) == 12


def test_marks_of_a_staff_say_nothing_of_a_vehicles_inset(operator: Client, ground: Ground) -> None:
    """A check target's marks stand in its side plane: they pulled the roofs' 0.45 m to 0.23 m."""
    rng = np.random.default_rng(4)
    for height_m in np.repeat(rng.uniform(1.85, 2.6, 6), 2):
        for check, true_m in ((False, 0.45), (True, 0.0)):
            known = {"manufacturer_height_m": height_m, "u_manufacturer_height_m": 0.0}
            vehicle = add_vehicle(operator, ground.recording_id, category="suv", check_target=check, **known)
            where = roof(pose_above_road(), height_m, true_m, rng.uniform(0.0, 2.0), rng)
            own = {"inset_m": 0.0, "u_inset_m": 0.002} if check else {"inset_m": None, "u_inset_m": None}
            measure(operator, vehicle["id"], **where, sigma_px=0.3, **own)
    check = operator.seen(f"/surveys/{ground.survey_id}/checks/insets")
    target = next(one for one in check["targets"] if one["target"] == "roof")
    known = target["estimates"][0]
    assert (target["measured"], known["vehicles"] + len(known["left_out"])) == (12, 12)
    assert known["inset_m"] == pytest.approx(0.45, abs=2.5 * known["u_inset_m"])
    assert known["u_inset_m"] < 0.07  # heights said to be exact are no worse than that: not 0.03 m / sqrt(3)


def test_cases_are_metrologys_closed_form(viewer: Client, ground: Ground) -> None:
    check = viewer.seen(f"/surveys/{ground.survey_id}/checks/insets")
    assert check["camera_height_m"] == pytest.approx(1.5)
    eye = next(one for one in check["cases"] if one["target"] == "driver_eye")
    # an eye at 1.16 m, 0.45 m inboard, 3 m away, camera at 1.5 m: +44 mm
    at_3m = dict(zip(check["cases_at_m"], eye["bias_m"], strict=True))[3.0]
    assert (eye["height_m"], eye["inset_m"], round(1000 * at_3m)) == (1.16, 0.45, 44)
