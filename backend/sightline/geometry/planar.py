"""Pose of a plane of points: both planar solutions, each refined to its minimum.

A plane seen from far away has two poses with almost the same picture (Collins and Bartoli 2014, IPPE). Both
are tried, refined by Gauss-Newton in pixels with the lens model's own derivative, and the lower cost is
kept. IPPE gets its points with z *away* from the camera: with z towards it, OpenCV is off by degrees for a
board seen square-on.
"""

from dataclasses import dataclass

import cv2
import numpy as np

from sightline.arrays import Floats
from sightline.geometry.arrays import exp_rotation, nearest_rotation, skew
from sightline.geometry.camera import Camera, project_with_jacobians, undistort

_ROUNDS = 60
_SAME_RAD = 1e-3  # two starts that end this close found the same minimum


@dataclass(frozen=True, eq=False)
class PlanarPose:
    """x_cam = rotation @ x + translation. `jacobian` (2N, 6) by r and t', `lens_jacobian` (2N, n)."""

    rotation: Floats
    translation: Floats
    residuals_px: Floats  # (N, 2), seen minus modelled
    jacobian: Floats
    lens_jacobian: Floats

    @property
    def cost(self) -> float:
        return float(np.square(self.residuals_px).sum())


def linearise(
    camera: Camera, rotation: Floats, translation: Floats, points: Floats, seen: Floats
) -> PlanarPose:
    """Residuals and derivatives at a pose; points (N, 3), metres, seen (N, 2) pixels; rotation (3, 3),
    translation (3,).

    With x_cam = Exp(r) (R x + t) + t' (CONVENTIONS.md, Frames and signs), dx_cam = r x x_cam + t', so the
    derivative by (r, t') is dp/dx_cam [-skew(x_cam), I].
    """
    at_cam = points @ rotation.T + translation
    pixels, by_point, by_lens = project_with_jacobians(camera, at_cam)
    jacobian = np.concatenate([by_point @ -skew(at_cam), by_point], axis=2)
    n = 2 * len(points)
    return PlanarPose(
        rotation, translation, seen - pixels, jacobian.reshape(n, 6), by_lens.reshape(n, by_lens.shape[2])
    )


def refine(camera: Camera, rotation: Floats, translation: Floats, points: Floats, seen: Floats) -> PlanarPose:
    """The pose at the nearest minimum of the squared pixel residuals; points (N, 3), metres, seen (N, 2),
    pixels; it starts at rotation (3, 3), translation (3,). Levenberg-Marquardt (Marquardt 1963); every point
    stays before the camera.
    """
    now = linearise(camera, rotation, translation, points, seen)
    damping = 1e-6
    for _ in range(_ROUNDS):
        normal = now.jacobian.T @ now.jacobian
        scaled = normal + damping * np.diag(np.diag(normal))
        gain = now.jacobian.T @ now.residuals_px.ravel()
        step = np.asarray(np.linalg.solve(scaled, gain), dtype=np.float64)
        turn = exp_rotation(step[:3])
        tried = linearise(camera, turn @ now.rotation, turn @ now.translation + step[3:], points, seen)
        if np.isfinite(tried.cost) and tried.cost <= now.cost and _in_front(tried, points):
            done = now.cost - tried.cost <= 1e-13 * now.cost or float(np.abs(step).max()) < 1e-13
            now, damping = tried, max(damping * 0.1, 1e-12)
            if done:
                break
        else:
            damping *= 10.0
            if damping > 1e8:
                break
    return now


def _in_front(pose: PlanarPose, points: Floats) -> bool:
    return bool((points @ pose.rotation[2] + pose.translation[2] > 0).all())


def planar_roots(camera: Camera, flat_points: Floats, seen: Floats) -> list[PlanarPose]:
    """Refined poses of a plane, best first; flat_points (N, 3), metres, with z = 0, away from the camera;
    seen (N, 2), pixels.

    IPPE (Collins and Bartoli 2014) for both roots, then `refine`. Empty where a corner lies outside the lens
    model's valid radius or no pose puts the plane before the camera.
    """
    rays = undistort(camera, seen)
    if not rays.ok.all():
        return []
    roots = []
    for turn, translation in _starts(flat_points, rays.points):
        rotation = nearest_rotation(np.asarray(cv2.Rodrigues(turn)[0], dtype=np.float64))
        if (flat_points @ rotation[2] + translation[2] > 0).all():
            roots.append(refine(camera, rotation, translation, flat_points, seen))
    roots.sort(key=lambda pose: pose.cost)
    return [pose for i, pose in enumerate(roots) if i == 0 or _turn_between(pose, roots[0]) > _SAME_RAD]


def _starts(flat_points: Floats, rays: Floats) -> list[tuple[Floats, Floats]]:
    """Rotation vectors and translations to start from: both of IPPE's roots, else one of another solver.

    OpenCV's IPPE answers NaN to some ordinary boards; a picture a millionth larger it answers well.
    """
    for points, flag in (
        (rays, cv2.SOLVEPNP_IPPE),
        (rays * (1.0 + 1e-6) + 1e-7, cv2.SOLVEPNP_IPPE),
        (rays, cv2.SOLVEPNP_SQPNP),
    ):
        try:
            _, turns, shifts, _ = cv2.solvePnPGeneric(
                flat_points.reshape(-1, 1, 3), points.reshape(-1, 1, 2), np.eye(3), np.zeros(5), flags=flag
            )
        except cv2.error:
            continue
        pairs = zip(turns, shifts, strict=True)
        starts = [(np.asarray(r, np.float64).ravel(), np.asarray(t, np.float64).ravel()) for r, t in pairs]
        starts = [start for start in starts if np.isfinite(start).all()]
        if starts:
            return starts
    return []


def _turn_between(a: PlanarPose, b: PlanarPose) -> float:
    """Angle in radians between two rotations."""
    return float(np.arccos(np.clip((np.trace(a.rotation.T @ b.rotation) - 1.0) / 2.0, -1.0, 1.0)))
