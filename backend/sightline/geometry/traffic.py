"""What the traffic itself says of a pose: the direction of travel from both tyre contacts of vehicles."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.arrays import Bools, Floats
from sightline.geometry.arrays import freeze_array, skew
from sightline.geometry.camera import project_with_jacobians, undistort
from sightline.geometry.height import Parts, shared_covariance
from sightline.geometry.ray_intersection import MIN_DEPRESSION
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.spread import mean_and_spread, outliers
from sightline.messages.said import Said

LEAST_BASE_M = 1.0  # between two tyre contacts of one vehicle
MOST_BASE_M = 15.0
LEAST_VEHICLES = 3
_STEP_PX = 0.5
_LEAST_SCALE_RAD = float(np.deg2rad(0.1))  # vehicles keep no straighter course than this


@dataclass(frozen=True)
class Heading:
    """A vehicle's direction of travel against the road's X axis, whichever way it goes; and from how far
    apart its contacts are. `u_heading_rad`: that of the clicks; `parts` tells what vehicles share beside.
    `u_base_m`: that of the clicks on both tyres; None of a travel between frames.
    """

    heading_rad: float
    parts: Parts
    base_m: float
    u_base_m: float | None = None

    @property
    def u_heading_rad(self) -> float:
        """Of the vehicle's own clicks."""
        return self.parts.u_own


@dataclass(frozen=True, eq=False)
class Headings:
    """Headings of N vehicles, which were used, and their summary.

    `spread_rad`: standard deviation between vehicles beyond what clicks explain. `proposed`: whether the mean
    differs from 0 by more than the 95 % interval of Student's t; turning the road by `mean_rad` about Z
    then corrects the pose.
    """

    heading_rad: Floats
    used: Bools
    mean_rad: float
    u_mean_rad: float
    spread_rad: float
    proposed: bool


def headings_of_pairs(
    pose: RoadPose, first_px: ArrayLike, second_px: ArrayLike, sigma_px: float = 1.0
) -> list[Heading | Said]:
    """Direction of travel from both tyre contacts of N vehicles, `first_px`, `second_px` (N, 2), radians
    against X, or the reason why there is none.

    CONVENTIONS.md, Direction of travel. u is that of the clicks, by central differences of the road points
    (JCGM 100:2008, 5.1.3); the derivative by lens and pose is that of where the clicks' rays meet the road.
    """
    clicks = np.stack([np.asarray(c, dtype=np.float64).reshape(-1, 2) for c in (first_px, second_px)], axis=1)
    moves = np.zeros((9, 2, 2))
    for k, (which, axis) in enumerate(((0, 0), (0, 1), (1, 0), (1, 1))):
        moves[1 + 2 * k, which, axis], moves[2 + 2 * k, which, axis] = -_STEP_PX, _STEP_PX
    road = _road_points(pose, (clicks[:, None] + moves).reshape(-1, 2)).reshape(-1, 9, 2, 2)
    step = road[:, :, 1] - road[:, :, 0]
    sign = np.where(step[:, :1, 0] >= 0, 1.0, -1.0)
    angle = np.arctan2(sign * step[:, :, 1], sign * step[:, :, 0])
    lengths = np.hypot(step[..., 0], step[..., 1])
    base = lengths[:, 0]
    u, u_base = (
        sigma_px * np.linalg.norm((of[:, 2::2] - of[:, 1::2]) / (2.0 * _STEP_PX), axis=1)
        for of in (angle, lengths)
    )
    by = _by_lens_pose(pose, road[:, 0])
    return [
        _why_none(pose, pair, float(b), float(w))
        or Heading(float(a), Parts(float(w), g), float(b), float(ub))
        for pair, a, w, g, b, ub in zip(clicks, angle[:, 0], u, by, base, u_base, strict=True)
    ]


def _by_lens_pose(pose: RoadPose, road: Floats) -> Floats:
    """Derivatives (N, n + 6) by lens and pose of the directions between pairs of road points (N, 2, 2) that
    are seen in the same places: dXY = -(dp/dXY)^-1 dp/dk (implicit function).
    """
    points = np.concatenate([road, np.zeros((len(road), 2, 1))], axis=2).reshape(-1, 3)
    at_cam = pose.to_camera(points)
    with np.errstate(all="ignore"):
        _, by_point, by_lens = project_with_jacobians(pose.camera, at_cam)
        by = np.concatenate([by_lens, by_point @ -skew(at_cam), by_point], axis=2)
        on_road = (by_point @ pose.rotation)[:, :, :2]
        across = np.stack([on_road[:, 1, 1], -on_road[:, 0, 1], -on_road[:, 1, 0], on_road[:, 0, 0]], axis=1)
        inverse = across.reshape(-1, 2, 2) / np.linalg.det(on_road)[:, None, None]
        moved = (-inverse @ by).reshape(len(road), 2, 2, by.shape[2])
        step, change = road[:, 1] - road[:, 0], moved[:, 1] - moved[:, 0]
        turn = step[:, :1] * change[:, 1] - step[:, 1:] * change[:, 0]
        return np.asarray(turn / np.square(step).sum(axis=1)[:, None], dtype=np.float64)


def heading_of_pair(
    pose: RoadPose, first_px: ArrayLike, second_px: ArrayLike, sigma_px: float = 1.0
) -> Heading | Said:
    """As `headings_of_pairs`, of one vehicle: contacts `first_px`, `second_px` (2,); or the reason why there
    is none.
    """
    return headings_of_pairs(pose, first_px, second_px, sigma_px)[0]


def _road_points(pose: RoadPose, clicks: Floats) -> Floats:
    """X and Y (N, 2) on the road under clicks (N, 2), NaN where `road_point` has a reason."""
    undistorted = undistort(pose.camera, clicks)
    direction = np.column_stack([undistorted.points, np.ones(len(clicks))]) @ pose.rotation
    centre = pose.centre_m
    with np.errstate(all="ignore"):
        below = direction[:, 2] < -MIN_DEPRESSION * np.linalg.norm(direction, axis=1)
        out = centre[:2] - direction[:, :2] * (centre[2] / direction[:, 2:])
    out[~(below & undistorted.ok & pose.camera.inside(clicks))] = np.nan
    return np.asarray(out, dtype=np.float64)


def _why_none(pose: RoadPose, pair: Floats, base_m: float, u_rad: float) -> Said | None:
    """Why a pair of contacts (2, 2) gives no heading, or None."""
    for word, click in zip(("first", "second"), pair, strict=True):
        point = road_point(pose, click) if np.isnan(base_m) else None
        if isinstance(point, Said):
            return Said("heading-of-contact", which=word, reason=point)
    if base_m < LEAST_BASE_M:
        return Said("heading-base-short", base_m=round(base_m, 2))
    if base_m > MOST_BASE_M:
        return Said("heading-base-long", base_m=round(base_m))
    if not np.isfinite(u_rad):
        return Said("heading-at-edge")
    return None


def summary_of_headings(pose: RoadPose, headings: Sequence[Heading]) -> Headings | Said:
    """Mean of the headings of N vehicles, all of `pose`; or the reason why there is none.

    Vehicles that stray from the others beyond four times their own u and the robust scatter (a click on
    another vehicle's tyre, a change of lane) are left out. CONVENTIONS.md, Direction of travel: the mean of
    Paule and Mandel 1982, what lens, pose and board turn all of them by whole in it; a turn is proposed where
    it differs from 0 by Student's t at 95 %, degrees of freedom by Welch and Satterthwaite (JCGM 100:2008,
    G.4.1).
    """
    values = np.array([one.heading_rad for one in headings], dtype=np.float64)
    u = np.array([one.u_heading_rad for one in headings], dtype=np.float64)
    used = ~outliers(values, u, least=_LEAST_SCALE_RAD) if len(values) else np.zeros(0, dtype=np.bool_)
    if used.sum() < LEAST_VEHICLES:
        return Said("traffic-few-vehicles", least=LEAST_VEHICLES, usable=int(used.sum()))
    shared = shared_covariance(pose, [one.parts for one, good in zip(headings, used, strict=True) if good])
    estimate = mean_and_spread(values[used], u[used], shared)
    away = abs(estimate.mean) / estimate.u_mean
    freedom = (estimate.count - 1) * (estimate.u_mean / estimate.u_own) ** 4
    proposed = bool(away > scipy.special.stdtrit(freedom, 0.975))
    return Headings(
        heading_rad=freeze_array(values),
        used=used,
        mean_rad=estimate.mean,
        u_mean_rad=estimate.u_mean,
        spread_rad=estimate.between,
        proposed=proposed,
    )


def turn_pose_to_heading(pose: RoadPose, heading_rad: float, u_heading_rad: float = 0.0) -> RoadPose:
    """The pose with the road's X axis turned about Z to a heading found in the traffic.

    The road's origin, its plane and the camera's height stay. Increments of a pose act in the camera frame,
    x_cam = Exp(r) (R x + t) + t', which the turn leaves alone, so the covariance stays and what the
    traffic's mean is uncertain by comes to it: a turn about Z through the origin, r = R e_z e and
    t' = -r x t. (The board's own heading error stays in as well, so the sum is on the safe side.)
    """
    c, s = float(np.cos(heading_rad)), float(np.sin(heading_rad))
    axes = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    rotation = pose.rotation @ axes
    covariance = pose.covariance
    if covariance is not None:
        up = rotation[:, 2]
        turn = u_heading_rad * np.concatenate([up, -np.cross(up, pose.translation_m)])
        covariance = np.array(covariance)
        covariance[-6:, -6:] += np.outer(turn, turn)
    told = Said("pose-road-turned", heading_deg=round(float(np.rad2deg(heading_rad)), 2))
    return replace(pose, rotation=rotation, covariance=covariance, warnings=(*pose.warnings, told))
