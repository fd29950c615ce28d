"""Evidence files: the event that says one was made, and the events of the chain that one carries."""

from collections.abc import Collection, Mapping
from typing import Any

from sqlalchemy import and_, or_
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.audit.records import AuditEvent
from sightline.infra.audit.tables import audit_events
from sightline.scans.vehicles.store import get_scan_vehicle

_MOST_EVENTS = 1000


def note_evidence(session: Session, vehicle_id: int, made: Mapping[str, Any], *, actor: int | None) -> int:
    """Append to the survey's chain that a file of a vehicle was made; `made` names it by its hash."""
    survey_id = get_scan_vehicle(session, vehicle_id).survey_id
    return trail.record(session, actor, "create", "evidence", vehicle_id, survey_id, None, made)


def events_about(
    session: Session,
    survey_id: int,
    scan_id: int,
    measurement_ids: Collection[int],
    review_ids: Collection[int],
) -> tuple[AuditEvent, ...]:
    """Every event of a recording, of some measurements and of some verdicts, oldest first."""
    e = audit_events.c
    among = or_(
        and_(e.entity == "scan", e.entity_id == scan_id),
        and_(e.entity == "scan_measurement", e.entity_id.in_(measurement_ids)),
        and_(e.entity == "scan_review", e.entity_id.in_(review_ids)),
    )
    found = trail.listing(session, survey_id=survey_id, among=among, limit=_MOST_EVENTS)
    return tuple(reversed(found))
