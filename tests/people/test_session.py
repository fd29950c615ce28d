"""Signing in and out: links, passwords, limits, and what a cookie is worth."""

import pytest
from argon2 import PasswordHasher
from fastapi import FastAPI, Request
from fastapi.testclient import TestClient

from sightline.errors import BadInput, NotSignedIn
from sightline.infra.services import Services
from sightline.infra.web.cookie import COOKIE
from sightline.infra.web.person import Person
from sightline.people import service
from sightline.people.service import first_sign_in_link, new_sign_in_link
from sightline.people.store import get_person, list_people, update_person
from sightline.people.token_store import list_api_tokens
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect

PASSWORD = "  correct horse battery "


def fresh(app: FastAPI) -> Client:
    return Client(TestClient(app, headers={"X-Sightline": "1"}, raise_server_exceptions=False))


def token_of(link: str | None) -> str:
    assert link is not None
    assert link.startswith("/sign-in?token=")
    return link.partition("=")[2]


def test_first_start_makes_one_admin_who_signs_in_once(
    app: FastAPI, services: Services, nobody: Client
) -> None:
    """Two processes that start, or one that starts again, print two links: either is good, and once."""
    first = token_of(first_sign_in_link(services))
    second = token_of(first_sign_in_link(services))
    me = nobody.made("/session/link", {"token": first})
    assert me["person"]["role"] == "admin"
    assert me["needs_password"] is True
    assert nobody.seen("/session")["person"]["id"] == me["person"]["id"]
    assert first_sign_in_link(services) is None
    for used in (first, second):
        again = fresh(app).post("/session/link", {"token": used})
        assert again.status_code == 401
        assert "already used" in error_of(again)
    with services.reading() as session:
        assert len(list_people(session)) == 1


@pytest.mark.once
def test_the_cookie_is_http_only_and_same_site_strict(admin: Client, nobody: Client) -> None:
    link = admin.made("/people", {"name": "Ann", "email": "ann@example.org", "role": "viewer"})["link"]
    answer = nobody.post("/session/link", {"token": token_of(link)})
    cookie = answer.headers["set-cookie"].lower()
    assert cookie.startswith(f"{COOKIE}=")
    assert "httponly" in cookie and "samesite=strict" in cookie and "path=/" in cookie
    assert answer.headers["cache-control"] == "no-store"


@pytest.mark.once
def test_a_forged_or_changed_cookie_is_nobody(admin: Client, nobody: Client) -> None:
    good = admin.http.cookies[COOKIE]
    for bad in ("", "x", good[:-2] + "aa", good.replace(".", "", 1), "WzEsMSwwXQ.abc.def"):
        nobody.http.cookies.set(COOKIE, bad)
        assert nobody.get("/session").status_code == 401
        nobody.http.cookies.clear()


def test_password_then_sign_in(app: FastAPI, operator: Client) -> None:
    assert operator.put("/session/password", {"new": "short"}).status_code == 422
    me = operator.put("/session/password", {"new": PASSWORD})
    assert me.status_code == 200 and me.json()["needs_password"] is False
    other = fresh(app)
    wrong = other.post("/session", {"email": "operator@example.org", "password": PASSWORD.strip()})
    assert wrong.status_code == 401
    assert "Wrong e-mail or password" in error_of(wrong)
    me = other.post("/session", {"email": "OPERATOR@example.org ", "password": PASSWORD})
    assert me.status_code == 200
    refused = other.put("/session/password", {"current": "not the one", "new": "another password"})
    assert refused.status_code == 403
    assert other.put("/session/password", {"current": PASSWORD, "new": "another password"}).status_code == 200
    # The other browser's session ended with the change.
    assert operator.get("/session").status_code == 401
    assert other.get("/session").status_code == 200


@pytest.mark.once
def test_passwords_are_hashed_with_much_work(quick_passwords: PasswordHasher) -> None:
    """As RFC 9106 recommends where memory is short, at least; all other tests hash them quickly."""
    assert quick_passwords.memory_cost >= 64 * 1024 and quick_passwords.time_cost >= 3
    stored = quick_passwords.hash(PASSWORD)
    assert stored.startswith("$argon2id$") and quick_passwords.verify(stored, PASSWORD)


@pytest.mark.once
@pytest.mark.parametrize(
    "new", [" " * 10, "a" * 12, "aAaAaAaAaA", "a b a b a b", "\t \u00a0\u2003 \t \u00a0 \t\t", "1" * 1000]
)
def test_spaces_or_one_sign_alone_are_no_password(operator: Client, new: str) -> None:
    refused = operator.put("/session/password", {"new": new})
    assert refused.status_code == 422
    assert "3 different characters" in error_of(refused)
    assert operator.seen("/session")["needs_password"] is True


def test_a_link_for_a_forgotten_password_needs_no_current_one(
    app: FastAPI, services: Services, operator: Client
) -> None:
    operator.put("/session/password", {"new": PASSWORD})
    back = fresh(app)
    me = back.made("/session/link", {"token": token_of(new_sign_in_link(services, "operator@example.org"))})
    assert me["needs_password"] is True
    assert back.put("/session/password", {"new": "a new password"}).status_code == 200
    assert back.put("/session/password", {"new": "yet another one"}).status_code == 403
    with pytest.raises(BadInput):
        new_sign_in_link(services, "stranger@example.org")


def test_a_new_password_ends_the_links_that_wait(app: FastAPI, services: Services, operator: Client) -> None:
    link = token_of(new_sign_in_link(services, "operator@example.org"))
    assert operator.put("/session/password", {"new": PASSWORD}).status_code == 200
    assert fresh(app).post("/session/link", {"token": link}).status_code == 401


def test_whoever_is_switched_off_comes_back_by_no_old_link(
    app: FastAPI, services: Services, admin: Client, operator: Client
) -> None:
    link = token_of(new_sign_in_link(services, "operator@example.org"))
    me = operator.seen("/session")["person"]
    for active in (False, True):
        admin.put(f"/people/{me['id']}", {"name": me["name"], "role": me["role"], "active": active})
    assert fresh(app).post("/session/link", {"token": link}).status_code == 401


@pytest.mark.once
def test_whoever_is_switched_off_is_given_no_link(admin: Client, operator: Client) -> None:
    """It would hold once they are switched on again."""
    me = operator.seen("/session")["person"]
    links = f"/people/{me['id']}/link"
    admin.put(f"/people/{me['id']}", {"name": "Op", "role": me["role"], "active": False})
    refused = admin.post(links)
    assert refused.status_code == 409
    assert error_of(refused).startswith("Op’s account is deactivated; reactivate it")
    admin.put(f"/people/{me['id']}", {"name": "Op", "role": me["role"], "active": True})
    assert admin.post(links).status_code == 201


def test_a_sign_in_beside_a_change_of_password_is_over_with_the_other_sessions(
    app: FastAPI, operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    operator.put("/session/password", {"new": PASSWORD})
    matches, meanwhile = service.matches, ["another password"]

    def overtaken(stored: str | None, password: str) -> bool:
        if meanwhile and password == PASSWORD:
            new = {"current": PASSWORD, "new": meanwhile.pop()}
            assert operator.put("/session/password", new).status_code == 200
            return True
        return matches(stored, password)

    monkeypatch.setattr(service, "matches", overtaken)
    monkeypatch.setattr(type(service._hasher), "check_needs_rehash", lambda *_: True)
    other, credentials = fresh(app), {"email": "operator@example.org", "password": PASSWORD}
    other.post("/session", credentials)
    assert other.get("/session").status_code == 401
    assert fresh(app).post("/session", credentials).status_code == 401
    credentials["password"] = "another password"
    assert fresh(app).post("/session", credentials).status_code == 200


def test_a_change_of_ones_name_brings_no_rights_back(services: Services, operator: Client) -> None:
    """The request was let in as somebody read it a moment ago; an admin was faster."""
    with services.reading() as session:
        (before,) = [one for one in list_people(session) if one.email == "operator@example.org"]
    with services.writing() as session:
        update_person(session, before.id, name="Op", role="viewer", active=True, actor=None)
    assert service.change_name(services, before, "Olga").role == "viewer"
    with services.writing() as session:
        update_person(session, before.id, name="Op", role="viewer", active=False, actor=None)
    with pytest.raises(NotSignedIn):
        service.change_name(services, before, "Olga")
    with services.reading() as session:
        after = get_person(session, before.id)
    assert (after.name, after.role, after.active) == ("Op", "viewer", False)


def test_whoever_was_switched_off_a_moment_ago_makes_no_token(services: Services, operator: Client) -> None:
    """Another process may still let them in; the token would hold once they are switched on again."""
    me = operator.seen("/session")["person"]
    with services.writing() as session:
        update_person(session, me["id"], name="Op", role="operator", active=False, actor=None)
    made = operator.post("/session/tokens", {"name": "import", "scopes": ["read"], "days": 9})
    assert made.status_code == 401
    with services.reading() as session:
        assert list_api_tokens(session, me["id"]) == ()


def test_of_two_changes_of_a_password_the_first_ends_the_other(
    app: FastAPI, operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    operator.put("/session/password", {"new": PASSWORD})
    hashes, meanwhile = service.PasswordHasher.hash, ["the first of two"]

    def overtaken(hasher: PasswordHasher, password: str) -> str:
        if meanwhile and password == "the second of two":
            new = {"current": PASSWORD, "new": meanwhile.pop()}
            assert operator.put("/session/password", new).status_code == 200
        return hashes(hasher, password)

    other = fresh(app)
    assert other.post("/session", {"email": "operator@example.org", "password": PASSWORD}).status_code == 200
    monkeypatch.setattr(service.PasswordHasher, "hash", overtaken)
    second = other.put("/session/password", {"current": PASSWORD, "new": "the second of two"})
    assert second.status_code == 401
    credentials = {"email": "operator@example.org", "password": "the first of two"}
    assert fresh(app).post("/session", credentials).status_code == 200


@pytest.mark.once
def test_wrong_passwords_count_at_changing_them_too(operator: Client) -> None:
    operator.put("/session/password", {"new": PASSWORD})
    guesses = [{"current": f"guess {n}", "new": "another password"} for n in range(6)]
    assert [operator.put("/session/password", one).status_code for one in guesses] == [403] * 5 + [429]
    right = {"current": PASSWORD, "new": "another password"}
    assert operator.put("/session/password", right).status_code == 429


@pytest.mark.once
def test_failures_are_limited_and_say_nothing_about_accounts(app: FastAPI, operator: Client) -> None:
    operator.put("/session/password", {"new": PASSWORD})
    client = fresh(app)
    known = [client.post("/session", {"email": "operator@example.org", "password": "x"}) for _ in range(5)]
    unknown = [client.post("/session", {"email": "nobody@example.org", "password": "x"}) for _ in range(5)]
    assert [a.status_code for a in known + unknown] == [401] * 10
    assert error_of(known[0]) == error_of(unknown[0])
    # The right password too: otherwise the limit would only slow down whoever is honest.
    for email in ("operator@example.org", "nobody@example.org"):
        answer = client.post("/session", {"email": email, "password": PASSWORD})
        assert answer.status_code == 429
        assert "five minutes" in error_of(answer)
    assert client.post("/session", {"email": "viewer@example.org", "password": "x"}).status_code == 401


@pytest.mark.once
def test_success_forgets_failures(app: FastAPI, operator: Client) -> None:
    operator.put("/session/password", {"new": PASSWORD})
    client = fresh(app)
    for _ in range(3):
        for _ in range(4):
            assert (
                client.post("/session", {"email": "operator@example.org", "password": "x"}).status_code == 401
            )
        good = client.post("/session", {"email": "operator@example.org", "password": PASSWORD})
        assert good.status_code == 200


@pytest.mark.once
def test_sign_out(operator: Client) -> None:
    assert operator.delete("/session").status_code == 204
    assert operator.get("/session").status_code == 401
    assert operator.delete("/session").status_code == 204


@pytest.mark.once
def test_a_copied_cookie_is_worth_nothing_after_signing_out(app: FastAPI, operator: Client) -> None:
    copied = fresh(app)
    copied.http.cookies.set(COOKIE, operator.http.cookies[COOKIE])
    assert copied.get("/session").status_code == 200
    assert operator.delete("/session").status_code == 204
    assert copied.get("/session").status_code == 401
    # Whoever is nobody any more cannot sign the person out again from wherever they are by then.
    assert copied.delete("/session").status_code == 204


@pytest.mark.once
def test_what_was_read_before_a_change_is_not_believed_after_it(app: FastAPI, operator: Client) -> None:
    """A request that looks the person up while another one ends their session."""
    cookies = app.state.sign_in
    request = Request(
        {"type": "http", "headers": [(b"cookie", f"{COOKIE}={operator.http.cookies[COOKIE]}".encode())]}
    )
    look_up, looked_up = cookies._lookup, []

    def and_then_sign_out(person_id: int) -> Person | None:
        person = look_up(person_id)
        if not looked_up:
            looked_up.append(person_id)
            assert operator.delete("/session").status_code == 204
        return person  # type: ignore[no-any-return]

    cookies.forget()
    cookies._lookup = and_then_sign_out
    cookies.person_of(request)
    assert looked_up and cookies.person_of(request) is None


def test_whoever_is_switched_off_is_out_at_once(admin: Client, operator: Client) -> None:
    person = next(one for one in admin.seen("/people") if one["role"] == "operator")
    change = {"name": person["name"], "role": "operator", "active": False}
    assert admin.put(f"/people/{person['id']}", change).status_code == 200
    assert operator.get("/surveys").status_code == 401
    assert operator.post("/surveys", {"name": "no"}).status_code == 401


def test_a_new_role_counts_at_once(admin: Client, viewer: Client) -> None:
    person = next(one for one in admin.seen("/people") if one["role"] == "viewer")
    assert viewer.post("/surveys", {"name": "no"}).status_code == 403
    change = {"name": "Vera", "role": "operator", "active": True}
    assert admin.put(f"/people/{person['id']}", change).json()["role"] == "operator"
    assert viewer.post("/surveys", {"name": "yes"}).status_code == 201


def test_the_last_admin_stays(admin: Client) -> None:
    me = admin.seen("/session")["person"]
    for role, active in (("viewer", True), ("admin", False)):
        answer = admin.put(f"/people/{me['id']}", {"name": me["name"], "role": role, "active": active})
        assert answer.status_code == 409
        assert "last admin" in error_of(answer)


def test_accounts_need_an_address_of_their_own(admin: Client) -> None:
    twice = admin.post("/people", {"name": "Bob", "email": "Viewer@example.org", "role": "viewer"})
    assert twice.status_code == 409
    assert admin.post("/people", {"name": "Bob", "email": "nowhere", "role": "viewer"}).status_code == 422
    assert admin.post("/people", {"name": " ", "email": "b@example.org", "role": "viewer"}).status_code == 422
    assert admin.post("/people", {"name": "B", "email": "b@example.org", "role": "king"}).status_code == 422
    assert admin.post("/people/999999/link").status_code == 404
