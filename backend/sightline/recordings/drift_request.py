"""Asking whether the camera of a recording moved; `quality` has the job that looks."""

from sightline.errors import Conflict
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import jobs_under_way
from sightline.recordings.records import Recording
from sightline.recordings.store import get_ready_recording, get_recording

DRIFT = "drift"


def request_drift(session: Session, recording_id: int, *, actor: int | None) -> Job:
    """Queue a look at the whole recording. Raises Conflict without a road pose, BadInput while not ready."""
    recording = get_ready_recording(session, recording_id)
    if recording.pose_id is None:
        raise Conflict("recordings-no-pose", name=recording.name)
    payload = {"recording_id": recording_id, "pose_id": recording.pose_id}
    return registry.enqueue(
        session, DRIFT, payload, survey_id=recording.survey_id, recording_id=recording_id, actor=actor
    )


def request_if_posed(session: Session, recording_id: int, *, actor: int | None) -> None:
    """The same after a pose was taken or chosen; nothing for a recording without pose or frames."""
    recording = get_recording(session, recording_id)
    if recording.state == "ready" and recording.pose_id is not None:
        request_drift(session, recording_id, actor=actor)


def under_way(session: Session, recording: Recording) -> Job | None:
    """The look at a recording that waits or runs, if there is one."""
    return next(iter(jobs_under_way(session, DRIFT, recording_id=recording.id)), None)
