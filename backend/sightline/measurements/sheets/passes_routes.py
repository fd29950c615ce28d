"""Passes split and joined: what was measured on them decides which record stays."""

from typing import Annotated

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import FrameNumber, In, Out
from sightline.infra.web.deps import Operator, PathId, Writing
from sightline.infra.web.named import VehicleId
from sightline.measurements.bodies import VehicleBody, vehicle_body
from sightline.measurements.sheets import split_join
from sightline.measurements.sheets.query import get_sheet

router = APIRouter()
Version = Annotated[int, Field(ge=1, le=2**31 - 1, description="The version that you saw.")]


class SplitWanted(In):
    frame: FrameNumber = Field(description="The first frame of the later pass.")
    version: Version


class SplitBody(Out):
    earlier: VehicleBody
    later: VehicleBody


class JoinWanted(In):
    other_id: VehicleId
    version: Version
    other_version: Version


@router.post("/vehicles/{vehicle_id}/split")
def split_pass(vehicle_id: PathId, body: SplitWanted, who: Operator, session: Writing) -> SplitBody:
    """Two passes of one; the vehicle keeps the side on which it was measured."""
    sides = split_join.split(session, vehicle_id, body.frame, version=body.version, actor=who.id)
    earlier, later = (vehicle_body(get_sheet(session, side.id)) for side in sides)
    return SplitBody(earlier=earlier, later=later)


@router.post("/vehicles/{vehicle_id}/join")
def join_passes(vehicle_id: PathId, body: JoinWanted, who: Operator, session: Writing) -> VehicleBody:
    """One pass of two; refused where both were measured."""
    kept = split_join.join(
        session,
        vehicle_id,
        body.other_id,
        version=body.version,
        other_version=body.other_version,
        actor=who.id,
    )
    return vehicle_body(get_sheet(session, kept.id))
