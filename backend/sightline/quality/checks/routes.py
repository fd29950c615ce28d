"""Checks of a survey by its own vehicles: insets, and the direction of travel against the road poses."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import Finite, FrameNumber, In, Out, Point
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.messages.said import Said
from sightline.poses.bodies import PoseSummaryBody
from sightline.poses.records import PoseOverlay
from sightline.quality.checks import insets, store, traffic, turning
from sightline.quality.checks.records import WheelPair
from sightline.quality.checks.traffic import PoseFindings
from sightline.quality.checks.turning import Changes

# Bodies of the checks: insets from the survey itself, and the direction of travel against a road pose.


# Half a turn is more than any board was ever set up askew.
TurnRad = Annotated[Finite, Field(ge=-1.6, le=1.6, description="The mean that was shown, radians.")]


class RecordingNameBody(Out):
    id: int
    name: str


@dataclass(frozen=True, kw_only=True)
class PoseCheckBody(PoseFindings):
    """A pose in force against the traffic of its recordings."""

    recordings: list[RecordingNameBody]


@dataclass(frozen=True)
class TrafficCheckBody:
    """The poses in force of a survey, and all tyre contacts."""

    poses: list[PoseCheckBody]
    pairs: tuple[WheelPair, ...]


SeenPair = Annotated[
    int, Field(ge=0, le=2**31 - 1, description="The pair that you saw; 0: none. Another one is a conflict.")
]


class NewWheelPair(In):
    frame: FrameNumber
    frame_crc32: Annotated[int, Field(ge=0, le=2**32 - 1)] | None = Field(
        None, description="CRC-32 of the picture that was clicked on, as in the frame table."
    )
    first: Point
    second: Point
    seen: SeenPair | None = None


class TurnedPose(Out):
    """A pose turned to the traffic, before it is stored: what to draw, to say, and what it changes."""

    pose_id: int
    turn_rad: float
    u_turn_rad: float
    summary: list[Said]
    warnings: list[Said]
    overlay: PoseOverlay
    changes: Changes


class TurnWanted(In):
    turn_rad: TurnRad


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
