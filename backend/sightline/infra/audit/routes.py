"""The audit trail: reading it, and checking that nothing was changed."""

from dataclasses import replace
from typing import Annotated

from fastapi import APIRouter, Query

from sightline.infra.audit import trail
from sightline.infra.audit.records import AuditEvent, Verification
from sightline.infra.audit.verification import verify_records
from sightline.infra.web.bodies import Id
from sightline.infra.web.deps import Reading, SurveysSeen, Viewer
from sightline.messages import say

router = APIRouter()


@router.get("/audit")
def list_audit(
    who: Viewer,
    session: Reading,
    seen: SurveysSeen,
    survey_id: Annotated[Id | None, Query()] = None,
    entity: Annotated[str | None, Query(max_length=40)] = None,
    before_id: Annotated[Id | None, Query()] = None,
    limit: Annotated[int, Query(ge=1, le=1000)] = 100,
) -> tuple[AuditEvent, ...]:
    """Events, newest first; `before_id` turns the page."""
    return trail.listing(
        session, survey_id=survey_id, entity=entity, seen=seen, before_id=before_id, limit=limit
    )


@router.post("/audit/verify")
def verify_audit(who: Viewer, session: Reading, seen: SurveysSeen) -> Verification:
    """Go through all chains and the rows they speak of; `problem` says in one sentence what is wrong.

    Where it is may concern a survey that the person does not see: that is said to administrators alone.
    """
    found = verify_records(session)
    if found.problem is None or seen is None:
        return found
    return replace(found, problem=say("audit-problem-ask-admin", {}))
