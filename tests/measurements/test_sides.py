"""No eye has a silent side: by direction from the survey's traffic, said of a vehicle, or no height."""

from collections.abc import Callable
from typing import Any
from uuid import uuid4

import pytest

from sightline.infra.jobs.records import Job
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, clicks, pixel
from tests.support.ground import measure as measured

FAR = {"traffic_side": "right", "steering_side": "left", "camera_place": "verge"}
EYE = {"target": "driver_eye", "inset_m": None, "u_inset_m": None}


def changed(client: Client, path: str, body: dict[str, Any]) -> dict[str, Any]:
    answer = client.put(path, json=body)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def say_traffic(client: Client, survey_id: int, **traffic: Any) -> dict[str, Any]:
    survey = client.seen(f"/surveys/{survey_id}")
    words = {name: survey[name] for name in ("name", "site", "description", "version")}
    return changed(client, f"/surveys/{survey_id}", {**words, "traffic": traffic})


def change(client: Client, vehicle_id: int, **fields: Any) -> dict[str, Any]:
    version = client.seen(f"/vehicles/{vehicle_id}")["version"]
    return changed(client, f"/vehicles/{vehicle_id}", {"version": version, **fields})


def eye_of(vehicle: dict[str, Any]) -> dict[str, Any]:
    return next(one for one in vehicle["measurements"] if one["target"] == "driver_eye")


def test_without_the_facts_no_eye_has_a_height_until_its_side_is_said(
    operator: Client, ground: Ground
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)
    assert vehicle["side"] is None and vehicle["side_from"] is None
    eye = measured(operator, vehicle["id"], **EYE)
    assert eye["status"] == "not_measurable" and eye["reason"]["code"] == "height-side-unknown"
    numbers = ("height_m", "uncorrected_height_m", "inset_m", "u_inset_m", "x_m", "y_m")
    assert [eye[name] for name in numbers] == [None] * 6
    told = change(operator, vehicle["id"], driver_side="far")
    assert (told["side"], told["side_from"]) == ("far", "said")
    eye = eye_of(told)
    assert (eye["revision"], eye["side"], eye["side_from"]) == (2, "far", "said")
    assert (eye["inset_m"], eye["u_inset_m"], eye["inset_from"]) == (1.15, 0.15, "usual")
    far_m = eye["height_m"]
    near = eye_of(change(operator, vehicle["id"], driver_side="near"))
    assert (near["revision"], near["side"], near["inset_m"]) == (3, "near", 0.45)
    assert near["height_m"] > far_m and near["uncorrected_height_m"] > near["height_m"]
    again = eye_of(change(operator, vehicle["id"], driver_side="near", notes="an import"))
    assert again["revision"] == 3


def test_near_or_far_follows_from_the_direction(operator: Client, ground: Ground) -> None:
    assert say_traffic(operator, ground.survey_id, **FAR)["traffic"] == FAR
    vehicle = add_vehicle(operator, ground.recording_id)
    assert vehicle["side"] is None  # it may be in the opposite lane
    assert measured(operator, vehicle["id"], **EYE)["status"] == "not_measurable"
    left = change(operator, vehicle["id"], direction="left")
    assert (left["side"], left["side_from"]) == ("near", "direction")
    assert eye_of(left)["inset_m"] == 0.45 and "no direction" not in str(eye_of(left)["flags"])
    right = change(operator, vehicle["id"], direction="right")
    assert (right["side"], eye_of(right)["inset_m"], eye_of(right)["side_from"]) == ("far", 1.15, "direction")


def test_eyes_that_waited_are_computed_once_the_traffic_is_told(
    operator: Client, ground: Ground, work: Callable[[], list[Job]]
) -> None:
    right = add_vehicle(operator, ground.recording_id, direction="right")["id"]
    silent = add_vehicle(operator, ground.recording_id)["id"]
    own = add_vehicle(operator, ground.recording_id, direction="right")["id"]
    for vehicle in (right, silent):
        assert measured(operator, vehicle, **EYE)["status"] == "not_measurable"
    measured(operator, own, target="driver_eye", inset_m=0.7, u_inset_m=0.2)
    say_traffic(operator, ground.survey_id, **FAR)
    assert [job.result["heights"] for job in work() if job.result] == [1]
    eyes = [eye_of(operator.seen(f"/vehicles/{vehicle}")) for vehicle in (right, silent, own)]
    assert [eye["revision"] for eye in eyes] == [2, 1, 1]
    assert (eyes[0]["status"], eyes[0]["side"], eyes[0]["inset_m"]) == ("ok", "far", 1.15)
    assert eyes[1]["status"] == "not_measurable"
    # a height that is there is not changed behind anybody's back
    say_traffic(operator, ground.survey_id, **{**FAR, "steering_side": "right"})
    assert work() == []
    assert eye_of(operator.seen(f"/vehicles/{right}"))["revision"] == 2


def test_from_the_median_all_go_one_way(operator: Client, ground: Ground) -> None:
    say_traffic(operator, ground.survey_id, **{**FAR, "camera_place": "median"})
    vehicle = add_vehicle(operator, ground.recording_id)
    eye = measured(operator, vehicle["id"], **EYE)
    assert (eye["side"], eye["side_from"], eye["inset_m"]) == ("near", "place", 0.45)
    assert "height-flag-side-from-place" in {flag["code"] for flag in eye["flags"]}


def test_what_is_shown_before_the_click_is_what_is_stored(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)
    body = {**clicks(**EYE), "vehicle_id": vehicle["id"]}
    ask = f"/recordings/{ground.recording_id}/geometry"
    axes = {"contact": body["contact"], "target": "driver_eye", "vehicle_id": vehicle["id"]}
    unknown = operator.made(f"{ask}/height", body)
    assert unknown["status"] == "not_measurable"
    ruler = operator.made(f"{ask}/axes", axes)
    assert ruler["ok"] and ruler["ladder"] == []
    say_traffic(operator, ground.survey_id, **FAR)
    change(operator, vehicle["id"], direction="right")
    shown = operator.made(f"{ask}/height", body)
    stored = measured(operator, vehicle["id"], **EYE)
    for name in ("height_m", "u_height_m", "inset_m", "side", "side_from", "x_m", "y_m"):
        assert shown[name] == stored[name], name
    assert operator.made(f"{ask}/axes", axes)["ladder"]


def test_an_inset_of_its_own_stays_and_two_frames_need_no_side(operator: Client, ground: Ground) -> None:
    own = add_vehicle(operator, ground.recording_id)
    eye = measured(operator, own["id"], target="driver_eye", inset_m=0.7, u_inset_m=0.2)
    assert (eye["inset_from"], eye["side"], eye["status"]) == ("own", None, "ok")
    assert eye_of(change(operator, own["id"], driver_side="far"))["revision"] == 1
    two = add_vehicle(operator, ground.recording_id)
    first = {"contact": pixel(-0.5, 0.0, 0.0), "target_point": pixel(-0.3, 0.5, 1.2)}
    later = {"frame": 6, "contact": pixel(0.9, 0.0, 0.0), "target_point": pixel(1.1, 0.5, 1.2)}
    eye = measured(operator, two["id"], **EYE, **first, more_frames=[later])
    assert eye["status"] == "ok" and eye["side"] is None
    assert eye["height_m"] == pytest.approx(1.2, abs=1e-4)
    assert eye["solved_inset_m"] == pytest.approx(0.5, abs=1e-3)


def test_moving_a_point_keeps_side_and_inset(operator: Client, ground: Ground) -> None:
    say_traffic(operator, ground.survey_id, **FAR)
    vehicle = add_vehicle(operator, ground.recording_id, direction="right")
    eye = measured(operator, vehicle["id"], **EYE)
    say_traffic(operator, ground.survey_id, **{**FAR, "steering_side": "right"})
    moved = {**clicks(1.25), "target": "driver_eye", "inset_m": eye["inset_m"], "u_inset_m": eye["u_inset_m"]}
    body = {"revision": 1, **moved}
    after = changed(operator, f"/measurements/{eye['id']}", body)
    assert (after["side"], after["inset_m"], after["inset_from"]) == ("far", 1.15, "usual")
    fresh = operator.made(
        f"/vehicles/{add_vehicle(operator, ground.recording_id, direction='right')['id']}/measurements",
        {"client_key": str(uuid4()), **clicks(**EYE)},
    )
    assert (fresh["side"], fresh["inset_m"]) == ("near", 0.45)
