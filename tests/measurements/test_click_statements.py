"""What a stored click costs the database: every statement of the request is counted."""

from collections.abc import Callable
from uuid import uuid4

import pytest
from sqlalchemy import event

from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, clicks, measure

MOST_STATEMENTS = 9

pytestmark = pytest.mark.dialect


def _statements(services: Services, action: Callable[[], object]) -> list[str]:
    ran: list[str] = []

    def note(*given: object) -> None:
        statement = str(given[2])
        # PostgreSQL's lock of the chain; SQLite's comes with BEGIN, which is not counted either.
        if "pg_advisory_xact_lock" not in statement:
            ran.append(statement)

    event.listen(services.engine, "before_cursor_execute", note)
    try:
        action()
    finally:
        event.remove(services.engine, "before_cursor_execute", note)
    return ran


def test_a_stored_click_takes_at_most_nine_statements(
    operator: Client, services: Services, ground: Ground
) -> None:
    vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
    first = measure(operator, vehicle_id)  # the road pose is parsed once, then kept
    more = [{"frame": 5, **{name: clicks()[name] for name in ("contact", "target_point")}}]
    new = {**clicks(1.25, target="taillight"), "client_key": str(uuid4()), "more_frames": more}
    revised = {**clicks(1.3), "revision": 1, "more_frames": more}
    # Who clicks is believed for a moment, as an account and as a member; a click is not their first request.
    operator.seen(f"/measurements/{first['id']}")
    ran = {
        "new": _statements(services, lambda: operator.made(f"/vehicles/{vehicle_id}/measurements", new)),
        "revision": _statements(services, lambda: operator.put(f"/measurements/{first['id']}", revised)),
    }
    for kind, statements in ran.items():
        assert len(statements) <= MOST_STATEMENTS, (kind, len(statements), statements)
        assert sum("INSERT INTO audit_events" in one for one in statements) == 1, kind
    with services.reading() as session:
        assert verify_records(session).ok
