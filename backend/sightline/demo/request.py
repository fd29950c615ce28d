"""Asking for the demonstration survey; apart from its making, which a starting server does not load."""

from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import jobs_under_way
from sightline.surveys.store import demo_survey_id

KIND, STUDY_KIND = "demonstration", "demonstration_study"


def request_both(session: Session) -> Job | None:
    """Queue the demonstration study and, behind it, the survey: on the first start, not where the survey is
    there, waits or is being made (a test that asked for a part of it wants no study). The survey's job.
    """
    if demo_survey_id(session) is not None or _under_way(session) is not None:
        return ensure_requested(session)
    registry.enqueue(session, STUDY_KIND, {}, survey_id=None, actor=None)
    return ensure_requested(session)


def _under_way(session: Session) -> Job | None:
    return next(iter(jobs_under_way(session, KIND)), None)


def ensure_requested(session: Session) -> Job | None:
    """Queue the making of the demonstration survey unless it is there; None if it is, else its job."""
    if demo_survey_id(session) is not None:
        return None
    under_way = _under_way(session)
    if under_way is not None:
        return under_way
    return registry.enqueue(session, KIND, {}, survey_id=None, actor=None)
