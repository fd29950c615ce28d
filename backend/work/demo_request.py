"""Asking for the demonstration survey; apart from its making: a starting server needs no renderer."""

from sqlalchemy.orm import Session

from backend.storage import jobs as table
from backend.storage import surveys
from backend.storage.records import Job, JobState
from backend.work import jobs

KIND = "demonstration"
_UNDER_WAY: tuple[JobState, ...] = ("queued", "running")


def ensure_requested(session: Session) -> Job | None:
    """Queue the making of the demonstration survey unless it is there; None if it is, else its job."""
    if surveys.demo_survey_id(session) is not None:
        return None
    for state in _UNDER_WAY:
        for job in table.listing(session, state=state):
            if job.kind == KIND:
                return job
    return jobs.enqueue(session, KIND, {}, survey_id=None, actor=None)
