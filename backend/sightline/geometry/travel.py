"""A vehicle that travels straight and level: from pixels to how far it has come, and back.

Points of the vehicle are given the plane that they lie in (the side plane, or one an inset behind it); along
that plane a pixel says how far the point has moved.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.geometry.camera import project, undistort
from sightline.geometry.follow import Gray, Step, best_guess, follow_points, reach_px
from sightline.geometry.height import measure_height
from sightline.geometry.multiframe import LEAST_TRAVEL_M, MultiHeight, measure_frames
from sightline.geometry.ray_intersection import OK, contact_on_road, intersect_rays
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

_FASTEST_MPS = 45.0
_MOST_GUESSES = 40
_LEAST_POINTS = 3
_AGREE = 0.12  # points of one vehicle agree on its travel within this share, and this far at least
_AGREE_M = 0.04


@dataclass(frozen=True, eq=False)
class Body:
    """Points of a vehicle on the road (N, 3) at one frame, and the direction (2,) that it travels in."""

    points_m: Floats
    along: Floats = field(default_factory=lambda: np.array([1.0, 0.0]))

    def pixels(self, pose: RoadPose, travel_m: float) -> Floats:
        """Where the points (N, 2) are after the travel; NaN out of sight."""
        shift = travel_m * np.array([*self.along, 0.0])
        return project(pose.camera, pose.to_camera(self.points_m + shift))

    def travels_m(self, pose: RoadPose, points_px: Floats) -> Floats:
        """How far each point (N,) has come if it is now seen at points_px (N, 2); NaN where it cannot be."""
        undistorted = undistort(pose.camera, points_px)
        rays = np.column_stack([undistorted.points, np.ones(len(undistorted.points))]) @ pose.rotation
        across = np.array([-self.along[1], self.along[0]])
        with np.errstate(all="ignore"):
            reach = (self.points_m[:, :2] - pose.centre_m[:2]) @ across / (rays[:, :2] @ across)
            there = pose.centre_m[:2] + reach[:, None] * rays[:, :2]
            out = (there - self.points_m[:, :2]) @ self.along
        out[~undistorted.ok | ~(reach > 0)] = np.nan
        return np.asarray(out, dtype=np.float64)


def body_of(
    pose: RoadPose, contact_px: ArrayLike, target_px: ArrayLike, inset_m: float, spots_px: Floats
) -> Body | Said:
    """Contact, target (`inset_m` behind the side plane) and spots of the side plane as road points, or the
    reason why contact and target give none; `contact_px`, `target_px` (2,), `spots_px` (N, 2), pixels.

    Each ray C + lambda w meets its plane at lambda = (Y_plane - C_y) / w_y (CONVENTIONS.md, Height).
    """
    contact = np.asarray(contact_px, dtype=np.float64).reshape(1, 2)
    target = np.asarray(target_px, dtype=np.float64).reshape(1, 2)
    alone = measure_height(pose, contact[0], target[0], 0.0, inset_m)
    seen = intersect_rays(pose, contact, target, inset_m)
    if alone.reason is not None or seen.code[0] != OK:
        return alone.reason or Said("height-no-clicks")
    x, y, _ = (float(v[0]) for v in contact_on_road(pose, seen))
    pixels = np.concatenate([target, np.asarray(spots_px, dtype=np.float64).reshape(-1, 2)])
    planes = np.full(len(pixels), y)
    planes[0] += inset_m
    rays = undistort(pose.camera, pixels)
    lines = np.column_stack([rays.points, np.ones(len(pixels))]) @ pose.rotation
    with np.errstate(all="ignore"):
        points = pose.centre_m + ((planes - pose.centre_m[1]) / lines[:, 1])[:, None] * lines
    return Body(np.concatenate([[[x, y, 0.0]], points]))


class BodyTracker:
    """Follows a body through the frames of its pass, one frame after the other, one way in time.

    `speed_mps` (along the body's direction, negative against it) is None until the first frame has shown it.
    """

    def __init__(
        self, pose: RoadPose, body: Body, points_px: Floats, start: Gray, speed_mps: float | None = None
    ) -> None:
        self._pose = pose
        self._body = body
        self._picture = start
        self._points = np.asarray(points_px, dtype=np.float64)
        self._alive = np.asarray(np.isfinite(body.points_m).all(axis=1), dtype=np.bool_)
        self.speed_mps = speed_mps
        self.travel_m = 0.0

    def step(self, picture: Gray, dt_s: float) -> float | None:
        """How far the body is on the next `picture` (H, W), `dt_s` later (before: < 0), m; None if lost."""
        index = np.flatnonzero(self._alive)
        if len(index) < _LEAST_POINTS or dt_s == 0:
            return None
        searched = self._search(picture, dt_s, index)
        if searched is None:
            return None
        travels = np.full(len(self._points), np.nan)
        moved = self._points.copy()
        moved[index] = searched.points_px
        travels[index] = Body(self._body.points_m[index], self._body.along).travels_m(
            self._pose, searched.points_px
        )
        travels[index[~searched.ok]] = np.nan
        if not np.isfinite(travels).any():
            return None
        middle = float(np.nanmedian(travels))
        step = abs(middle - self.travel_m)
        with np.errstate(invalid="ignore"):
            self._alive[:] = np.abs(travels - middle) < max(_AGREE_M, _AGREE * step)
        if self._alive.sum() < _LEAST_POINTS:
            return None
        middle = float(np.median(travels[self._alive]))
        speed = (middle - self.travel_m) / dt_s
        if abs(speed) > _FASTEST_MPS:
            return None
        self.speed_mps, self.travel_m = speed, middle
        self._points, self._picture = moved, picture
        return middle

    def _search(self, picture: Gray, dt_s: float, index: np.ndarray) -> Step | None:
        points = self._points[index]
        body = Body(self._body.points_m[index], self._body.along)
        if self.speed_mps is not None:
            guess = body.pixels(self._pose, self.travel_m + self.speed_mps * dt_s)
            return follow_points(self._picture, picture, points, np.where(np.isfinite(guess), guess, points))
        furthest = _FASTEST_MPS * abs(dt_s)
        away = np.abs(body.pixels(self._pose, 0.1) - points).max(initial=1.0, where=np.isfinite(points))
        apart = max(0.1 * reach_px(picture) / float(away), 2.0 * furthest / _MOST_GUESSES)
        steps = [sign * s for s in np.arange(apart, furthest + apart, apart) for sign in (1.0, -1.0)]
        guesses = [body.pixels(self._pose, step) for step in steps]
        found = best_guess(
            self._picture, picture, points, [np.where(np.isfinite(g), g, points) for g in guesses]
        )
        return None if found is None else found[1]


@dataclass(frozen=True)
class Further:
    """What the same two points on one more frame would give: expected pixels and uncertainties."""

    travel_m: float
    contact_px: tuple[float, float]
    target_px: tuple[float, float]
    u_height_m: float
    u_inset_m: float


def further_gain(
    pose: RoadPose, contacts_px: Floats, targets_px: Floats, travel_m: float, sigma_px: float = 1.0
) -> Further | None:
    """Expected gain of a further frame beside F >= 2 clicked ones, `contacts_px`, `targets_px` (F, 2), after
    `travel_m` from the first. Its clicks are foreseen, and all measured as `measure_frames` does.

    None where that frame would not show both points, or the frames clicked have no height.
    """
    now = measure_frames(pose, contacts_px, targets_px, sigma_px)
    body = solved_body(pose, np.asarray(targets_px[0], dtype=np.float64), now)
    if body is None or abs(travel_m) < LEAST_TRAVEL_M:
        return None
    there = body.pixels(pose, travel_m)
    if not np.isfinite(there).all() or not pose.camera.inside(there).all():
        return None
    then = measure_frames(
        pose, np.vstack([contacts_px, there[:1]]), np.vstack([targets_px, there[1:]]), sigma_px
    )
    if then.height.u_height_m is None or then.u_solved_inset_m is None:
        return None
    (cx, cy), (tx, ty) = there.tolist()
    return Further(travel_m, (cx, cy), (tx, ty), then.height.u_height_m, then.u_solved_inset_m)


def solved_body(pose: RoadPose, target_px: Floats, solved: MultiHeight) -> Body | None:
    """Contact and target at the first frame as the frames together have them, `target_px` (2,) there; None
    without a height.

    The target's ray meets the vertical plane along the solved heading, the solved inset behind the contact
    (CONVENTIONS.md, Several frames).
    """
    height = solved.height
    if (
        height.x_m is None
        or height.y_m is None
        or solved.solved_inset_m is None
        or solved.heading_rad is None
    ):
        return None
    along = np.array([np.cos(solved.heading_rad), np.sin(solved.heading_rad)])
    across = np.array([-along[1], along[0]])
    foot = np.array([height.x_m, height.y_m])
    ray = pose.rotation.T @ np.array([*undistort(pose.camera, target_px.reshape(1, 2)).points[0], 1.0])
    plane = (foot - pose.centre_m[:2]) @ across + solved.solved_inset_m
    at = pose.centre_m + ray * (plane / float(ray[:2] @ across))
    return Body(np.array([[foot[0], foot[1], 0.0], at]), along)
