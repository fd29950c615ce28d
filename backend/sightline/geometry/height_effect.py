"""What two lenses that differ make of one height: the same board and the same clicks, through either."""

from dataclasses import dataclass, replace

import numpy as np

from sightline.arrays import Floats
from sightline.errors import BadInput
from sightline.geometry.board import Board, road_points
from sightline.geometry.camera import Camera, project
from sightline.geometry.corners import Corners
from sightline.geometry.height import measure_height
from sightline.geometry.planar import linearise
from sightline.geometry.pose import joint_covariance, pose_from_corners
from sightline.geometry.road_pose import Reference, RoadPose
from sightline.geometry.site import level_pose

CAMERA_M, BOARD_M, HEIGHT_M = 1.5, 3.0, 1.16
DISTANCES_M = (2.0, 3.0, 5.0)
_BOARD = Board(6, 4, 0.1)
_TOP_M = 0.9


@dataclass(frozen=True)
class HeightDifference:
    """Height by one lens minus height by the other at a distance; `expected_m`: its standard uncertainty by
    the lenses' covariances. None where the picture does not show it, or a covariance is unknown.
    """

    distance_m: float
    difference_m: float | None
    expected_m: float | None = None


def height_differences(whole: Camera, first: Camera, second: Camera) -> tuple[HeightDifference, ...]:
    """At each of DISTANCES_M, from the pixels that `whole` predicts for a level camera 1.5 m high, a board at
    3 m and an eye at 1.16 m. The pose is solved again through either lens, as in the field. `expected_m`
    takes the two lenses as independent of each other.
    """
    truth = level_pose(whole, CAMERA_M, BOARD_M)
    points = road_points(_BOARD, "top", _TOP_M)
    seen = project(whole, truth.to_camera(points))
    if not (np.isfinite(seen).all() and whole.inside(seen).all()):
        return tuple(HeightDifference(d, None, None) for d in DISTANCES_M)
    poses = _pose(first, seen), _pose(second, seen)
    doubtful = _doubtful(truth, seen, points, first, second)
    return tuple(_difference_at(truth, poses, doubtful, d) for d in DISTANCES_M)


def _pose(camera: Camera, seen: Floats) -> RoadPose | None:
    corners = Corners(
        found=True,
        points_px=seen.reshape(_BOARD.rows, _BOARD.columns, 2),
        board_as_seen=_BOARD,
        reason=None,
        sharpness=0.0,
        detector="predicted",
    )
    try:
        return pose_from_corners(camera, [corners], _BOARD, Reference("top", _TOP_M))
    except BadInput:
        return None


def _doubtful(
    truth: RoadPose, seen: Floats, points: Floats, first: Camera, second: Camera
) -> RoadPose | None:
    """The true pose with the covariance of the difference between the lenses, and of nothing else."""
    if first.covariance is None or second.covariance is None:
        return None
    lens = replace(truth.camera, covariance=first.covariance + second.covariance)
    at = linearise(lens, truth.rotation, truth.translation_m, points, seen)
    return RoadPose(lens, truth.rotation, truth.translation_m, joint_covariance(lens, at, 0.0))


def _difference_at(
    truth: RoadPose,
    poses: tuple[RoadPose | None, RoadPose | None],
    doubtful: RoadPose | None,
    distance_m: float,
) -> HeightDifference:
    x, y = float(truth.centre_m[0]), float(truth.centre_m[1]) + distance_m
    clicks = project(truth.camera, truth.to_camera(np.array([[x, y, 0.0], [x, y, HEIGHT_M]])))
    nothing = HeightDifference(distance_m, None, None)
    if not (np.isfinite(clicks).all() and truth.camera.inside(clicks).all()):
        return nothing
    heights = [
        None if pose is None else measure_height(pose, clicks[0], clicks[1]).height_m for pose in poses
    ]
    if heights[0] is None or heights[1] is None:
        return nothing
    expected = None if doubtful is None else measure_height(doubtful, clicks[0], clicks[1], 0.0).u_height_m
    return HeightDifference(distance_m, heights[0] - heights[1], expected)
