"""The sight-distance page's answer over a seeded survey: percentiles, crests, other fleets, refusals."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from sqlalchemy import text

from sightline.export.report.crest import crest_sentence
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.messages.said import Said
from sightline.results.measured_columns_query import NONE, Measured
from sightline.results.sightdistance import service
from sightline.results.sightdistance.records import SightQuestion
from sightline.results.sightdistance.service import HeightRead, case_of, exact_height
from sightline.results.survey_statistics import Filter, measured_columns
from sightline.results.usual_standards import STANDARDS
from sightline.sightdistance.curves import crest_constants_m
from sightline.sightdistance.workbench import Bounded
from sightline.statistics.rules import unknown_rule
from sightline.statistics.summary import Grouping
from tests.bench.seed import seed
from tests.support.app import Client, error_of

ASKED = "/sightdistance?survey={survey}&object_target=taillight"


@pytest.fixture
def survey(services: Services) -> int:
    """300 vehicles, each with roof, eye and taillight."""
    return seed(services.sessions, 900).survey.id


def heights(services: Services, target: str) -> np.ndarray[Any, Any]:
    """Those accepted, read without the page's own columns."""
    query = (
        "SELECT m.height_m, v.category FROM measurements m JOIN measurement_series s ON s.id = m.series_id "
        "JOIN vehicles v ON v.id = s.vehicle_id WHERE m.target = :target AND m.revision = "
        "(SELECT MAX(n.revision) FROM measurements n WHERE n.series_id = s.id) AND EXISTS (SELECT 1 FROM "
        "reviews r WHERE r.series_id = s.id AND r.result_revision = m.revision AND r.verdict = 'accepted')"
    )
    with services.reading() as session:
        rows = session.execute(text(query), {"target": target}).all()
    return np.array([tuple(row) for row in rows], dtype=[("height_m", float), ("category", "U20")])


def rule(viewer: Client, survey: int, what: str, percent: float) -> dict[str, Any]:
    """THE figure of a rule, as the statistics page has it."""
    rules = viewer.get(f"/statistics?survey={survey}").json()["rules"]
    return next(
        one for one in rules if one["standard"]["what"] == what and one["standard"]["percent"] == percent
    )


def assert_same(crest: dict[str, Any], figure: dict[str, Any]) -> None:
    """To the last digit."""
    assert (crest["value"], crest["low"], crest["high"]) == (
        figure["value_m"],
        figure["U95_low_m"],
        figure["U95_high_m"],
    )


def test_crests_by_the_standard_and_by_the_survey(services: Services, survey: int, viewer: Client) -> None:
    found = viewer.get(ASKED.format(survey=survey)).json()
    standard, of_survey = found["cases"]
    assert [round(standard["crest"]["constant_m"]["value"]), found["distance"]["design_m"]] == [658, 185]
    assert standard["comparison"] is None and standard["crest"]["constant_m"]["low"] is None
    eye = rule(viewer, survey, "eye_car", 10)
    thing = rule(viewer, survey, "object_stopping", 5)
    crest = of_survey["crest"]
    assert_same(crest["eye_m"], eye)
    assert_same(crest["object_m"], thing)
    cars = [heights(services, target) for target in ("driver_eye", "taillight")]
    cars = [one[np.isin(one["category"], ("hatchback", "saloon", "suv"))] for one in cars]
    raw = float(np.quantile(cars[0]["height_m"], 0.10))
    assert crest["eye_m"]["value"] == pytest.approx(raw, abs=0.01)
    constant = float(crest_constants_m(eye["value_m"], thing["value_m"]))
    assert crest["constant_m"]["value"] == pytest.approx(constant)
    assert crest["k_m"]["low"] < crest["k_m"]["value"] < crest["k_m"]["high"]
    assert of_survey["comparison"]["verdict"] == "shorter"  # the seed's taillights are high
    hundred = found["speeds_mps"].index(pytest.approx(100 / 3.6))
    assert standard["k_m"][hundred]["value"] == pytest.approx(52.0, abs=0.05)
    assert found["distances_m"][hundred] == 185
    assert found["of_class"] == "class" and (found["eyes"], found["objects"]) == (len(cars[0]), len(cars[1]))
    assert eye["n"] == found["eyes"] and thing["n"] == found["objects"]


def test_another_fleet_of_one_class_is_that_class(services: Services, survey: int, viewer: Client) -> None:
    found = viewer.get(ASKED.format(survey=survey) + "&share=suv:100&share=van:0&object_percent=10").json()
    eyes = heights(services, "driver_eye")
    suv = np.quantile(eyes["height_m"][eyes["category"] == "suv"], 0.10, method="median_unbiased")
    mix = found["cases"][2]
    assert mix["name"] == "mix"
    assert mix["crest"]["eye_m"]["value"] == pytest.approx(float(suv), abs=0.01)
    alone = viewer.get(ASKED.format(survey=survey) + "&category=suv&object_percent=10").json()["cases"][1][
        "crest"
    ]["eye_m"]
    assert mix["crest"]["eye_m"]["value"] == pytest.approx(alone["value"], abs=0.003)
    assert {one["category"] for one in found["classes"]} == {"hatchback", "saloon", "suv", "van"}


def test_another_fleet_of_several_sites_is_of_many(
    survey: int, viewer: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Vehicles dealt to three sites: the fleet of one class has the interval of that class."""

    def dealt(_: Any, found: Measured) -> Grouping:
        return Grouping(found.vehicle_id % 3, ("one", "two", "three"))

    monkeypatch.setattr(service, "sites_of", dealt)
    asked = ASKED.format(survey=survey) + "&eye_percent=50&object_percent=50"
    mix = viewer.seen(f"{asked}&share=suv:100&share=van:0")["cases"][2]["crest"]["eye_m"]
    alone = viewer.seen(f"{asked}&category=suv")["cases"][1]["crest"]["eye_m"]
    assert mix["value"] == pytest.approx(alone["value"], abs=0.003)
    assert mix["high"] - mix["low"] == pytest.approx(alone["high"] - alone["low"], rel=0.1)


def test_a_rule_is_read_on_those_of_its_class_that_are_chosen(
    services: Services, survey: int, viewer: Client
) -> None:
    eyes = heights(services, "driver_eye")
    for query, kept in (
        ("&category=suv", ("suv",)),
        ("&class_set=light_trucks&category=suv", ("suv",)),
        ("&class_set=light_trucks&class_set=passenger_cars", ("hatchback", "saloon", "suv")),
    ):
        found = viewer.get(ASKED.format(survey=survey) + query + "&eye_percent=15&object_percent=15").json()
        mine = eyes["height_m"][np.isin(eyes["category"], kept)]
        assert found["eyes"] == len(mine) and found["of_class"] == "chosen"
        quantile = np.quantile(mine, 0.15, method="median_unbiased")
        assert found["cases"][1]["crest"]["eye_m"]["value"] == pytest.approx(float(quantile), abs=0.01)
    found = viewer.seen(ASKED.format(survey=survey) + "&class_set=light_trucks")  # vans, no passenger car
    assert (found["eyes"], found["objects"], found["of_class"]) == (0, 0, "chosen")
    assert found["cases"][1]["missing"] == ["driver_eye", "taillight"]


@pytest.mark.parametrize(("unknown", "said_of"), [("driver_eye", "objects"), ("taillight", "eyes")])
def test_heights_without_a_class_are_not_said_to_be_of_one(
    services: Services,
    survey: int,
    viewer: Client,
    monkeypatch: pytest.MonkeyPatch,
    unknown: str,
    said_of: str,
) -> None:
    def read(session: Session, chosen: Filter) -> Measured:
        found = measured_columns(session, chosen)
        if chosen.target != unknown:
            return found
        return replace(found, category=np.full_like(found.category, NONE))

    monkeypatch.setattr(service, "measured_columns", read)
    found = viewer.seen(ASKED.format(survey=survey))
    assert found["of_class"] == said_of
    read_on = {"driver_eye": found["eyes"], "taillight": found["objects"]}
    assert read_on[unknown] == len(heights(services, unknown))


@pytest.mark.parametrize(
    ("eye", "thing", "expected"),
    [
        ((5, True), (5, True), "class"),
        ((5, True), (5, False), "eyes"),
        ((5, False), (0, True), "objects"),
        ((5, True), (0, False), "class"),
        ((0, True), (5, True), "class"),
        ((5, False), (5, False), "all"),
        ((0, False), (0, False), "all"),
    ],
    ids=str,
)
def test_whose_heights_both_are(eye: tuple[int, bool], thing: tuple[int, bool], expected: str) -> None:
    """(heights, whether of the rule's class) of each; a target without a height is of nobody."""
    none = Said("stat-none-of-class")
    first, second = (unknown_rule(STANDARDS[0], n, known, None, none) for n, known in (eye, thing))
    assert service.of_class(first, second, of_chosen=False) == expected
    assert service.of_class(first, second, of_chosen=True) == "chosen"


def test_a_class_of_too_few_gives_the_count_in_place_of_a_crest(survey: int, viewer: Client) -> None:
    found = viewer.get(ASKED.format(survey=survey) + "&category=suv").json()
    of_survey = found["cases"][1]
    assert of_survey["crest"] is None and of_survey["missing"] == [] and found["of_class"] == "chosen"
    n = found["objects"]
    assert 0 < n < 72
    assert [(one["target"], one["reason"]["message"]) for one in of_survey["too_few"]] == [
        ("taillight", f"P5 needs 72; there are {n}")
    ]


def test_eyes_of_trucks_are_read_by_the_rule_of_trucks(survey: int, viewer: Client) -> None:
    found = viewer.get(ASKED.format(survey=survey) + "&eye_what=eye_truck").json()
    assert found["eyes"] == 0 and found["cases"][1]["missing"] == ["driver_eye"]  # the seed has none
    assert viewer.get(ASKED.format(survey=survey) + "&eye_what=vehicle").status_code == 422


def test_feet_take_the_other_set_of_formulas(survey: int, viewer: Client) -> None:
    found = viewer.get(ASKED.format(survey=survey) + "&unit=ft&speed_mps=26.8224").json()
    assert round(found["distance"]["design_m"] / 0.3048) == 570
    assert found["distance"]["formula"].startswith("1.47 V t")


REFUSED = {
    "share=suv:60&share=van:30": "sum to 100",
    "share=lorry:100": "lorry",
    "share=suv": "suv:40",
    "eye_m=108": "metres",
    "speed_mps=-3": "design speed",
    "kind=passing&speed_mps=5": "30 to 130",
    "difference_percent=0": "grade difference",
}


def test_bad_input_is_one_sentence(survey: int, viewer: Client) -> None:
    for asked, word in REFUSED.items():
        answer = viewer.get(f"{ASKED.format(survey=survey)}&{asked}")
        assert answer.status_code == 422
        assert word in error_of(answer)


def test_a_survey_without_eyes_says_so(viewer: Client) -> None:
    found = viewer.get("/sightdistance?object_target=taillight").json()
    assert found["cases"][1]["crest"] is None
    assert found["cases"][1]["missing"] == ["driver_eye", "taillight"]
    alone = viewer.get("/sightdistance").json()
    assert alone["cases"][1]["missing"] == ["driver_eye"]


def test_the_share_in_the_sentence_is_that_of_k() -> None:
    """Where the sight distance reaches beyond the curve, its length changes by another share."""
    asked = SightQuestion(
        chosen=Filter(),
        eye_m=1.08,
        object_m=0.60,
        eye_percent=10.0,
        object_percent=5.0,
        object_target="taillight",
        kind="stopping",
        speed_mps=100 / 3.6,
        difference_percent=3.0,
        headlight_m=0.6,
        radius_m=500.0,
        shares={},
        unit="m",
    )
    standard = case_of(asked, "standard", exact_height(1.08), exact_height(0.60))
    read = (HeightRead(Bounded(1.16, 1.14, 1.18)), HeightRead(Bounded(0.75, 0.73, 0.77)))
    survey = case_of(asked, "survey", *read)
    assert standard.crest is not None and survey.crest is not None
    lengths_m = [one.crest.length_m.value for one in (standard, survey) if one.crest is not None]
    assert [round(one, 1) for one in lengths_m] == [150.7, 118.3]  # a fifth
    sentence = crest_sentence(asked, standard, survey) or ""
    assert "K could be 12.9" in sentence and "Crests could be" not in sentence
