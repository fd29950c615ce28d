"""API tokens: made once, hashed, with scopes and an end; what they may do is in `test_roles`."""

from datetime import timedelta

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from sqlalchemy import select

from sightline.app import create_app
from sightline.infra.audit.tables import audit_events
from sightline.infra.database.types import now
from sightline.infra.limits.store import Limit
from sightline.infra.services import BELIEVED_S, Services
from sightline.infra.web import bearer
from sightline.people import token_store
from sightline.people.tables import api_tokens
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect


def made(client: Client, *scopes: str, name: str = "import", days: int = 30) -> tuple[int, str]:
    answer = client.made("/session/tokens", {"name": name, "scopes": scopes or ["read"], "days": days})
    return answer["token"]["id"], answer["text"]


def program(app: FastAPI, text: str, **headers: str) -> Client:
    """A program: no cookie and no header of the pages."""
    http = TestClient(
        app, headers={"Authorization": f"Bearer {text}", **headers}, raise_server_exceptions=False
    )
    return Client(http)


def test_a_token_speaks_for_its_person(app: FastAPI, operator: Client, services: Services) -> None:
    token_id, text = made(operator, "read", "measure")
    client = program(app, text)
    assert client.seen("/session")["person"]["email"] == "operator@example.org"
    survey = client.made("/surveys", {"name": "By a program"})
    assert operator.seen(f"/surveys/{survey['id']}")["my_role"] == "manager"
    (listed,) = operator.seen("/session/tokens")
    assert listed["scopes"] == ["read", "measure"] and listed["last_used_at"] is not None
    assert text not in str(listed)
    with services.reading() as session:
        row = session.execute(select(api_tokens)).mappings().one()
        assert row["id"] == token_id and text not in str(dict(row))
        assert row["token_hash"] == token_store.token_hash(text)


def test_made_and_revoked_tokens_stand_in_the_chain(operator: Client, services: Services) -> None:
    token_id, text = made(operator)
    assert operator.delete(f"/session/tokens/{token_id}").status_code == 204
    with services.reading() as session:
        e = audit_events.c
        rows = session.execute(
            select(e.action, e.before, e.after).where(e.entity == "api_token").order_by(e.id)
        )
        events = [tuple(row) for row in rows]
    assert [one[0] for one in events] == ["create", "revoke"]
    assert text not in str(events) and token_store.token_hash(text) not in str(events)


@pytest.mark.once
def test_a_form_is_one_request(app: FastAPI, operator: Client, monkeypatch: pytest.MonkeyPatch) -> None:
    """Who sends it is asked before it is read, and again by its route."""
    spent = list[int]()
    monkeypatch.setattr(bearer.Bearers, "_spend", lambda _bearers, token: spent.append(token.id))
    token_id, text = made(operator)
    form = {"file": ("road.jpg", b"no picture", "image/jpeg")}
    assert program(app, text).post("/surveys/9/photographs", files=form).status_code == 404
    assert spent == [token_id]


def test_a_revoked_token_ends_at_once_and_in_other_processes_soon(
    app: FastAPI, services: Services, operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = [0.0]
    token_id, text = made(operator)
    other = create_app(services=services)
    other.state.bearers = bearer.Bearers(app.state.bearers._store, lambda: clock[0])
    here, there = program(app, text), program(other, text)
    assert here.get("/surveys").status_code == there.get("/surveys").status_code == 200
    operator.delete(f"/session/tokens/{token_id}")
    assert here.get("/surveys").status_code == 401
    clock[0] = BELIEVED_S + 0.01
    refused = there.get("/surveys")
    assert refused.status_code == 401 and "token" in error_of(refused)
    assert operator.delete(f"/session/tokens/{token_id}").status_code == 404


def test_a_token_ends_with_its_days_and_with_its_account(
    app: FastAPI, operator: Client, admin: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, text = made(operator, days=1)
    client = program(app, text)
    assert client.get("/surveys").status_code == 200
    with monkeypatch.context() as later:
        later.setattr(bearer, "now", lambda: now() + timedelta(days=1, seconds=1))
        assert client.get("/surveys").status_code == 401
    me = operator.seen("/session")["person"]
    admin.put(f"/people/{me['id']}", {"name": me["name"], "role": me["role"], "active": False})
    assert client.get("/surveys").status_code == 401
    admin.put(f"/people/{me['id']}", {"name": me["name"], "role": me["role"], "active": True})
    assert client.get("/surveys").status_code == 401  # for good


def test_others_tokens_are_neither_seen_nor_revoked(operator: Client, viewer: Client) -> None:
    token_id, _ = made(operator)
    assert viewer.seen("/session/tokens") == []
    assert viewer.delete(f"/session/tokens/{token_id}").status_code == 404
    assert len(operator.seen("/session/tokens")) == 1


@pytest.mark.once
def test_a_cookie_counts_for_nothing_beside_a_token(app: FastAPI, operator: Client, viewer: Client) -> None:
    """So a write may be without the header against cross-site requests only where no cookie decides."""
    operator.http.headers["Authorization"] = "Bearer sightline_wrong"
    assert operator.post("/surveys", {"name": "no"}).status_code == 401
    del operator.http.headers["Authorization"]
    _, text = made(viewer)
    operator.http.headers["Authorization"] = f"bearer {text}"
    assert operator.seen("/session")["person"]["email"] == "viewer@example.org"
    assert operator.post("/surveys", {"name": "no"}).status_code == 403
    operator.http.headers.update({"Authorization": "Basic eDp5"})
    del operator.http.headers["X-Sightline"]
    assert "X-Sightline" in error_of(operator.post("/surveys", {"name": "no"}))


@pytest.mark.once
def test_no_token_makes_tokens(app: FastAPI, operator: Client) -> None:
    _, text = made(operator, "read", "upload", "measure", "review", "export")
    client = program(app, text)
    refused = client.post("/session/tokens", {"name": "more", "scopes": ["read"]})
    assert refused.status_code == 403 and "browser" in error_of(refused)
    assert client.get("/session/tokens").status_code == 403


@pytest.mark.once
def test_what_cannot_be_a_token_is_refused(operator: Client, monkeypatch: pytest.MonkeyPatch) -> None:
    for body in (
        {"name": " ", "scopes": ["read"]},
        {"name": "a", "scopes": []},
        {"name": "a", "scopes": ["all"]},
    ):
        assert operator.post("/session/tokens", body).status_code == 422
    assert operator.post("/session/tokens", {"name": "a", "scopes": ["read"], "days": 367}).status_code == 422
    monkeypatch.setattr(token_store, "MOST_TOKENS", 1)
    made(operator)
    assert operator.post("/session/tokens", {"name": "b", "scopes": ["read"]}).status_code == 409


def test_requests_of_a_token_are_limited_over_all_processes(
    app: FastAPI, services: Services, operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sightline.people.service.PER_TOKEN", Limit("requests with a token", 60, 60))
    _, text = made(operator)
    both = [program(app, text), program(create_app(services=services), text)]
    answers = [both[n % 2].get("/session").status_code for n in range(100)]
    assert answers.count(200) <= 60 and answers.count(200) >= 60 - bearer.BLOCK and 429 in answers


def test_wrong_tokens_make_an_address_wait(app: FastAPI, services: Services, operator: Client) -> None:
    _, text = made(operator)
    good = program(app, text)
    assert good.get("/session").status_code == 200
    both = [program(app, "sightline_wrong"), program(create_app(services=services), "sightline_wrong")]
    answers = [both[n % 2].get("/session").status_code for n in range(60)]
    assert answers == [401] * 50 + [429] * 10
    assert good.get("/session").status_code == 200
