"""Geometry while clicking: axes, ladder and height, computed here and nowhere else."""

from fastapi import APIRouter

from backend.api.deps import PathId, Reading, Viewer
from backend.api.pose_bodies import AxesAnswer, AxesWanted, HeightAnswer, HeightWanted
from backend.work import measuring

router = APIRouter()


@router.post("/recordings/{recording_id}/geometry/axes")
def axes_through_contact(recording_id: PathId, body: AxesWanted, who: Viewer, session: Reading) -> AxesAnswer:
    """The road's axes through a contact click, and the ladder of heights above it."""
    contact = (body.contact[0], body.contact[1])
    found = measuring.ruler_at(session, recording_id, contact, body.target, body.inset_m)
    return AxesAnswer.model_validate(found)


@router.post("/recordings/{recording_id}/geometry/height")
def height_of_point(recording_id: PathId, body: HeightWanted, who: Viewer, session: Reading) -> HeightAnswer:
    """The height that these two points would be stored with."""
    clicked = measuring.Clicked(
        target=body.target,
        contact=(body.contact[0], body.contact[1]),
        point=(body.point[0], body.point[1]),
        sigma_px=body.sigma_px,
        inset_m=body.inset_m,
        u_inset_m=body.u_inset_m,
    )
    return HeightAnswer.model_validate(measuring.height_at(session, recording_id, clicked))
