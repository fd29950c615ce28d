"""Passes, looked for in the background."""

from fastapi import APIRouter

from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import PathId, Reading, Uploader, Viewer, Writing
from sightline.vehicles.passes import find_job
from sightline.vehicles.store import PassCount, count_passes

router = APIRouter()


@router.post("/recordings/{recording_id}/find-passes", status_code=202)
def find_passes(recording_id: PathId, who: Uploader, session: Writing) -> JobBody:
    """Look for vehicle passes in the background; those that are there or were discarded are left alone."""
    return JobBody.model_validate(find_job.request_passes(session, recording_id, actor=who.id))


@router.get("/surveys/{survey_id}/pass-counts")
def list_pass_counts(survey_id: PathId, who: Viewer, session: Reading) -> tuple[PassCount, ...]:
    """How many passes each recording has, without those that were discarded."""
    return count_passes(session, survey_id)
