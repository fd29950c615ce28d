"""Did the camera move since its camera pose: what was found, looking again, and what people decide."""

from fastapi import APIRouter

from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.quality.drift.bodies import Decision, DriftBody, drift_body
from sightline.recordings.drift_request import request_drift, under_way
from sightline.recordings.store import decide_drift, get_recording, take_back_drift_decision

router = APIRouter()


@router.get("/recordings/{recording_id}/drift")
def get_drift(recording_id: PathId, who: Viewer, session: Reading) -> DriftBody:
    """What was found of the camera since the camera pose in force, and whether it is being looked at."""
    recording = get_recording(session, recording_id)
    job = under_way(session, recording)
    return drift_body(recording).model_copy(
        update={"job": None if job is None else JobBody.model_validate(job)}
    )


@router.post("/recordings/{recording_id}/drift", status_code=202)
def look_again(recording_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Look at the whole recording, in the background. A conflict without a camera pose."""
    return JobBody.model_validate(request_drift(session, recording_id, actor=who.id))


@router.put("/recordings/{recording_id}/drift/decision")
def decide(recording_id: PathId, body: Decision, who: Operator, session: Writing) -> DriftBody:
    """The camera pose is still good although the camera moved: its measurements are flagged no more."""
    return drift_body(decide_drift(session, recording_id, body.reason, actor=who.id))


@router.delete("/recordings/{recording_id}/drift/decision")
def take_back(recording_id: PathId, who: Operator, session: Writing) -> DriftBody:
    """Take the decision back."""
    return drift_body(take_back_drift_decision(session, recording_id, actor=who.id))
