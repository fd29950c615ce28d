"""The events of a chain as a test wants them."""

from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.audit.trail import AuditEvent


def events_of(session: Session, survey_id: int | None = None) -> list[AuditEvent]:
    """All events, oldest first, of one survey or of all."""
    found: list[AuditEvent] = []
    while page := trail.listing(
        session, survey_id=survey_id, before_id=found[-1].id if found else None, limit=1000
    ):
        found += page
    return found[::-1]
