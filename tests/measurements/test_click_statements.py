"""What a stored click costs the database: every statement of the request is counted."""

import math
from collections.abc import Callable
from typing import Any
from uuid import uuid4

import pytest
from sqlalchemy import event

from sightline.infra.audit.verification import verify_records
from sightline.infra.database.postgres import LimitedConnection
from sightline.infra.services import Services
from sightline.infra.web import access, cookie
from sightline.infra.web.idempotency import Idempotency
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, clicks, measure

#: with SQLite's BEGIN; on PostgreSQL an event, its chain's new end and its request's key are one statement
MOST_STATEMENTS = {"sqlite": 8, "postgresql": 6}
MOST_WITH_KEY = {"sqlite": 9, "postgresql": 6}
#: What a click of PostgreSQL waits for beside: BEGIN, its turn, COMMIT.
MOST_ANSWERS = 9

pytestmark = pytest.mark.dialect


@pytest.fixture(autouse=True)
def believed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Who clicks is believed for a moment, account and member; here however slow the machine is."""
    for room in (access, cookie):
        monkeypatch.setattr(room, "BELIEVED_S", 3600.0)


@pytest.fixture(autouse=True)
def answered(monkeypatch: pytest.MonkeyPatch) -> None:
    """For what is kept after the answer nobody waits."""

    async def nothing(*_given: object) -> None:
        return None

    monkeypatch.setattr(Idempotency, "_keep", nothing)


def _statements(services: Services, action: Callable[[], object]) -> list[str]:
    ran: list[str] = []

    def note(*given: object) -> None:
        statement = str(given[2])
        # PostgreSQL's turn, which on SQLite comes with BEGIN
        if "pg_advisory_xact_lock" not in statement:
            ran.append(statement)

    event.listen(services.engine, "before_cursor_execute", note)
    try:
        action()
    finally:
        event.remove(services.engine, "before_cursor_execute", note)
    return ran


def _key() -> dict[str, str]:
    return {"Idempotency-Key": str(uuid4())}


@pytest.mark.parametrize("keyed", [False, True])
def test_a_stored_click_takes_few_statements_and_answers_as_what_is_read_afterwards(
    operator: Client, services: Services, ground: Ground, keyed: bool
) -> None:
    headers = _key if keyed else dict[str, str]
    vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
    first = measure(operator, vehicle_id)  # the road pose is parsed once, then kept
    more = [{"frame": 5, **{name: clicks()[name] for name in ("contact", "target_point")}}]
    new = {**clicks(1.25, target="taillight"), "client_key": str(uuid4()), "more_frames": more}
    revised = {**clicks(1.3), "revision": 1, "more_frames": more}
    # a click is not their first request
    operator.seen(f"/measurements/{first['id']}")
    said: list[Any] = []
    ran = {
        "new": _statements(
            services,
            lambda: said.append(
                operator.post(f"/vehicles/{vehicle_id}/measurements", new, headers=headers()).json()
            ),
        ),
        "revision": _statements(
            services,
            lambda: said.append(
                operator.put(f"/measurements/{first['id']}", revised, headers=headers()).json()
            ),
        ),
    }
    most = (MOST_WITH_KEY if keyed else MOST_STATEMENTS)[services.engine.dialect.name]
    for kind, statements in ran.items():
        assert len(statements) <= most, (kind, len(statements), statements)
        assert sum("INSERT INTO audit_events" in one for one in statements) == 1, kind
    assert said == [operator.seen(f"/measurements/{one['id']}") for one in said]
    with services.reading() as session:
        assert verify_records(session).ok


def test_a_click_of_postgresql_waits_for_few_answers(
    operator: Client, services: Services, ground: Ground, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every answer of the server is a switch of threads; a click had seventeen."""
    if services.engine.dialect.name == "sqlite":
        pytest.skip("SQLite answers within the process")
    vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
    first = measure(operator, vehicle_id)
    operator.seen(f"/measurements/{first['id']}")
    waits, wait = list[object](), LimitedConnection.wait

    def counted(self: LimitedConnection, *given: Any, **named: Any) -> Any:
        waits.append(self)
        return wait(self, *given, **named)

    monkeypatch.setattr(
        LimitedConnection, "heard_at_s", math.inf
    )  # it was heard just now, whatever else runs
    monkeypatch.setattr(LimitedConnection, "wait", counted)
    answer = operator.put(f"/measurements/{first['id']}", {**clicks(1.3), "revision": 1}, headers=_key())
    assert answer.status_code == 200 and len(waits) <= MOST_ANSWERS, len(waits)
