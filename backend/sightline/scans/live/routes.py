"""Live streams of line-scan cameras: looked at, and written by the computer at the roadside."""

from datetime import UTC
from typing import Annotated

from fastapi import APIRouter, Query

from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.scans.live.bodies import BegunSegment, Moment, NewSegment, SegmentEnds, SegmentGrows
from sightline.scans.live.recording import add_to_recording, begin_recording, end_recording
from sightline.scans.live.records import LiveHealth, LiveSegment, LiveStream, SegmentFacts
from sightline.scans.live.service import live_streams
from sightline.scans.live.store import is_live, live_segments
from sightline.scans.service import uploaded_strips
from sightline.scans.store import get_scan
from sightline.scans.vehicles.motion import values_told

router = APIRouter()


@router.get("/surveys/{survey_id}/live")
def get_live(survey_id: PathId, who: Viewer, session: Reading) -> list[LiveStream]:
    """The streams of a survey, newest first, each with its health, last vehicles and flow."""
    return live_streams(session, survey_id)


@router.get("/surveys/{survey_id}/live/segments")
def list_live_segments(
    survey_id: PathId,
    who: Operator,
    session: Reading,
    stream: Annotated[str, Query(max_length=40)],
    began_at: Moment,
) -> list[LiveSegment]:
    """The recordings of a part of a stream, newest first, deleted ones too; for who writes them."""
    return live_segments(session, survey_id, stream, began_at.astimezone(UTC))


@router.post("/surveys/{survey_id}/live")
def begin_segment(survey_id: PathId, body: NewSegment, who: Operator, session: Writing) -> BegunSegment:
    """The recording of a part of a stream, made unless it is there; also where a person deleted it."""
    segment = SegmentFacts(
        number=body.number, stream=body.stream, source=body.source, began_at=body.began_at.astimezone(UTC)
    )
    rig = body.stream_rig()
    scan_id = begin_recording(session, survey_id, segment, rig, body.others, actor=who.id)
    return BegunSegment(id=scan_id)


@router.post("/scans/{scan_id}/live", status_code=204)
def add_to_segment(scan_id: PathId, body: SegmentGrows, who: Operator, session: Writing) -> None:
    """Vehicles that were measured, and how the stream is; what is there already is not stored again."""
    rig = body.stream_rig()
    vehicles = [values_told(one.told(rig), rig, "found") for one in body.vehicles]
    health = None if body.health is None else LiveHealth(**dict(body.health))
    add_to_recording(session, scan_id, vehicles, health, actor=who.id)


@router.post("/scans/{scan_id}/live/end", status_code=204)
def end_segment(scan_id: PathId, body: SegmentEnds, who: Operator, session: Writing) -> None:
    """The stream adds no more; its strips are read in the background. Nothing where it has ended before."""
    if not is_live(session, scan_id):
        return
    strips, uploads = None, body.uploads()
    if uploads is not None:
        strips = uploaded_strips(session, get_scan(session, scan_id).survey_id, *uploads)
    rig = body.stream_rig()
    end_recording(session, scan_id, strips, rig, body.method, body.notes, body.told, actor=who.id)
