"""Passes, looked for in the background."""

from fastapi import APIRouter

from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Writing
from sightline.vehicles.passes import find_job

router = APIRouter()


@router.post("/recordings/{recording_id}/find-passes", status_code=202)
def find_passes(recording_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Look for vehicle passes in the background; those that are there or were discarded are left alone."""
    return JobBody.model_validate(find_job.request_passes(session, recording_id, actor=who.id))
