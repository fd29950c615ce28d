"""Two calibrations from two halves of the views: what their difference does to a height.

A covariance holds corner noise only. Two halves that share a wrong lens model still differ more than their
covariances say (mrcal's tour of cross-validation), so the difference is shown as what it makes of a height:
the same board and the same clicks, measured through either half.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from backend.errors import BadInput
from backend.geometry.arrays import Floats
from backend.geometry.board import Board, board_points, road_points
from backend.geometry.calibration import NamedCorners, calibrate
from backend.geometry.camera import Camera, project
from backend.geometry.corners import Corners
from backend.geometry.height import measure_height
from backend.geometry.lens import Model
from backend.geometry.plan import level_pose
from backend.geometry.planar import planar_roots
from backend.geometry.pose import pose_from_corners
from backend.geometry.road_pose import Reference, RoadPose

_LEAST_VIEWS = 6
_CAMERA_M, _BOARD_M, _HEIGHT_M = 1.5, 3.0, 1.16
_BOARD = Board(6, 4, 0.1)
_TOP_M = 0.9


@dataclass(frozen=True)
class CrossValidation:
    """`held_out_rms_px`: residual of each half's views under the other half's lens; `height_differences_m`:
    at each distance, height by the first half minus height by the second (None where the picture does not
    show it).
    """

    held_out_rms_px: tuple[float, float]
    height_differences_m: tuple[tuple[float, float | None], ...]

    @property
    def worst_m(self) -> float | None:
        known = [abs(d) for _, d in self.height_differences_m if d is not None]
        return max(known, default=None)


def cross_validate(
    views: Sequence[NamedCorners],
    board: Board,
    model: Model = "brown",
    distances_m: Sequence[float] = (2.0, 3.0, 5.0),
) -> CrossValidation | str:
    """Calibrate from every other view, twice, and compare; or the reason why that cannot be done.

    The comparison is that of a level camera 1.5 m high with a board at 3 m and an eye at 1.16 m.
    """
    usable = [view for view in views if view[1].found]
    if len(usable) < _LEAST_VIEWS:
        return f"Two halves need at least {_LEAST_VIEWS} views with a board; there are {len(usable)}."
    halves = usable[::2], usable[1::2]
    try:
        whole = calibrate(usable, board, model).camera
        first, second = (calibrate(half, board, model).camera for half in halves)
    except BadInput as error:
        return error.message
    held_out = (_residual(first, halves[1], board), _residual(second, halves[0], board))
    return CrossValidation(held_out, tuple((d, _difference(whole, first, second, d)) for d in distances_m))


def _residual(camera: Camera, views: Sequence[NamedCorners], board: Board) -> float:
    """RMS point residual of views under a lens that they did not help to find."""
    squares, count = 0.0, 0
    for _, corners, _ in views:
        seen_as = Board(corners.board_as_seen.columns, corners.board_as_seen.rows, board.square_m)
        seen = corners.points_px.reshape(-1, 2)
        roots = planar_roots(camera, board_points(seen_as), seen)
        if roots:
            squares, count = squares + roots[0].cost, count + len(seen)
    return float(np.sqrt(squares / count)) if count else float("inf")


def _difference(whole: Camera, first: Camera, second: Camera, distance_m: float) -> float | None:
    """Height by one half minus height by the other, from the pixels that the whole calibration predicts."""
    truth = level_pose(whole, _CAMERA_M, _BOARD_M)
    seen = project(whole, truth.to_camera(road_points(_BOARD, "top", _TOP_M)))
    x, y = float(truth.centre_m[0]), float(truth.centre_m[1]) + distance_m
    clicks = project(whole, truth.to_camera(np.array([[x, y, 0.0], [x, y, _HEIGHT_M]])))
    if not (np.isfinite(seen).all() and np.isfinite(clicks).all() and whole.inside(clicks).all()):
        return None
    heights = [_height(camera, seen, clicks) for camera in (first, second)]
    return None if heights[0] is None or heights[1] is None else heights[0] - heights[1]


def _height(camera: Camera, seen: Floats, clicks: Floats) -> float | None:
    grid = seen.reshape(_BOARD.rows, _BOARD.columns, 2)
    corners = Corners(True, grid, _BOARD, None, 0.0, "predicted")
    try:
        pose: RoadPose = pose_from_corners(camera, [corners], _BOARD, Reference("top", _TOP_M))
    except BadInput:
        return None
    return measure_height(pose, clicks[0], clicks[1]).height_m
