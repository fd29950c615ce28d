"""The audit trail: reading it, and checking that nothing was changed."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.infra.audit import trail
from sightline.infra.audit.records import AuditEvent, Verification
from sightline.infra.audit.verification import verify_records
from sightline.infra.web.bodies import Id
from sightline.infra.web.deps import Reading, Viewer

router = APIRouter()


@router.get("/audit")
def list_audit(
    who: Viewer,
    session: Reading,
    survey_id: Annotated[Id | None, Query()] = None,
    entity: Annotated[str | None, Query(max_length=40)] = None,
    before_id: Annotated[Id | None, Query()] = None,
    limit: Annotated[int, Query(ge=1, le=1000)] = 100,
) -> tuple[AuditEvent, ...]:
    """Events, newest first; `before_id` turns the page."""
    return trail.listing(session, survey_id=survey_id, entity=entity, before_id=before_id, limit=limit)


@router.post("/audit/verify")
def verify_audit(who: Viewer, session: Reading) -> Verification:
    """Go through the whole chain and the rows it speaks of; `problem` says in one sentence what is wrong."""
    return verify_records(session)
