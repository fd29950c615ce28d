"""Connections to PostgreSQL that died without a word, and writers that died with the turn in hand."""

import asyncio
import threading
import time
from collections.abc import Iterator

import psycopg
import pytest
from sqlalchemy import Engine, make_url, text

from sightline.infra.database import engine as database
from sightline.infra.database import postgres
from sightline.infra.database.engine import (
    SIGN_IN,
    DatabaseAway,
    make_engine,
    reading,
    session_factory,
    writing,
)
from sightline.surveys.store import create_survey, list_surveys
from tests.conftest import SERVER
from tests.support.relay import Relay
from tests.support.waiting import NEVER_S, until

pytestmark = [
    pytest.mark.dialect,
    pytest.mark.skipif(not SERVER, reason="SQLite has no connection that could die"),
]


@pytest.fixture
def relay(database_url: str) -> Iterator[Relay]:
    address = make_url(database_url)
    with Relay(address.host or "127.0.0.1", address.port or 5432) as relay:
        yield relay


@pytest.fixture
def through(relay: Relay, database_url: str, monkeypatch: pytest.MonkeyPatch) -> Iterator[Engine]:
    """An engine that reaches the database by the relay, and waits a second for an answer; to a write longer
    than another writer may rest in its turn, as outside of tests.
    """
    for name, seconds in {"PING_S": 1.0, "READ_S": 1.0, "SHORT_WRITE_S": 3.0, "LONG_WRITE_S": 3.0}.items():
        monkeypatch.setattr(postgres, name, seconds)
    monkeypatch.setattr(postgres, "HEARD_S", 0.0)
    monkeypatch.setattr(postgres.LimitedConnection, "answer_s", 1.0)
    monkeypatch.setattr(database, "SHORT_IDLE_S", 1.0)
    monkeypatch.setattr(database, "LONG_IDLE_S", 1.0)
    address = make_url(database_url).set(host="127.0.0.1", port=relay.port)
    engine = make_engine(address.render_as_string(hide_password=False))
    yield engine
    engine.dispose()


@pytest.mark.parametrize("within", [None, 1, SIGN_IN])
def test_a_writer_whose_connection_died_gives_its_turn_up(
    relay: Relay, through: Engine, engine: Engine, within: int | None
) -> None:
    """Others write after the idle limit; the process itself hears that nothing answers, and writes again."""
    ours, others = session_factory(through), session_factory(engine)
    with pytest.raises(DatabaseAway, match="does not answer"), writing(ours, within) as session:
        create_survey(session, name="lost", actor=None)
        assert relay.freeze() >= 1
        with writing(others, within) as other:
            create_survey(other, name="another machine's", actor=None)
        create_survey(session, name="lost too", actor=None)
    with writing(ours, within) as session:
        create_survey(session, name="ours again", actor=None)
    with reading(ours) as session:
        assert {one.name for one in list_surveys(session)} == {"another machine's", "ours again"}


def test_connections_that_died_in_the_pool_are_found_by_one_question(relay: Relay, through: Engine) -> None:
    ours = session_factory(through)
    inside = threading.Barrier(5)

    def ask() -> None:
        with reading(ours) as session:
            session.execute(text("SELECT 1"))
            inside.wait(NEVER_S)

    threads = [threading.Thread(target=ask, daemon=True) for _ in range(4)]
    for thread in threads:
        thread.start()
    inside.wait(NEVER_S)
    for thread in threads:
        thread.join(NEVER_S)
    assert relay.freeze() == 4
    begun = time.monotonic()
    for _ in range(4):
        with reading(ours) as session:
            assert session.execute(text("SELECT 1")).scalar_one() == 1
    # one silent second; without limits it would be four times the kernel's patience
    assert time.monotonic() - begun >= 1.0 and through.pool.checkedout() == 0  # type: ignore[attr-defined]


def test_a_long_answer_is_waited_for_and_a_lost_one_is_not(
    relay: Relay, through: Engine, engine: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The server is asked whether it is still at the statement: while it is, its answer may come."""
    monkeypatch.setattr(postgres, "READ_S", NEVER_S)
    monkeypatch.setattr(postgres, "SILENT_S", 0.1)
    monkeypatch.setattr(postgres, "ON_ITS_WAY_S", 0.1)
    ours = session_factory(through)
    with reading(ours) as session:
        assert session.execute(text("SELECT 7 FROM pg_sleep(1)")).scalar_one() == 7

    def freeze() -> None:
        at_work = "FROM pg_stat_activity WHERE query LIKE 'SELECT 8 FROM%' AND state = 'active'"
        with engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection:
            until(lambda: connection.execute(text(f"SELECT 1 {at_work}")).first())
            relay.freeze()
            connection.execute(text(f"SELECT pg_cancel_backend(pid) {at_work}"))

    freezing = threading.Thread(target=freeze)
    freezing.start()
    begun = time.monotonic()
    with pytest.raises(DatabaseAway, match="does not answer"), reading(ours) as session:
        session.execute(text("SELECT 8 FROM pg_sleep(600)"))
    freezing.join()
    assert time.monotonic() - begun < NEVER_S / 2


def test_a_worker_waits_for_notices_and_not_for_a_dead_connection(
    relay: Relay, database_url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    address = make_url(database_url).set(drivername="postgresql", host="127.0.0.1", port=relay.port)

    async def work() -> None:
        info = address.render_as_string(hide_password=False)
        connection = await postgres.LimitedAsyncConnection.connect(info, autocommit=True)
        monkeypatch.setattr(postgres, "SHORT_WRITE_S", 0.2)
        with pytest.raises(TimeoutError):
            await asyncio.wait_for(anext(connection.notifies()), 0.5)
        relay.freeze()
        with pytest.raises(psycopg.OperationalError):
            await connection.execute("SELECT 1")
        assert connection.closed

    asyncio.run(work())


def test_a_writer_that_does_nothing_is_ended_and_stores_nothing(
    factory: database.SessionFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Eight seconds in a survey and where people wait, thirty in the turn of all; here a tenth of one."""
    serving = session_factory(database.engine_of(factory), idle_s=database.SHORT_IDLE_S)
    assert postgres.LOCK_S < database.SHORT_IDLE_S  # else a dead waiter gets the turn of a dead writer
    turns = ((factory, 1, "8s"), (factory, SIGN_IN, "8s"), (factory, None, "30s"), (serving, None, "8s"))
    for sessions, within, limit in turns:
        with writing(sessions, within) as session:
            assert session.execute(text("SHOW idle_in_transaction_session_timeout")).scalar_one() == limit
    monkeypatch.setattr(database, "SHORT_IDLE_S", 0.1)
    with pytest.raises(DatabaseAway, match="does not answer"), writing(factory, 1) as session:
        create_survey(session, name="half", actor=None)
        with writing(factory, 1) as other:  # its turn comes when the idle one has ended
            create_survey(other, name="next", actor=None)
        create_survey(session, name="too late", actor=None)
    with reading(factory) as session:
        assert {one.name for one in list_surveys(session)} == {"next"}


def test_who_signs_in_waits_for_no_survey(factory: database.SessionFactory) -> None:
    with writing(factory), writing(factory, SIGN_IN) as session:
        session.execute(text("SELECT 1"))


def test_a_turn_that_does_not_come_is_said_to_be_busy(
    database_url: str, factory: database.SessionFactory
) -> None:
    address = make_url(database_url)
    options = f"{address.query.get('options', '')} -clock_timeout=100"
    impatient = make_engine(address.update_query_dict({"options": options}).render_as_string(False))
    with (
        writing(factory, 1),
        pytest.raises(DatabaseAway, match="busy"),
        writing(session_factory(impatient), 1),
    ):
        pass
    impatient.dispose()
