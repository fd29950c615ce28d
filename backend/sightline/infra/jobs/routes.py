"""Long work: how far it is, and stopping it."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.enums import JobState
from sightline.errors import NotAllowed
from sightline.infra.jobs import registry, store
from sightline.infra.web.access import RANK
from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import (
    ActingAs,
    Operator,
    PathId,
    Reading,
    Stopper,
    StudiesSeen,
    SurveysSeen,
    Viewer,
    Wired,
)
from sightline.infra.web.named import SurveyId

router = APIRouter()


@router.get("/jobs")
def list_jobs(
    who: Viewer,
    session: Reading,
    seen: SurveysSeen,
    seen_studies: StudiesSeen,
    survey_id: Annotated[SurveyId | None, Query()] = None,
    state: Annotated[JobState | None, Query()] = None,
) -> list[JobBody]:
    """The newest hundred jobs of surveys and studies that the person sees, and of none.

    What the program does for itself, such as deleting files, is listed until it is done.
    """
    found = store.list_jobs(
        session,
        survey_id=survey_id,
        state=state,
        seen=seen,
        seen_studies=seen_studies,
        unless_done=registry.housekeeping(),
    )
    return [JobBody.model_validate(one) for one in found]


@router.get("/jobs/{job_id}")
def get_job(job_id: PathId, who: Viewer, session: Reading) -> JobBody:
    """One job."""
    return JobBody.model_validate(store.get_job(session, job_id))


@router.post("/jobs/{job_id}/again", status_code=202)
def again(job_id: PathId, who: Operator, services: Wired) -> JobBody:
    """The same work once more, after it failed or was stopped."""
    with services.writing() as session:
        return JobBody.model_validate(registry.enqueue_again(session, store.get_job(session, job_id), who.id))


@router.post("/jobs/{job_id}/cancel")
def cancel(job_id: PathId, who: Stopper, role: ActingAs, services: Wired) -> JobBody:
    """Stop a queued job at once, a running one when it next looks. A viewer may stop only their own."""
    with services.writing() as session:
        job = store.get_job(session, job_id)
        if job.created_by != who.id and RANK[role] < RANK["operator"]:
            raise NotAllowed("jobs-not-yours")
        return JobBody.model_validate(registry.cancel(session, job, who.id))
