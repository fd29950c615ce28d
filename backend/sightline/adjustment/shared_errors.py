"""The errors that all heights of a pose share, as independent standard numbers z with the board's budget as
prior.

Lens and pose are off by x = L z, z of mean 0 and variance 1 (times what a part was released by): the columns
of L are a root of the pose's covariance and the increments that one standard uncertainty of each part of the
board causes (geometry/board_errors.py). So a covariance without full rank, a parameter taken as exact and a
board without a stated bow need no case of their own. Two more z are the common errors of all known wheelbases
and of all known roofs, and one each that of an inset which several roofs assume.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sightline.adjustment.observed import Known
from sightline.arrays import Floats
from sightline.coverage import MEAN_OF_INSET
from sightline.geometry.arrays import exp_rotation, nearest_rotation, skew
from sightline.geometry.board_errors import board_parts
from sightline.geometry.camera import Camera
from sightline.geometry.road_pose import DEFAULT_U_SQUARE, BoardOnRoad, RoadPose

# A part stated as exact is still tested: so small that it moves nothing unless the traffic contradicts it.
_LEAST_U_RAD, _LEAST_U_M = 1e-6, 1e-6


@dataclass(frozen=True)
class Part:
    """One error with a name and a unit: `u` is what was stated, in that unit; `released_u` what is allowed
    where the traffic contradicts it (None: it is kept in any case). `of_m`: of a common error, the length
    that all of them state, where it is one.
    """

    name: str
    u: float
    released_u: float | None
    of_m: float | None = None


@dataclass(frozen=True, eq=False)
class SharedErrors:
    """`root` (n + 6, m): lens and pose by z; the last `len(parts)` of the m numbers are the parts. Of these
    the last `commons` are errors of known lengths: of wheelbases, of roofs, of each inset that is shared.
    """

    pose: RoadPose
    root: Floats
    parts: tuple[Part, ...]
    commons: int

    @property
    def size(self) -> int:
        """How many numbers z there are."""
        return int(self.root.shape[1])

    @property
    def first_part(self) -> int:
        """Index of the first z that is a part with a name."""
        return self.size - len(self.parts)

    @property
    def common(self) -> tuple[Part, ...]:
        """The parts that are errors of known lengths."""
        return self.parts[-self.commons :]


def shared_errors(
    pose: RoadPose, u_wheelbase_common_m: float, u_roof_common_m: float, insets: Sequence[Known] = ()
) -> SharedErrors:
    """The errors of `pose` that its traffic may correct; the last parts are the common ones, metres, that of
    each of the shared `insets` among them.

    The prior of each is what was stated: JCGM 102:2011, 5.4.1, with the pose as the quantity measured. Of an
    inset it is the part of its variance that is its mean's, as in the statistics of heights.
    """
    columns = [_root_of(pose.covariance, len(pose.parameters))]
    parts: list[Part] = []
    if pose.board is not None:
        tested = replace(pose, board=_tested(pose.board))
        for names, increments in zip(_names(pose.board), board_parts(tested).values(), strict=False):
            columns.append(np.concatenate([np.zeros((len(pose.camera.parameters), len(names))), increments]))
            parts += names
    common = [
        Part("wheelbase_common_m", u_wheelbase_common_m, None),
        Part("roof_common_m", u_roof_common_m, None),
        *(Part("roof_inset_common_m", MEAN_OF_INSET**0.5 * one.u_m, None, one.value_m) for one in insets),
    ]
    columns.append(np.zeros((len(pose.parameters), len(common))))
    return SharedErrors(pose, np.concatenate(columns, axis=1), (*parts, *common), len(common))


def _names(board: BoardOnRoad) -> list[list[Part]]:
    """In the order of `board_parts`."""
    square = board.square_m * DEFAULT_U_SQUARE if board.u_square_m is None else board.u_square_m
    bow = board.u_bow_m or 0.0
    lean = max(board.u_lean_rad, _LEAST_U_RAD)
    return [
        [Part("board_lean_rad", lean, 0.05)],
        [Part("board_roll_rad", lean, 0.05)],
        [Part("board_height_m", max(board.u_reference_height_m, _LEAST_U_M), 0.05)],
        [Part("square_m", max(square, _LEAST_U_M * board.square_m), 0.03 * board.square_m)],
        [Part("bow_along_rows_m", bow, None), Part("bow_down_columns_m", bow, None)],
    ]


def _tested(board: BoardOnRoad) -> BoardOnRoad:
    """The board with what is stated as exact, or not stated, open to the traffic."""
    parts = {part.name: part.u for group in _names(board) for part in group}
    return replace(
        board,
        u_lean_rad=parts["board_lean_rad"],
        u_reference_height_m=parts["board_height_m"],
        u_square_m=parts["square_m"],
    )


def _root_of(covariance: Floats | None, size: int) -> Floats:
    """A matrix B with B B' = `covariance`, without columns of zeros; scaled: pixels and radians."""
    if covariance is None:
        return np.zeros((size, 0))
    sigma = np.sqrt(np.diag(covariance))
    scale = np.where(sigma > 0, sigma, 1.0)
    values, vectors = np.linalg.eigh(covariance / np.outer(scale, scale))
    kept = values > 1e-10
    return np.asarray(scale[:, None] * vectors[:, kept] * np.sqrt(values[kept]), dtype=np.float64)


def moved_pose(pose: RoadPose, increments: Floats) -> RoadPose:
    """The pose with its lens and place off by `increments` (n + 6,), in the order of its parameters.

    x_cam = Exp(r) (R x + t) + t', CONVENTIONS.md, Pose. Its covariance is left as it was.
    """
    n = len(pose.camera.parameters)
    turn = exp_rotation(increments[n : n + 3])
    return replace(
        pose,
        camera=moved_camera(pose.camera, increments[:n]),
        rotation=nearest_rotation(turn @ pose.rotation),
        translation_m=turn @ pose.translation_m + increments[n + 3 :],
    )


def moved_camera(camera: Camera, by: Floats) -> Camera:
    """The camera with each of its parameters changed by `by` (n,).

    The parameters are those of Brown 1966 or of Kannala and Brandt 2006 (CONVENTIONS.md, Lens).
    """
    fx, fy, cx, cy = (float(v) for v in by[:4])
    return replace(
        camera,
        fx_px=camera.fx_px + fx,
        fy_px=camera.fy_px + fy,
        cx_px=camera.cx_px + cx,
        cy_px=camera.cy_px + cy,
        distortion=camera.distortion + by[4:],
    )


def covariance_at(pose: RoadPose, increments: Floats, covariance: Floats) -> Floats:
    """`covariance` (n + 6, n + 6) of increments from `pose`, as that, (n + 6, n + 6), of increments
    from the pose moved by `increments` (n + 6,).

    Exp(r + dr) = Exp(J dr) Exp(r) with J = I + [r]/2 to first order (Sola et al. 2018), and t' then turns
    with the rest: dt = dt' - (J dr) x t'.
    """
    n = len(pose.camera.parameters)
    turn = np.eye(3) + 0.5 * skew(increments[n : n + 3])
    change = np.eye(n + 6)
    change[n : n + 3, n : n + 3] = turn
    change[n + 3 :, n : n + 3] = skew(increments[n + 3 :]) @ turn
    return np.asarray(change @ covariance @ change.T, dtype=np.float64)
