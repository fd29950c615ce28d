"""Adjusting road poses by the traffic: what it says, putting it in force, taking it back."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.adjustment.observed import DEFAULT_U_COMMON_M
from sightline.infra.web.bodies import Finite, In, JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.quality.adjusting import service
from sightline.quality.adjusting.records import KnownUncertainties, PoseAdjustment

router = APIRouter()

USUAL_U_WHEELBASE_M = 0.010  # maker's figure against the vehicle, tyre contact against axle (estimate)
Length = Annotated[Finite, Field(ge=0.0, le=1.0)]


class Known(In):
    u_wheelbase_m: Length = Field(USUAL_U_WHEELBASE_M, description="Of a wheelbase that states none.")
    u_wheelbase_common_m: Length = Field(DEFAULT_U_COMMON_M, description="Shared by all known wheelbases.")
    u_roof_common_m: Length = Field(DEFAULT_U_COMMON_M, description="Shared by all known roofs.")


class AdjustmentWanted(Known):
    camera_height_change_m: Finite = Field(description="The change of the camera's height that was shown.")


@dataclass(frozen=True, slots=True)
class PutInForce:
    """The new pose, and the job that computes the heights again with it."""

    pose_id: int
    job: JobBody


@dataclass(frozen=True, slots=True)
class TakenBack:
    """The job that puts the heights back; null where they cannot be put back as a whole any more."""

    job: JobBody | None


@router.get("/surveys/{survey_id}/checks/adjustment")
def check_adjustment(
    survey_id: PathId, who: Viewer, session: Reading, asked: Annotated[Known, Query()]
) -> list[PoseAdjustment]:
    """Each road pose in force as the traffic's known wheelbases and roofs adjust it; nothing is stored."""
    known = KnownUncertainties(**asked.model_dump())
    return list(service.check_adjustments(session, survey_id, known))


@router.post("/poses/{pose_id}/adjustment", status_code=201)
def put_adjustment_in_force(
    pose_id: PathId, body: AdjustmentWanted, who: Operator, session: Writing
) -> PutInForce:
    """Store the adjusted pose, in force where the one before was, and have the heights computed again.

    A conflict where the traffic now says something else than was shown.
    """
    known = KnownUncertainties(**body.model_dump(exclude={"camera_height_change_m"}))
    made, job = service.put_in_force(session, pose_id, known, body.camera_height_change_m, actor=who.id)
    return PutInForce(made.id, JobBody.model_validate(job))


@router.post("/poses/{pose_id}/adjustment/undo", status_code=202)
def take_back_adjustment(pose_id: PathId, who: Operator, session: Writing) -> TakenBack:
    """The pose before is in force again, and the heights that were computed with the adjusted one go back."""
    job = service.take_back(session, pose_id, actor=who.id)
    return TakenBack(None if job is None else JobBody.model_validate(job))
