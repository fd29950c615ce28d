"""Geometry while clicking: axes, ladder and height, computed here and nowhere else."""

from dataclasses import replace

from fastapi import APIRouter

from sightline.geometry.ruler import Ruler
from sightline.infra.web.deps import PathId, Reading, Viewer, Wired
from sightline.measurements import second_frame
from sightline.measurements.bodies import SecondFrameWanted
from sightline.measurements.height_of_clicks import Answer
from sightline.measurements.preview.bodies import AxesWanted, HeightWanted
from sightline.measurements.routes import clicked_frames, clicks_of
from sightline.measurements.service import height_at, ruler_at

router = APIRouter()


@router.post("/recordings/{recording_id}/geometry/axes")
def axes_through_contact(recording_id: PathId, body: AxesWanted, who: Viewer, session: Reading) -> Ruler:
    """The road's axes through a contact click, and the ladder of heights above it."""
    return ruler_at(session, recording_id, body.contact, body.target, body.inset_m, body.vehicle_id)


@router.post("/recordings/{recording_id}/geometry/height")
def height_of_point(recording_id: PathId, body: HeightWanted, who: Viewer, session: Reading) -> Answer:
    """The height that these two points would be stored with."""
    clicks = clicks_of(body, body.target)
    return height_at(session, recording_id, clicks, vehicle_id=body.vehicle_id, actor=who.id)


@router.post("/recordings/{recording_id}/geometry/second-frame")
def best_second_frame(
    recording_id: PathId, body: SecondFrameWanted, who: Viewer, session: Reading, services: Wired
) -> second_frame.Proposal:
    """The frame of the pass on which clicking the same two points again would gain most, or why none would.

    With `others` one frame for all of them, where one shows them all well; else each has its own, or none.
    Where the points are expected there is a proposal to look at: it is stored only when it is clicked.
    """
    first = clicks_of(body, body.target)
    others = [
        replace(first, more_frames=clicked_frames(one.more_frames), **one.model_dump(exclude={"more_frames"}))
        for one in body.others
    ]
    return second_frame.proposal(
        services, session, recording_id, first, others, vehicle_id=body.vehicle_id, actor=who.id
    )
