"""Live streams of line-scan cameras, to be looked at."""

from fastapi import APIRouter

from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.scans.live.records import LiveStream
from sightline.scans.live.service import live_streams

router = APIRouter()


@router.get("/surveys/{survey_id}/live")
def get_live(survey_id: PathId, who: Viewer, session: Reading) -> list[LiveStream]:
    """The streams of a survey, newest first, each with its health, last vehicles and flow."""
    return live_streams(session, survey_id)
