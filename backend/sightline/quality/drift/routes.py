"""Did the camera move since its camera pose: what was found, looking again, and what people decide."""

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import In, JobBody, Out, Text, of_record
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.recordings.drift import (
    DriftCheck,
    DriftDecision,
    DriftLook,
    MovedSpan,
    drift_check_of,
    open_spans,
)
from sightline.recordings.drift_request import request_drift, under_way
from sightline.recordings.records import Recording
from sightline.recordings.store import decide_drift, get_recording, take_back_drift_decision

router = APIRouter()


@of_record(DriftLook, optional=True)
class DriftSample(Out):
    """One frame against the pose's: a motion in pixels with what it is worth in height, or a reason."""

    frame: int
    time_s: float


class SpanBody(Out):
    first_frame: int
    last_frame: int
    moved: bool
    moved_px: float
    u_px: float
    change_m: float | None


@of_record(DriftDecision, "by_id", "spans")
class DecisionBody(Out):
    holds: bool = Field(description="Whether it is about the pose in force.")


@of_record(DriftCheck)
class CheckBody(Out):
    looks: list[DriftSample]
    spans: list[SpanBody]


class DriftBody(Out):
    """`check` is None while nobody has looked since the pose in force was taken."""

    recording_id: int
    pose_id: int | None
    check: CheckBody | None
    decision: DecisionBody | None
    flagged: list[MovedSpan]
    job: JobBody | None = Field(default=None, description="A look that waits or is under way.")


class Decision(In):
    reason: Text = Field(min_length=1, description="Why the camera pose is still good.")


def drift_body(recording: Recording) -> DriftBody:
    check, decision = drift_check_of(recording.drift, recording.pose_id), recording.drift_decision
    shown_decision = (
        None if decision is None else {**decision, "holds": decision["pose_id"] == recording.pose_id}
    )
    return DriftBody.model_validate(
        {
            "recording_id": recording.id,
            "pose_id": recording.pose_id,
            "check": check,
            "decision": shown_decision,
            "flagged": open_spans(recording.drift, decision, recording.pose_id),
        }
    )


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
