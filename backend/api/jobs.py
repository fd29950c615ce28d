"""Long work: how far it is, and stopping it."""

from typing import Annotated

from fastapi import APIRouter, Query

from backend.api.bodies import Id, JobBody, JobState
from backend.api.deps import RANK, PathId, Reading, Viewer, Wired
from backend.errors import NotAllowed
from backend.storage import jobs
from backend.work import scanning, scanning_read
from backend.work.ingesting import cancel_job

router = APIRouter()


@router.get("/jobs")
def list_jobs(
    who: Viewer,
    session: Reading,
    survey_id: Annotated[Id | None, Query()] = None,
    state: Annotated[JobState | None, Query()] = None,
) -> list[JobBody]:
    """The newest hundred jobs."""
    return [JobBody.model_validate(one) for one in jobs.listing(session, survey_id=survey_id, state=state)]


@router.get("/jobs/{job_id}")
def get_job(job_id: PathId, who: Viewer, session: Reading) -> JobBody:
    """One job."""
    return JobBody.model_validate(jobs.get(session, job_id))


@router.post("/jobs/{job_id}/cancel")
def cancel(job_id: PathId, who: Viewer, services: Wired) -> JobBody:
    """Stop a queued job at once, a running one when it next looks. A viewer may stop only their own."""
    with services.writing() as session:
        job = jobs.get(session, job_id)
        if job.created_by != who.id and RANK[who.role] < RANK["operator"]:
            raise NotAllowed("Somebody else started this job; ask them or an operator to cancel it.")
        stopped = cancel_job(session, job, who.id)
        if stopped.state == "cancelled" and stopped.kind == scanning.READ:
            scanning_read.mark_failed(session, stopped, scanning_read.STOPPED)
        return JobBody.model_validate(stopped)
