"""A judged height that is replaced and put back: its verdict comes back with it, and is vouched for."""

import csv
import io
from pathlib import Path
from typing import Any

import pytest

from sightline.infra.services import Services
from sightline.measurements.again.verify import put_back, verdict_gone_over
from tests.measurements.test_second_frame import exported, on_frame, rewritten
from tests.support.app import Client
from tests.support.ground import Ground, clicks, measure, pixel
from tests.support.mutations import checked

ONE = {**on_frame(2, 0.0), "target": "driver_eye", "inset_m": 0.9, "u_inset_m": 0.1}
TWO = {**ONE, "more_frames": [on_frame(7, 1.8)]}
BY_HAND = (clicks(1.2), clicks(1.25))
TWO_FRAMES = (ONE, TWO)
TO_ONE_FRAME = (TWO, ONE)


def judge(client: Client, one: dict[str, Any], verdict: str, **more: Any) -> Any:
    body = {"revision": one["revision"], "verdict": verdict, **more}
    return client.made(f"/measurements/{one['id']}/reviews", body)


def put(client: Client, one: dict[str, Any], body: dict[str, Any]) -> dict[str, Any]:
    """The points as the page sends them: with the click's own sigma, and the revision that was seen."""
    answer = client.put(f"/measurements/{one['id']}", {**body, "revision": one["revision"], "sigma_px": 1.0})
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


@pytest.mark.dialect
@pytest.mark.parametrize(("was", "becomes"), [BY_HAND, TWO_FRAMES, TO_ONE_FRAME])
@pytest.mark.parametrize("verdict", ["accepted", "rejected"])
def test_undo_brings_the_verdict_back_with_the_height(
    operator: Client,
    reviewer: Client,
    vehicle_id: int,
    was: dict[str, Any],
    becomes: dict[str, Any],
    verdict: str,
) -> None:
    first = measure(operator, vehicle_id, **{"more_frames": [], **was})
    judged = judge(reviewer, first, verdict, reason="The tyre is hidden.")
    moved = put(operator, judged, becomes)
    assert moved["height_m"] != first["height_m"]
    assert moved["review"] == {**moved["review"], "verdict": "to_review", "reviewer": None}
    back = put(operator, moved, was)
    assert (back["revision"], back["height_m"]) == (3, first["height_m"])
    assert back["review"] == judged["review"] and back["review"]["reviewer"]["name"] == "Reviewer"
    redone = put(operator, back, becomes)
    assert redone["review"]["verdict"] == "to_review"
    assert put(operator, redone, was)["review"] == judged["review"]


@pytest.mark.dialect
def test_the_last_verdict_on_the_height_is_what_comes_back(
    operator: Client, reviewer: Client, vehicle_id: int
) -> None:
    was, becomes = BY_HAND
    one = judge(reviewer, measure(operator, vehicle_id, **was), "rejected", reason="A mirror.")
    one = put(operator, put(operator, one, becomes), was)
    one = judge(reviewer, one, "accepted")
    between = judge(reviewer, put(operator, one, becomes), "rejected", reason="Beside the roof.")
    assert put(operator, between, was)["review"]["verdict"] == "accepted"


@pytest.mark.dialect
def test_a_withdrawal_that_is_undone_leaves_the_verdict_as_it_was(
    operator: Client, reviewer: Client, vehicle_id: int
) -> None:
    one = judge(reviewer, measure(operator, vehicle_id), "rejected", reason="A mirror.")
    path = f"/measurements/{one['id']}"
    gone = operator.delete(f"{path}?revision=1").json()
    assert gone["withdrawn"] and gone["review"]["verdict"] == "to_review"
    assert operator.made(f"{path}/restore", {"revision": 2})["review"] == one["review"]


@pytest.mark.dialect
@pytest.mark.parametrize(
    "nearly",
    [
        {"inset_m": 0.05},
        {"target": "headlight"},
        {"frame": 3},
        {"target_point": pixel(0.6, 0.0, 1.2001)},
        {"contact": pixel(0.2001, 0.0, 0.0)},
    ],
)
def test_what_is_not_the_very_same_waits_for_a_reviewer(
    operator: Client, reviewer: Client, vehicle_id: int, nearly: dict[str, Any]
) -> None:
    was, becomes = BY_HAND
    one = judge(reviewer, measure(operator, vehicle_id, **was), "accepted")
    back = put(operator, put(operator, one, becomes), {**was, **nearly})
    assert back["review"]["verdict"] == "to_review"


@pytest.mark.once
def test_the_chain_vouches_for_the_verdict_that_came_back(
    operator: Client,
    reviewer: Client,
    services: Services,
    ground: Ground,
    vehicle_id: int,
    tmp_path: Path,
) -> None:
    one = judge(reviewer, measure(operator, vehicle_id, **{**ONE, "more_frames": []}), "accepted")
    put(operator, put(operator, one, TWO), ONE)
    newest, *_ = operator.seen(f"/audit?survey_id={ground.survey_id}&entity=measurement")
    assert newest["after"]["row"]["verdict_of_revision"] == 1 and newest["after"]["revision"] == 3
    files = exported(services, ground.survey_id, tmp_path / "export")
    assert checked(files).ok, checked(files).problem
    (row,) = csv.DictReader(io.StringIO(files["tables/measurements.csv"].decode()))
    assert (row["verdict"], row["verdict_of_revision"], row["revision"]) == ("accepted", "1", "3")
    forged = rewritten(files, "measurements.csv", "verdict", "to_review")
    assert "newest review" in str(checked(forged).problem)

    # whoever writes the events anew too is found by the clicks and the height
    revisions = list(csv.DictReader(io.StringIO(files["tables/revisions.csv"].decode())))
    assert gone_over(revisions, [0, 0, 1]) is None
    assert gone_over(revisions, [0, 1, 0]) == revisions[1]  # the moved one is not the one accepted
    assert gone_over(revisions, [0, 0, 2]) == revisions[2]
    for name, other in (("target_y_px", "99.5"), ("height_m", "1.5"), ("frame", "4"), ("frame2", "7")):
        changed = {**revisions[2], name: other}
        assert gone_over([*revisions[:2], changed], [0, 0, 1]) == changed, name
    # of a height whose verdict went over to it itself
    again = {**revisions[2], "revision": "4"}
    moved = {**revisions[1], "revision": "4"}
    assert gone_over([*revisions, again], [0, 0, 1, 1]) is None
    assert gone_over([*revisions, moved], [0, 0, 1, 1]) == moved


def gone_over(revisions: list[dict[str, str]], judged: list[int]) -> Any:
    return verdict_gone_over(revisions, judged, {}, set(), put_back)
