"""A roof's inset follows from the vehicle's class: a box has its roof above its tyres, a car has not."""

from typing import Any

import numpy as np
import pytest

from sightline.geometry.camera import project
from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, lay_ground, measure, pose_above_road

BOX_M, TRUE_INSET_M = 3.6, 0.02


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def roof(height_m: float, inset_m: float, across_m: float = 1.0) -> dict[str, Any]:
    """Exact clicks on a roof's edge so far behind the side plane; the survey says the inset."""
    pose = pose_above_road()
    points = np.array([[-0.5, across_m, 0.0], [-0.2, across_m + inset_m, height_m]])
    contact, point = project(pose.camera, pose.to_camera(points)).tolist()
    given = {"target": "roof", "inset_m": None, "u_inset_m": None, "sigma_px": 0.3}
    return {"contact": contact, "target_point": point, **given}


def change(client: Client, vehicle: dict[str, Any], **facts: Any) -> dict[str, Any]:
    version = client.seen(f"/vehicles/{vehicle['id']}")["version"]
    answer = client.put(f"/vehicles/{vehicle['id']}", {**facts, "version": version})
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def test_a_lorrys_roof_is_right_once_its_class_is_known(
    operator: Client, services: Services, ground: Ground
) -> None:
    """Without a class it reads high as a car's would, says so by its U95, and is computed anew with it."""
    vehicle = add_vehicle(operator, ground.recording_id)
    made = measure(operator, vehicle["id"], **roof(BOX_M, TRUE_INSET_M))
    wrong_m = made["height_m"] - BOX_M
    assert (made["inset_m"], made["u_inset_m"]) == (0.30, 0.15) and wrong_m > 0.05
    assert abs(wrong_m) < made["U95_height_m"]

    shown = change(operator, vehicle, category="lorry")["measurements"][0]
    assert (shown["id"], shown["revision"], shown["inset_m"]) == (made["id"], 2, 0.03)
    assert shown["height_m"] == pytest.approx(BOX_M, abs=0.01)
    assert shown["U95_height_m"] < made["U95_height_m"]

    car = change(operator, vehicle, category="suv")["measurements"][0]
    assert (car["revision"], car["inset_m"], car["u_inset_m"]) == (3, 0.30, 0.10)
    same = change(operator, vehicle, category="estate")["measurements"][0]
    assert same["revision"] == 3, "the same inset: nothing is computed"
    with services.reading() as session:
        assert verify_records(session).ok


def test_whose_clicks_they_are_stays_when_somebody_else_says_class_or_side(
    operator: Client, reviewer: Client, services: Services, ground: Ground
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)
    measure(operator, vehicle["id"], **roof(BOX_M, TRUE_INSET_M))
    shown = change(reviewer, vehicle, category="lorry")["measurements"][0]
    assert (shown["revision"], shown["created_by"]["name"]) == (2, "Operator")
    found = reviewer.seen(f"/statistics?survey={ground.survey_id}&state=all")
    assert [one["name"] for one in found["operators"]] == ["Operator"]
    with services.reading() as session:
        assert verify_records(session).ok


def test_an_inset_of_its_own_stays_with_any_class(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, category="suv")
    own = roof(1.5, 0.4) | {"inset_m": 0.4, "u_inset_m": 0.02}
    made = measure(operator, vehicle["id"], **own)
    shown = change(operator, vehicle, category="bus")["measurements"][0]
    assert (shown["revision"], shown["inset_m"]) == (made["revision"], 0.4)


def test_the_inset_of_a_class_that_becomes_another_marks_its_roofs_alone(
    operator: Client, ground: Ground
) -> None:
    kinds = {"lorry": "roof_box", "van": "roof_van", "suv": "roof", None: "roof_unknown"}
    made = {}
    for category in kinds:
        facts = {"category": category} if category else {}
        vehicle = add_vehicle(operator, ground.recording_id, **facts)
        made[category] = measure(operator, vehicle["id"], **roof(2.5, 0.2))["id"]
    path = f"/surveys/{ground.survey_id}"
    for category, name in kinds.items():
        survey = operator.seen(path)
        words = {word: survey[word] for word in ("name", "site", "description", "version")}
        before = survey["insets"][name]
        told = {name: {**before, "inset_m": before["inset_m"] + 0.05}}
        assert operator.put(path, {**words, "insets": told}).status_code == 200
        stale = operator.seen(f"{path}/computings")["out_of_date"]["measurements"]
        assert set(map(int, stale)) == {made[category]}
        back = operator.seen(path)
        words = {word: back[word] for word in ("name", "site", "description", "version")}
        assert operator.put(path, {**words, "insets": {name: before}}).status_code == 200


def test_how_many_have_no_class_is_counted(operator: Client, ground: Ground) -> None:
    for facts in ({}, {}, {"category": "suv"}):
        vehicle = add_vehicle(operator, ground.recording_id, **facts)
        measure(operator, vehicle["id"], **roof(1.5, 0.3))
    counted = operator.seen(f"/statistics?survey={ground.survey_id}&state=all")["counted"]
    assert (counted["vehicles"], counted["without_class"]) == (3, 2)
