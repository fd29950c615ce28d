"""Proposals of what to click, made in the background and read by the measure page."""

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import In, JobBody
from sightline.infra.web.deps import Manager, Operator, PathId, Reading, Viewer, Writing
from sightline.recordings.store import get_recording
from sightline.vehicles.proposing import plan_store, propose_job
from sightline.vehicles.proposing.records import FreePlan, PointProposal
from sightline.vehicles.proposing.store import proposals_of_recording

router = APIRouter()


class FreePlanIn(In):
    free_one_in: int = Field(ge=0, le=100, description="One in so many shows no proposal; 0: none.")
    version: int = Field(description="Of the plan that it replaces.")


@router.post("/recordings/{recording_id}/propose", status_code=202)
def propose(recording_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Propose in the background what to click of every found pass, in the place of what was proposed before.

    Proposals are no measurements: a person confirms, moves or ignores them.
    """
    return JobBody.model_validate(propose_job.request_proposals(session, recording_id, actor=who.id))


@router.get("/recordings/{recording_id}/proposals")
def list_proposals(recording_id: PathId, who: Viewer, session: Reading) -> list[PointProposal]:
    """What is proposed with the road pose in force, by vehicle; of each point a place, or why none. Of a
    vehicle that is measured free the frame alone.
    """
    get_recording(session, recording_id)
    return [one.as_shown for one in proposals_of_recording(session, recording_id)]


@router.get("/surveys/{survey_id}/free-plan")
def free_plan(survey_id: PathId, who: Viewer, session: Reading) -> FreePlan:
    """How many vehicles are measured free of proposals, to know how far people lean on them."""
    return plan_store.get_free_plan(session, survey_id)


@router.put("/surveys/{survey_id}/free-plan")
def choose_free_plan(survey_id: PathId, body: FreePlanIn, who: Manager, session: Writing) -> FreePlan:
    """Put another plan in its place; which vehicles it hits the server draws."""
    return plan_store.choose_free_plan(
        session, survey_id, free_one_in=body.free_one_in, version=body.version, actor=who.id
    )
