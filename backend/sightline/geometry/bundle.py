"""Least squares over a lens and the poses of all its views at once (bundle adjustment of a calibration).

It ends what OpenCV's solvers begin, and takes the board's shape in as well where the board is not flat.
OpenCV's fisheye solver has one fixed start and can end in a false minimum: then several focal lengths are
tried here, each with poses from both planar solutions, and the best is refined to its minimum.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sightline.arrays import Floats
from sightline.enums import LensModel
from sightline.geometry.arrays import exp_rotation
from sightline.geometry.camera import Camera
from sightline.geometry.planar import PlanarPose, linearise, planar_roots

_ROUNDS = 80
_GOOD_RMS_PX = 1.0  # no further start is tried below this
_FOCAL_SHARES = (0.4, 0.28, 0.6, 0.9, 1.4)  # of the picture's width


def refine_all(
    camera: Camera, poses: Sequence[PlanarPose], objects: Sequence[Floats], seen: Sequence[Floats]
) -> tuple[Camera, tuple[PlanarPose, ...]]:
    """Least squares over the lens's parameters and every pose; per view `objects` (N, 3), metres, and `seen`
    (N, 2), pixels.

    Levenberg-Marquardt (Marquardt 1963) with the Schur complement over the poses (Triggs et al. 2000).
    """
    flat = [np.empty((len(points), 0)) for points in objects]
    camera, found, _ = refine_bent(camera, poses, objects, seen, flat)
    return camera, found


def refine_bent(
    camera: Camera,
    poses: Sequence[PlanarPose],
    objects: Sequence[Floats],
    seen: Sequence[Floats],
    bases: Sequence[Floats],
) -> tuple[Camera, tuple[PlanarPose, ...], Floats]:
    """As `refine_all`, and over the board's shape; per view `objects` (N, 3), metres, `seen` (N, 2), pixels.

    `bases` (N, m) are the corners' heights out of the board's plane per unit of each of m coefficients, which
    come back (m,), metres. The poses' `lens_jacobian` then holds m further columns, those of the shape
    (Strobl and Hirzinger 2011).
    """
    n, shape = 4 + len(camera.distortion), np.zeros(bases[0].shape[1])
    now = _all_turned(camera, poses, [np.zeros(6)] * len(poses), shape, objects, seen, bases)
    cost, damping = sum(p.cost for p in now), 1e-4
    for _ in range(_ROUNDS):
        step, turns = _step(now, damping)
        tried_camera, tried_shape = _step_camera(camera, step[:n]), shape + step[n:]
        if tried_camera is None:
            damping *= 10.0
            continue
        tried = _all_turned(tried_camera, now, turns, tried_shape, objects, seen, bases)
        new_cost = sum(p.cost for p in tried)
        if np.isfinite(new_cost) and new_cost <= cost:
            done = cost - new_cost <= 1e-11 * cost
            camera, shape, now, cost, damping = (
                tried_camera,
                tried_shape,
                tried,
                new_cost,
                max(0.1 * damping, 1e-10),
            )
            if done:
                break
        else:
            damping *= 10.0
            if damping > 1e8:
                break
    return camera, now, shape


def _all_turned(
    camera: Camera,
    poses: Sequence[PlanarPose],
    turns: Sequence[Floats],
    shape: Floats,
    objects: Sequence[Floats],
    seen: Sequence[Floats],
    bases: Sequence[Floats],
) -> tuple[PlanarPose, ...]:
    return tuple(
        _step_pose(camera, pose, turn, apply_board_shape(o, b, shape), s, b)
        for pose, turn, o, s, b in zip(poses, turns, objects, seen, bases, strict=True)
    )


def apply_board_shape(points: Floats, basis: Floats, shape: Floats) -> Floats:
    """The flat board's `points` (N, 3) with the heights of its shape, (N, 3), metres: z + `basis` (N, m)
    times `shape` (m,).

    CONVENTIONS.md, Calibration.
    """
    if not shape.size:
        return points
    return np.column_stack([points[:, :2], points[:, 2] + basis @ shape])


def _step(poses: Sequence[PlanarPose], damping: float) -> tuple[Floats, list[Floats]]:
    """One damped step: of the lens (n,), and of each pose (6,)."""
    n = poses[0].lens_jacobian.shape[1]
    normal, gain = np.zeros((n, n)), np.zeros(n)
    for pose in poses:
        normal += pose.lens_jacobian.T @ pose.lens_jacobian
        gain += pose.lens_jacobian.T @ pose.residuals_px.ravel()
    normal += damping * np.diag(np.diag(normal))
    blocks = []
    for pose in poses:
        own = pose.jacobian.T @ pose.jacobian
        own += damping * np.diag(np.diag(own))
        cross = pose.lens_jacobian.T @ pose.jacobian
        pull = pose.jacobian.T @ pose.residuals_px.ravel()
        solved = np.linalg.solve(own, np.column_stack([cross.T, pull]))
        normal -= cross @ solved[:, :n]
        gain -= cross @ solved[:, n]
        blocks.append(solved)
    lens_step = np.asarray(np.linalg.lstsq(normal, gain, rcond=1e-14)[0], dtype=np.float64)
    return lens_step, [solved[:, n] - solved[:, :n] @ lens_step for solved in blocks]


def _step_camera(camera: Camera, step: Floats) -> Camera | None:
    fx, fy = camera.fx_px + float(step[0]), camera.fy_px + float(step[1])
    if not (np.isfinite(step).all() and 0.05 * camera.width_px < fx and 0.05 * camera.width_px < fy):
        return None
    cx, cy = camera.cx_px + float(step[2]), camera.cy_px + float(step[3])
    return replace(camera, fx_px=fx, fy_px=fy, cx_px=cx, cy_px=cy, distortion=camera.distortion + step[4:])


def _step_pose(
    camera: Camera, pose: PlanarPose, step: Floats, points: Floats, seen: Floats, basis: Floats
) -> PlanarPose:
    turn = exp_rotation(step[:3])
    at = linearise(camera, turn @ pose.rotation, turn @ pose.translation + step[3:], points, seen)
    if not basis.shape[1]:
        return at
    by_height = at.jacobian[:, 3:] @ at.rotation[:, 2]  # a corner that moves along the board's normal
    by_shape = by_height[:, None] * np.repeat(basis, 2, axis=0)
    return replace(at, lens_jacobian=np.concatenate([at.lens_jacobian, by_shape], axis=1))


def from_scratch(
    size: tuple[int, int], model: LensModel, objects: Sequence[Floats], seen: Sequence[Floats]
) -> tuple[Camera, tuple[PlanarPose, ...]] | None:
    """The best of several starts without distortion, refined; None where none puts every board before the
    camera. Per view `objects` (N, 3) with z = 0, metres, and `seen` (N, 2), pixels.

    Own method: focal lengths as shares of the picture's width, poses by IPPE (Collins and Bartoli 2014),
    `refine_all`.
    """
    best: tuple[Camera, tuple[PlanarPose, ...]] | None = None
    width, height = size
    for share in _FOCAL_SHARES:
        f = share * width
        k = np.zeros(5 if model == "brown" else 4)
        camera = Camera(
            name="camera",
            width_px=width,
            height_px=height,
            model=model,
            fx_px=f,
            fy_px=f,
            cx_px=(width - 1) / 2,
            cy_px=(height - 1) / 2,
            distortion=k,
        )
        poses = [
            roots[0] for o, s in zip(objects, seen, strict=True) if (roots := planar_roots(camera, o, s))
        ]
        if len(poses) < len(objects):
            continue
        found = refine_all(camera, poses, objects, seen)
        if best is None or _cost(found) < _cost(best):
            best = found
        if _cost(best) < _GOOD_RMS_PX**2 * sum(map(len, seen)):
            break
    return best


def _cost(found: tuple[Camera, tuple[PlanarPose, ...]]) -> float:
    return sum(pose.cost for pose in found[1])
