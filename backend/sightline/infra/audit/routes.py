"""The audit trail: reading it, checking that nothing was changed, and signing where its chains end."""

from typing import Annotated

from fastapi import APIRouter, Query, Response

from sightline.infra.audit import trail
from sightline.infra.audit.checkpoints import checkpoint_document, listed_checkpoints, sign_checkpoint
from sightline.infra.audit.records import AuditEvent, Checkpoints, Verification
from sightline.infra.audit.signing import signing_key
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.schema import json_bytes
from sightline.infra.web.bodies import Id
from sightline.infra.web.deps import Admin, PathId, Reading, SurveysSeen, Viewer, Wired, Writing
from sightline.infra.web.named import SurveyId

router = APIRouter()

#: How many checkpoints a page shows: each export signs one.
_MOST_SHOWN = 50


@router.get("/audit")
def list_audit(
    who: Viewer,
    session: Reading,
    seen: SurveysSeen,
    survey_id: Annotated[SurveyId | None, Query()] = None,
    entity: Annotated[str | None, Query(max_length=40)] = None,
    before_id: Annotated[Id | None, Query()] = None,
    limit: Annotated[int, Query(ge=1, le=1000)] = 100,
) -> tuple[AuditEvent, ...]:
    """Events, newest first; `before_id` turns the page."""
    return trail.listing(
        session, survey_id=survey_id, entity=entity, seen=seen, before_id=before_id, limit=limit
    )


@router.post("/audit/verify")
def verify_audit(who: Admin, session: Reading) -> Verification:
    """Go through all chains and the rows they speak of; `problem` says in one sentence what is wrong."""
    return verify_records(session)


@router.get("/audit/checkpoints")
def list_checkpoints(who: Admin, session: Reading) -> Checkpoints:
    """The newest checkpoints and the key that signs now."""
    return listed_checkpoints(session, _MOST_SHOWN)


@router.post("/audit/checkpoints", status_code=201)
def add_checkpoint(who: Admin, services: Wired, session: Writing) -> Checkpoints:
    """Sign the ends of all chains now; the answer is the list with the new one first."""
    sign_checkpoint(session, signing_key(services.settings), actor=who.id)
    return listed_checkpoints(session, _MOST_SHOWN)


@router.get("/audit/checkpoints/{checkpoint_id}/checkpoint.json", response_class=Response)
def download_checkpoint(checkpoint_id: PathId, who: Admin, session: Reading) -> Response:
    """A checkpoint with the keys and how each was handed on, as `sightline checkpoint -o` writes it."""
    document = checkpoint_document(session, checkpoint_id)
    headers = {"Content-Disposition": f'attachment; filename="checkpoint-{checkpoint_id}.json"'}
    return Response(json_bytes(document), media_type="application/json", headers=headers)
