"""Repeats: clicked again without seeing, in no list or result; a person's own click sigma fills in."""

from typing import Any

import numpy as np
import pytest

from sightline.infra.services import Services
from sightline.measurements.click_sigma_store import choose_click_sigma
from tests.support.app import Client, error_of
from tests.support.ground import (
    Ground,
    add_pose,
    add_vehicle,
    clicks,
    flat_camera,
    lay_ground,
    measure,
    pixel,
)

pytestmark = pytest.mark.dialect


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.fixture
def vehicle_id(operator: Client, ground: Ground) -> int:
    return int(add_vehicle(operator, ground.recording_id)["id"])


def test_a_repeat_stands_beside_what_it_repeats_and_in_no_list(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    first = measure(operator, vehicle_id, inset_m=0.2, u_inset_m=0.1)
    again = measure(
        reviewer,
        vehicle_id,
        target_point=pixel(0.6, 0.2, 1.22),
        repeat_of=first["id"],
        inset_m=None,
        u_inset_m=None,
    )
    assert again["repeat_of"] == first["id"] and first["repeat_of"] is None
    assert (again["inset_m"], again["u_inset_m"]) == (0.2, 0.1)
    assert again["height_m"] == pytest.approx(1.22, abs=1e-9)
    assert [one["id"] for one in operator.seen(f"/vehicles/{vehicle_id}")["measurements"]] == [first["id"]]
    queue = operator.seen(f"/surveys/{ground.survey_id}/review-queue")
    assert [one["measurement"]["id"] for one in queue] == [first["id"]]
    assert operator.seen(f"/surveys/{ground.survey_id}")["counts"]["measurements"] == 1
    assert operator.delete(f"/measurements/{again['id']}?revision=1").status_code == 200


@pytest.mark.once
def test_a_repeat_of_another_target_or_vehicle_is_refused(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    first = measure(operator, vehicle_id)
    other = add_vehicle(operator, ground.recording_id)["id"]
    body = {**clicks(), "client_key": "5c3ae0cf-7a0e-4f5b-9b25-9b1f2f1d1d01", "repeat_of": first["id"]}
    refused = operator.post(f"/vehicles/{other}/measurements", body)
    assert refused.status_code == 422 and "repeat" in error_of(refused)
    refused = operator.post(f"/vehicles/{vehicle_id}/measurements", {**body, "target": "taillight"})
    assert refused.status_code == 422 and "repeat" in error_of(refused)


def test_a_persons_own_sigma_fills_in_live_and_stored(
    operator: Client, reviewer: Client, services: Services, ground: Ground, vehicle_id: int
) -> None:
    me = operator.seen("/session")["person"]["id"]
    live_path = f"/recordings/{ground.recording_id}/geometry/height"
    usual = operator.post(live_path, clicks()).json()
    with services.writing() as session:
        choose_click_sigma(session, ground.survey_id, me, sigma_px=0.4, pairs=12, actor=me)
    live, stored = operator.post(live_path, clicks()).json(), measure(operator, vehicle_id)
    assert stored["sigma_px"] == 0.4
    assert stored["u_height_m"] == live["u_height_m"] < usual["u_height_m"]
    assert reviewer.post(live_path, clicks()).json()["u_height_m"] == usual["u_height_m"]
    with services.writing() as session:
        choose_click_sigma(session, ground.survey_id, me, sigma_px=None, pairs=12, actor=me)
    assert measure(operator, vehicle_id, target="taillight")["sigma_px"] == 1.0


def test_points_that_were_moved_after_a_repeat_are_not_compared_with_it_when_computed_again(
    operator: Client, reviewer: Client, services: Services, ground: Ground, work: Any, vehicle_id: int
) -> None:
    """Whoever sees how far apart the repeat lies may move their own points there."""
    first = measure(operator, vehicle_id)
    moved = pixel(0.6, 0.0, 1.24)
    measure(reviewer, vehicle_id, target_point=moved, repeat_of=first["id"])
    points = {name: value for name, value in clicks(1.24).items() if name != "target"}
    assert operator.put(f"/measurements/{first['id']}", {"revision": 1, **points}).status_code == 200
    path = f"/surveys/{ground.survey_id}/repeats"
    (before,) = reviewer.seen(path)["differences"]
    assert before["difference_m"] == pytest.approx(0.04, abs=1e-9)
    add_pose(services, ground.recording_id, ground.calibration_id, flat_camera())
    operator.made(f"/surveys/{ground.survey_id}/computings")
    work()
    found = reviewer.seen(path)
    assert (found["repeats"], found["differences"], found["not_compared"]) == (1, [], 1)


@pytest.mark.once
def test_a_repeat_is_compared_by_what_the_clicks_alone_let_one_expect(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    first = measure(operator, vehicle_id)
    for height_m in (1.203, 1.26):
        measure(reviewer, vehicle_id, target_point=pixel(0.6, 0.0, height_m), repeat_of=first["id"])
    near, far = reviewer.seen(f"/measurements/{first['id']}/repeats")
    clicks_u = sum(e["u_m"] ** 2 for e in first["budget"] if e["source"].startswith("click")) ** 0.5
    assert near["expected_m"] == pytest.approx(2 * clicks_u * 2**0.5, rel=0.05)
    assert near["expected_m"] < 2 * 2**0.5 * first["u_height_m"]
    assert near["agrees"] and near["difference_m"] == pytest.approx(0.003, abs=1e-6)
    assert not far["agrees"] and far["difference_m"] == pytest.approx(0.06, abs=1e-6)
    gone = near["repeat"]
    assert reviewer.delete(f"/measurements/{gone['id']}?revision=1").status_code == 200
    assert len(reviewer.seen(f"/measurements/{first['id']}/repeats")) == 1
    other_frame = measure(reviewer, vehicle_id, frame=first["frame"] + 1, repeat_of=first["id"])
    last = reviewer.seen(f"/measurements/{first['id']}/repeats")[-1]
    assert last["repeat"]["id"] == other_frame["id"] and last["difference_m"] is None
    assert "different frames" in last["reason"]["message"]


def clicked_beside(
    client: Client, vehicle_id: int, rng: np.random.Generator, x_m: float = 0.6, **more: Any
) -> dict[str, Any]:
    contact, point = (list(rng.normal(at, 0.5)) for at in (pixel(0.2, 0.0, 0.0), pixel(x_m, 0.0, 1.2)))
    return measure(client, vehicle_id, contact=contact, target_point=point, **more)


def test_figures_per_target_and_person_and_a_sigma_of_ones_own(
    operator: Client, reviewer: Client, ground: Ground
) -> None:
    rng = np.random.default_rng(8)
    me = operator.seen("/session")["person"]["id"]
    path = f"/surveys/{ground.survey_id}/repeats"
    choice = f"/surveys/{ground.survey_id}/people/{me}/click-sigma"
    assert operator.seen(path)["targets"] == []
    for n in range(12):
        vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
        first = clicked_beside(operator, vehicle_id, rng)
        clicked_beside(operator, vehicle_id, rng, repeat_of=first["id"])
        clicked_beside(reviewer, vehicle_id, rng, repeat_of=first["id"])
        if n == 8:
            refused = reviewer.put(choice, {"own": True})
            assert refused.status_code == 422 and "9" in error_of(refused) and "10" in error_of(refused)
    found = operator.seen(path)
    assert (found["repeats"], len(found["differences"]), found["not_compared"]) == (24, 24, 0)
    everything, roof = found["targets"]
    assert (everything["target"], roof["target"]) == (None, "roof")
    gauge = roof["gauge"]
    assert (gauge["n"], gauge["items"], gauge["persons"]) == (36, 12, 2)
    # 0.5 px clicks on a budget of 1 px: about half of what is claimed.
    assert roof["uncertainty_check"]["low"] < 0.5 < roof["uncertainty_check"]["high"] < 1
    assert (
        gauge["repeatability"]["low"]
        < roof["uncertainty_check"]["claimed"] / 2
        < gauge["repeatability"]["high"]
    )
    by_name = {one["person"]["name"]: one for one in found["people"]}
    mine, theirs = by_name["Operator"], by_name["Reviewer"]
    assert mine["pairs"] == 12 and mine["sigma"]["low"] < 0.5 < mine["sigma"]["high"]
    assert mine["may_choose"] and mine["items"] == 12
    assert theirs["pairs"] == 0 and theirs["sigma"]["sd"] is None
    assert "Reviewer" in theirs["sigma"]["reason"]["message"]
    assert mine["operator_bias_m"] == pytest.approx(-theirs["operator_bias_m"], abs=0.01)
    assert operator.put(choice, {"own": True}).status_code == 403
    chosen = reviewer.put(choice, {"own": True}).json()
    assert chosen["sigma_px"] == pytest.approx(mine["sigma"]["sd"], abs=0.001)
    assert measure(operator, vehicle_id, target="taillight")["sigma_px"] == chosen["sigma_px"]
    assert reviewer.put(choice, {"own": False}).json()["sigma_px"] is None


@pytest.mark.once
def test_where_along_its_edge_a_roof_is_clicked_is_no_part_of_a_sigma(
    operator: Client, ground: Ground
) -> None:
    rng = np.random.default_rng(10)
    for _ in range(8):
        vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
        first = clicked_beside(operator, vehicle_id, rng)
        clicked_beside(operator, vehicle_id, rng, x_m=0.9, repeat_of=first["id"])
    (me,) = operator.seen(f"/surveys/{ground.survey_id}/repeats")["people"]
    assert me["target_point"]["low"] > 5.0
    assert me["sigma"]["low"] < 0.5 < me["sigma"]["high"] < 1.5


def test_who_clicked_two_targets_is_one_person(operator: Client, reviewer: Client, ground: Ground) -> None:
    """What they lean by is told by target; how many they are is not."""
    rng = np.random.default_rng(11)
    for _ in range(3):
        vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
        for target in ("roof", "taillight"):
            first = clicked_beside(operator, vehicle_id, rng, target=target)
            clicked_beside(reviewer, vehicle_id, rng, target=target, repeat_of=first["id"])
    gauges = [one["gauge"] for one in operator.seen(f"/surveys/{ground.survey_id}/repeats")["targets"]]
    assert [(one["items"], one["persons"]) for one in gauges] == [(6, 2), (3, 2), (3, 2)]


@pytest.mark.once
def test_the_other_wheel_is_no_slip_of_the_hand(operator: Client, ground: Ground) -> None:
    rng = np.random.default_rng(9)
    for _ in range(6):
        vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
        first = clicked_beside(operator, vehicle_id, rng)
        clicked_beside(operator, vehicle_id, rng, repeat_of=first["id"])
        other = [first["contact"][0] - 60.0, first["contact"][1]]
        measure(
            operator, vehicle_id, contact=other, target_point=first["target_point"], repeat_of=first["id"]
        )
    (me,) = operator.seen(f"/surveys/{ground.survey_id}/repeats")["people"]
    assert me["contact"]["freedom"] == 12 and me["contact"]["high"] < 2


@pytest.mark.once
def test_what_is_drawn_to_click_again_shows_neither_points_nor_heights(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    first = measure(operator, vehicle_id)
    other = measure(operator, vehicle_id, target="taillight")
    path = f"/surveys/{ground.survey_id}/repeats/sample"
    assert reviewer.seen(path) == []
    drawn = reviewer.seen(f"{path}?only_own=false&count=5")
    assert {one["measurement_id"] for one in drawn} == {first["id"], other["id"]}
    names = ("measurement_id", "vehicle_id", "vehicle_number", "recording_id", "frame", "target")
    assert all(set(one) == set(names) for one in drawn)
    measure(operator, vehicle_id, repeat_of=first["id"])
    assert [one["measurement_id"] for one in operator.seen(path)] == [other["id"], first["id"]]


@pytest.mark.once
def test_a_correction_after_the_repeat_leaves_what_was_repeated(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    first = measure(operator, vehicle_id)
    measure(reviewer, vehicle_id, target_point=pixel(0.6, 0.0, 1.21), repeat_of=first["id"])
    assert operator.put(f"/measurements/{first['id']}", {**clicks(1.5), "revision": 1}).status_code == 200
    (difference,) = operator.seen(f"/surveys/{ground.survey_id}/repeats")["differences"]
    assert difference["difference_m"] == pytest.approx(0.01, abs=1e-6)
    assert (difference["first_person"]["name"], difference["person"]["name"]) == ("Operator", "Reviewer")


@pytest.mark.once
def test_on_another_frame_more_than_the_clicks_differs_and_has_a_figure_of_its_own(
    operator: Client, ground: Ground
) -> None:
    off_m = [0.004, -0.010, 0.012, -0.006, 0.020]
    for one in off_m:
        vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
        first = measure(operator, vehicle_id)
        there = {"frame": first["frame"] + 1, "contact": pixel(0.5, 0.0, 0.0)}
        measure(operator, vehicle_id, **there, target_point=pixel(0.9, 0.0, 1.2 + one), repeat_of=first["id"])
    found = operator.seen(f"/surveys/{ground.survey_id}/repeats")
    assert (found["repeats"], found["differences"], found["not_compared"]) == (5, [], 0)
    apart = operator.seen(f"/vehicles/{vehicle_id}")["measurements"][0]["height_m"] - 1.2
    expected_m = np.sqrt(np.mean([(one - apart) ** 2 / 2 for one in off_m]))
    elsewhere = found["targets"][1]["another_frame"]
    assert elsewhere["sd"] == pytest.approx(expected_m, rel=1e-6) and elsewhere["freedom"] == 5
    assert found["targets"][1]["gauge"]["repeatability"]["sd"] is None
