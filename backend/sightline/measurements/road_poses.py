"""Stored road poses, each parsed once."""

from typing import Any
from weakref import WeakKeyDictionary

from sightline.geometry.road_pose import RoadPose
from sightline.infra.database import Session
from sightline.measurements.height_of_clicks import PoseCache
from sightline.poses.store import get_pose

# One cache a database: pose 1 of one is not pose 1 of another.
_pose_caches: WeakKeyDictionary[Any, PoseCache] = WeakKeyDictionary()


def road_pose(session: Session, pose_id: int) -> RoadPose:
    """A stored road pose, parsed once. Raises NotFound."""
    poses = _pose_caches.setdefault(session.get_bind(), PoseCache())
    return poses.get(pose_id) or poses.put(pose_id, get_pose(session, pose_id).document)
