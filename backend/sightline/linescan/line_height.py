"""Lateral position and height from two rows of a line camera: the tyre's contact and a target.

The contact stands on the road, so its slope gives its distance, D = -Hc / s_contact. The target lies `inset`
behind it, so its height is h = Hc + s_target (D + inset). The same two clicks, inset and budget as in the
main mode; the pose is that of `line_pose`.
"""

from dataclasses import dataclass

import numpy as np

from sightline.coverage import COVERAGE_95
from sightline.enums import MeasurementStatus
from sightline.linescan.line_pose import LinePose
from sightline.messages.said import Said

STEP_M, MOST_LADDER_M = 0.5, 5.0


@dataclass(frozen=True)
class Contribution:
    """One source of the height's uncertainty, m."""

    source: str
    u_m: float


@dataclass(frozen=True)
class LineHeight:
    """Distance and height with standard uncertainties in m; or the reason why there are none."""

    status: MeasurementStatus
    reason: Said | None = None
    distance_m: float | None = None
    u_distance_m: float | None = None
    height_m: float | None = None
    u_height_m: float | None = None
    U95_height_m: float | None = None
    budget: tuple[Contribution, ...] = ()
    flags: tuple[Said, ...] = ()


def line_height(
    pose: LinePose,
    contact_row_px: float,
    target_row_px: float,
    *,
    sigma_px: float = 1.0,
    inset_m: float = 0.0,
    u_inset_m: float = 0.0,
) -> LineHeight:
    """Height of a target and distance of the tyre below it, in a strip of a line camera.

    Every input by first-order propagation (JCGM 100:2008, 5.1.2); entries: click target, click contact, pose
    (its covariance as one), inset.

    Parameters
    ----------
    pose : LinePose
    contact_row_px, target_row_px : float
        Rows of the tyre's contact with the road and of the target, px.
    sigma_px : float
        Standard uncertainty of a row, px.
    inset_m, u_inset_m : float
        How far the target lies behind the contact, and its standard uncertainty, metres.

    Returns
    -------
    LineHeight
        Metres. Never raises for what was clicked: rows that no road point has give a reason.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> height_m, distance_m = np.tile([0.0, 1.0, 2.0], 2), np.repeat([3.0, 5.0], 3)
    >>> row_px = 200 - 600 * (height_m - 1.4) / distance_m
    >>> pose = sightline.solve_line_pose(distance_m, height_m, row_px, sigma_px=0.5)
    >>> found = sightline.line_height(pose, contact_row_px=480.0, target_row_px=190.0)
    >>> round(found.height_m, 3), round(found.distance_m, 3)
    (1.45, 3.0)
    """
    if not np.all(np.isfinite([contact_row_px, target_row_px, sigma_px, inset_m, u_inset_m])):
        return _not_measurable(Said("line-height-click-no-number"))
    contact, target = (float(pose.slopes_of(row)) for row in (contact_row_px, target_row_px))
    if contact >= 0:
        return _not_measurable(Said("line-height-contact-above-horizon"))
    if target_row_px >= contact_row_px:
        return _not_measurable(Said("line-height-target-below-contact"))
    distance = -pose.camera_height_m / contact
    if distance + inset_m <= 0:
        return _not_measurable(Said("line-height-target-behind-camera"))
    height = pose.camera_height_m + target * (distance + inset_m)
    by_pose, by_contact, by_target = _gradients(pose, contact_row_px, target_row_px, inset_m)
    pose_distance, pose_height = (float(np.sqrt(max(g @ pose.covariance @ g, 0.0))) for g in by_pose)
    budget = (
        Contribution("click, target", abs(by_target) * sigma_px),
        Contribution("click, contact", abs(by_contact[1]) * sigma_px),
        Contribution("pose of the line camera", pose_height),
        Contribution("inset", abs(target) * u_inset_m),
    )
    u_height = float(np.sqrt(sum(one.u_m**2 for one in budget)))
    return LineHeight(
        status="ok",
        distance_m=distance,
        u_distance_m=float(np.hypot(abs(by_contact[0]) * sigma_px, pose_distance)),
        height_m=height,
        u_height_m=u_height,
        U95_height_m=COVERAGE_95 * u_height,
        budget=budget,
        flags=_flags(pose, contact_row_px, target_row_px),
    )


def contact_distance(pose: LinePose, contact_row_px: float) -> float | None:
    """Horizontal distance of the road point at a row, m; None at or above the horizon."""
    slope = float(pose.slopes_of(contact_row_px))
    return -pose.camera_height_m / slope if slope < 0 else None


def ladder(pose: LinePose, distance_m: float, rows: int) -> tuple[tuple[float, float], ...]:
    """(height m, row) every half metre above the road at a distance, as far as a strip of so many rows."""
    heights = np.arange(0.0, MOST_LADDER_M + STEP_M / 2, STEP_M)
    found = pose.rows_of(np.full_like(heights, distance_m), heights)
    pairs = zip(heights.tolist(), found.tolist(), strict=True)
    return tuple((height, row) for height, row in pairs if -0.5 <= row <= rows - 0.5)


def _gradients(
    pose: LinePose, contact_row: float, target_row: float, inset_m: float
) -> tuple[tuple[np.ndarray, np.ndarray], tuple[float, float], float]:
    """Of (distance, height) by (p0, p1, p2, Hc) and the contact row; of the height by the target row."""
    height_m = pose.camera_height_m
    s_c, s_t = (float(pose.slopes_of(row)) for row in (contact_row, target_row))
    contact, target = _slope_gradient(pose, contact_row), _slope_gradient(pose, target_row)
    distance = -height_m / s_c
    distance_by_slope = height_m / s_c**2
    of_distance = np.append(distance_by_slope * contact[:3], -1 / s_c)
    of_height = s_t * of_distance + np.append((distance + inset_m) * target[:3], 1.0)
    by_contact = distance_by_slope * contact[3]
    return (of_distance, of_height), (by_contact, s_t * by_contact), (distance + inset_m) * target[3]


def _slope_gradient(pose: LinePose, row: float) -> np.ndarray:
    """Derivatives of s = (row - p0) / (p1 - p2 row) by p0, p1, p2 and row: (4,)."""
    p0, p1, p2, _ = pose.parameters
    below = p1 - p2 * row
    slope = (row - p0) / below
    return np.array([-1 / below, -slope / below, slope * row / below, (1 + slope * p2) / below])


def _flags(pose: LinePose, *rows: float) -> tuple[Said, ...]:
    low, high = pose.row_span
    margin = 0.1 * (high - low)
    if all(low - margin <= row <= high + margin for row in rows):
        return ()
    return (Said("line-height-extrapolated"),)


def _not_measurable(reason: Said) -> LineHeight:
    return LineHeight("not_measurable", reason)
