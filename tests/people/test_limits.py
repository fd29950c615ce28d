"""Limits hold over every process of the app: here two apps, each with a database connection of its own."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import timedelta

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from sightline.app import create_app
from sightline.errors import NoRoom
from sightline.infra.database.types import now
from sightline.infra.limits import store as limits
from sightline.infra.limits.store import Limit, count_against, forget_counted
from sightline.infra.services import Services, open_services
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect

LIMIT = Limit("tries", 3, 60)


@pytest.fixture
def other(services: Services) -> Iterator[FastAPI]:
    """The app in another process, as far as what it shares goes: the database and the data folder."""
    opened = open_services(services.settings)
    yield create_app(services=opened)
    opened.close()


def wrong(client: Client, email: str = "operator@example.org") -> int:
    return client.post("/session", {"email": email, "password": "not this one"}).status_code


@pytest.fixture
def both(app: FastAPI, other: FastAPI) -> list[Client]:
    return [Client(TestClient(one, headers={"X-Sightline": "1"})) for one in (app, other)]


@pytest.mark.usefixtures("operator")
def test_failed_sign_ins_count_in_all_processes(both: list[Client]) -> None:
    assert [wrong(both[n % 2]) for n in range(6)] == [401] * 5 + [429]
    assert [wrong(client) for client in both] == [429, 429]
    assert wrong(both[1], "somebody@example.org") == 401


@pytest.mark.once
def test_links_are_not_guessed_by_the_thousand(both: list[Client]) -> None:
    answers = [both[n % 2].post("/session/link", {"token": f"guess {n}"}).status_code for n in range(52)]
    assert answers == [401] * 50 + [429] * 2


def test_an_office_behind_one_address_signs_in(
    both: list[Client], operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    """More right sign-ins than the address may fail; a wrong one counts as before."""
    monkeypatch.setattr("sightline.people.service.PER_ADDRESS", Limit("failures of an office", 3, 300))
    body = {"email": "operator@example.org", "password": "a password for tests"}
    operator.put("/session/password", {"new": body["password"]})
    assert [both[n % 2].post("/session", body).status_code for n in range(5)] == [200] * 5
    answers = [both[n % 2].post("/session/link", {"token": f"guess {n}"}).status_code for n in range(5)]
    assert answers == [401] * 3 + [429] * 2
    assert both[0].post("/session", body).status_code == 429


def test_an_address_is_slowed_down_and_not_shut_out(
    both: list[Client], operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Beyond the limit one try in five seconds, also for who is right; then that one is in."""
    monkeypatch.setattr("sightline.people.service.PER_ADDRESS", Limit("failures of a network", 3, 300))
    body = {"email": "operator@example.org", "password": "a password for tests"}
    operator.put("/session/password", {"new": body["password"]})
    begun = now()
    at: Callable[[float], None] = lambda s: monkeypatch.setattr(  # noqa: E731
        limits, "now", lambda: begun + timedelta(seconds=s)
    )
    at(0)
    assert [both[n % 2].post("/session/link", {"token": f"{n}"}).status_code for n in range(3)] == [401] * 3
    at(2)
    refused = both[1].post("/session", body)
    assert refused.status_code == 429 and refused.headers["Retry-After"] == "3"
    assert error_of(refused) == "Many sign-ins from your network failed; try again in 3 s."
    at(5)
    assert both[1].post("/session/link", {"token": "again"}).status_code == 401
    assert both[0].post("/session", body).headers["Retry-After"] == "5"
    at(10)
    assert both[0].post("/session", body).status_code == 200


def test_an_account_says_when_it_may_be_tried_again(
    both: list[Client], monkeypatch: pytest.MonkeyPatch
) -> None:
    begun = now()
    at: Callable[[float], None] = lambda s: monkeypatch.setattr(  # noqa: E731
        limits, "now", lambda: begun + timedelta(seconds=s)
    )
    for second in range(5):
        at(second)
        assert wrong(both[0]) == 401
    at(100)
    body = {"email": "operator@example.org", "password": "not this one"}
    assert both[1].post("/session", body).headers["Retry-After"] == "200"
    at(301)
    assert wrong(both[1]) == 401


def test_with_a_full_disk_people_sign_in_and_are_counted_all_the_same(
    app: FastAPI, operator: Client, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    body = {"email": "operator@example.org", "password": "a password for tests"}
    operator.put("/session/password", {"new": body["password"]})

    @contextmanager
    def full(*_given: object, **_more: object) -> Iterator[None]:
        raise NoRoom("database-disk-full")
        yield

    scopes = {"name": "a program", "scopes": ["read"], "days": 1}
    token = operator.made("/session/tokens", scopes)["text"]
    monkeypatch.setattr(type(services), "writing", full)
    program = Client(TestClient(app, headers={"Authorization": f"Bearer {token}"}))
    assert program.get("/surveys").status_code == 200
    client = Client(TestClient(app, headers={"X-Sightline": "1"}))
    assert client.post("/session", body).status_code == 200
    assert client.get("/surveys").status_code == 200
    assert [wrong(client) for _ in range(6)] == [401] * 5 + [429]


def test_a_session_that_was_ended_ends_in_the_other_process(both: list[Client], operator: Client) -> None:
    here, there = both
    for client in both:
        client.http.cookies.update(operator.http.cookies)
        assert client.get("/surveys").status_code == 200
    copied = dict(operator.http.cookies)
    assert operator.delete("/session").status_code == 204
    here.http.cookies.update(copied)
    there.http.cookies.update(copied)
    assert here.get("/surveys").status_code == 401
    soon = threading.Event()
    for _ in range(30):
        answer = there.get("/surveys").status_code
        if answer == 401:
            return
        soon.wait(0.1)
    pytest.fail("the other process still believes the session after three seconds")


def test_many_at_once_do_not_slip_through(services: Services) -> None:
    counted: list[bool] = []

    def attempt() -> None:
        with services.writing() as session:
            counted.append(count_against(session, LIMIT, "one"))

    threads = [threading.Thread(target=attempt) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(counted) == [False] * 5 + [True] * 3


def test_a_window_moves_and_others_have_one_of_their_own(
    services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    at: Callable[[float], None] = lambda s: monkeypatch.setattr(  # noqa: E731
        limits, "now", lambda: begun + timedelta(seconds=s)
    )
    begun = now()
    with services.writing() as session:
        for second in (0, 10, 20):
            at(second)
            assert count_against(session, LIMIT, "one")
        assert not count_against(session, LIMIT, "one") and count_against(session, LIMIT, "two", 3)
        at(60.5)
        assert count_against(session, LIMIT, "one") and not count_against(session, LIMIT, "one")
        forget_counted(session, LIMIT, "one")
        assert count_against(session, LIMIT, "one", 3) and not count_against(session, LIMIT, "one")
