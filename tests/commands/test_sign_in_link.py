"""`sightline sign-in-link`: a locked-out admin gets back in, the audit trail tells, nobody else gets one."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from sqlalchemy import Engine

from sightline.cli import main
from sightline.errors import NotSignedIn
from sightline.infra.audit import trail
from sightline.infra.database.engine import make_engine, reading, session_factory, writing
from sightline.people.store import create_person, create_sign_in_link, update_person, use_sign_in_link


@pytest.fixture
def accounts(tmp_path: Path, database_url: str, monkeypatch: pytest.MonkeyPatch) -> Iterator[Engine]:
    """An admin and somebody whose account is switched off."""
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(tmp_path))
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", database_url)
    engine = make_engine(database_url)
    with writing(session_factory(engine)) as session:
        create_person(session, name="Ada", email="ada@example.org", role="admin", actor=None)
        off = create_person(session, name="Bo", email="bo@example.org", role="operator", actor=None)
        update_person(session, off.id, name="Bo", role="operator", active=False, actor=None)
    yield engine
    engine.dispose()


def test_the_link_works_once_ends_older_ones_and_is_audited(
    accounts: Engine, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SIGHTLINE_ADDRESS", "https://heights.example.org/")
    factory = session_factory(accounts)
    with writing(factory) as session:
        older = create_sign_in_link(session, 1, actor=None)
    assert main(["sign-in-link", " Ada@Example.org "]) == 0
    said = capsys.readouterr().out
    assert said.count("\n") == 1 and " https://heights.example.org/sign-in?token=" in said
    token = said.strip().partition("token=")[2]
    with reading(factory) as session:
        event = trail.listing(session, entity="sign_in_link", limit=1)[0]
    assert event.action == "create" and event.actor is None
    assert event.after is not None and event.after["email"] == "ada@example.org" and token not in str(event)
    with writing(factory) as session:
        assert use_sign_in_link(session, token).name == "Ada"
        for used in (token, older):
            with pytest.raises(NotSignedIn):
                use_sign_in_link(session, used)


def test_without_an_address_it_says_what_is_to_stand_before_the_link(
    accounts: Engine, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A path alone looked like a whole link that leads nowhere."""
    monkeypatch.delenv("SIGHTLINE_ADDRESS", raising=False)
    assert main(["sign-in-link", "ada@example.org"]) == 0
    said = capsys.readouterr().out
    assert said.startswith(
        "Put the address of your Sightline before this, and open it, once: /sign-in?token="
    )
    assert said.count("\n") == 1


@pytest.mark.parametrize("email", ["nobody@example.org", "bo@example.org"])
def test_nobody_else_gets_one(accounts: Engine, email: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sign-in-link", email]) == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1 and email in said.err
