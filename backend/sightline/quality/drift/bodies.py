"""Camera stability as it goes out, and what people decide of it as it comes in."""

from pydantic import Field

from sightline.infra.web.bodies import In, JobBody, Out, Text, of_record
from sightline.recordings.drift import (
    DriftCheck,
    DriftDecision,
    DriftLook,
    MovedSpan,
    drift_check_of,
    open_spans,
)
from sightline.recordings.records import Recording


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
