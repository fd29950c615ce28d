"""Before going out: what a height will be worth from a given place, and what to do about it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from backend.errors import BadInput
from backend.geometry.arrays import Floats
from backend.geometry.board import Board, road_points
from backend.geometry.camera import Camera, project
from backend.geometry.height import Height, measure_height
from backend.geometry.insets import DEFAULT_INSETS
from backend.geometry.planar import linearise
from backend.geometry.pose import joint_covariance
from backend.geometry.road_pose import BoardOnRoad, Reference, RoadPose

# typical heights above the road, for planning only (estimates)
TYPICAL_M = (("roof", 1.50), ("driver_eye", 1.15), ("taillight", 0.75), ("headlight", 0.65))
_BOARD = Board(6, 4, 0.1)
_BOARD_TOP_M = 0.9
_CORNER_SIGMA_PX = 0.05  # of the mean corners of a still clip


@dataclass(frozen=True)
class PlannedTarget:
    """What to expect of one target. `bias_if_ignored_m`: the error when its inset is taken as 0."""

    target: str
    height_m: float
    inset_m: float
    u_inset_m: float
    result: Height
    bias_if_ignored_m: float


@dataclass(frozen=True)
class Plan:
    """Expected uncertainties of a set-up, with advice in words."""

    camera_height_m: float
    distance_m: float
    board_distance_m: float
    targets: tuple[PlannedTarget, ...]
    advice: tuple[str, ...]


def plan_site(
    camera: Camera,
    camera_height_m: float,
    distance_m: float,
    board_distance_m: float | None = None,
    sigma_px: float = 1.0,
) -> Plan:
    """Expected uncertainty per target of a camera at `camera_height_m`, `distance_m` across from the wheel
    track.

    The camera is assumed to look square across the road, tipped so that road and roof are in view, the board
    (6x4 corners of 10 cm) to stand at `board_distance_m` (the wheel track by default). Raises BadInput for
    numbers that no site has.
    """
    board_m = distance_m if board_distance_m is None else board_distance_m
    for what, value, least, most in (
        ("camera height", camera_height_m, 0.2, 20.0),
        ("distance", distance_m, 0.5, 100.0),
        ("board's distance", board_m, 0.5, 100.0),
        ("click sigma", sigma_px, 1e-3, 100.0),
    ):
        if not (np.isfinite(value) and least <= value <= most):
            raise BadInput(
                f"A {what} of {value} cannot be planned with; it must lie between {least} and {most}."
            )
    pose = _planned_pose(camera, camera_height_m, distance_m, board_m)
    targets = tuple(_target(pose, name, h, distance_m, sigma_px) for name, h in TYPICAL_M)
    return Plan(
        camera_height_m,
        distance_m,
        board_m,
        targets,
        tuple(_advice(camera_height_m, distance_m, board_m, targets)),
    )


def level_pose(camera: Camera, height_m: float, board_m: float, aim_m: float | None = None) -> RoadPose:
    """A level camera that looks along +Y, tipped to the middle of road and roof at `aim_m` (the board's
    distance by default), with the planning board's origin `board_m` away. Without covariance.
    """
    aim = board_m if aim_m is None else aim_m
    low, high = np.arctan2(-height_m, aim), np.arctan2(1.6 - height_m, aim)
    pitch = -0.5 * float(low + high)
    c, s = float(np.cos(pitch)), float(np.sin(pitch))
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, -s, -c], [0.0, c, -s]])
    eye = np.array([0.5 * (_BOARD.columns - 1) * _BOARD.square_m, -board_m, height_m])
    return RoadPose(camera, rotation, -rotation @ eye)


def _planned_pose(camera: Camera, height_m: float, distance_m: float, board_m: float) -> RoadPose:
    """The level pose with the covariance that a board there would give."""
    bare = level_pose(camera, height_m, board_m, distance_m)
    points = road_points(_BOARD, "top", _BOARD_TOP_M)
    seen = project(camera, bare.to_camera(points))
    covariance = None
    if np.isfinite(seen).all():
        at = linearise(camera, bare.rotation, bare.translation_m, points, seen)
        covariance = joint_covariance(camera, at, _CORNER_SIGMA_PX)
    reference = Reference("top", _BOARD_TOP_M)
    board = BoardOnRoad(
        _BOARD.columns,
        _BOARD.rows,
        _BOARD.square_m,
        "top",
        _BOARD_TOP_M,
        reference.u_height_m,
        reference.u_lean_rad,
        board_m,
    )
    return RoadPose(camera, bare.rotation, bare.translation_m, covariance, board)


def _target(pose: RoadPose, name: str, height_m: float, distance_m: float, sigma_px: float) -> PlannedTarget:
    inset, u_inset, _ = DEFAULT_INSETS[name]
    x, y = float(pose.centre_m[0]), float(pose.centre_m[1]) + distance_m
    clicks: Floats = project(pose.camera, pose.to_camera(np.array([[x, y, 0.0], [x, y + inset, height_m]])))
    result = measure_height(pose, clicks[0], clicks[1], sigma_px, inset, u_inset)
    bias = (float(pose.centre_m[2]) - height_m) * inset / (distance_m + inset)
    return PlannedTarget(name, height_m, inset, u_inset, result, bias)


def _advice(
    camera_m: float, distance_m: float, board_m: float, targets: Sequence[PlannedTarget]
) -> list[str]:
    out = []
    eye = next(t for t in targets if t.target == "driver_eye")
    if abs(camera_m - eye.height_m) > 0.15:
        out.append(
            f"A camera at the height to be measured does not mind the inset: at {eye.height_m:.2f} m it "
            f"would be rid of the {1000 * abs(eye.bias_if_ignored_m):.0f} mm that the eye's inset costs here."
        )
    if abs(board_m - distance_m) > 0.2 * distance_m:
        out.append(
            "Put the board at the wheel track: errors of pose, lean and focal length vanish at its distance."
        )
    out.append(
        "Stand the board square to the road, not plumb; 2.5 % crossfall is worth up to 37 mm otherwise."
    )
    out.append("Turn the board by about 30 degrees, which fixes its direction twice as well as square-on.")
    unseen = [t.target for t in targets if t.result.status != "ok"]
    if unseen:
        names = ", ".join(unseen)
        out.append(f"Road or target lie outside the picture for: {names}; step back or take a wider lens.")
    if distance_m < 1.5:
        out.append("The lane is very close; step back to at least 2 m.")
    return out
