"""Turning a road pose to the direction of the traffic: what it would change, and the new pose."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sightline.enums import Target
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.traffic import turn_pose_to_heading
from sightline.infra.database import Session
from sightline.measurements.records import Measurement
from sightline.measurements.road_poses import road_pose
from sightline.measurements.service import answers_again
from sightline.messages.said import Said
from sightline.poses.records import Pose, SolvedPose
from sightline.poses.service import describe_pose
from sightline.poses.store import get_pose
from sightline.quality.in_force import replace_in_force
from sightline.recordings.records import Recording

_MOST_LISTED = 200


@dataclass(frozen=True)
class HeightChange:
    """A stored measurement's height as it is and as the turned pose would have it."""

    measurement_id: int
    vehicle_id: int
    target: Target
    height_m: float
    turned_height_m: float
    difference_m: float


@dataclass(frozen=True)
class Changes:
    """Heights under the turned pose, largest difference first; `listed`: 200 at most, `count`: all."""

    count: int
    largest_m: float
    listed: tuple[HeightChange, ...]


def changes_of_heights(pose: RoadPose, turn_rad: float, standing: Sequence[Measurement]) -> Changes:
    """What turning the pose would change, the clicks and insets being the same; no measurement is touched."""
    changes = [
        HeightChange(
            measurement_id=measurement.id,
            vehicle_id=measurement.vehicle_id,
            target=measurement.values.target,
            height_m=measurement.values.height_m,
            turned_height_m=new.height_m,
            difference_m=new.height_m - measurement.values.height_m,
        )
        for measurement, new in zip(
            standing, answers_again(turn_pose_to_heading(pose, turn_rad), standing), strict=True
        )
        if measurement.values.height_m is not None and new.height_m is not None
    ]
    changes.sort(key=lambda one: -abs(one.difference_m))
    largest = abs(changes[0].difference_m) if changes else 0.0
    return Changes(len(changes), largest, tuple(changes[:_MOST_LISTED]))


def turned_pose(
    session: Session, pose_id: int, turn_rad: float, u_turn_rad: float, vehicles: int
) -> SolvedPose:
    """A stored pose turned about the road's normal, with its words and drawing; nothing is stored."""
    stored = get_pose(session, pose_id)
    pose = turn_pose_to_heading(road_pose(session, pose_id), turn_rad, u_turn_rad)
    corners = np.asarray(stored.overlay.get("corners_px") or [], dtype=np.float64).reshape(-1, 2)
    turn_deg = round(float(np.rad2deg(turn_rad)), 2)
    told = Said("pose-turned-by-vehicles", turn_deg=turn_deg, vehicles=vehicles)
    solved = describe_pose(pose, corners)
    warnings = [*stored.warnings, told, Said("pose-before", pose=pose_id)]
    return {**solved, "summary": [told, *solved["summary"]], "warnings": warnings}


def store_turned(
    session: Session,
    pose_id: int,
    users: Sequence[Recording],
    turn_rad: float,
    u_turn_rad: float,
    vehicles: int,
    *,
    actor: int,
) -> Pose:
    """Store the turned pose, in force for the recordings that use the pose before; measurements keep theirs.

    Raises Conflict where no recording uses the pose any more.
    """
    before = get_pose(session, pose_id)
    solved = turned_pose(session, pose_id, turn_rad, u_turn_rad, vehicles)
    return replace_in_force(
        session, before, users, solved, turned_from=pose_id, turned_by_rad=turn_rad, actor=actor
    )
