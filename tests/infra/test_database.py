"""Transactions: one writer at a time, one sentence when the database cannot."""

import sqlite3
import threading
from pathlib import Path

import pytest
from sqlalchemy import Engine, make_url, text
from sqlalchemy.exc import OperationalError
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Damaged, NoRoom
from sightline.infra.audit import trail
from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import (
    DatabaseAway,
    SessionFactory,
    explanation,
    make_engine,
    migrate,
    reading,
    session_factory,
    writing,
)
from sightline.settings import Settings, load_settings
from sightline.surveys.store import create_survey, list_surveys
from tests.conftest import SERVER
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.dialect


def test_many_writers_take_turns_and_the_chain_holds(factory: SessionFactory) -> None:
    problems: list[BaseException] = []

    def write(name: str) -> None:
        try:
            for n in range(5):
                with writing(factory) as session:
                    create_survey(session, name=f"{name}-{n}", actor=None)
        except BaseException as error:
            problems.append(error)

    threads = [threading.Thread(target=write, args=(str(n),)) for n in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert problems == []
    with reading(factory) as session:
        assert verify_records(session).checked == 40 and verify_records(session).ok


def test_reading_goes_on_while_somebody_writes(factory: SessionFactory) -> None:
    with writing(factory) as session:
        create_survey(session, name="seen later", actor=None)
        with reading(factory) as other:
            assert list_surveys(other) == ()
    with reading(factory) as other:
        assert [one.name for one in list_surveys(other)] == ["seen later"]


def test_reading_sees_one_state_to_its_end(factory: SessionFactory) -> None:
    """An export is many queries: what is stored between two of them must be in none or in all."""
    with reading(factory) as session:
        before = list_surveys(session)
        with writing(factory) as other:
            create_survey(other, name="Meanwhile", actor=None)
        assert list_surveys(session) == before
    with reading(factory) as session:
        assert len(list_surveys(session)) == len(before) + 1


def test_what_reading_changed_is_rolled_back(factory: SessionFactory) -> None:
    with reading(factory) as session:
        create_survey(session, name="never", actor=None)
    with reading(factory) as session:
        assert list_surveys(session) == () and trail.head(session).count == 0


def test_sqlite_runs_as_it_should(engine: Engine) -> None:
    if engine.dialect.name != "sqlite":
        return
    with engine.connect() as connection:
        found = {
            name: connection.execute(text(f"PRAGMA {name}")).scalar_one()
            for name in ("journal_mode", "foreign_keys", "busy_timeout")
        }
    assert found == {"journal_mode": "wal", "foreign_keys": 1, "busy_timeout": 10_000}


def test_foreign_keys_hold(session: Session) -> None:
    with pytest.raises(Exception, match=r"(?i)foreign key"):
        session.execute(text("INSERT INTO frames VALUES (99, 0, 0, 0, true, 0)"))
        session.flush()
    session.rollback()


@pytest.mark.parametrize(
    ("words", "kind", "said"),
    [
        ("database or disk is full", NoRoom, "disk is full"),
        ('could not extend file "x": No space left on device', NoRoom, "disk is full"),
        ("database is locked", DatabaseAway, "busy"),
        ("attempt to write a readonly database", DatabaseAway, "permissions"),
        ("connection refused", DatabaseAway, "does not answer"),
        ("database disk image is malformed", Damaged, "is damaged"),
        ("malformed database schema (x)", Damaged, "is damaged"),
        ("Could not decode to UTF-8 column 'name'", Damaged, "is damaged"),
        ("file is not a database", BadInput, "beginning is damaged"),
    ],
)
def test_operational_errors_become_one_sentence(words: str, kind: type, said: str) -> None:
    found = explanation(OperationalError("x", {}, sqlite3.OperationalError(words)))
    assert found is not None and type(found) is kind and said in found.message


def test_a_full_disk_leaves_nothing_half_there(tmp_path: Path) -> None:
    engine = make_engine(f"sqlite:///{tmp_path}/small.db")
    migrate(engine)
    factory = session_factory(engine)
    with writing(factory) as session:
        pages = session.execute(text("PRAGMA page_count")).scalar_one()
        session.execute(text(f"PRAGMA max_page_count = {pages + 2}"))
    with pytest.raises(NoRoom, match="disk is full"), writing(factory) as session:
        create_survey(session, name="x", description="much " * 20_000, actor=None)
    with reading(factory) as session:
        assert list_surveys(session) == () and verify_records(session).ok
    engine.dispose()


@pytest.mark.parametrize("url", ["", "sqlite://", "sqlite:///:memory:", "mysql://a/b", "not a url"])
def test_addresses_that_cannot_be_used(url: str) -> None:
    with pytest.raises(BadInput, match=r"^[A-Z].*\.$"):
        make_engine(url)


def test_a_database_that_is_away_is_said_so() -> None:
    engine = make_engine("postgresql://nobody@127.0.0.1:1/none?connect_timeout=2")
    with (
        pytest.raises(DatabaseAway, match="does not answer"),
        reading(session_factory(engine)) as session,
    ):
        list_surveys(session)
    with pytest.raises(DatabaseAway, match="does not answer"):
        migrate(engine)


def test_settings_come_from_the_environment(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in Settings.model_fields:
        monkeypatch.delenv(f"SIGHTLINE_{name.upper()}", raising=False)
    assert load_settings().port == 8000 and load_settings().data_dir.name == ".data"
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(tmp_path))
    monkeypatch.setenv("SIGHTLINE_PORT", "9")
    found = load_settings(port=None)
    assert (found.port, found.media_url) == (9, str(tmp_path / "media"))
    assert found.database_url == f"sqlite:///{tmp_path / 'sightline.db'}"
    assert load_settings(port=10).port == 10
    monkeypatch.setenv("SIGHTLINE_PORT", "many")
    with pytest.raises(ValueError, match="port"):
        load_settings()


def test_different_surveys_are_written_side_by_side_and_each_in_turns(
    factory: SessionFactory, engine: Engine
) -> None:
    """On PostgreSQL; who writes to everything waits for both."""
    if engine.dialect.name == "sqlite":
        pytest.skip("SQLite has one writer")
    came: list[str] = []
    begun = {name: threading.Event() for name in ("other", "same", "all")}

    def write(name: str, survey: int | None) -> None:
        begun[name].set()
        with writing(factory, survey) as session:
            came.append(name)
            create_survey(session, name=name, actor=None)

    waiting = {"same": threading.Thread(target=write, args=("same", 1), daemon=True)}
    waiting["all"] = threading.Thread(target=write, args=("all", None), daemon=True)
    with writing(factory, 1):
        write("other", 2)
        for name, thread in waiting.items():
            thread.start()
            begun[name].wait(NEVER_S)
            thread.join(0.3)
        assert came == ["other"]
    for thread in waiting.values():
        thread.join(NEVER_S)
    assert sorted(came) == ["all", "other", "same"]
    with reading(factory) as session:
        assert verify_records(session).ok


def test_who_shares_the_database_in_another_schema_is_not_waited_for(database_url: str) -> None:
    if not SERVER:
        pytest.skip("SQLite has one installation a file")
    own = make_url(database_url)
    options = f"{own.query['options']} -clock_timeout=2000"
    engine = make_engine(own.update_query_dict({"options": options}).render_as_string(hide_password=False))
    neighbour = make_engine(SERVER)
    with writing(session_factory(neighbour)), writing(session_factory(engine)) as session:
        create_survey(session, name="meanwhile", actor=None)
    neighbour.dispose()
    engine.dispose()
