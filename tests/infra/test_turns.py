"""Many at once: nobody holds a connection while waiting, and overload is told and not waited out."""

import asyncio

import anyio.to_thread
import httpx2
import pytest
from fastapi import FastAPI

from sightline.app import create_app
from sightline.infra.services import Services
from sightline.infra.web.error_handlers import RETRY_AFTER_S
from sightline.infra.web.turns import Turns
from sightline.infra.web.write_gate import WriteGate
from tests.support.app import Client, error_of
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.dialect


@pytest.fixture(autouse=True)
def few_connections(monkeypatch: pytest.MonkeyPatch) -> None:
    few = {"pool_size": 6, "max_overflow": 0, "pool_timeout": 60}
    monkeypatch.setattr("sightline.infra.database.engine._POOL", few)


@pytest.fixture
def app(few_connections: None, services: Services) -> FastAPI:
    return create_app(services=services)


def together(app: FastAPI, admin: Client, requests: list[tuple[str, str]]) -> list[httpx2.Response]:
    """The answers to requests (method, path) that are all sent at the same moment, by few threads."""

    async def ask() -> list[httpx2.Response]:
        anyio.to_thread.current_default_thread_limiter().total_tokens = 3
        async with httpx2.AsyncClient(
            transport=httpx2.ASGITransport(app),
            base_url="http://testserver",
            headers={"X-Sightline": "1"},
            cookies=dict(admin.http.cookies),
        ) as http:
            body = {"name": "Many"}
            return await asyncio.gather(
                *(http.request(how, path, json=body if how == "POST" else None) for how, path in requests)
            )

    return asyncio.run(ask())


def test_more_readers_than_threads_and_connections_are_all_answered(app: FastAPI, admin: Client) -> None:
    app.state.readers, app.state.write_gate = Turns(2, wait_s=NEVER_S), WriteGate(wait_s=NEVER_S)
    answers = together(app, admin, [("GET", "/api/surveys"), ("POST", "/api/surveys")] * 30)
    assert {one.status_code for one in answers} == {200, 201}


def test_overload_is_said_and_nothing_was_done(app: FastAPI, admin: Client) -> None:
    """Whoever cannot be served in time is told when to come again; the next one is served."""
    app.state.readers, app.state.write_gate = Turns(1, wait_s=0.05), WriteGate(wait_s=0.05)
    before = len(admin.seen("/surveys"))

    async def overloaded() -> list[httpx2.Response]:
        async with (
            app.state.readers.turn(),
            app.state.write_gate.turns.turn(),
            httpx2.AsyncClient(
                transport=httpx2.ASGITransport(app),
                base_url="http://testserver",
                headers={"X-Sightline": "1"},
                cookies=dict(admin.http.cookies),
            ) as http,
        ):
            return [
                await http.get("/api/surveys"),
                await http.post("/api/surveys", json={"name": "One too many"}),
            ]

    for answer in asyncio.run(overloaded()):
        assert answer.status_code == 503 and answer.headers["Retry-After"] == str(RETRY_AFTER_S)
        assert "try again" in error_of(answer)
    assert len(admin.seen("/surveys")) == before
    admin.made("/surveys", {"name": "The next"})
