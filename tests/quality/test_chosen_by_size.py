"""A model chosen because it fits what was measured is no reference: errors, checks, adjustment, package."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.services import Services
from sightline.studies.packages import read_packages
from sightline.studies.query import StudyTables
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure, pixel
from tests.support.packages import edit, reseal, rows, written

pytestmark = pytest.mark.dialect
BY_SIZE = {"model_chosen_by": "size", "model_sizes": "wheelbase height"}
KNOWN = {
    "make": "Tesmer",
    "model": "Juna",
    "manufacturer_height_m": 1.19,
    "u_manufacturer_height_m": 0.005,
    "known_taillight_m": 0.72,
    "known_driver_eye_m": 1.10,
}
TYRES = {"frame": 2, "first": pixel(-1.0, 0.0, 0.0), "second": pixel(1.0, 0.0, 0.0)}


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.fixture
def cars(operator: Client, reviewer: Client, ground: Ground) -> list[dict[str, Any]]:
    """Four roofs of 1.20 m beside a maker's 1.19 m, accepted; the last car's model was chosen by size."""
    operator.made("/catalogue", {"make": "Tesmer", "model": "Juna", "wheelbase_m": 2.0, "source": "test"})
    made = []
    for more in ({}, {}, {}, BY_SIZE):
        car = add_vehicle(operator, ground.recording_id, category="saloon", **KNOWN, **more)
        operator.made(f"/vehicles/{car['id']}/wheel-pair", TYRES)
        for target, height_m in (("roof", 1.2), ("taillight", 0.73), ("driver_eye", 1.12)):
            one = measure(operator, car["id"], target=target, height_m=height_m)
            reviewer.made(f"/measurements/{one['id']}/reviews", {"revision": 1, "verdict": "accepted"})
        made.append(car)
    return made


def counts(client: Client, ground: Ground) -> tuple[int, int, int, int, int]:
    """How often the cars serve: roofs and lamps among errors, roofs for the inset, tyres, roofs adjusting."""
    page = client.seen(f"/statistics?survey={ground.survey_id}")
    known_errors = {one["target"]: one["groups"][0]["n"] for one in page["known_errors"]}
    lamps, table = known_errors["taillight"], page["errors"]["groups"]
    roofs = next(one["n"] for one in table if one["group"] == "overall")
    assert roofs == known_errors["roof"] == page["counted"]["with_reference"]
    assert known_errors["driver_eye"] == lamps  # of each car one
    insets = client.seen(f"/surveys/{ground.survey_id}/checks/insets")["targets"]
    known = [
        way["vehicles"] for one in insets for way in one["estimates"] if way["method"] == "known_heights"
    ]
    (pose,) = client.seen(f"/surveys/{ground.survey_id}/checks/adjustment")
    return roofs, lamps, max(known), pose["tyres"], pose["roofs"]


def test_it_counts_nowhere_until_somebody_says_that_the_model_was_seen(
    operator: Client, viewer: Client, ground: Ground, cars: list[dict[str, Any]]
) -> None:
    assert counts(viewer, ground) == (3, 3, 3, 3, 3)
    assert viewer.seen(f"/statistics?survey={ground.survey_id}")["counted"]["by_size"] == 1
    (pose,) = viewer.seen(f"/surveys/{ground.survey_id}/checks/adjustment")
    assert {one["reason"]["code"] for one in pose["left_out"]} == {"adjustment-model-by-size"}
    # another height of the same model is no better
    changed = operator.put(f"/vehicles/{cars[3]['id']}", {"manufacturer_height_m": 1.18, "version": 1}).json()
    assert (changed["model_chosen_by"], changed["model_sizes"]) == ("size", "wheelbase height")
    assert counts(viewer, ground) == (3, 3, 3, 3, 3)
    seen = operator.put(f"/vehicles/{cars[3]['id']}", {"model_chosen_by": "seen", "version": 2}).json()
    assert (seen["model_chosen_by"], seen["model_sizes"]) == ("seen", "wheelbase height")
    assert counts(viewer, ground) == (4, 4, 4, 4, 4)
    assert viewer.seen(f"/statistics?survey={ground.survey_id}")["counted"]["by_size"] == 0


def test_a_height_chosen_by_size_is_neither_an_error_in_review_nor_a_doubt(
    operator: Client, reviewer: Client, ground: Ground
) -> None:
    by_size: dict[int, bool] = {}
    for n, more in enumerate(({}, BY_SIZE)):
        car = add_vehicle(operator, ground.recording_id, manufacturer_height_m=1.4, **more)
        by_size[car["id"]] = bool(more)
        measure(operator, car["id"])
        doubts = operator.seen(f"/vehicles/{car['id']}")["doubts"]
        assert [one["kind"] for one in doubts] == (["far_from_maker"] if n == 0 else [])
    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")
    errors = {by_size[one["vehicle"]["id"]]: one["judged"]["error_m"] for one in queue}
    assert errors[False] == pytest.approx(-0.2, abs=1e-3) and errors[True] is None


@pytest.mark.once
def test_a_makers_height_without_a_u_is_no_exact_one(
    operator: Client, reviewer: Client, ground: Ground
) -> None:
    """The doubt and the sign for a reviewer take the same u of a maker's height of which nobody said one."""
    car = add_vehicle(operator, ground.recording_id)
    roof = measure(operator, car["id"], sigma_px=3.0)
    u_m = roof["u_height_m"]
    aside_m = 1.96 * (u_m + np.hypot(u_m, 0.03 / np.sqrt(3.0))) / 2.0  # beyond U95 of the roof, not of both
    assert aside_m > 0.08
    told = {"manufacturer_height_m": roof["height_m"] + aside_m, "version": 1}
    assert operator.put(f"/vehicles/{car['id']}", told).json()["doubts"] == []
    judged = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")[0]["judged"]
    assert "far_from_maker" not in judged["signs"] and judged["error_m"] == pytest.approx(-aside_m)
    exact = {"u_manufacturer_height_m": 0.0, "version": 2}
    (doubt,) = operator.put(f"/vehicles/{car['id']}", exact).json()["doubts"]
    assert doubt["kind"] == "far_from_maker"


@pytest.mark.once
def test_the_package_says_it_and_computes_the_same_from_its_files(
    services: Services, viewer: Client, ground: Ground, cars: list[dict[str, Any]], tmp_path: Path
) -> None:
    place = written(services, ground.survey_id, tmp_path / "package")
    told = [(row["model_chosen_by"], row["model_sizes"]) for row in rows(place, "vehicles.csv")]
    assert told == [("", ""), ("", ""), ("", ""), ("size", "wheelbase height")]
    references = [row["reference_height_m"] for row in rows(place, "clicks.csv") if row["target"] == "roof"]
    assert references == ["1.190000", "1.190000", "1.190000", ""]
    with StudyTables(read_packages([place], lambda _files: None, tmp_path)) as tables:
        told_m = tables.heights("roof").known_m
    assert np.sort(told_m)[:3].tolist() == [1.19] * 3 and np.isnan(told_m).sum() == 1
    found = verify_package(FolderFiles(place))
    assert found.ok, found.problem
    # who takes the word out makes a reference of it, and is found
    edit(place, "vehicles.csv", lambda row: row["model_chosen_by"] == "size", model_chosen_by="seen")
    reseal(place, page=True)
    assert not verify_package(FolderFiles(place)).ok


def test_how_a_model_was_chosen_is_said_whole(operator: Client, ground: Ground) -> None:
    car = add_vehicle(operator, ground.recording_id)["id"]
    bare = operator.put(f"/vehicles/{car}", {"model_chosen_by": "size", "version": 1})
    assert bare.status_code == 422 and "needs the sizes" in error_of(bare)
    wrong = operator.put(f"/vehicles/{car}", {**BY_SIZE, "model_sizes": "colour", "version": 1})
    assert wrong.status_code == 422 and error_of(wrong).startswith(
        "colour is not a size of a model; give some of"
    )
    operator.put(f"/vehicles/{car}", {**BY_SIZE, "version": 1})
    named = operator.put(f"/vehicles/{car}", {"model_chosen_by": None, "version": 2}).json()
    assert (named["model_chosen_by"], named["model_sizes"]) == (None, None)
