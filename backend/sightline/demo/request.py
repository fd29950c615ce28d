"""Asking for the demonstration survey; apart from its making: a starting server needs no renderer."""

from collections.abc import Sequence
from typing import Any

from sightline.enums import JobState
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import list_jobs
from sightline.surveys.store import demo_survey_id

KIND, STUDY_KIND = "demonstration", "demonstration_study"
_UNDER_WAY: tuple[JobState, ...] = ("queued", "running")


def request_both(session: Session) -> Job | None:
    """Queue the demonstration study and, behind it, the survey: on the first start, not where the survey is
    there, waits or is being made (a test that asked for a part of it wants no study). The survey's job.
    """
    if demo_survey_id(session) is not None or _under_way(session) is not None:
        return ensure_requested(session)
    registry.enqueue(session, STUDY_KIND, {}, survey_id=None, actor=None)
    return ensure_requested(session)


def _under_way(session: Session) -> Job | None:
    found = (job for state in _UNDER_WAY for job in list_jobs(session, state=state) if job.kind == KIND)
    return next(found, None)


def ensure_requested(
    session: Session, *, scenes: Sequence[str] = (), scan_vehicles: int | None = None
) -> Job | None:
    """Queue the making of the demonstration survey unless it is there; None if it is, else its job.

    `scenes` (such as "day:2", its first two vehicles) and `scan_vehicles` cut it, so that a test need not
    wait for all of it; a job that waits already stays as it was asked for.
    """
    if demo_survey_id(session) is not None:
        return None
    under_way = _under_way(session)
    if under_way is not None:
        return under_way
    payload: dict[str, Any] = {"scenes": list(scenes)} if scenes else {}
    if scan_vehicles is not None:
        payload["scan_vehicles"] = scan_vehicles
    return registry.enqueue(session, KIND, payload, survey_id=None, actor=None)
