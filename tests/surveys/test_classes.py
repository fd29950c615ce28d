"""Classes of vehicles: stored with their sets, edited, refused where they cannot be; closed words fit."""

import re
from typing import get_args

import pytest
from sqlalchemy import CheckConstraint, String

from sightline.enums import Category, ClassSet
from sightline.infra.database.types import metadata
from sightline.infra.services import Services
from sightline.infra.slices import load_tables
from sightline.results.measured_columns_query import CATEGORIES, CLASS_SETS, load_measured_columns
from sightline.surveys.classes import USUAL_CLASSES
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure

pytestmark = pytest.mark.dialect


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.mark.once
def test_the_usual_table_names_every_class_once() -> None:
    assert tuple(one.category for one in USUAL_CLASSES) == get_args(Category)
    assert {one.class_set for one in USUAL_CLASSES} == {*get_args(ClassSet), None}
    assert all(set(one.fhwa) <= set(range(1, 14)) for one in USUAL_CLASSES)
    of_fhwa = {number for one in USUAL_CLASSES for number in one.fhwa}
    assert of_fhwa == set(range(1, 14))


def test_a_class_is_put_into_another_set(operator: Client, viewer: Client, survey_id: int) -> None:
    path = f"/surveys/{survey_id}"
    before = operator.seen(path)["classes"]
    assert len(before) == 14
    suv = {"category": "suv", "class_set": "light_trucks", "eu": ["N1", "M1"], "fhwa": [3, 3]}
    changed = operator.put(path, {"name": "Rouen", "version": 1, "classes": [suv]}).json()["classes"]
    stored = {"category": "suv", "class_set": "light_trucks", "eu": ["M1", "N1"], "fhwa": [3]}
    assert changed == [stored if one["category"] == "suv" else one for one in before]
    (event, *_) = viewer.seen(f"/audit?survey_id={survey_id}")
    assert event["before"]["classes"]["suv"]["class_set"] == "passenger_cars"
    assert event["after"]["classes"]["suv"]["class_set"] == "light_trucks"
    assert operator.put(path, {"name": "Paris", "version": 2}).json()["classes"] == changed


@pytest.mark.once
def test_a_table_that_cannot_be_is_refused(operator: Client, survey_id: int) -> None:
    path = f"/surveys/{survey_id}"
    twice = operator.put(
        path, {"name": "Rouen", "version": 1, "classes": [{"category": "bus"}, {"category": "bus"}]}
    )
    assert twice.status_code == 422 and "bus" in error_of(twice) and "once" in error_of(twice)
    for wrong in (
        {"fhwa": [14]},
        {"fhwa": [0]},
        {"eu": ["M4"]},
        {"class_set": "taxis"},
        {"category": "tank"},
    ):
        body = {"name": "Rouen", "version": 1, "classes": [{"category": "bus", **wrong}]}
        assert operator.put(path, body).status_code == 422
    assert operator.seen(path)["version"] == 1


def test_every_class_comes_back_as_it_was_stored(
    operator: Client, ground: Ground, services: Services
) -> None:
    """Columns hold words as numbers: not one may come back as another, nor change the lighting beside it."""
    told = {}
    for n, category in enumerate(get_args(Category)):
        lighting = ("daytime", "low_light")[n % 2]
        car = add_vehicle(operator, ground.recording_id, category=category, lighting=lighting)
        told[measure(operator, car["id"])["id"]] = (category, lighting)
    with services.reading() as session:
        found = load_measured_columns(session, [ground.survey_id])
    sets = {one.category: one.class_set for one in USUAL_CLASSES}
    assert len(found) == len(told) == 14
    for k, id_ in enumerate(found.measurement_id.tolist()):
        category, lighting = told[id_]
        assert (CATEGORIES[found.category[k]], ("daytime", "low_light")[found.lighting[k]]) == (
            category,
            lighting,
        )
        assert (None if found.class_set[k] < 0 else CLASS_SETS[found.class_set[k]]) == sets[category]


def test_every_word_of_a_closed_list_fits_its_column() -> None:
    """PostgreSQL refuses a word that is too long for its column; SQLite would not say so."""
    load_tables()
    looked_at = 0
    for table in metadata.tables.values():
        for check in table.constraints:
            if not isinstance(check, CheckConstraint) or not str(check.name).endswith("_known"):
                continue
            name, listed = str(check.sqltext).split(" IN ")
            kind = table.columns[name].type
            assert isinstance(kind, String)
            for word in re.findall(r"'(\w+)'", listed):
                looked_at += 1
                assert kind.length is None or len(word) <= kind.length, (table.name, name, word)
    assert looked_at > 100
