"""The examples that the API's description gives of its commonest calls are sent to the app as they stand."""

from typing import Any

import pytest
from fastapi import FastAPI

from sightline.infra.services import Services
from sightline.people.service import set_password
from tests.support.app import Client
from tests.support.ground import lay_ground

#: In the order in which the work goes; each names what the calls before it made (all numbers are 1).
CALLS = (
    ("post", "/session"),
    ("post", "/session/tokens"),
    ("post", "/surveys"),
    ("put", "/recordings/{recording_id}"),
    ("put", "/surveys/{survey_id}/members/{person_id}"),
    ("post", "/recordings/{recording_id}/vehicles"),
    ("post", "/recordings/{recording_id}/geometry/height"),
    ("post", "/vehicles/{vehicle_id}/measurements"),
    ("post", "/vehicles/{vehicle_id}/follow"),
    ("post", "/measurements/{measurement_id}/reviews"),
    ("post", "/surveys/{survey_id}/exports"),
)


def example_of(description: dict[str, Any], method: str, path: str) -> Any:
    """The one example of a call's body."""
    body = description["paths"][f"/api{path}"][method]["requestBody"]["content"]["application/json"]["schema"]
    names = [one.get("$ref", "") for one in (body, *body.get("anyOf", ()))]
    (name,) = (name.rpartition("/")[2] for name in names if name)
    (example,) = description["components"]["schemas"][name]["examples"]
    return example


@pytest.fixture
def numbers(
    services: Services, admin: Client, operator: Client, survey_id: int, recording_id: int
) -> dict[str, int]:
    """What the paths name; the person of the example has an account and a password."""
    from sightline.people import service

    ground = lay_ground(services, survey_id, recording_id)
    example = {"email": "ada@example.org", "password": "a few words in a row"}
    made = admin.made("/people", {"name": "Ada", "email": example["email"], "role": "operator"})["person"]
    with services.writing() as session:
        set_password(session, made["id"], service._hasher.hash(example["password"]), actor=None)
    return {
        "survey_id": ground.survey_id,
        "recording_id": ground.recording_id,
        "person_id": made["id"],
        "vehicle_id": 1,
        "measurement_id": 1,
    }


def test_each_example_is_answered(
    app: FastAPI, admin: Client, operator: Client, reviewer: Client, numbers: dict[str, int]
) -> None:
    description = app.openapi()
    with_example = {
        name for name, schema in description["components"]["schemas"].items() if "examples" in schema
    }
    assert len(with_example) == len(CALLS), "each example is of one of the calls"
    for method, path in CALLS:
        who = {"put": admin}.get(method, reviewer if path.endswith("/reviews") else operator)
        body = example_of(description, method, path)
        answer = who.http.request(method, f"/api{path.format(**numbers)}", json=body)
        assert answer.status_code in (200, 201, 202), (path, answer.text)
    measured = operator.seen("/measurements/1")
    assert measured["status"] == "ok" and measured["height_m"] == pytest.approx(1.2, abs=0.1)
