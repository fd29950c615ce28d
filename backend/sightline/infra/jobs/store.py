"""The job table: it says what is to be done and what became of it, whatever happens to a worker.

A worker process claims a job under its name. Every change by a worker is guarded by (worker, attempts), so
one that was thought dead and comes back changes nothing. Creating, cancelling, putting back and ending a job
are audited; claiming and progress are not.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import timedelta
from typing import Any, Unpack, get_args

from sqlalchemy import Column, func, or_, select, update
from sqlalchemy.orm import Session

from sightline.enums import AuditAction, EndedState, JobState, JsonObject
from sightline.errors import Conflict, SightlineError
from sightline.infra.audit import trail
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import now
from sightline.infra.jobs.records import Job, JobOf
from sightline.infra.jobs.tables import jobs
from sightline.messages.said import Said

MAX_ATTEMPTS = 3
#: how long a job waits for the database or the storage at first, and at most
FIRST_PAUSE, LONGEST_PAUSE = timedelta(seconds=5), timedelta(minutes=5)


class JobLost(SightlineError):
    """Another worker has this job now, or it is over; the one who asks must stop without a trace."""


@dataclass(frozen=True, slots=True)
class Hold:
    """What a worker learns of its job: does it still hold it, and is it to stop?"""

    held: bool
    cancel_requested: bool


def create_job(
    session: Session,
    kind: str,
    payload: Mapping[str, Any],
    *,
    survey_id: int | None,
    actor: int | None,
    **of: Unpack[JobOf],
) -> Job:
    """A queued job. Use `sightline.infra.jobs.registry.enqueue`, which also has it delivered."""
    content: dict[str, Any] = {"kind": kind, "payload": dict(payload), "survey_id": survey_id}
    content |= {"recording_id": None} | {name: id_ for name, id_ in of.items() if id_ is not None}
    stamps = {"state": "queued", "progress": 0.0, "attempts": 0}
    job_id = add_row(session, jobs, {**content, **stamps, "created_at": now(), "created_by": actor})
    trail.record(session, actor, "create", "job", job_id, survey_id, None, content)
    return get_job(session, job_id)


def get_job(session: Session, job_id: int) -> Job:
    """One job. Raises NotFound."""
    return _job(get_row(session, jobs, job_id, "job"))


def list_jobs(
    session: Session,
    *,
    survey_id: int | None = None,
    state: JobState | None = None,
    seen: Collection[int] | None = None,
    seen_studies: Collection[int] | None = None,
    unless_done: Collection[str] = (),
    limit: int = 100,
) -> tuple[Job, ...]:
    """Jobs, newest first; `seen`, `seen_studies`: only those of these surveys and studies, and of none.

    `unless_done`: the kinds of which those that are done are left out.
    """
    query = select(jobs).order_by(jobs.c.id.desc()).limit(limit)
    query = query.where(or_(jobs.c.state != "done", jobs.c.kind.not_in(unless_done)))
    if seen is not None:
        query = query.where(or_(jobs.c.survey_id.in_(seen), jobs.c.survey_id.is_(None)))
    if seen_studies is not None:
        query = query.where(or_(jobs.c.study_id.in_(seen_studies), jobs.c.study_id.is_(None)))
    if survey_id is not None:
        query = query.where(jobs.c.survey_id == survey_id)
    if state is not None:
        query = query.where(jobs.c.state == state)
    return tuple(_job(row) for row in session.execute(query).mappings())


def jobs_under_way(
    session: Session, kind: str, *, survey_id: int | None = None, recording_id: int | None = None
) -> tuple[Job, ...]:
    """Those of a kind that run or wait, of a survey or a recording alone; running and newest ones first."""
    query = select(jobs).where(jobs.c.kind == kind, jobs.c.state.in_(("running", "queued")))
    for column, id_ in ((jobs.c.survey_id, survey_id), (jobs.c.recording_id, recording_id)):
        query = query if id_ is None else query.where(column == id_)
    query = query.order_by(jobs.c.state.desc(), jobs.c.id.desc())
    return tuple(_job(row) for row in session.execute(query).mappings())


def count_jobs(session: Session) -> dict[JobState, int]:
    """How many jobs are in each state, all states named."""
    query = select(jobs.c.state, func.count()).group_by(jobs.c.state)
    found: dict[str, int] = {str(state): int(count) for state, count in session.execute(query)}
    return {state: found.get(state, 0) for state in get_args(JobState)}


def latest_jobs_of_recordings(session: Session, recording_ids: Sequence[int]) -> dict[int, Job]:
    """The newest job of each recording, by recording."""
    return _latest(session, jobs.c.recording_id, recording_ids)


def latest_jobs_of_scans(session: Session, scan_ids: Sequence[int]) -> dict[int, Job]:
    """The newest job of each line-scan recording, by its id."""
    return _latest(session, jobs.c.scan_id, scan_ids)


def _latest(session: Session, of: Column[Any], ids: Sequence[int]) -> dict[int, Job]:
    newest = select(func.max(jobs.c.id)).where(of.in_(ids)).group_by(of)
    query = select(jobs).where(jobs.c.id.in_(newest))
    return {row[of.name]: _job(row) for row in session.execute(query).mappings()} if ids else {}


def request_job_cancel(session: Session, job_id: int, *, actor: int | None) -> Job:
    """Stop a job: a queued one at once, a running one when it next looks. Raises Conflict if it is over."""
    before = get_job(session, job_id)
    if before.state not in ("queued", "running"):
        raise Conflict("jobs-already-over", job_id=job_id, state=before.state)
    if before.state == "queued":
        change: dict[str, Any] = {"state": "cancelled", "finished_at": now(), "message": None}
    else:
        change = {"cancel_requested": True}
    change_row(session, jobs, job_id, change)
    then = {"state": before.state, "cancel_requested": before.cancel_requested}
    after = {**then, **{key: change[key] for key in then if key in change}}
    trail.record(session, actor, "cancel", "job", job_id, before.survey_id, then, after)
    return get_job(session, job_id)


def claim_job(session: Session, job_id: int, *, worker: str) -> Job | None:
    """Take a queued job; None if somebody else has it or it is over."""
    claimed = session.execute(
        update(jobs)
        .where(jobs.c.id == job_id, jobs.c.state == "queued", jobs.c.attempts < MAX_ATTEMPTS)
        .values(
            state="running",
            worker=worker,
            attempts=jobs.c.attempts + 1,
            started_at=func.coalesce(jobs.c.started_at, now()),
        )
        .returning(jobs.c.id)
    )
    return None if claimed.first() is None else get_job(session, job_id)


def check_hold(session: Session, job: Job) -> Hold:
    """Whether the worker still holds the job, and whether it is to stop."""
    row = session.execute(select(jobs.c.cancel_requested).where(*_held_conditions(job))).first()
    return Hold(row is not None, row is not None and bool(row[0]))


def note_progress(session: Session, job: Job, fraction: float, message: Said | None) -> Hold:
    """Store how far the job is (0 to 1)."""
    change = update(jobs).where(*_held_conditions(job)).values(progress=fraction, message=message)
    row = session.execute(change.returning(jobs.c.cancel_requested)).first()
    return Hold(row is not None, row is not None and bool(row[0]))


def finish_job(session: Session, job: Job, result: Mapping[str, Any]) -> Job:
    """The job is done. Raises JobLost, which undoes the whole write, if another has it."""
    return _end(session, job, "done", {"result": dict(result), "progress": 1.0})


def fail_job(session: Session, job: Job, error: SightlineError) -> Job:
    """The job cannot be done; `error` says why. Raises JobLost."""
    return _end(session, job, "failed", {"error": error.said})


def job_cancelled(session: Session, job: Job) -> Job:
    """The worker stopped because it was asked to. Raises JobLost."""
    return _end(session, job, "cancelled", {"message": None})


def running_jobs(session: Session, *, worker: str | None = None) -> tuple[Job, ...]:
    """The jobs that are being done, by one worker or by all."""
    query = select(jobs).where(jobs.c.state == "running")
    if worker is not None:
        query = query.where(jobs.c.worker == worker)
    return tuple(_job(row) for row in session.execute(query.order_by(jobs.c.id)).mappings())


def queued_jobs(session: Session) -> dict[int, str]:
    """The kinds of the jobs that may be begun by the jobs' ids, oldest first."""
    due = or_(jobs.c.not_before.is_(None), jobs.c.not_before <= now())
    query = select(jobs.c.id, jobs.c.kind).where(jobs.c.state == "queued", due).order_by(jobs.c.id)
    return {int(job_id): str(kind) for job_id, kind in session.execute(query)}


def requeue_job(session: Session, job: Job) -> Job:
    """Give the job of a dead worker to the next one. Raises JobLost if it moved on meanwhile."""
    return _put_back(session, job, "requeue", {"message": Said("job-begun-again")})


def release_job(session: Session, job: Job) -> Job:
    """Put a job back because its worker shuts down; that attempt does not count. Raises JobLost."""
    change = {"attempts": job.attempts - 1, "message": Said("job-waits-to-begin-again")}
    return _put_back(session, job, "release", change)


def postpone_job(session: Session, job: Job) -> Job:
    """Put a job back, database or storage being away, for a growing pause, uncounted. Raises JobLost."""
    pause = min(FIRST_PAUSE * 2 ** min(job.outages, 16), LONGEST_PAUSE)
    change = {"attempts": job.attempts - 1, "outages": job.outages + 1, "not_before": now() + pause}
    return _put_back(session, job, "release", {**change, "message": Said("job-tried-again")})


def _put_back(session: Session, job: Job, action: AuditAction, change: Mapping[str, Any]) -> Job:
    values = {"state": "queued", "worker": None, "progress": 0.0, **change}
    done = session.execute(update(jobs).where(*_held_conditions(job)).values(values).returning(jobs.c.id))
    if done.first() is None:
        raise JobLost("jobs-changed-meanwhile", id=job.id)
    after = {"state": "queued", "attempts": change.get("attempts", job.attempts)}
    trail.record(session, None, action, "job", job.id, job.survey_id, {"state": "running"}, after)
    return get_job(session, job.id)


def _held_conditions(job: Job) -> tuple[Any, ...]:
    same = (jobs.c.worker == job.worker, jobs.c.attempts == job.attempts)
    return (jobs.c.id == job.id, jobs.c.state == "running", *same)


def _end(session: Session, job: Job, state: EndedState, change: Mapping[str, Any]) -> Job:
    values = {**change, "state": state, "finished_at": now()}
    done = session.execute(update(jobs).where(*_held_conditions(job)).values(values).returning(jobs.c.id))
    if done.first() is None:
        raise JobLost("jobs-given-away", id=job.id)
    told = {key: change[key] for key in ("result", "error") if key in change}
    after = {"state": state, "attempts": job.attempts, **told}
    trail.record(session, job.created_by, state, "job", job.id, job.survey_id, {"state": "running"}, after)
    return get_job(session, job.id)


def _job(row: Mapping[Any, Any]) -> Job:
    values: JsonObject = {name: row[name] for name in Job.__slots__}
    return Job(**values)
