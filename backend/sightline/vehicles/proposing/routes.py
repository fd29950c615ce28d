"""Proposals of what to click, made in the background and read by the measure page."""

from fastapi import APIRouter

from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.recordings.store import get_recording
from sightline.vehicles.proposing import propose_job
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import proposals_of_recording

router = APIRouter()


@router.post("/recordings/{recording_id}/propose", status_code=202)
def propose(recording_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Propose in the background what to click of every found pass, in the place of what was proposed before.

    Proposals are no measurements: a person confirms, moves or ignores them.
    """
    return JobBody.model_validate(propose_job.request_proposals(session, recording_id, actor=who.id))


@router.get("/recordings/{recording_id}/proposals")
def list_proposals(recording_id: PathId, who: Viewer, session: Reading) -> list[PointProposal]:
    """What is proposed with the road pose in force, by vehicle; of each point a place, or why none."""
    get_recording(session, recording_id)
    return list(proposals_of_recording(session, recording_id))
