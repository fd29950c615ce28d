"""Heights computed again: what is out of date, what was computed and what that changed; undone as a whole."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.measurements.again.query import list_computings
from sightline.measurements.again.records import ComputedHeights, Computing, OutOfDate
from sightline.measurements.again.service import ask_to_compute, ask_to_undo
from sightline.scans.again.service import heights_of, out_of_date
from sightline.surveys.store import get_survey

router = APIRouter()


@dataclass(frozen=True, slots=True)
class ComputingsBody:
    """What is out of date in a survey, and every computing of its heights, newest first."""

    out_of_date: OutOfDate
    computings: Annotated[list[Computing], Field(description="Newest first.")]


@router.get("/surveys/{survey_id}/computings")
def list_all(survey_id: PathId, who: Viewer, session: Reading) -> ComputingsBody:
    """Heights that follow from other facts than hold now, and what was computed again before."""
    return ComputingsBody(out_of_date(session, survey_id), list(list_computings(session, survey_id)))


@router.post("/surveys/{survey_id}/computings", status_code=202)
def compute_again(survey_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Compute every height of the survey again: those that come out as others become new revisions.

    The job's result names the computing; only what moved by more than its u is to be reviewed again.
    """
    get_survey(session, survey_id)
    return JobBody.model_validate(ask_to_compute(session, survey_id, actor=who.id))


@router.get("/computings/{computing_id}")
def get_computing(computing_id: PathId, who: Viewer, session: Reading) -> ComputedHeights:
    """Old beside new, what moved most by its u first."""
    return heights_of(session, computing_id)


@router.post("/computings/{computing_id}/undo", status_code=202)
def undo(computing_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Put every height back that the computing changed; what was changed since stays."""
    return JobBody.model_validate(ask_to_undo(session, computing_id, actor=who.id))
