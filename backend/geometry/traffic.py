"""What the traffic itself says of a pose and of insets: headings from tyre contacts, insets from known
heights.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from backend.geometry.arrays import Bools, Floats, frozen
from backend.geometry.road import road_point
from backend.geometry.road_pose import RoadPose

_LEAST_BASE_M = 1.0
_LEAST_VEHICLES = 3


@dataclass(frozen=True, eq=False)
class Headings:
    """Direction of travel against the road's X axis per vehicle (NaN where unusable), and their summary.

    `proposed`: whether the mean differs from 0 by more than twice its uncertainty; turning the road by
    `mean_rad` about Z then corrects the pose.
    """

    heading_rad: Floats
    used: Bools
    mean_rad: float
    u_mean_rad: float
    spread_rad: float
    proposed: bool


def headings(pose: RoadPose, first_px: ArrayLike, second_px: ArrayLike) -> Headings | str:
    """Self-check of a pose: both tyre contacts (N, 2) of N vehicles give their directions of travel.

    Or the reason why there is none. Vehicles whose contacts lie less than a metre apart are not used.
    """
    a = np.asarray(first_px, dtype=np.float64).reshape(-1, 2)
    b = np.asarray(second_px, dtype=np.float64).reshape(-1, 2)
    out = np.full(len(a), np.nan)
    for i, (one, two) in enumerate(zip(a, b, strict=True)):
        p, q = road_point(pose, one), road_point(pose, two)
        if isinstance(p, str) or isinstance(q, str) or np.linalg.norm(q - p) < _LEAST_BASE_M:
            continue
        step = (q - p) * (1.0 if q[0] >= p[0] else -1.0)
        out[i] = np.arctan2(step[1], step[0])
    used = np.isfinite(out)
    if used.sum() < _LEAST_VEHICLES:
        return (
            f"Both tyre contacts of at least {_LEAST_VEHICLES} vehicles are needed; {used.sum()} can be used."
        )
    values = out[used]
    mean, spread = float(values.mean()), float(values.std(ddof=1))
    u_mean = spread / float(np.sqrt(len(values)))
    return Headings(frozen(out), used, mean, u_mean, spread, abs(mean) > 2.0 * u_mean)


def turned(pose: RoadPose, heading_rad: float) -> RoadPose:
    """The pose with the road's X axis turned about Z to a heading found in the traffic; heights hardly
    change.
    """
    c, s = float(np.cos(heading_rad)), float(np.sin(heading_rad))
    axes = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    covariance = (
        pose.covariance
    )  # increments act in the camera frame, which the turn of the road leaves alone
    return RoadPose(
        pose.camera,
        pose.rotation @ axes,
        pose.translation_m,
        covariance,
        pose.board,
        pose.frames_used,
        pose.rms_px,
        (
            *pose.warnings,
            f"Turned by {np.rad2deg(heading_rad):+.2f} degrees to the direction of the traffic.",
        ),
    )


@dataclass(frozen=True)
class InsetEstimate:
    """An inset found from a survey's own vehicles, with its standard uncertainty and the number used."""

    inset_m: float
    u_inset_m: float
    vehicles: int


def inset_from_known_heights(
    camera_height_m: float, distances_m: ArrayLike, measured_m: ArrayLike, known_m: ArrayLike
) -> InsetEstimate | str:
    """Inset of a target whose true heights are known (roofs), from uncorrected heights at distances D.

    An uncorrected height is m = Hc + (h - Hc) D / (D + inset), so h - m = (m - Hc) inset / D: a straight line
    through the origin in (m - Hc)/D, whose slope is the inset. (Errors of m in the abscissa pull it down by
    their share of the variance, a few per cent where heights differ from Hc by more than 0.2 m.) The
    uncertainty is that of the residuals' scatter. A reason where vehicles or their variety do not suffice.
    """
    d, m, h = (np.asarray(v, dtype=np.float64).ravel() for v in (distances_m, measured_m, known_m))
    fine = np.isfinite(d) & np.isfinite(m) & np.isfinite(h) & (d > 0)
    slope = ((m - camera_height_m) / d)[fine]
    gap = (h - m)[fine]
    if len(slope) < _LEAST_VEHICLES:
        return f"At least {_LEAST_VEHICLES} vehicles of known height are needed; {len(slope)} can be used."
    power = float(slope @ slope)
    if power < 1e-6:
        return "The heights are those of the camera, which say nothing about the inset."
    inset = float(slope @ gap) / power
    residual = gap - inset * slope
    u = float(np.sqrt(residual @ residual / (len(slope) - 1) / power))
    return InsetEstimate(inset, u, len(slope))
