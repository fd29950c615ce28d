"""How far a survey's sample has come."""

from fastapi import APIRouter

from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.results.sampling.records import SampleProgress
from sightline.results.sampling.service import sample_progress

router = APIRouter()


@router.get("/surveys/{survey_id}/sample")
def sample_of_survey(survey_id: PathId, who: Viewer, session: Reading) -> SampleProgress:
    """Quotas with their progress, and how passes end: measured, not visible, open, left out."""
    return sample_progress(session, survey_id)
