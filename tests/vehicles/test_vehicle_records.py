"""Vehicle records: numbered, completed, changed by one person at a time, taken out without being erased."""

import pytest

from tests.support.app import Client, error_of
from tests.support.ground import add_vehicle


def test_records_are_numbered_in_the_survey_and_listed_by_recording(
    operator: Client, survey_id: int, recording_id: int
) -> None:
    first = add_vehicle(operator, recording_id, make="Corvane", category="suv", best_frame=4)
    second = add_vehicle(operator, recording_id)
    assert (first["number"], second["number"]) == (1, 2)
    assert (first["state"], first["notes"], first["measurements"]) == ("to_do", "", [])
    listed = operator.seen(f"/surveys/{survey_id}/vehicles?recording_id={recording_id}")
    assert [one["id"] for one in listed] == [first["id"], second["id"]]
    other = operator.get(f"/surveys/{survey_id}/vehicles?recording_id={recording_id + 1}")
    assert other.status_code == 404
    assert operator.get(f"/surveys/{survey_id + 1}/vehicles").status_code == 404


def test_the_second_of_two_tabs_is_told_and_loses_nothing(
    operator: Client, admin: Client, recording_id: int
) -> None:
    vehicle = add_vehicle(operator, recording_id)
    path = f"/vehicles/{vehicle['id']}"
    mine = operator.put(path, {"version": 1, "make": "Corvane", "manufacturer_height_m": 1.624})
    assert mine.status_code == 200 and mine.json()["version"] == 2
    theirs = admin.put(path, {"version": 1, "make": "Tesmer"})
    assert theirs.status_code == 409
    body = theirs.json()
    assert "Operator" in body["error"]["message"] and "UTC" in body["error"]["message"]
    assert body["current"]["make"] == "Corvane" and body["current"]["version"] == 2
    assert operator.seen(path)["make"] == "Corvane"


def test_null_clears_and_what_is_left_out_stays(operator: Client, recording_id: int) -> None:
    vehicle = add_vehicle(operator, recording_id, make="Corvane", model="Lindo", notes="white")
    path = f"/vehicles/{vehicle['id']}"
    changed = operator.put(path, {"version": 1, "model": None, "notes": None}).json()
    assert (changed["make"], changed["model"], changed["notes"]) == ("Corvane", None, "")
    assert (changed["first_frame"], changed["last_frame"]) == (0, 8)


def test_taking_out_is_soft(operator: Client, survey_id: int, recording_id: int) -> None:
    vehicle = add_vehicle(operator, recording_id)
    path = f"/vehicles/{vehicle['id']}"
    assert operator.delete(path).status_code == 204
    assert operator.get(path).status_code == 404
    assert operator.seen(f"/surveys/{survey_id}/vehicles") == []
    assert operator.made(f"{path}/restore")["number"] == 1
    assert operator.post(f"{path}/restore").status_code == 409


@pytest.mark.parametrize(
    "wrong",
    [
        {"first_frame": 9, "last_frame": 3},
        {"last_frame": 999},
        {"best_frame": 11},
        {"category": "tank"},
        {"manufacturer_height_m": -1.0},
        {"manufacturer_height_m": 1624.0},
        {"year": 12},
        {"year": 2090},
        {"lighting": "dusk"},
        {"make": "x" * 300},
    ],
)
def test_a_record_that_cannot_be_is_refused_in_words(
    operator: Client, survey_id: int, recording_id: int, wrong: dict[str, object]
) -> None:
    body = {"first_frame": 0, "last_frame": 8, **wrong}
    answer = operator.post(f"/recordings/{recording_id}/vehicles", body)
    assert answer.status_code == 422, answer.text
    error_of(answer)
    assert operator.seen(f"/surveys/{survey_id}/vehicles") == []
