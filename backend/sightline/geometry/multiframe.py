"""Contact and target clicked in two or more frames: the inset is solved for instead of assumed.

The vehicle travels straight and level, so in F frames the same two points give 4F coordinates for F + 5
unknowns: where the contact stands on the road (2), how far it has come since (F - 1), the heading of the
traffic against the road's X, and the target's place on the vehicle: ahead of the contact, behind the side
plane (the inset), and above the road. Parallax between target and contact separates the inset from the
height; the single-frame bias (C_z - h) inset / (D + inset), which Dupuis et al. 2019 leave out, is gone. No
published method is known.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.geometry.arrays import skew
from sightline.geometry.board_errors import board_parts
from sightline.geometry.camera import project_with_jacobians, undistort
from sightline.geometry.height import BudgetEntry, Height, Parts, left_out, not_measurable
from sightline.geometry.insets import implausible_inset
from sightline.geometry.ray_intersection import (
    BAD_SIGMA,
    BELOW_ROAD,
    NO_CROSSING,
    OK,
    REASONS,
    contact_on_road,
    intersect_rays,
)
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

U_HEADING_RAD = float(np.deg2rad(1.0))  # how well a board is set parallel to the traffic (estimate)
LEAST_TRAVEL_M = 0.15
_UNSETTLED = Said("height-clicks-disagree")
_ROUNDS = 50
# Settled: left to gain of 1 + chi-square; its root is the step left in uncertainties (scaled by the misfit).
_LEFT_TO_GAIN = 1e-8
_CHI2_999 = {1: 10.83, 3: 16.27, 5: 20.52, 7: 24.32}


@dataclass(frozen=True)
class MultiHeight:
    """A height from several frames; the solved numbers are None where it is not measurable.

    `heading_rad`: direction of travel against the road's X axis; `travel_m`: between the two frames that lie
    furthest apart. The frames may come in any order; the contact point is that of the first given.
    `inset_parts`, `heading_parts`: their u in parts.
    """

    height: Height
    solved_inset_m: float | None = None
    u_solved_inset_m: float | None = None
    heading_rad: float | None = None
    u_heading_rad: float | None = None
    travel_m: float | None = None
    frames: int = 0
    inset_parts: Parts | None = None
    heading_parts: Parts | None = None


@dataclass(frozen=True, eq=False)
class _Linear:
    """Residuals (4F,) and derivatives at one estimate."""

    residual: Floats
    jacobian: Floats  # (4F, F + 5)
    by_lens_pose: Floats  # (4F, n + 6)


def measure_frames(
    pose: RoadPose,
    contacts_px: ArrayLike,
    targets_px: ArrayLike,
    sigma_px: float = 1.0,
    u_heading_rad: float | None = U_HEADING_RAD,
) -> MultiHeight:
    """Height and inset from the same two points in F >= 2 frames of a passing vehicle.

    Least squares in pixels; the uncertainty comes from the clicks, the heading, lens and pose (through the
    implicit function of the minimum, -N^-1 J' W J_k) and what the board may be off by: own derivation,
    CONVENTIONS.md, Several frames.

    Parameters
    ----------
    pose : RoadPose
    contacts_px, targets_px : (F, 2) array
        Pixels of the tyre's contact and of the target, a row a frame.
    sigma_px : float
        Standard uncertainty of each coordinate of each click, px.
    u_heading_rad : float or None
        Standard uncertainty of the traffic's direction against the road's X axis; None: nothing is known.

    Returns
    -------
    MultiHeight
        `height` as of `measure_height`, `solved_inset_m` and its u, metres. Never raises for what was
        clicked: no height comes back with its reason.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> tyre = np.array([[-0.7, 0.0, 0.0], [0.9, 0.0, 0.0]])
    >>> points = tyre, tyre + [0.0, 0.2, 1.45]
    >>> pixels = [sightline.project(camera, pose.to_camera(of_point)) for of_point in points]
    >>> found = sightline.measure_frames(pose, *pixels)
    >>> round(found.height.height_m, 3), round(found.solved_inset_m, 3)
    (1.45, 0.2)
    """
    contacts = np.asarray(contacts_px, dtype=np.float64).reshape(-1, 2)
    targets = np.asarray(targets_px, dtype=np.float64).reshape(-1, 2)
    reason = _refusal(pose, contacts, targets, sigma_px)
    if reason is not None:
        return MultiHeight(not_measurable(reason))
    start = _start(pose, contacts, targets)
    travel = _span(start, len(contacts))
    if travel < LEAST_TRAVEL_M:
        return MultiHeight(not_measurable(Said("height-travel-short", travel_m=round(travel, 2))))
    sigma = max(sigma_px, 1e-6)
    solved = _solve(pose, contacts, targets, start, sigma, u_heading_rad)
    if solved is None:
        return MultiHeight(not_measurable(_UNSETTLED))
    return _reported(pose, contacts, targets, solved, sigma, u_heading_rad)


def _refusal(pose: RoadPose, contacts: Floats, targets: Floats, sigma_px: float) -> Said | None:
    if len(contacts) != len(targets) or len(contacts) < 2:
        return Said("height-frames-too-few")
    if not np.isfinite(sigma_px) or sigma_px < 0:
        return REASONS[BAD_SIGMA]
    codes = intersect_rays(pose, contacts, targets, 0.0).code
    for frame, code in enumerate(codes, start=1):
        if code not in (OK, BELOW_ROAD, NO_CROSSING):
            return Said("height-of-frame", frame=frame, frames=len(codes), reason=REASONS[int(code)])
    return None


def _start(pose: RoadPose, contacts: Floats, targets: Floats) -> Floats:
    """First estimate (F + 5,): contacts on the road, travel and heading from them, the target by crossing
    rays.

    Order: x, y of the first contact, travel of frames 2 to F, heading, then ahead, inset and height of the
    target.
    """
    x, y, _ = contact_on_road(pose, intersect_rays(pose, contacts, targets, 0.0))
    ground = np.stack([x, y], axis=1)
    step = ground[int(np.argmax(np.linalg.norm(ground - ground[0], axis=1)))] - ground[0]
    forward = -1.0 if step[0] < 0 else 1.0
    heading = float(np.arctan2(forward * step[1], forward * step[0]))
    axes = _axes(heading)
    rays = undistort(pose.camera, targets).points
    direction = np.column_stack([rays, np.ones(len(rays))]) @ pose.rotation
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    eye = pose.centre_m - np.column_stack([ground, np.zeros(len(ground))])
    across = np.eye(3) - direction[:, :, None] * direction[:, None, :]
    point = np.linalg.lstsq(across.sum(axis=0), np.einsum("fij,fj->i", across, eye), rcond=None)[0]
    travel = (ground - ground[0]) @ axes[0]
    return np.concatenate([ground[0], travel[1:], [heading], axes @ point[:2], point[2:]])


def _span(theta: Floats, frames: int) -> float:
    """How far the vehicle came between the two frames that lie furthest apart."""
    return float(np.ptp([0.0, *theta[2 : frames + 1]]))


def _axes(heading: float) -> Floats:
    """Rows: along the traffic and across it, in the road's X and Y."""
    c, s = float(np.cos(heading)), float(np.sin(heading))
    return np.array([[c, s], [-s, c]])


def _linearise(pose: RoadPose, contacts: Floats, targets: Floats, theta: Floats) -> _Linear:
    """Residuals (seen minus modelled) and derivatives; rows: contact x, y of each frame, then target x, y."""
    frames = len(contacts)
    heading, ahead, inset, height = (float(v) for v in theta[frames + 1 :])
    along, across = _axes(heading)
    travel = np.concatenate([[0.0], theta[2 : frames + 1]])
    ground = theta[:2] + travel[:, None] * along
    flat = ground + ahead * along + inset * across
    points = np.zeros((2 * frames, 3))
    points[:, :2] = np.concatenate([ground, flat])
    points[frames:, 2] = height
    by_theta = np.zeros((2 * frames, 3, frames + 5))
    by_theta[:, 0, 0] = by_theta[:, 1, 1] = 1.0
    for k in range(1, frames):
        by_theta[[k, frames + k], :2, 1 + k] = along
    turn = np.concatenate([travel, travel + ahead])
    by_theta[:, :2, frames + 1] = turn[:, None] * across
    by_theta[frames:, :2, frames + 1] -= inset * along
    by_theta[frames:, :2, frames + 2] = along
    by_theta[frames:, :2, frames + 3] = across
    by_theta[frames:, 2, frames + 4] = 1.0
    at_cam = pose.to_camera(points)
    pixels, by_point, by_lens = project_with_jacobians(pose.camera, at_cam)
    by_road = by_point @ pose.rotation
    by_pose = np.concatenate([by_point @ -skew(at_cam), by_point], axis=2)
    rows = 4 * frames
    return _Linear(
        (np.concatenate([contacts, targets]) - pixels).ravel(),
        (by_road @ by_theta).reshape(rows, frames + 5),
        np.concatenate([by_lens, by_pose], axis=2).reshape(rows, -1),
    )


def _prior(frames: int, u_heading_rad: float | None) -> Floats:
    """Information on the parameters: the heading is that of the board, to u_heading_rad."""
    out = np.zeros(frames + 5)
    if u_heading_rad is not None:
        out[frames + 1] = 1.0 / max(u_heading_rad, 1e-9) ** 2
    return out


def _solve(
    pose: RoadPose, contacts: Floats, targets: Floats, theta: Floats, sigma: float, u_heading: float | None
) -> Floats | None:
    """Levenberg-Marquardt from `theta`; None where it does not settle on a target in front of the camera."""
    prior = _prior(len(contacts), u_heading)
    now = _linearise(pose, contacts, targets, theta)
    cost = _cost(now, theta, prior, sigma)
    damping = 1e-6
    for _ in range(_ROUNDS):
        normal = now.jacobian.T @ now.jacobian / sigma**2 + np.diag(prior)
        gain = now.jacobian.T @ now.residual / sigma**2 - prior * theta
        try:
            step = np.linalg.solve(normal + damping * np.diag(np.diag(normal)), gain)
        except np.linalg.LinAlgError:
            return None
        tried = _linearise(pose, contacts, targets, theta + step)
        new_cost = _cost(tried, theta + step, prior, sigma)
        if np.isfinite(new_cost) and new_cost <= cost + 1e-12:
            settled = cost - new_cost <= 1e-12 * (1.0 + cost) and float(np.abs(step).max()) < 1e-9
            theta, now, cost, damping = theta + step, tried, new_cost, max(0.1 * damping, 1e-12)
            if settled:
                break
        else:
            damping *= 10.0
            if damping > 1e10:
                break
    left = _left_to_gain(now, theta, prior, sigma)
    return theta if left <= _LEFT_TO_GAIN * (1.0 + cost) else None


def _left_to_gain(at: _Linear, theta: Floats, prior: Floats, sigma: float) -> float:
    """How much an undamped step would still lower the cost; infinite where there is no such step.

    Rounds may run out, and damping grow without end, far from the minimum as well as at it.
    """
    normal = at.jacobian.T @ at.jacobian / sigma**2 + np.diag(prior)
    gain = at.jacobian.T @ at.residual / sigma**2 - prior * theta
    scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-300))
    try:
        left = float(gain * scale @ np.linalg.solve(normal * np.outer(scale, scale), gain * scale))
    except np.linalg.LinAlgError:
        return np.inf
    return abs(left) if np.isfinite(left) else np.inf


def _cost(at: _Linear, theta: Floats, prior: Floats, sigma: float) -> float:
    return float(at.residual @ at.residual / sigma**2 + prior @ (theta * theta))


def _budget(
    pose: RoadPose, at: _Linear, sigma: float, u_heading: float | None
) -> tuple[dict[str, Floats], Floats, Floats] | None:
    """Effect of each source on theta: variances (F + 5,) by source; its derivatives by lens and pose
    (F + 5, n + 6); what one u of the assumed heading does to it (F + 5,).
    """
    frames = at.jacobian.shape[1] - 5
    prior = _prior(frames, u_heading)
    information = at.jacobian.T @ at.jacobian / sigma**2
    scale = 1.0 / np.sqrt(np.diag(information + np.diag(prior)))
    scaled = (information + np.diag(prior)) * np.outer(scale, scale)
    if not np.isfinite(scaled).all() or np.linalg.cond(scaled) > 1e12:
        return None
    covariance = np.linalg.inv(scaled) * np.outer(scale, scale)
    answer = -covariance @ at.jacobian.T / sigma**2
    # a variance of 0 may come out of rounding as less
    out = {"clicks": np.maximum(np.diag(covariance @ information @ covariance), 0.0)}
    turned = covariance[:, frames + 1] * np.sqrt(prior[frames + 1])
    if u_heading is not None:
        out["heading"] = np.square(turned)
    moved = answer @ at.by_lens_pose
    if pose.covariance is not None:
        out["lens and pose"] = np.maximum(np.einsum("ij,jk,ik->i", moved, pose.covariance, moved), 0.0)
    for source, part in board_parts(pose).items():
        out[source] = np.square(moved[:, -6:] @ part).sum(axis=1)
    return out, np.asarray(moved, dtype=np.float64), np.asarray(turned, dtype=np.float64)


def _reported(
    pose: RoadPose, contacts: Floats, targets: Floats, theta: Floats, sigma: float, u_heading: float | None
) -> MultiHeight:
    frames = len(contacts)
    at = _linearise(pose, contacts, targets, theta)
    budget = _budget(pose, at, sigma, u_heading)
    heading, _, inset, height = (float(v) for v in theta[frames + 1 :])
    if budget is None:
        return MultiHeight(not_measurable(Said("height-inset-undetermined")))
    if height <= 0:
        return MultiHeight(not_measurable(REASONS[BELOW_ROAD]))
    reason = implausible_inset(inset)
    if reason is not None:
        return MultiHeight(not_measurable(reason))
    sources, moved, turned = budget
    variances = np.sum(list(sources.values()), axis=0)
    u_heading_out, _, u_inset, u_height = (float(v) for v in np.sqrt(variances[frames + 1 :]))
    x, y = float(theta[0]), float(theta[1])
    result = Height(
        status="ok",
        reason=None,
        height_m=height,
        u_height_m=u_height,
        U95_height_m=COVERAGE_95 * u_height,
        x_m=x,
        y_m=y,
        distance_m=float(np.linalg.norm(pose.centre_m - [x, y, 0.0])),
        inset_m=inset,
        u_inset_m=u_inset,
        budget=tuple(BudgetEntry(name, float(np.sqrt(v[-1]))) for name, v in sources.items()),
        flags=_flags(pose, at, theta, sigma, u_inset),
    )

    def parts(which: int) -> Parts:
        return Parts(float(np.sqrt(sources["clicks"][which])), moved[which], float(turned[which]))

    return MultiHeight(
        height=result,
        solved_inset_m=inset,
        u_solved_inset_m=u_inset,
        heading_rad=heading,
        u_heading_rad=u_heading_out,
        travel_m=_span(theta, frames),
        frames=frames,
        inset_parts=parts(frames + 3),
        heading_parts=parts(frames + 1),
    )


def _flags(pose: RoadPose, at: _Linear, theta: Floats, sigma: float, u_inset: float) -> tuple[Said, ...]:
    out = left_out(pose)
    freedom = len(at.residual) - len(theta)
    if at.residual @ at.residual / sigma**2 > _CHI2_999.get(freedom, freedom + 4.0 * np.sqrt(2.0 * freedom)):
        out.append(Said("height-flag-clicks-misfit"))
    if u_inset > 0.3:
        out.append(Said("height-flag-inset-weak"))
    return tuple(out)
