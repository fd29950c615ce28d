"""Short writes: each a transaction of its own, several together on the disk, and nobody told before."""

import asyncio
import threading
from collections.abc import Callable, Iterator
from functools import partial

import pytest
from sqlalchemy import event, text
from sqlalchemy.orm import Session

from sightline.infra.database.engine import DatabaseAway
from sightline.infra.services import Services
from sightline.infra.web.write_gate import WriteGate
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.dialect


def _noted(services: Services) -> list[str]:
    """What the database does from now on: begin, commit, rollback, sync."""
    seen: list[str] = []
    for word in ("begin", "commit", "rollback"):
        event.listen(services.engine, word, partial(lambda word, _connection: seen.append(word), word))
    return seen


def _synced(seen: list[str], monkeypatch: pytest.MonkeyPatch, services: Services) -> None:
    real = Services.sync

    def sync(_self: Services) -> None:
        real(services)
        seen.append("sync")

    monkeypatch.setattr(Services, "sync", sync)


@pytest.fixture
def table(services: Services) -> Iterator[None]:
    with services.writing() as session:
        session.execute(text("CREATE TABLE notes (id INTEGER PRIMARY KEY)"))
    yield
    with services.writing() as session:
        session.execute(text("DROP TABLE notes"))


def _add(number: int) -> Callable[[Session], int]:
    def work(session: Session) -> int:
        session.execute(text("INSERT INTO notes VALUES (:number)"), {"number": number})
        if number == 3:
            raise LookupError("not this one")
        return number

    return work


def _stored(services: Services) -> list[int]:
    with services.reading() as session:
        return list(session.execute(text("SELECT id FROM notes ORDER BY id")).scalars())


def test_each_write_is_committed_by_itself_and_the_disk_is_waited_for_once(
    services: Services, table: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, seen = WriteGate(), _noted(services)
    _synced(seen, monkeypatch, services)

    async def together() -> list[object]:
        waiting = (gate.write(services, 1, _add(number)) for number in range(6))
        return list(await asyncio.gather(*waiting, return_exceptions=True))

    answers = asyncio.run(together())
    assert isinstance(answers[3], LookupError)
    assert [one for one in answers if not isinstance(one, LookupError)] == [0, 1, 2, 4, 5]
    assert _stored(services) == [0, 1, 2, 4, 5]
    until = seen[: seen.index("sync")]
    expected = 5 if services.engine.dialect.name == "sqlite" else 6  # PostgreSQL's sync is one more
    assert until.count("commit") == expected
    assert until.count("rollback") == 1 and seen.count("sync") == 1


def test_nobody_is_told_before_the_disk_has_it(
    services: Services, table: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, may_sync, syncs = WriteGate(), threading.Event(), threading.Event()

    def sync(_self: Services) -> None:
        syncs.set()
        assert may_sync.wait(NEVER_S)

    monkeypatch.setattr(Services, "sync", sync)

    async def two() -> None:
        answers = [asyncio.create_task(gate.write(services, 1, _add(number))) for number in (1, 2)]
        assert await asyncio.to_thread(syncs.wait, NEVER_S)
        await asyncio.sleep(0.05)
        assert not any(one.done() for one in answers)
        may_sync.set()
        assert [await one for one in answers] == [1, 2]

    asyncio.run(two())


def test_one_alone_waits_for_the_disk_with_its_own_commit(
    services: Services, table: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen, real = list[bool](), Services.writing

    def writing(self: Services, survey: object = None, *, unsynced: bool = False) -> object:
        seen.append(unsynced)
        return real(self, survey, unsynced=unsynced)  # type: ignore[arg-type]

    monkeypatch.setattr(Services, "writing", writing)
    asyncio.run(WriteGate().write(services, 1, _add(1)))
    assert seen == [False]


def test_a_disk_that_fails_is_told_to_everybody_who_waited_for_it(
    services: Services, table: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    def sync(_self: Services) -> None:
        raise DatabaseAway("database-not-writable")

    monkeypatch.setattr(Services, "sync", sync)
    gate = WriteGate()

    async def together() -> list[object]:
        waiting = (gate.write(services, 1, _add(number)) for number in (1, 2))
        return list(await asyncio.gather(*waiting, return_exceptions=True))

    assert [type(one) for one in asyncio.run(together())] == [DatabaseAway, DatabaseAway]


def test_a_long_write_and_short_ones_wait_for_each_other(services: Services, table: None) -> None:
    gate = WriteGate()

    async def both() -> None:
        async with gate.unit(services.writing()) as session:
            short = asyncio.create_task(gate.write(services, 1, _add(1)))
            await asyncio.sleep(0.05)
            assert not short.done() and gate.waiting == 1
            await asyncio.to_thread(_add(2), session)
        assert await short == 1

    asyncio.run(both())
    assert _stored(services) == [1, 2]


@pytest.mark.once
def test_an_ordinary_write_after_an_unsynced_one_waits_for_the_disk_itself(
    services: Services, table: None
) -> None:
    if services.engine.dialect.name != "sqlite":
        pytest.skip("PostgreSQL's is a setting of the one transaction")
    levels = []
    for unsynced in (True, False, True):
        with services.writing(unsynced=unsynced) as session:
            levels.append(session.execute(text("PRAGMA synchronous")).scalar_one())
    assert levels == [1, 2, 1]  # NORMAL, FULL


def test_the_next_are_written_while_the_disk_is_waited_for(
    services: Services, table: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, may_sync, syncs = WriteGate(), threading.Event(), list[list[int]]()

    def sync(_self: Services) -> None:
        syncs.append(_stored(services))
        assert may_sync.wait(NEVER_S)

    monkeypatch.setattr(Services, "sync", sync)

    async def some() -> list[int]:
        first = [asyncio.create_task(gate.write(services, 1, _add(number))) for number in (1, 2)]
        while not syncs:
            await asyncio.sleep(0.01)
        later = [asyncio.create_task(gate.write(services, 1, _add(number))) for number in (4,)]
        while len(_stored(services)) < 3:
            await asyncio.sleep(0.01)
        later += [asyncio.create_task(gate.write(services, 1, _add(number))) for number in (5, 6)]
        while len(_stored(services)) < 5:
            await asyncio.sleep(0.01)
        assert not any(one.done() for one in (*first, *later))
        may_sync.set()
        return [await one for one in (*first, *later)]

    assert asyncio.run(some()) == [1, 2, 4, 5, 6]
    # one wait for the disk covers all that was committed before it began, and nobody else
    assert syncs == [[1, 2], [1, 2, 4, 5, 6]]
