"""Which model fits: heights and tyres of a vehicle against the catalogue, and the model that cannot be it."""

from typing import Any

import pytest

from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, lay_ground, measure, pixel


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def add_model(client: Client, model: str, **sizes: Any) -> None:
    client.made("/catalogue", {"make": "Tesmer", "model": model, "source": "test", **sizes})


def asked(client: Client, vehicle_id: int) -> Any:
    return client.seen(f"/vehicles/{vehicle_id}/which-model")


def test_reasons_come_before_anything_is_measured(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)["id"]
    assert asked(operator, vehicle)["reason"]["code"] == "models-none-in-catalogue"
    add_model(operator, "Juna", wheelbase_m=2.0)
    said = asked(operator, vehicle)
    assert said["fitting"] == [] and said["reason"]["code"] == "models-nothing-measured"
    assert all(one["reason"] for one in said["measured"])
    measure(operator, vehicle, target="taillight", height_m=0.74)
    assert asked(operator, vehicle)["reason"]["code"] == "models-no-such-size"


def test_tyres_rank_the_models_and_the_wrong_one_is_flagged_and_not_listed(
    operator: Client, viewer: Client, ground: Ground
) -> None:
    add_model(operator, "Juna", wheelbase_m=2.0, taillight_m=0.74)
    add_model(operator, "Ayla", wheelbase_m=2.08, taillight_m=0.74)
    add_model(operator, "Taiga", wheelbase_m=2.9, taillight_m=0.74)
    add_model(operator, "Blank")
    vehicle = add_vehicle(operator, ground.recording_id, make="Tesmer", model="Taiga")["id"]
    pair = {"frame": 2, "first": pixel(-1.0, 0.0, 0.0), "second": pixel(1.0, 0.0, 0.0)}
    operator.made(f"/vehicles/{vehicle}/wheel-pair", pair)
    measure(operator, vehicle, target="taillight", height_m=0.74)
    said = asked(viewer, vehicle)
    sizes = {one["size"]: one["value_m"] for one in said["measured"]}
    assert sizes["wheelbase"] == pytest.approx(2.0) and sizes["height"] is None
    assert [one["entry"]["model"] for one in said["fitting"]] == ["Juna", "Ayla"]
    assert (said["ranked_by"], said["fit"], said["cannot_fit"]) == (["wheelbase"], 2, 1)
    first, chosen = said["fitting"][0], said["chosen"]
    assert not first["cannot"] and first["compared"] == 2
    assert chosen["entry"]["model"] == "Taiga" and chosen["cannot"] and chosen["p"] < said["limit_p"]
    assert operator.get("/vehicles/999999/which-model").status_code == 404


def test_no_measured_height_ranks_it_only_strikes_out(
    operator: Client, viewer: Client, ground: Ground
) -> None:
    """The model whose roof is nearest to the measured one was the first of the list, and then its truth."""
    for model, more in {
        "Corva": {"height_m": 1.23, "category": "saloon"},
        "Alto": {"height_m": 1.21, "category": "suv"},
        "Berta": {"height_m": 1.20, "category": "suv"},
        "Dora": {"height_m": 1.40, "category": "saloon"},
    }.items():
        add_model(operator, model, **more)
    vehicle = add_vehicle(operator, ground.recording_id)["id"]
    measure(operator, vehicle, height_m=1.2)
    said = asked(viewer, vehicle)
    assert [one["entry"]["model"] for one in said["fitting"]] == ["Alto", "Berta", "Corva"]
    assert (said["ranked_by"], said["fit"], said["cannot_fit"], said["reason"]) == ([], 3, 1, None)
    operator.put(f"/vehicles/{vehicle}", {"category": "saloon", "version": 1})
    assert [one["entry"]["model"] for one in asked(viewer, vehicle)["fitting"]] == ["Corva", "Alto", "Berta"]


def test_a_model_of_other_years_is_none_of_the_vehicle(
    operator: Client, viewer: Client, ground: Ground
) -> None:
    add_model(operator, "Corva", height_m=1.2, year_from=2001, year_to=2008)
    vehicle = add_vehicle(operator, ground.recording_id, year=2012)["id"]
    measure(operator, vehicle, height_m=1.2)
    said = asked(viewer, vehicle)
    assert said["fitting"] == [] and said["reason"]["code"] == "models-none-of-year"
    assert "2012." in said["reason"]["message"]
    add_model(operator, "Alto", height_m=1.2, year_from=2009)
    add_model(operator, "Berta", height_m=1.2)
    said = asked(viewer, vehicle)
    assert [one["entry"]["model"] for one in said["fitting"]] == ["Alto", "Berta"]
    assert (said["fit"], said["cannot_fit"], said["reason"]) == (2, 0, None)


def test_where_no_model_can_be_it_that_is_said(operator: Client, ground: Ground) -> None:
    add_model(operator, "Dora", height_m=1.6)
    vehicle = add_vehicle(operator, ground.recording_id)["id"]
    measure(operator, vehicle, height_m=1.2)
    said = asked(operator, vehicle)
    assert said["fitting"] == [] and said["cannot_fit"] == 1
    assert said["reason"]["code"] == "models-none-fits"
