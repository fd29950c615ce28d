"""The pose of a line camera in its scanning plane, from marks at known distances and heights.

Model. The camera's centre stands Hc above the road and sees, in its vertical scanning plane, a point at
horizontal distance D and height h under the slope s = (h - Hc) / D (upwards positive). With focal length f,
principal row c and pitch p (upwards positive) the point's row is c - f (s - tan p) / (1 + s tan p): a
projective map of the slope,

    row = (p0 + p1 s) / (1 + p2 s),   p0 = c + f tan p,  p1 = c tan p - f,  p2 = tan p.

p0, p1, p2 and Hc are solved for by least squares over the rows; f, c and p follow from them but are never
needed, and are poorly known one by one where the field is narrow. The lens is taken as free of distortion and
the road as level across. A rod with two or more marks, held upright at two or more distances, gives all four;
marks at one distance leave Hc open, for then only (h - Hc) / D is seen.

The distance of each stand of the rod has an uncertainty of its own, shared by its marks, and so has the rod's
lean along the line of sight, which shifts a mark at height h by h times the lean; both are carried into the
covariance to first order.
"""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.errors import BadInput

LEAST_MARKS = 4
# Beyond this, columns of the scaled Jacobian cannot be told apart: the marks do not fix the pose.
_WORST_CONDITION = 1e7


class LinePoseError(BadInput):
    """The marks do not give a pose; the message says what to do."""


@dataclass(frozen=True, eq=False)
class LinePose:
    """`parameters` (p0, p1, p2, Hc) with their `covariance` (4, 4); rows in px, Hc in m.

    `rms_px` of the residual rows; `rows` of the strip, as far as they were calibrated: `row_span`.
    """

    parameters: Floats
    covariance: Floats
    rms_px: float
    row_span: tuple[float, float]

    @property
    def camera_height_m(self) -> float:
        """Height of the camera's centre above the road."""
        return float(self.parameters[3])

    @property
    def focal_px(self) -> float:
        """Focal length; poorly known by itself where the field is narrow."""
        p0, p1, p2, _ = self.parameters
        return float((p0 * p2 - p1) / (1 + p2 * p2))

    def rows_of(self, distance_m: ArrayLike, height_m: ArrayLike) -> Floats:
        """(N,) rows of points at `distance_m` (N,), horizontal, and `height_m` (N,) above the road, m."""
        slopes = _slopes(np.asarray(distance_m, float), np.asarray(height_m, float), self.camera_height_m)
        return _project_rows(self.parameters, slopes)

    def slopes_of(self, row: ArrayLike) -> Floats:
        """(N,) slopes under which the rows `row` (N,) look out."""
        p0, p1, p2, _ = self.parameters
        rows = np.asarray(row, dtype=np.float64)
        return np.asarray((rows - p0) / (p1 - p2 * rows), dtype=np.float64)


def solve_line_pose(
    distance_m: ArrayLike,
    height_m: ArrayLike,
    row_px: ArrayLike,
    *,
    sigma_px: float | None = None,
    u_distance_m: float = 0.0,
    u_lean_rad: float = 0.0,
) -> LinePose:
    """The pose of a line camera from marks on a rod that is held up at two distances or more.

    CONVENTIONS.md, Line scan: row = (p0 + p1 s) / (1 + p2 s), s = (h - Hc) / D, by least squares over the
    rows. Covariance: sigma^2 (J'J)^-1 and what the stands' errors do through pinv(J) (JCGM 100:2008, 5.1.2).

    Parameters
    ----------
    distance_m, height_m, row_px : (N,) array
        Of N >= 4 marks: from the camera's centre, above the road (metres), and where they are seen (px).
    sigma_px : float, optional
        Standard uncertainty of a row; None: taken from the residuals, which needs more than 4 marks.
    u_distance_m, u_lean_rad : float
        Standard uncertainties of each stand's distance and of the rod's lean there.

    Returns
    -------
    LinePose
        With covariance (4, 4) and `camera_height_m`.

    Raises
    ------
    LinePoseError
        In one sentence, where the marks cannot fix the pose.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> height_m, distance_m = np.tile([0.0, 1.0, 2.0], 2), np.repeat([3.0, 5.0], 3)
    >>> row_px = 200 - 600 * (height_m - 1.4) / distance_m
    >>> round(sightline.solve_line_pose(distance_m, height_m, row_px, sigma_px=0.5).camera_height_m, 6)
    1.4
    """
    distance, height, row = (
        np.asarray(one, dtype=np.float64).ravel() for one in (distance_m, height_m, row_px)
    )
    _check(distance, height, row, sigma_px)
    start = _start(distance, height, row)
    scale = np.array([max(np.ptp(row), 1.0), abs(start[1]), 1.0, 1.0])

    def residuals(x: Floats) -> Floats:
        return _project_rows(x * scale, _slopes(distance, height, x[3] * scale[3])) - row

    solution = scipy.optimize.least_squares(
        residuals, start / scale, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    jacobian = solution.jac
    norms = np.linalg.norm(jacobian, axis=0)
    if (
        not np.all(np.isfinite(norms))
        or norms.min() == 0
        or np.linalg.cond(jacobian / norms) > _WORST_CONDITION
    ):
        raise LinePoseError("line-pose-open")
    parameters = solution.x * scale
    if parameters[3] <= 0:
        raise LinePoseError("line-pose-below-road")
    freedom = len(row) - 4
    squares = float(solution.fun @ solution.fun)
    variance = sigma_px**2 if sigma_px is not None else squares / freedom
    shifts = (
        scale[:, None]
        * np.linalg.pinv(jacobian)
        @ _stand_shifts(parameters, distance, height, u_distance_m, u_lean_rad)
    )
    covariance = variance * np.linalg.inv(jacobian.T @ jacobian) * np.outer(scale, scale) + shifts @ shifts.T
    rms = float(np.sqrt(squares / len(row)))
    return LinePose(parameters, covariance, rms, (float(row.min()), float(row.max())))


def _stand_shifts(
    parameters: Floats, distance: Floats, height: Floats, u_distance_m: float, u_lean_rad: float
) -> Floats:
    """(N, 2 stands) changes of rows with one standard uncertainty of each stand's distance and lean."""
    before = _project_rows(parameters, _slopes(distance, height, parameters[3]))
    columns = []
    for stand in np.unique(distance):
        for moved_m in (np.full_like(height, u_distance_m), u_lean_rad * height):
            there = distance + np.where(distance == stand, moved_m, 0.0)
            columns.append(_project_rows(parameters, _slopes(there, height, parameters[3])) - before)
    return np.column_stack(columns)


def _check(distance: Floats, height: Floats, row: Floats, sigma_px: float | None) -> None:
    if not len(distance) == len(height) == len(row):
        raise LinePoseError("line-pose-mark-incomplete")
    if not all(np.all(np.isfinite(one)) for one in (distance, height, row)):
        raise LinePoseError("line-pose-not-numbers")
    least = LEAST_MARKS if sigma_px is not None else LEAST_MARKS + 1
    if len(row) < least:
        raise LinePoseError("line-pose-too-few", count=len(row), least=least)
    if np.any(distance <= 0) or (sigma_px is not None and sigma_px <= 0):
        raise LinePoseError("line-pose-above-zero")
    if np.ptp(distance) < 1e-3 * distance.mean():
        raise LinePoseError("line-pose-one-distance")


def _start(distance: Floats, height: Floats, row: Floats) -> Floats:
    """p2 = 0 makes row * D = p0 D + p1 h - p1 Hc linear in (p0, p1, p1 Hc)."""
    design = np.column_stack([distance, height, -np.ones_like(distance)])
    (p0, p1, product), *_ = np.linalg.lstsq(design, row * distance, rcond=None)
    if p1 >= 0:
        raise LinePoseError("line-pose-upside-down")
    return np.array([p0, p1, 0.0, product / p1])


def _slopes(distance: Floats, height: Floats, camera_height_m: float) -> Floats:
    return np.asarray((height - camera_height_m) / distance, dtype=np.float64)


def _project_rows(parameters: Floats, slopes: Floats) -> Floats:
    p0, p1, p2, _ = parameters
    return np.asarray((p0 + p1 * slopes) / (1 + p2 * slopes), dtype=np.float64)
