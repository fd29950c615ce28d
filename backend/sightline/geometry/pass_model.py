"""Where the points of a vehicle that travels straight are seen at given times, with all derivatives.

With t the time since the middle of the pass, s = v t + a t^2 / 2 and psi the heading against the road's X, a
point o ahead of the contact, c behind the side plane and H above the road is at

    X = x + (s + o) cos psi - c sin psi,   Y = y + (s + o) sin psi + c cos psi,   Z = H

    contact   o = c = H = 0      second contact   o = W, c = H = 0      target   o = ahead, c = inset, H

A rolling shutter sees row r at t + tau (r - middle), r being where the point is then seen: p = f(t + tau
r(p)), so every derivative of f is to be multiplied by (I - tau f' e_r')^-1 (implicit function). Own
derivation.
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.geometry.arrays import skew
from sightline.geometry.camera import project_with_jacobians, undistort
from sightline.geometry.followed_tracks import CONTACT, SECOND, TARGET, Tracks
from sightline.geometry.road_pose import RoadPose

X, Y, HEADING, SPEED, AHEAD, INSET, HEIGHT, WHEELBASE, ACCELERATION = range(9)
_ROW_ROUNDS = 4  # each brings a point tau f' nearer, a thousandth and less


@dataclass(frozen=True, eq=False)
class Seen:
    """Modelled pixels (N, 2); derivatives, rows x and y of each observation, by the nine unknowns (2N, 9), by
    lens and pose (2N, n + 6), by the row time (2N,); and the points' speed in the picture (N, 2), pixels a
    second.
    """

    pixels: Floats
    by_unknowns: Floats
    by_lens_pose: Floats
    by_row_time: Floats
    speed_px_s: Floats


def middle_s(tracks: Tracks) -> float:
    """The middle of the first and the last of the times, seconds (CONVENTIONS.md, Whole passes)."""
    return float(0.5 * (tracks.time_s.min() + tracks.time_s.max()))


def since_middle(tracks: Tracks) -> Floats:
    """Times (N,), seconds, from `middle_s` (CONVENTIONS.md, Whole passes)."""
    return np.asarray(tracks.time_s - middle_s(tracks), dtype=np.float64)


def predict_tracks(pose: RoadPose, tracks: Tracks, t_s: Floats, row_time_s: float, unknowns: Floats) -> Seen:
    """What the model shows for `tracks` (N) at `t_s` (N,), `since_middle`, with `unknowns` (9,).

    The equations of this module; projection after Brown 1966 or Kannala and Brandt 2006.
    """
    middle = 0.5 * (pose.camera.height_px - 1)
    row = np.asarray(tracks.points_px[:, 1] - middle, dtype=np.float64)
    for _ in range(_ROW_ROUNDS if row_time_s else 0):
        points = _placed(tracks, t_s + row_time_s * row, unknowns)[0]
        pixels = project_with_jacobians(pose.camera, pose.to_camera(points))[0]
        row = np.asarray(pixels[:, 1] - middle, dtype=np.float64)
    points, by_unknowns, velocity = _placed(tracks, t_s + row_time_s * row, unknowns)
    at_cam = pose.to_camera(points)
    pixels, by_point, by_lens = project_with_jacobians(pose.camera, at_cam)
    by_road = by_point @ pose.rotation
    speed = (by_road @ velocity[:, :, None])[:, :, 0]
    late = np.broadcast_to(np.eye(2), (len(row), 2, 2)).copy()
    late[:, :, 1] -= row_time_s * speed
    late = np.asarray(np.linalg.inv(late), dtype=np.float64)
    by_pose = np.concatenate([by_lens, by_point @ -skew(at_cam), by_point], axis=2)
    speed = (late @ speed[:, :, None])[:, :, 0]
    return Seen(
        pixels=pixels,
        by_unknowns=(late @ by_road @ by_unknowns).reshape(2 * len(row), -1),
        by_lens_pose=(late @ by_pose).reshape(2 * len(row), -1),
        by_row_time=(speed * row[:, None]).ravel(),
        speed_px_s=speed,
    )


def _placed(tracks: Tracks, t_s: Floats, unknowns: Floats) -> tuple[Floats, Floats, Floats]:
    """Points on the road (N, 3), their derivatives by the unknowns (N, 3, 9), their velocity (N, 3)."""
    x, y, heading, speed, ahead, inset, height, wheelbase, acceleration = (float(v) for v in unknowns)
    along = np.array([np.cos(heading), np.sin(heading), 0.0])
    across = np.array([-along[1], along[0], 0.0])
    target, second = tracks.point == TARGET, tracks.point == SECOND
    forward = speed * t_s + 0.5 * acceleration * t_s**2 + ahead * target + wheelbase * second
    points = np.array([x, y, 0.0]) + forward[:, None] * along + np.outer(inset * target, across)
    points[:, 2] = height * target
    out = np.zeros((len(t_s), 3, 9))
    out[:, 0, X] = out[:, 1, Y] = 1.0
    out[:, :, HEADING] = forward[:, None] * across - np.outer(inset * target, along)
    out[:, :, SPEED] = t_s[:, None] * along
    out[:, :, AHEAD] = np.outer(target, along)
    out[:, :, INSET] = np.outer(target, across)
    out[:, 2, HEIGHT] = target
    out[:, :, WHEELBASE] = np.outer(second, along)
    out[:, :, ACCELERATION] = 0.5 * t_s[:, None] ** 2 * along
    return points, out, (speed + acceleration * t_s)[:, None] * along


def first_estimate(pose: RoadPose, tracks: Tracks, t_s: Floats) -> Floats:
    """First estimate of the unknowns (9,) from a straight line through the contacts, at `t_s` (N,), and the
    target's rays, which cross at one point of the moving vehicle; NaN where rays do not meet the road.

    Own method: two linear least squares in metres.
    """
    rays = (
        np.column_stack([undistort(pose.camera, tracks.points_px).points, np.ones(len(t_s))]) @ pose.rotation
    )
    with np.errstate(all="ignore"):
        ground = pose.centre_m[:2] - rays[:, :2] * (pose.centre_m[2] / rays[:, 2:])
    mine = tracks.point == CONTACT
    line = np.column_stack([np.ones(int(mine.sum())), t_s[mine]])
    if not np.isfinite(ground[mine]).all():
        return np.full(9, np.nan)
    (start, velocity), *_ = np.linalg.lstsq(line, ground[mine], rcond=None)
    sign = -1.0 if velocity[0] < 0 else 1.0
    heading = float(np.arctan2(sign * velocity[1], sign * velocity[0]))
    along = np.array([np.cos(heading), np.sin(heading)])
    axes = np.array([along, [-along[1], along[0]]])
    other = tracks.point == SECOND
    base = (ground[other] - start - np.outer(t_s[other], velocity)) @ along
    wheelbase = float(np.median(base)) if other.any() else 0.0
    target = tracks.point == TARGET
    point = _crossing(pose, rays[target], start + np.outer(t_s[target], velocity))
    speed = sign * float(np.hypot(*velocity))
    return np.array([*start, heading, speed, *(axes @ point[:2]), point[2], wheelbase, 0.0])


def _crossing(pose: RoadPose, rays: Floats, ground: Floats) -> Floats:
    """The point (3,) that rays (F, 3) meet best, in axes that go with the contact, at ground (F, 2)."""
    direction = rays / np.linalg.norm(rays, axis=1)[:, None]
    eye = pose.centre_m - np.column_stack([ground, np.zeros(len(ground))])
    across = np.eye(3) - direction[:, :, None] * direction[:, None, :]
    found = np.linalg.lstsq(across.sum(axis=0), np.einsum("fij,fj->i", across, eye), rcond=None)[0]
    return np.asarray(found, dtype=np.float64)
