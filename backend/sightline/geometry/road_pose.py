"""Where the camera stands with respect to the road, and what a click becomes there.

Frames (CONVENTIONS.md): camera x right, y down, z forward; road X along the traffic, Y across it and away
from the camera, Z up, origin on the road below the board's reference corner.
`x_cam = rotation @ x_road + translation_m`.
"""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from sightline.arrays import Floats
from sightline.enums import BoardSide
from sightline.geometry.arrays import freeze_array
from sightline.geometry.camera import Camera
from sightline.messages.said import Said

POSE_NAMES = ("rx", "ry", "rz", "tx", "ty", "tz")


DEFAULT_U_HEIGHT_M = 0.003  # a tape read to a few millimetres (estimate)
DEFAULT_U_LEAN_RAD = 0.005  # a board set up with a spirit level, about 0.3 degrees (estimate)
DEFAULT_U_SQUARE = 0.001  # of a square's side: a print or a rule off by 1 in 1000 (estimate)
DEFAULT_U_BOW_M = 0.0005  # middle of a stiff board out of plane, in either direction (estimate)


@dataclass(frozen=True)
class Reference:
    """The row of inner corners whose height above the road was measured with a tape; what the board may be
    off by. `u_square_m` None stands for `DEFAULT_U_SQUARE` of the square's side.
    """

    side: BoardSide
    height_m: float
    u_height_m: float = DEFAULT_U_HEIGHT_M
    u_lean_rad: float = DEFAULT_U_LEAN_RAD
    u_square_m: float | None = None
    u_bow_m: float = DEFAULT_U_BOW_M


@dataclass(frozen=True)
class BoardOnRoad:
    """The board as it stood. `columns`, `rows`: inner corners across and down, as seen. `u_lean_rad` holds
    about X and about Y. `bow_response`: pose increments per metre of bow along the rows and down the columns
    (board_errors.py). None: not stated, and left out of every uncertainty.
    """

    columns: int
    rows: int
    square_m: float
    reference: BoardSide
    reference_height_m: float
    u_reference_height_m: float
    u_lean_rad: float
    distance_m: float
    u_square_m: float | None = None
    u_bow_m: float | None = None
    bow_response: tuple[tuple[float, ...], ...] | None = None


@dataclass(frozen=True, eq=False)
class RoadPose:
    """A camera on the road. `covariance` is of `parameters`: the lens's, then rx ry rz tx ty tz, where an
    increment acts as x_cam = Exp(r) (R x_road + t) + t'. It holds lens and corner noise only; what the board
    may be off by are entries of their own. None: unknown, and left out of every uncertainty."""

    camera: Camera
    rotation: Floats
    translation_m: Floats
    covariance: Floats | None = None
    board: BoardOnRoad | None = None
    frames_used: int = 0
    rms_px: float | None = None
    warnings: tuple[Said, ...] = field(default=())

    def __post_init__(self) -> None:
        object.__setattr__(self, "rotation", freeze_array(self.rotation))
        object.__setattr__(self, "translation_m", freeze_array(self.translation_m))
        if self.covariance is not None:
            object.__setattr__(self, "covariance", freeze_array(self.covariance))

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        return self.camera.parameters + POSE_NAMES

    @cached_property
    def centre_m(self) -> Floats:
        """Camera centre in the road frame, (3,); its Z is the camera height."""
        return freeze_array(-self.rotation.T @ self.translation_m)

    def to_camera(self, points_road_m: Floats) -> Floats:
        """Camera-frame points (N, 3) of road points, `points_road_m` (N, 3): R x + t, metres."""
        return np.asarray(points_road_m @ self.rotation.T + self.translation_m, dtype=np.float64)
