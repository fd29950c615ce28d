"""Asking for the demonstration survey; apart from its making: a starting server needs no renderer."""

from sqlalchemy.orm import Session

from sightline.enums import JobState
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import list_jobs
from sightline.surveys.store import demo_survey_id

KIND = "demonstration"
_UNDER_WAY: tuple[JobState, ...] = ("queued", "running")


def ensure_requested(session: Session) -> Job | None:
    """Queue the making of the demonstration survey unless it is there; None if it is, else its job."""
    if demo_survey_id(session) is not None:
        return None
    for state in _UNDER_WAY:
        for job in list_jobs(session, state=state):
            if job.kind == KIND:
                return job
    return registry.enqueue(session, KIND, {}, survey_id=None, actor=None)
