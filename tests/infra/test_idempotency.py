"""A write that is sent again with its `Idempotency-Key` is stored once, whatever became of its answer."""

import random
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import timedelta
from typing import get_type_hints
from uuid import uuid4

import httpx2
import pytest
from fastapi import FastAPI
from fastapi.routing import APIRoute
from sqlalchemy import func, select, update

from sightline.app import ROUTERS
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import DatabaseAway
from sightline.infra.database.types import now
from sightline.infra.idempotency import store
from sightline.infra.idempotency.tables import idempotency_keys
from sightline.infra.services import Services
from sightline.infra.web import idempotency
from sightline.infra.web.idempotency import REPLAYED, TOLD_ONCE
from sightline.people.store import update_person
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, clicks, lay_ground, measure

pytestmark = pytest.mark.dialect


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


#: Where a process may end while it stores something, and what is lost then.
KILLED = ("before the commit", "before the answer is kept", "before the answer is heard")


@contextmanager
def _killed(place: str) -> Iterator[None]:
    """The server ends at a place, as far as what is stored goes."""
    with pytest.MonkeyPatch.context() as patch:
        if place == "before the commit":
            patch.setattr("sightline.infra.audit.trail.chain_hash", _end)
        if place == "before the answer is kept":
            patch.setattr(idempotency, "keep_answers", _end)
        yield


def _end(*_given: object) -> None:
    raise DatabaseAway("database-no-answer")


def _events(services: Services) -> int:
    with services.reading() as session:
        return session.execute(select(func.count()).select_from(audit_events)).scalar_one()


def _key() -> dict[str, str]:
    return {"Idempotency-Key": str(uuid4())}


Send = Callable[[dict[str, str]], httpx2.Response]


def _writes(operator: Client, reviewer: Client, ground: Ground) -> dict[str, Send]:
    """Writes of every way in which routes store: a short one, a session, a transaction of its own."""
    vehicles = [add_vehicle(operator, ground.recording_id) for _ in range(5)]
    first, second, third, fourth, fifth = (int(one["id"]) for one in vehicles)
    revised, withdrawn, judged = (measure(operator, one) for one in (first, second, third))
    survey, recording = f"/surveys/{ground.survey_id}", ground.recording_id
    span = {"first_frame": 1, "last_frame": 3}
    verdict = {"revision": 1, "verdict": "accepted"}
    clicked = {**clicks(1.25), "client_key": str(uuid4())}
    return {
        "add a vehicle": lambda headers: operator.post(
            f"/recordings/{recording}/vehicles", span, headers=headers
        ),
        "change a vehicle": lambda headers: operator.put(
            f"/vehicles/{fourth}", {"version": 1, "notes": "a dent"}, headers=headers
        ),
        "remove a vehicle": lambda headers: operator.delete(f"/vehicles/{fifth}?version=1", headers=headers),
        "measure": lambda headers: operator.post(
            f"/vehicles/{fourth}/measurements",
            clicked,
            headers=headers,
        ),
        "revise": lambda headers: operator.put(
            f"/measurements/{revised['id']}", {**clicks(1.3), "revision": 1}, headers=headers
        ),
        "withdraw": lambda headers: operator.delete(
            f"/measurements/{withdrawn['id']}?revision=1", headers=headers
        ),
        "judge": lambda headers: reviewer.post(
            f"/measurements/{judged['id']}/reviews", verdict, headers=headers
        ),
        "add a camera": lambda headers: operator.post(
            f"{survey}/cameras", {"name": "Another"}, headers=headers
        ),
    }


def _same(first: httpx2.Response, again: httpx2.Response) -> bool:
    return (first.status_code, first.content) == (again.status_code, again.content)


def test_a_repeat_stores_nothing_and_is_answered_as_the_first(
    operator: Client, reviewer: Client, services: Services, ground: Ground
) -> None:
    for name, send in _writes(operator, reviewer, ground).items():
        key, before = _key(), _events(services)
        first = send(key)
        assert first.is_success, (name, first.text)
        assert _events(services) == before + 1, name
        again = send(key)
        assert _same(first, again), (name, again.text)
        # what knows its own key by itself finds what is stored, without the middle's help
        assert name == "measure" or again.headers[REPLAYED] == "true"
        assert REPLAYED not in first.headers and _events(services) == before + 1, name


def test_wherever_the_server_ends_a_write_is_stored_once(
    operator: Client,
    reviewer: Client,
    services: Services,
    ground: Ground,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each write is sent until an answer is heard, the server ending at places drawn by lot meanwhile."""
    # a server that ended keeps no answer any more
    monkeypatch.setattr(idempotency, "_ON_ITS_WAY", timedelta(0))
    lot = random.Random(7)
    ended: set[tuple[str, str]] = set()
    for name, send in _writes(operator, reviewer, ground).items():
        key, before, lost = _key(), _events(services), False
        for place in (*lot.sample(KILLED, 3), *lot.choices(KILLED, k=2)):
            ended.add((name, place))
            with _killed(place):
                told = send(key)
            lost = lost or place == "before the answer is kept"
            stored = _events(services) - before
            assert stored in (0, 1), (name, place)
            assert (told.status_code == 503) == (stored == 0), (name, place, told.text)
        answer = send(key)
        assert _events(services) == before + 1, name
        assert answer.is_success or (lost and answer.json()["error"]["kind"] == "done_before"), (
            name,
            answer.text,
        )
    assert len(ended) == 8 * len(KILLED)
    with services.reading() as session:
        assert verify_records(session).ok


def test_of_two_at_once_one_is_stored_and_both_hear_of_it(
    operator: Client, services: Services, ground: Ground
) -> None:
    key, before, answers = _key(), _events(services), list[httpx2.Response]()
    span = {"first_frame": 1, "last_frame": 3}

    def send() -> None:
        answers.append(operator.post(f"/recordings/{ground.recording_id}/vehicles", span, headers=key))

    threads = [threading.Thread(target=send) for _ in range(4)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert _events(services) == before + 1
    assert [one.status_code for one in answers] == [201] * 4
    assert len({one.content for one in answers}) == 1


def test_an_answer_that_is_not_kept_is_told_as_done(
    operator: Client, services: Services, ground: Ground
) -> None:
    address, key = f"/recordings/{ground.recording_id}/vehicles", _key()
    span = {"first_frame": 1, "last_frame": 3}
    with _killed("before the answer is kept"):
        assert operator.post(address, span, headers=key).status_code == 201
    with services.writing() as session:  # long ago: nobody waits for the answer
        session.execute(update(idempotency_keys).values(at=now() - timedelta(hours=1)))
    again = operator.post(address, span, headers=key)
    assert again.status_code == 409 and again.json()["error"]["kind"] == "done_before"
    assert "was stored when it was first sent" in error_of(again)
    assert again.headers[REPLAYED] == "true"


def test_a_key_is_for_one_request_of_one_person(
    operator: Client, admin: Client, services: Services, ground: Ground
) -> None:
    address, key = f"/recordings/{ground.recording_id}/vehicles", _key()
    span = {"first_frame": 1, "last_frame": 3}
    first = operator.post(address, span, headers=key)
    other = operator.post(address, {**span, "last_frame": 4}, headers=key)
    assert other.status_code == 422
    assert error_of(other).startswith(f"The Idempotency-Key {key['Idempotency-Key']} was sent before")
    # quoted as the draft has it
    quoted = operator.post(address, span, headers={"Idempotency-Key": f'"{key["Idempotency-Key"]}"'})
    assert _same(first, quoted)
    theirs = admin.post(address, span, headers=key)
    assert theirs.status_code == 201 and theirs.json()["id"] != first.json()["id"]
    for bad in ("", "with space", "x" * 101):
        refused = operator.post(address, span, headers={"Idempotency-Key": bad})
        assert refused.status_code == 422 and "1 to 100 letters" in error_of(refused)


def test_a_refusal_is_not_kept(operator: Client, services: Services, ground: Ground) -> None:
    """What was refused stored nothing, so the same key may store it when it can be."""
    vehicle, key = add_vehicle(operator, ground.recording_id), _key()
    address, said = f"/vehicles/{vehicle['id']}", {"version": 2, "notes": "a dent"}
    assert operator.put(address, said, headers=key).status_code == 409
    assert operator.put(address, {"version": 1, "notes": "a scratch"}).status_code == 200
    assert operator.put(address, said, headers=key).status_code == 200


def test_who_may_not_any_more_is_told_nothing_of_before(
    operator: Client, admin: Client, services: Services, ground: Ground
) -> None:
    address, key = f"/recordings/{ground.recording_id}/vehicles", _key()
    span = {"first_frame": 1, "last_frame": 3}
    assert operator.post(address, span, headers=key).status_code == 201
    admin.delete("/session")
    assert admin.post(address, span, headers=key).status_code == 401
    me = operator.seen("/session")["person"]["id"]
    with services.writing() as session:
        update_person(session, me, name="Olga", role="viewer", active=True, actor=None)
    for part in (operator.http.app.state.sign_in, operator.http.app.state.access):  # type: ignore[attr-defined]
        part.forget()
    assert operator.post(address, span, headers=key).status_code == 403


def test_a_secret_that_is_told_once_is_kept_nowhere(admin: Client, services: Services) -> None:
    key = _key()
    asked = {"name": "for a program", "scopes": ["read"], "days": 1}
    assert admin.post("/session/tokens", asked, headers=key).status_code == 201
    again = admin.post("/session/tokens", asked, headers=key)
    assert again.status_code == 409 and again.json()["error"]["kind"] == "done_before"
    with services.reading() as session:
        assert session.execute(select(idempotency_keys.c.answer)).scalars().all() == [None]


@pytest.mark.once
def test_every_answer_with_a_secret_says_so() -> None:
    secret = {"link", "text"}
    told = set()
    for _, router in ROUTERS:
        for route in router.routes:
            assert isinstance(route, APIRoute)
            answer = get_type_hints(route.endpoint).get("return")
            fields = {*getattr(answer, "model_fields", ()), *getattr(answer, "__dataclass_fields__", ())}
            if not route.methods.isdisjoint({"POST", "PUT", "DELETE"}) and fields & secret:
                told.add((route.path, TOLD_ONCE in route.dependencies))
    assert told == {("/session/tokens", True), ("/people", True), ("/people/{person_id}/link", True)}


def test_keys_are_forgotten_after_some_days(
    app: FastAPI, operator: Client, services: Services, ground: Ground, monkeypatch: pytest.MonkeyPatch
) -> None:
    address, old = f"/recordings/{ground.recording_id}/vehicles", _key()
    span = {"first_frame": 1, "last_frame": 3}
    first = operator.post(address, span, headers=old)
    with services.writing() as session:
        session.execute(update(idempotency_keys).values(at=now() - timedelta(days=store.KEPT_DAYS, hours=1)))
    monkeypatch.setattr(idempotency, "_FORGET_EVERY_S", -1.0)
    assert operator.post(address, span, headers=_key()).status_code == 201
    anew = operator.post(address, span, headers=old)
    assert anew.status_code == 201 and anew.json()["id"] != first.json()["id"]
