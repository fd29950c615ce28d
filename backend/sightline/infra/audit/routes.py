"""The audit trail: reading it, and checking that nothing was changed."""

from datetime import datetime
from typing import Annotated, Any

from fastapi import APIRouter, Query

from sightline.infra.audit import trail
from sightline.infra.audit.verification import verify_records
from sightline.infra.web.bodies import Id, Out, WhoBody
from sightline.infra.web.deps import Reading, Viewer

router = APIRouter()


class AuditEventBody(Out):
    id: int
    at: datetime
    actor: WhoBody | None
    action: str
    entity: str
    entity_id: int | None
    survey_id: int | None
    before: dict[str, Any] | None
    after: dict[str, Any] | None
    hash: str
    previous_hash: str


class VerificationBody(Out):
    ok: bool
    checked: int
    head_hash: str
    problem: str | None


@router.get("/audit")
def list_audit(
    who: Viewer,
    session: Reading,
    survey_id: Annotated[Id | None, Query()] = None,
    entity: Annotated[str | None, Query(max_length=40)] = None,
    before_id: Annotated[Id | None, Query()] = None,
    limit: Annotated[int, Query(ge=1, le=1000)] = 100,
) -> list[AuditEventBody]:
    """Events, newest first; `before_id` turns the page."""
    events = trail.listing(session, survey_id=survey_id, entity=entity, before_id=before_id, limit=limit)
    return [AuditEventBody.model_validate(one) for one in events]


@router.post("/audit/verify")
def verify_audit(who: Viewer, session: Reading) -> VerificationBody:
    """Go through the whole chain and the rows it speaks of; `problem` says in one sentence what is wrong."""
    return VerificationBody.model_validate(verify_records(session))
