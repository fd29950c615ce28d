"""Checks of a survey by its own vehicles: insets, and the direction of travel against the road poses."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.infra.by_name import filled_from
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.poses.bodies import PoseSummaryBody
from sightline.quality.checks import insets, store, traffic, turning
from sightline.quality.checks.bodies import (
    NewWheelPair,
    PoseCheckBody,
    RecordingNameBody,
    SeenPair,
    TrafficCheckBody,
    TurnedPose,
    TurnWanted,
)
from sightline.quality.checks.records import WheelPair

router = APIRouter()


@router.get("/surveys/{survey_id}/checks/insets")
def check_insets(survey_id: PathId, who: Viewer, session: Reading) -> insets.InsetCheck:
    """Insets from the survey itself beside those in force, and what they matter."""
    return insets.check_insets(session, survey_id)


@router.get("/surveys/{survey_id}/checks/traffic")
def check_traffic(survey_id: PathId, who: Viewer, session: Reading) -> TrafficCheckBody:
    """The direction of travel of each vehicle against the road poses in force, and all tyre contacts."""
    found = traffic.check_traffic(session, survey_id)
    named = [[RecordingNameBody.model_validate(of) for of in one.recordings] for one in found]
    poses = [
        filled_from(PoseCheckBody, one, recordings=names) for one, names in zip(found, named, strict=True)
    ]
    return TrafficCheckBody(poses, store.list_wheel_pairs(session, survey_id))


@router.post("/vehicles/{vehicle_id}/wheel-pair", status_code=201)
def add_wheel_pair(vehicle_id: PathId, body: NewWheelPair, who: Operator, session: Writing) -> WheelPair:
    """Store both tyre contacts of a vehicle on one frame, in place of the pair before.

    Refused, saying why, where they give no direction: contacts closer than a metre, or above the horizon.
    """
    return traffic.store_pair(session, vehicle_id, **body.model_dump(), actor=who.id)


@router.delete("/vehicles/{vehicle_id}/wheel-pair")
def withdraw_wheel_pair(
    vehicle_id: PathId, who: Operator, session: Writing, seen: Annotated[SeenPair | None, Query()] = None
) -> WheelPair:
    """Take a vehicle's tyre contacts out of the check; nothing is erased."""
    return store.withdraw_wheel_pair(session, vehicle_id, seen=seen, actor=who.id)


@router.get("/poses/{pose_id}/turn")
def preview_turn(pose_id: PathId, who: Viewer, session: Reading) -> TurnedPose:
    """The pose turned to the traffic's mean direction, not stored: its drawing and what it would change."""
    at = traffic.turn_of(session, pose_id)
    solved = turning.turned_pose(session, pose_id, at.turn_rad, at.u_turn_rad, at.vehicles)
    return TurnedPose(
        pose_id=pose_id,
        turn_rad=at.turn_rad,
        u_turn_rad=at.u_turn_rad,
        summary=solved["summary"],
        warnings=solved["warnings"],
        overlay=solved["overlay"],
        changes=at.changes,
    )


@router.post("/poses/{pose_id}/turn", status_code=201)
def turn_pose(pose_id: PathId, body: TurnWanted, who: Operator, session: Writing) -> PoseSummaryBody:
    """Store the turned pose, in force for the recordings that use the one before; measurements keep theirs.

    A conflict where the traffic's mean is no longer the one that was shown.
    """
    at = traffic.turn_of(session, pose_id, seen_rad=body.turn_rad)
    made = turning.store_turned(
        session, pose_id, at.recordings, at.turn_rad, at.u_turn_rad, at.vehicles, actor=who.id
    )
    return PoseSummaryBody.model_validate(made)
