"""What a survey asks for by lighting; targets that cannot be seen are answers, with a reason and counted."""

from typing import Any

import pytest

from sightline.enums import AskedTarget, Lighting
from sightline.messages import say
from sightline.surveys.records import Asked
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle
from tests.support.ground import measure as measured


def change(client: Client, vehicle_id: int, **fields: Any) -> dict[str, Any]:
    version = client.seen(f"/vehicles/{vehicle_id}")["version"]
    answer = client.put(f"/vehicles/{vehicle_id}", json={"version": version, **fields})
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def state(client: Client, vehicle_id: int) -> str:
    return str(client.seen(f"/vehicles/{vehicle_id}")["state"])


@pytest.mark.parametrize(
    ("lighting", "wanted"),
    [
        ("daytime", ("roof", "driver_eye")),
        ("low_light", ("roof", "taillight")),
        (None, ("roof", "driver_eye", "taillight")),
    ],
)
def test_a_new_survey_asks_for_eyes_by_day_and_lamps_in_low_light(
    lighting: Lighting | None, wanted: tuple[AskedTarget, ...]
) -> None:
    assert Asked().of(lighting) == wanted


def test_measured_means_what_is_asked_for(operator: Client, ground: Ground) -> None:
    day = add_vehicle(operator, ground.recording_id, lighting="daytime")
    dusk = add_vehicle(operator, ground.recording_id, lighting="low_light")
    assert (day["asked"], dusk["asked"]) == (["roof", "driver_eye"], ["roof", "taillight"])
    for one in (day, dusk):
        measured(operator, one["id"])
        assert state(operator, one["id"]) == "partial"
        measured(operator, one["id"], target="driver_eye")
    assert (state(operator, day["id"]), state(operator, dusk["id"])) == ("measured", "partial")
    survey = operator.seen(f"/surveys/{ground.survey_id}")
    assert survey["counts"]["vehicles_measured"] == 1
    words = {name: survey[name] for name in ("name", "site", "description", "version")}
    asked = {"daytime": ["headlight"], "low_light": ["roof"]}
    twice = {**asked, "daytime": ["headlight", "headlight"]}  # said twice, asked once
    changed = operator.put(f"/surveys/{ground.survey_id}", json={**words, "asked": twice}).json()
    assert changed["asked"] == asked and changed["counts"]["vehicles_measured"] == 1
    assert (state(operator, day["id"]), state(operator, dusk["id"])) == ("partial", "measured")
    words["version"] += 1
    nothing = operator.put(
        f"/surveys/{ground.survey_id}", json={**words, "asked": {**asked, "low_light": []}}
    )
    assert nothing.status_code == 422 and "at least one target" in error_of(nothing)


def test_not_visible_is_an_answer_until_it_is_measured(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, lighting="daytime")["id"]
    change(operator, vehicle, driver_eye_not_visible="glare")
    assert state(operator, vehicle) == "partial"
    measured(operator, vehicle)
    assert state(operator, vehicle) == "measured"
    counts = operator.seen(f"/surveys/{ground.survey_id}")["counts"]
    assert (counts["vehicles_measured"], counts["not_visible"]) == (1, 1)
    assert told_of_vehicles(operator, ground) == "The vehicle is measured or not visible."
    eye = measured(operator, vehicle, target="driver_eye")
    found = operator.seen(f"/vehicles/{vehicle}")
    assert found["driver_eye_not_visible"] is None and found["state"] == "measured"
    assert eye["status"] == "ok"
    unseen = add_vehicle(operator, ground.recording_id, lighting="low_light")["id"]
    both = change(operator, unseen, roof_not_visible="hidden", taillight_not_visible="too_dark")
    assert both["state"] == "not_visible"
    counts = operator.seen(f"/surveys/{ground.survey_id}")["counts"]
    assert (counts["vehicles_measured"], counts["not_visible"]) == (2, 2)
    assert told_of_vehicles(operator, ground) == "All 2 vehicles are measured or not visible."


def told_of_vehicles(operator: Client, ground: Ground) -> str:
    steps = operator.seen(f"/surveys/{ground.survey_id}")["steps"]
    (step,) = (one for one in steps if one["key"] == "vehicles")
    return str(step["summary"][0]["message"])


def test_a_target_may_be_hidden_by_its_own_body(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)["id"]
    assert change(operator, vehicle, taillight_not_visible="own_body")["taillight_not_visible"] == "own_body"
    said = [say("not-visible-own_body", {}, language) for language in ("en", "fr")]
    assert said == ["hidden by its own body", "masqué par le véhicule lui-même"]


def test_what_is_measured_is_visible_and_only_an_eye_has_a_driver(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)["id"]
    measured(operator, vehicle)
    version = operator.seen(f"/vehicles/{vehicle}")["version"]
    for field, why, words in (
        ("roof_not_visible", "hidden", "withdraw"),
        ("taillight_not_visible", "no_driver", "driver"),
    ):
        refused = operator.put(f"/vehicles/{vehicle}", json={"version": version, field: why})
        assert refused.status_code == 422 and words in error_of(refused)
    assert operator.seen(f"/vehicles/{vehicle}")["version"] == version
