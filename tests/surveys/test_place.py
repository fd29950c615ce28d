"""The place of a survey: coordinates, road, speed limit, lamps, zone; and what cannot be true of it."""

from typing import Any

import pytest

from tests.support.app import Client

ROUEN = {
    "latitude_deg": 49.44315,
    "longitude_deg": 1.09932,
    "road_class": " urban arterial ",
    "lane": "lane 1, next to the verge",
    "travel_direction": "towards the south",
    "speed_limit_mps": 50 / 3.6,
    "street_lamps": "present",
    "time_zone": "Europe/Paris",
}


def test_a_survey_has_its_place(operator: Client) -> None:
    made = operator.made("/surveys", {"name": "Rouen", "place": ROUEN})
    assert made["place"] == {**ROUEN, "road_class": "urban arterial"}
    same = operator.put(f"/surveys/{made['id']}", {"name": "Rouen", "version": 1}).json()
    assert same["place"] == made["place"]
    nothing = {"name": "Rouen", "version": 2, "place": {}}
    assert set(operator.put(f"/surveys/{made['id']}", nothing).json()["place"].values()) == {None}


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        ({"latitude_deg": None}, "surveys-place-half-coordinates"),
        ({"latitude_deg": 149.4}, "surveys-place-latitude"),
        ({"longitude_deg": -181.0}, "surveys-place-longitude"),
        ({"speed_limit_mps": 0.0}, "surveys-place-speed-limit"),
        ({"speed_limit_mps": 500.0}, "surveys-place-speed-limit"),
        ({"time_zone": "Europe/Rouen"}, "local-time-unknown-zone"),
    ],
)
def test_what_cannot_be_true_of_a_place_is_said(operator: Client, wrong: dict[str, Any], code: str) -> None:
    answer = operator.post("/surveys", {"name": "Rouen", "place": {**ROUEN, **wrong}})
    assert answer.status_code == 422
    assert answer.json()["error"]["code"] == code
