"""Somebody who belongs to nothing: whatever number stands wherever, hidden and missing are answered alike.

Routes, paths, queries and bodies are those of the API's own description, so a new one is asked too; a kind of
thing that has no line in `hidden_things` fails.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from sightline.cameras.calibrations.records import Detection
from sightline.cameras.store import add_calibration_image
from sightline.export.store import add_export
from sightline.infra.audit import trail
from sightline.infra.audit.checkpoints import sign_checkpoint
from sightline.infra.audit.signing import signing_key
from sightline.infra.database import Session
from sightline.infra.jobs.store import create_job
from sightline.infra.services import Services
from sightline.infra.web.access import APART, THINGS
from sightline.measurements.again.store import add_computing
from sightline.people.store import create_person, create_sign_in_link
from sightline.people.token_store import create_api_token
from sightline.recordings.uploads.store import create_upload
from tests.support import samples, scans_samples
from tests.support.app import TUS, Client, error_of
from tests.surveys.test_named import NOT_THERE, Place, places

pytestmark = pytest.mark.dialect

#: What stands before a number in a path, and what the number is of; a study's result lies within the study.
TABLES = {**THINGS, "results": "study_results"}
#: What else stands in braces.
PLAIN = {"n": "20", "frame": "20", "picture": "first", "quantity": "speed", "source": "radar"}
PLAIN |= {"camera": "1", "number": "1", "level": "0", "index": "0"}


def hidden_things(session: Session) -> tuple[samples.Sample, dict[str, int]]:
    """A closed survey and a closed study with one of everything that has a number, and the numbers."""
    one = samples.sample(session, open_to_all=False)
    measured = samples.measure(session, one)
    made = scans_samples.vehicle(session, one)
    detection = Detection(True, None, [[1.0, 2.0]], columns=9, rows=6, sharpness=3.0)
    file: dict[str, Any] = {"name": "a.png", "media_key": "k", "width_px": 640, "height_px": 480}
    stored: dict[str, Any] = {"media_key": "z", "size_bytes": 1, "sha256": "0" * 64}
    by = {"actor": one.olga.id}
    study = samples.study(session, one)
    return one, {
        "surveys": one.survey.id,
        "survey_photographs": samples.photograph(session, one).id,
        "cameras": one.camera.id,
        "calibration_images": add_calibration_image(
            session, one.camera.id, **file, detection=detection, **by
        ).id,
        "calibrations": one.calibration.id,
        "uploads": create_upload(
            session, one.survey.id, filename="a.mp4", size_bytes=9, media_key="u", **by
        ).id,
        "recordings": one.recording.id,
        "road_poses": one.pose.id,
        "vehicles": one.vehicle.id,
        "measurement_series": measured.id,
        "computings": add_computing(session, one.survey.id, [], kind="asked", **by).id,
        "lots": samples.lot_of(session, one, measured.id).id,
        "scans": made.scan_id,
        "scan_vehicles": made.id,
        "scan_measurements": scans_samples.measured(session, one).id,
        "exports": add_export(
            session, one.survey.id, **stored, head=trail.head(session, one.survey.id), **by
        ).id,
        "jobs": create_job(session, "export", {}, survey_id=one.survey.id, **by).id,
        "studies": study.id,
        "study_results": samples.result_of_study(session, one, study).id,
    }


@dataclass
class Outsider:
    """A reviewer by account who belongs to nothing, and the numbers of what is hidden from them."""

    client: Client
    hidden: dict[str, int]
    one: samples.Sample
    asked: int = field(default=0)

    def ask(self, place: Place, numbers: dict[str, int]) -> Any:
        """A request in which each number is one of these."""

        def filled(found: re.Match[str]) -> str:
            kind, name = found[1], found[2]
            if not name.endswith("_id"):
                return f"/{kind}/{PLAIN[name]}"
            return f"/{kind}/{numbers[TABLES[kind]] if kind in TABLES else self.one.olga.id}"

        path = re.sub(r"/([a-z-]+)/\{(\w+)\}", filled, place.path)
        path = re.sub(r"\{(\w+)\}", lambda found: PLAIN[found[1]], path)
        sent: dict[str, Any] = {"headers": TUS}
        if place.where == "query":
            sent["params"] = {place.keys[0]: numbers[str(place.table)]}
        elif place.where != "path":
            sent["json"] = place.body(numbers[str(place.table)])
        self.asked += 1
        return self.client.http.request(place.method, path, **sent)


@pytest.fixture
def outsider(app: FastAPI, services: Services) -> Outsider:
    with services.writing() as session:
        one, hidden = hidden_things(session)
        person = create_person(session, name="Otto", email="otto@example.org", role="reviewer", actor=None)
        token = create_sign_in_link(session, person.id, actor=None)
    client = Client(TestClient(app, headers={"X-Sightline": "1"}, raise_server_exceptions=False))
    client.made("/session/link", {"token": token})
    return Outsider(client, hidden, one)


def in_paths(description: dict[str, Any]) -> Iterator[Place]:
    """Every number in a path that names a thing of a survey or a study."""
    for path, methods in description["paths"].items():
        for kind, name in re.findall(r"/([a-z-]+)/\{(\w+_id)\}", path):
            assert kind in TABLES or kind in APART, path
            if kind in TABLES:
                yield from (Place(method, path, "path", (name,), TABLES[kind]) for method in methods)


def said(answer: Any) -> str:
    """The whole body of an answer; numbers are those that were asked for."""
    return re.sub(r"\b\d+\b", "N", str(answer.text))


def test_there_is_one_of_everything_that_has_a_number(outsider: Outsider) -> None:
    assert set(outsider.hidden) == set(TABLES.values())
    assert NOT_THERE not in outsider.hidden.values()


def test_hidden_and_missing_are_answered_alike_everywhere(app: FastAPI, outsider: Outsider) -> None:
    description = app.openapi()
    named = [*in_paths(description), *(place for place in places(description) if place.table)]
    missing = dict.fromkeys(outsider.hidden, NOT_THERE)
    for place in named:
        unseen, nothing = outsider.ask(place, outsider.hidden), outsider.ask(place, missing)
        assert unseen.status_code == nothing.status_code == 404, (place, unseen.text, nothing.text)
        assert said(unseen) == said(nothing), place
        if unseen.text:
            error_of(unseen)
    assert outsider.asked == 2 * len(named) and len(named) > 200
    kinds = {place.where for place in named}
    assert kinds == {"path", "query", "application/json"}


def test_a_missing_thing_within_a_hidden_one_is_answered_alike(app: FastAPI, outsider: Outsider) -> None:
    """Of two numbers the hidden one comes first or last: the answer is the one for what is not there."""
    description = app.openapi()
    for place in places(description):
        if place.table and "{" in place.path:
            mixed = {**outsider.hidden, str(place.table): NOT_THERE}
            answer = outsider.ask(place, mixed)
            assert answer.status_code == 404, (place, answer.text)


def test_no_list_and_no_figure_names_what_is_hidden(app: FastAPI, outsider: Outsider) -> None:
    """Every question without a number, asked by somebody who belongs to nothing."""
    names = (outsider.one.survey.name, "Hills", outsider.one.recording.name, outsider.one.olga.name)
    described = app.openapi()["paths"].items()
    asked = [path for path, methods in described if "get" in methods and "{" not in path]
    assert len(asked) > 15
    for path in asked:
        answer = outsider.client.http.get(path)
        assert answer.status_code in (200, 403, 404, 422), (path, answer.text)
        for name in names:
            assert name not in answer.text, (path, name)


def test_jobs_of_what_is_hidden_are_as_if_not_there(outsider: Outsider, services: Services) -> None:
    """Of a survey and of a study: neither listed, nor stopped, nor done again."""
    by = {"actor": outsider.one.olga.id}
    with services.writing() as session:
        of = {"survey_id": None, "study_id": outsider.hidden["studies"]}
        made = [
            create_job(session, "export", {}, survey_id=outsider.hidden["surveys"], **by),
            create_job(session, "study", {"study_id": of["study_id"]}, **of, **by),
        ]
    assert outsider.client.seen("/jobs") == []
    for job in made:
        for method, path in (("GET", ""), ("POST", "/again"), ("POST", "/cancel")):
            unseen, nothing = (
                outsider.client.http.request(method, f"/api/jobs/{number}{path}")
                for number in (job.id, NOT_THERE)
            )
            assert unseen.status_code == nothing.status_code == 404, (method, path, unseen.text)
            assert said(unseen) == said(nothing)


def test_the_trail_of_no_survey_is_for_administrators(
    outsider: Outsider, admin: Client, services: Services
) -> None:
    """Checkpoints name every survey; tokens and jobs of studies are other people's."""
    with services.writing() as session:
        sign_checkpoint(session, signing_key(services.settings), actor=outsider.one.olga.id)
        create_api_token(session, outsider.one.olga.id, name="Gate", scopes=["read"], days=1)
        study = outsider.hidden["studies"]
        create_job(session, "study", {}, survey_id=None, study_id=study, actor=outsider.one.olga.id)
    for path in ("/audit", "/audit/events"):
        assert outsider.client.seen(path) == []
        for entity in ("checkpoint", "api_token", "job", "study", "person"):
            assert outsider.client.seen(f"{path}?entity={entity}") == []
            assert admin.seen(f"{path}?entity={entity}") != [], entity
    assert outsider.client.post("/audit/verify").status_code == 403
    assert admin.post("/audit/verify").status_code == 200
