"""What a second frame would gain, before anybody clicks it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.height import measure_height
from sightline.geometry.multiframe import LEAST_TRAVEL_M, measure_frames
from sightline.geometry.ray_intersection import OK, contact_on_road, intersect_rays
from sightline.geometry.road_pose import RoadPose


@dataclass(frozen=True)
class Gain:
    """Expected standard uncertainties of a height with one frame and with a second one at `travel_m`."""

    travel_m: float
    u_single_m: float
    u_double_m: float
    u_inset_m: float
    contact_px: tuple[float, float]
    target_px: tuple[float, float]


def second_frame_gain(
    pose: RoadPose,
    contact_px: ArrayLike,
    target_px: ArrayLike,
    travel_m: float,
    sigma_px: float = 1.0,
    inset_m: float = 0.0,
    u_inset_m: float = 0.0,
) -> Gain | None:
    """Expected gain when the vehicle has moved `travel_m` along X (negative: against it).

    contact_px, target_px (2,): the clicks of the first frame. The answer also says where both points will be
    in the second frame. None where the first frame has no height, or the second would not show both points.
    The clicks of the second frame are foreseen and both measured as in CONVENTIONS.md, Several frames.
    """
    contact = np.asarray(contact_px, dtype=np.float64).reshape(1, 2)
    target = np.asarray(target_px, dtype=np.float64).reshape(1, 2)
    single = measure_height(pose, contact[0], target[0], sigma_px, inset_m, u_inset_m)
    if single.u_height_m is None or abs(travel_m) < LEAST_TRAVEL_M:
        return None
    second = _move_clicks(pose, contact, target, travel_m, inset_m)
    if not np.isfinite(second).all() or not pose.camera.inside(second).all():
        return None
    both_frames = measure_frames(
        pose, np.stack([contact[0], second[0]]), np.stack([target[0], second[1]]), sigma_px
    )
    if both_frames.height.u_height_m is None or both_frames.u_solved_inset_m is None:
        return None
    (cx, cy), (tx, ty) = second.tolist()
    return Gain(
        travel_m=travel_m,
        u_single_m=single.u_height_m,
        u_double_m=both_frames.height.u_height_m,
        u_inset_m=both_frames.u_solved_inset_m,
        contact_px=(cx, cy),
        target_px=(tx, ty),
    )


def _move_clicks(pose: RoadPose, contact: Floats, target: Floats, travel_m: float, inset_m: float) -> Floats:
    """Pixels (2, 2) of contact and target after the travel; NaN where the first frame has no height."""
    intersection = intersect_rays(pose, contact, target, inset_m)
    if intersection.code[0] != OK:
        return np.full((2, 2), np.nan)
    x, y, _ = (float(v[0]) for v in contact_on_road(pose, intersection))
    ray = pose.rotation.T @ np.array([intersection.target[0][0], intersection.target[1][0], 1.0])
    at = pose.centre_m + ray * (float(intersection.plane_m[0]) / float(intersection.w_target_y[0]))
    shift = np.array([travel_m, 0.0, 0.0])
    return project(pose.camera, pose.to_camera(np.stack([np.array([x, y, 0.0]), at]) + shift))
