"""Numbers of another survey's things, wherever a query or a body has a place for one: as if not there.

The places are those of the API's own description, so a field that is added is tried too; one that has neither
a type of its own nor a line here fails.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.web.access import THINGS
from sightline.infra.web.named import KEY
from sightline.people.store import create_sign_in_link
from sightline.recordings.uploads.store import create_upload
from sightline.surveys.members import store as members
from tests.support import samples, scans_samples
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect

#: Numbers that name nothing of a survey: amounts and places, what a person saw (a version), and the rows of
#: everybody (people, the catalogue) or of a list's page; and of a stream, what its recording is not.
NO_THING = {
    *("version", "other_version", "revision", "seen", "frame", "first_frame", "last_frame", "best_frame"),
    *(
        "frame_crc32",
        "every",
        "first",
        "count",
        "limit",
        "offset",
        "columns",
        "rows",
        "step",
        "start",
        "seed",
    ),
    *("seed", "wanted", "fhwa", "year", "year_from", "year_to", "width_px", "height_px", "x", "y", "w", "h"),
    *(
        "cut_1_px",
        "cut_2_px",
        "blind_one_in",
        "free_one_in",
        "vehicle",
        "before_id",
        "person_id",
        "operator",
    ),
    *("catalogue_id", "days", "minutes", "hour_from", "hour_to"),
    *("lines", "number", "others", "told"),
}


@dataclass(frozen=True)
class Place:
    """Where a number stands: in which request, under which names; `table` is what it names, if anything."""

    method: str
    path: str
    where: str
    keys: tuple[str, ...]
    table: str | None

    def body(self, number: int) -> Any:
        """A body that holds this number alone."""
        found: Any = number
        for key in reversed(self.keys):
            found = [found] if key == "[]" else {key: found}
        return found


def numbers(schema: Any, schemas: Any, keys: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Every number that a JSON schema takes: under which names, and what it names."""
    if "$ref" in schema:
        schema = schemas[schema["$ref"].rpartition("/")[2]]
    inner = [(keys, choice) for kind in ("anyOf", "oneOf", "allOf") for choice in schema.get(kind, ())]
    inner += [((*keys, key), value) for key, value in schema.get("properties", {}).items()]
    inner += [((*keys, "[]"), schema["items"])] if "items" in schema else []
    if isinstance(schema.get("additionalProperties"), dict):
        inner += [((*keys, "{}"), schema["additionalProperties"])]
    if schema.get("type") == "integer":
        yield keys, schema.get(KEY)
    for where, part in inner:
        yield from numbers(part, schemas, where)


def places(description: dict[str, Any]) -> Iterator[Place]:
    """Every number in a query or a body."""
    schemas = description["components"]["schemas"]
    for path, methods in description["paths"].items():
        for method, operation in methods.items():
            for asked in operation.get("parameters", ()):
                if asked["in"] == "query":
                    for _, table in numbers(asked["schema"], schemas):
                        yield Place(method, path, "query", (asked["name"],), table)
            for kind, body in operation.get("requestBody", {}).get("content", {}).items():
                for keys, table in numbers(body["schema"], schemas):
                    yield Place(method, path, kind, keys, table)


def everything(session: Session, people: tuple[str, str]) -> tuple[samples.Sample, dict[str, int]]:
    """A survey of two people's with one of everything that is named, and the numbers."""
    one = samples.sample(session, open_to_all=False, of=people)
    members.put_member(session, one.survey.id, one.rene.id, "manager", actor=None)
    measured = samples.measure(session, one, key=one.survey.id)
    upload = create_upload(
        session, one.survey.id, filename="a.mp4", size_bytes=9, media_key=f"u{one.survey.id}", actor=None
    )
    scanned = scans_samples.vehicle(session, one)
    return one, {
        "surveys": one.survey.id,
        "survey_photographs": samples.photograph(session, one).id,
        "cameras": one.camera.id,
        "calibrations": one.calibration.id,
        "recordings": one.recording.id,
        "road_poses": one.pose.id,
        "vehicles": one.vehicle.id,
        "measurement_series": measured.id,
        "lots": samples.lot_of(session, one, measured.id).id,
        "uploads": upload.id,
        "studies": samples.study_with_member(session, one).id,
        "scans": scanned.scan_id,
        "scan_vehicles": scanned.id,
    }


@dataclass(frozen=True)
class Asking:
    """Somebody who manages a survey, the numbers in it, and those of another one that they do not see."""

    client: Client
    mine: dict[str, int]
    theirs: dict[str, int]

    def ask(self, place: Place, number: int) -> Any:
        def known(found: re.Match[str]) -> str:
            number = 2 if found[1] == "frames" else self.mine[THINGS[found[1]]]
            return f"/{found[1]}/{number}"

        path = re.sub(r"/([a-z-]+)/\{\w+\}", known, place.path)
        if place.where == "query":
            return self.client.http.request(place.method, path, params={place.keys[0]: number})
        return self.client.http.request(place.method, path, json=place.body(number))


NOT_THERE = 4711


@pytest.fixture
def asking(app: FastAPI, services: Services) -> Asking:
    with services.writing() as session:
        _, theirs = everything(session, ("Olga", "Oscar"))
        one, mine = everything(session, ("Rita", "Rosa"))
        token = create_sign_in_link(session, one.rene.id, actor=None)
    assert all(theirs[table] != mine[table] for table in mine)
    client = Client(TestClient(app, headers={"X-Sightline": "1"}, raise_server_exceptions=False))
    client.made("/session/link", {"token": token})
    return Asking(client, mine, theirs)


@pytest.mark.once
def test_every_number_says_what_it_names(app: FastAPI) -> None:
    found = list(places(app.openapi()))
    for place in found:
        name = [key for key in place.keys if key not in ("[]", "{}")][-1]
        assert (place.table is None) == (name in NO_THING), place
        assert place.table is None or place.table in THINGS.values(), place
        assert place.where in ("query", "application/json"), f"a form's numbers are not looked at: {place}"
    assert {name for place in found if place.table is None for name in place.keys} >= NO_THING


def test_what_is_anothers_is_answered_like_what_is_not_there(app: FastAPI, asking: Asking) -> None:
    named = [place for place in places(app.openapi()) if place.table]
    assert len(named) >= 25
    for place in named:
        theirs = asking.theirs[str(place.table)]
        unseen, nothing = asking.ask(place, theirs), asking.ask(place, NOT_THERE)
        assert unseen.status_code == nothing.status_code == 404, (place, unseen.text, nothing.text)
        said = [re.sub(r"\b\d+\b", "N", error_of(one)) for one in (unseen, nothing)]
        assert said[0] == said[1], place
        own = asking.ask(place, asking.mine[str(place.table)])
        assert own.status_code != 404, (place, own.text)


def test_a_number_is_read_as_the_route_reads_it(asking: Asking) -> None:
    """Pydantic takes 7.0 and "7" for 7, and so does the check."""
    mine, theirs = asking.mine, asking.theirs
    for written in (f"{theirs['surveys']}.0", f"%20{theirs['surveys']}", f"+{theirs['surveys']}"):
        for path in (f"/surveys/{written}", f"/jobs?survey_id={written.replace('+', '%2B')}"):
            answer = asking.client.get(path)
            assert answer.status_code == 404, (path, answer.text)
    for number in (str(theirs["cameras"]), float(theirs["cameras"]), f"{theirs['cameras']}.0"):
        answer = asking.client.put(f"/recordings/{mine['recordings']}", {"name": "a", "camera_id": number})
        assert answer.status_code == 404, (number, answer.text)


def test_what_a_body_names_must_be_seen_and_lowers_no_role(asking: Asking, services: Services) -> None:
    """A study of a survey in which one is a viewer may be made: it is read from."""
    with services.writing() as session:
        person_id = asking.client.seen("/session")["person"]["id"]
        members.put_member(session, asking.theirs["surveys"], person_id, "viewer", actor=None)
    of = [{"survey_id": asking.theirs["surveys"], "year": 2026}]
    assert asking.client.post("/studies", {"name": "Both", "surveys": of}).status_code == 201
