"""What the traffic itself says of a pose: the direction of travel from both tyre contacts of vehicles."""

from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.geometry.arrays import Bools, Floats, frozen
from sightline.geometry.camera import undistort
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
    apart its contacts are. `u_base_m`: that of the clicks on both tyres; None of a travel between frames.
    """

    heading_rad: float
    u_heading_rad: float
    base_m: float
    u_base_m: float | None = None


@dataclass(frozen=True, eq=False)
class Headings:
    """Headings of N vehicles (NaN where there is none), which were used, and their summary.

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

    CONVENTIONS.md, Direction of travel. u is that of the clicks alone, by central differences of the road
    points (JCGM 100:2008, 5.1.3).
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
    return [
        _why_none(pose, pair, float(b), float(w)) or Heading(float(a), float(w), float(b), float(ub))
        for pair, a, w, b, ub in zip(clicks, angle[:, 0], u, base, u_base, strict=True)
    ]


def heading_of_pair(
    pose: RoadPose, first_px: ArrayLike, second_px: ArrayLike, sigma_px: float = 1.0
) -> Heading | Said:
    """As `headings_of_pairs`, of one vehicle: contacts `first_px`, `second_px` (2,); or the reason why there
    is none.
    """
    return headings_of_pairs(pose, first_px, second_px, sigma_px)[0]


def _road_points(pose: RoadPose, clicks: Floats) -> Floats:
    """X and Y (N, 2) on the road under clicks (N, 2), NaN where `road_point` has a reason."""
    seen = undistort(pose.camera, clicks)
    direction = np.column_stack([seen.points, np.ones(len(clicks))]) @ pose.rotation
    centre = pose.centre_m
    with np.errstate(all="ignore"):
        below = direction[:, 2] < -MIN_DEPRESSION * np.linalg.norm(direction, axis=1)
        out = centre[:2] - direction[:, :2] * (centre[2] / direction[:, 2:])
    out[~(below & seen.ok & pose.camera.inside(clicks))] = np.nan
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


def summary_of_headings(heading_rad: ArrayLike, u_rad: ArrayLike) -> Headings | Said:
    """Mean of headings, `heading_rad` (N,), with their own uncertainties, `u_rad` (N,), NaN where there is
    none; or the reason why there is none.

    Vehicles that stray from the others beyond four times their own u and the robust scatter (a click on
    another vehicle's tyre, a change of lane) are left out. CONVENTIONS.md, Direction of travel: the mean of
    Paule and Mandel 1982; a turn is proposed where it differs from 0 by Student's t at 95 %.
    """
    values, u = np.asarray(heading_rad, dtype=np.float64), np.asarray(u_rad, dtype=np.float64)
    used = np.isfinite(values) & np.isfinite(u)
    if used.any():
        used[used] = ~outliers(values[used], u[used], least=_LEAST_SCALE_RAD)
    if used.sum() < LEAST_VEHICLES:
        return Said("traffic-few-vehicles", least=LEAST_VEHICLES, usable=int(used.sum()))
    found = mean_and_spread(values[used], u[used])
    away = abs(found.mean) / found.u_mean
    proposed = bool(away > scipy.stats.t.ppf(0.975, found.count - 1))
    return Headings(
        heading_rad=frozen(values),
        used=used,
        mean_rad=found.mean,
        u_mean_rad=found.u_mean,
        spread_rad=found.between,
        proposed=proposed,
    )


def turned(pose: RoadPose, heading_rad: float, u_heading_rad: float = 0.0) -> RoadPose:
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
