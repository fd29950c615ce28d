"""How long the server believes what it read about a signed-in person."""

import time
from dataclasses import replace

import pytest
from fastapi import Request, Response

from sightline.infra.database.types import now
from sightline.infra.services import BELIEVED_S
from sightline.infra.web.cookie import MAX_AGE_S, SignIn
from sightline.infra.web.person import Person

ANNA = Person(
    id=1,
    name="Anna",
    email="anna@example.org",
    role="operator",
    active=True,
    created_at=now(),
    last_seen_at=None,
    has_password=True,
    session_key=5,
)


class Accounts:
    """One account, a clock, and how often the account was looked up."""

    def __init__(self) -> None:
        self.person, self.time_s, self.lookups = ANNA, 100.0, 0
        self.sign_in = SignIn(b"secret", False, self.look_up, lambda: self.time_s)
        answer = Response()
        self.sign_in.remember(answer, ANNA, by_link=False)
        cookie = answer.headers["set-cookie"].split(";")[0].encode()
        self.request = Request({"type": "http", "headers": [(b"cookie", cookie)]})

    def look_up(self, person_id: int) -> Person | None:
        self.lookups += 1
        return self.person if person_id == self.person.id else None

    def signed_in(self) -> bool:
        return self.sign_in.person_of(self.request) is not None


def test_a_person_is_believed_for_a_moment_only() -> None:
    accounts = Accounts()
    assert accounts.signed_in() and accounts.signed_in() and accounts.lookups == 1
    accounts.person = replace(ANNA, active=False)
    accounts.time_s += BELIEVED_S - 0.01
    assert accounts.signed_in() and accounts.lookups == 1
    accounts.time_s += 0.02
    assert not accounts.signed_in() and accounts.lookups == 2


def test_a_change_here_counts_at_once() -> None:
    accounts = Accounts()
    assert accounts.signed_in()
    accounts.person = replace(ANNA, session_key=6)
    accounts.sign_in.forget()
    assert not accounts.signed_in()


def test_what_was_read_before_a_change_is_not_believed_after_it() -> None:
    accounts = Accounts()
    look_up = accounts.look_up

    def overtaken(person_id: int) -> Person | None:
        read = look_up(person_id)
        accounts.person = replace(ANNA, active=False)
        accounts.sign_in.forget()
        return read

    accounts.sign_in._lookup = overtaken
    assert accounts.signed_in()
    accounts.sign_in._lookup = look_up
    assert not accounts.signed_in()


@pytest.mark.parametrize(
    ("signed_s_ago", "held"),
    [(0, True), (MAX_AGE_S - 60, True), (MAX_AGE_S + 60, False), (-3600, True), (-MAX_AGE_S - 60, False)],
)
def test_a_clock_set_back_signs_nobody_out_and_an_old_cookie_ends(
    signed_s_ago: int, held: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = time.time()
    with monkeypatch.context() as then:
        then.setattr("itsdangerous.timed.time.time", lambda: told - signed_s_ago)
        accounts = Accounts()
    assert accounts.signed_in() == held
