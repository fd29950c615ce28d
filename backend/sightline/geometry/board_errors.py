"""What an imperfect board does to the road pose solved from it: lean, roll, height, square size, bow.

Each part is given as the increments of the pose (rx ry rz tx ty tz, as in RoadPose) that one standard
uncertainty of it causes, the pose solved again each time. The board is taken to be known at the reference
corner P = (0, 0, h_ref), where the tape was held. With p = R P + t, P in the camera frame:

    lean, roll     the road turns by e about X, or about Y, through P:  r = R e_x e (or R e_y e), t' = -r x p
    board height   the road moves along Z:                              t' = R e_z dh
    square size    the scene scales about P, directions stay:           t' = p ds / s  (exact: a similarity)
    bow            (J'J)^-1 J' dpixels/dbow, as the lens's covariance passes through the pose; it depends on
                   where the corners lie in the picture, so it is found with the pose and kept in its file
"""

import numpy as np

from sightline.arrays import Floats
from sightline.geometry.board import Board
from sightline.geometry.planar import PlanarPose
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

BOWS = 2  # along the rows and down the columns, independent of each other


def bow_profiles(board: Board) -> Floats:
    """How far the corners (N = rows * columns) of a board bent by 1 in the middle lie out of plane: (N, 2).

    Parabolas, 1 - x^2 and 1 - y^2 on -1..1 (CONVENTIONS.md, Pose): bent along the rows, and down the columns.
    Any other zero than the outer corners, or a slope, is a shift or a lean of the whole board.
    """
    row, column = np.mgrid[-1 : 1 : board.rows * 1j, -1 : 1 : board.columns * 1j]
    return np.stack([1.0 - column.ravel() ** 2, 1.0 - row.ravel() ** 2], axis=1)


def bow_response(at: PlanarPose, profiles: Floats) -> Floats:
    """Pose increments (6, 2) per metre of bow (radians, metres), the pose solved again: (J'J)^-1 J' dp/db,
    linear in the bow.

    at: the solution in the road frame, in which the board's normal is Y; profiles (N, 2) of its N corners.
    Own derivation: CONVENTIONS.md, Pose.
    """
    by_normal = at.jacobian[:, 3:] @ at.rotation[:, 1]
    shift = by_normal[:, None] * np.repeat(profiles, 2, axis=0)
    return np.asarray(np.linalg.solve(at.jacobian.T @ at.jacobian, at.jacobian.T @ shift), dtype=np.float64)


def board_parts(pose: RoadPose) -> dict[str, Floats]:
    """Pose increments (6, k), radians and metres, that one standard uncertainty of each known part of the
    board causes; {} without a board. Several columns of one part are independent of each other.

    Own derivation: the table of CONVENTIONS.md, Pose.
    """
    board = pose.board
    if board is None:
        return {}
    across, away, up = pose.rotation.T
    corner = up * board.reference_height_m + pose.translation_m
    out = {
        "board lean": _turn(across, corner) * board.u_lean_rad,
        "board roll": _turn(away, corner) * board.u_lean_rad,
        "board height": _shift(up) * board.u_reference_height_m,
    }
    if board.u_square_m is not None:
        out["square size"] = _shift(corner) * (board.u_square_m / board.square_m)
    if board.u_bow_m is not None and board.bow_response is not None:
        out["board bow"] = np.array(board.bow_response).T * board.u_bow_m
    return out


def board_covariance(pose: RoadPose) -> Floats:
    """Covariance (6, 6) of the pose's increments (rad, m) from all known parts of the board together: the sum
    of B B' over the parts B of `board_parts`, which are independent (JCGM 100:2008, 5.1.2).
    """
    total = np.zeros((6, 6))
    for part in board_parts(pose).values():
        total += part @ part.T
    return total


def unknown_parts(pose: RoadPose) -> Said | None:
    """Which parts of the board's uncertainty the pose does not state, or None."""
    board = pose.board
    if board is None:
        return Said("height-flag-no-board")
    no_square_size = board.u_square_m is None
    no_bow = board.u_bow_m is None or board.bow_response is None
    if no_square_size and no_bow:
        return Said("height-flag-no-square-size-and-bow")
    if no_square_size:
        return Said("height-flag-no-square-size")
    return Said("height-flag-no-bow") if no_bow else None


def _turn(axis: Floats, pivot: Floats) -> Floats:
    """A turn of the road by 1 about `axis` through `pivot`, both in the camera frame; (6, 1)."""
    return np.concatenate([axis, -np.cross(axis, pivot)])[:, None]


def _shift(by: Floats) -> Floats:
    return np.concatenate([np.zeros(3), by])[:, None]
