"""What becomes of the jobs of worker processes that ended in the middle."""

import logging

from sqlalchemy.orm import Session

from sightline.errors import Away, NoRoom, SightlineError
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.infra.jobs.delivery import deliver, withdraw
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import STOPPED, clean_up, is_long
from sightline.infra.jobs.store import (
    MAX_ATTEMPTS,
    JobLost,
    fail_job,
    job_cancelled,
    postpone_job,
    queued_jobs,
    release_job,
    requeue_job,
    running_jobs,
)

log = logging.getLogger("sightline.jobs")


def put_back(session: Session, job: Job, *, counted: bool = True, postponed: bool = False) -> None:
    """Queue a running job again, or end it: cancelled if that was asked for, failed after three deaths.

    `counted` says whether the attempt counts: it does not where the worker was told to stop. A `postponed`
    job waits for the database or the storage, and its attempt does not count either; its own worker puts it
    back, whose delivery ends with that. Raises JobLost.
    """
    if not postponed:
        withdraw(session, job.id)
    long = is_long(job.kind)
    if job.cancel_requested:
        job_cancelled(session, job)
        clean_up(session, job, STOPPED)
    elif postponed:
        later = postpone_job(session, job)
        deliver(session, job.id, long=long, not_before=later.not_before)
    elif not counted:
        release_job(session, job)
        deliver(session, job.id, long=long)
    elif job.attempts >= MAX_ATTEMPTS:
        error = SightlineError("jobs-gave-up", attempts=job.attempts)
        fail_job(session, job, error)
        clean_up(session, job, error.said)
    else:
        requeue_job(session, job)
        deliver(session, job.id, long=long)


def deliver_anew(session: Session) -> None:
    """Let workers have every job that waits or was being done, where they do not know of them."""
    for job_id, kind in queued_jobs(session).items():
        deliver(session, job_id, long=is_long(kind))
    for job in running_jobs(session):
        put_back(session, job, counted=False)


def take_back(sessions: SessionFactory, *, worker: str | None = None, counted: bool = True) -> int:
    """Put back what an ended worker process was at (without a name: what all were at); how many jobs."""
    with reading(sessions) as session:
        left = running_jobs(session, worker=worker)
    for job in left:
        try:
            with writing(sessions) as session:
                put_back(session, job, counted=counted)
        except JobLost:
            continue
        except (Away, NoRoom):
            raise
        except Exception:
            log.exception("job %s (%s) cannot be put back", job.id, job.kind)
            continue
        if counted:
            log.warning("a worker process ended in the middle of job %s (%s)", job.id, job.kind)
    return len(left)
