"""The camera: pixels to directions and back, exactly and with refusal where the lens model has no inverse."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Bools, Floats
from sightline.enums import LensModel
from sightline.errors import BadInput
from sightline.geometry import lens
from sightline.geometry.arrays import freeze_array, points
from sightline.geometry.lens_limit import LensLimit, lens_limit
from sightline.messages.said import Said

_SETTLED = 1e-7  # a last Newton step this short leaves an error of its square: 2e-11 px at f = 2000 px
_MOST_STEPS = 30


@dataclass(frozen=True)
class View:
    """One picture of a calibration. `rms_px` is None and `reason` says why where it was left out."""

    file: str
    rms_px: float | None
    used: bool
    reason: Said | None = None


@dataclass(frozen=True, eq=False)
class Undistorted:
    """`points` (N, 2) on the normalised plane (x/z, y/z); `ok` (N,) is False where there is no direction."""

    points: Floats
    ok: Bools


@dataclass(frozen=True, eq=False)
class Camera:
    """Intrinsics of one body and lens. Pixel (0, 0) is the centre of the top-left pixel.

    `covariance` is of `parameters`, in that order (fx_px fy_px cx_px cy_px, then the distortion), or None.
    """

    name: str
    width_px: int
    height_px: int
    model: LensModel
    fx_px: float
    fy_px: float
    cx_px: float
    cy_px: float
    distortion: Floats
    rms_px: float | None = None
    covariance: Floats | None = None
    views: tuple[View, ...] = field(default=())

    def __post_init__(self) -> None:
        object.__setattr__(self, "distortion", freeze_array(self.distortion))
        if self.covariance is not None:
            object.__setattr__(self, "covariance", freeze_array(self.covariance))

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        return ("fx_px", "fy_px", "cx_px", "cy_px", *lens.names(self.model, len(self.distortion)))

    @cached_property
    def limit(self) -> LensLimit:
        x = (np.array([-0.5, self.width_px - 0.5]) - self.cx_px) / self.fx_px
        y = (np.array([-0.5, self.height_px - 0.5]) - self.cy_px) / self.fy_px
        return lens_limit(self.model, self.distortion, float(np.hypot(np.abs(x).max(), np.abs(y).max())))

    @cached_property
    def matrix(self) -> Floats:
        """K (3, 3), pixels: Dupuis et al. 2019, eq. (2), a focal length per axis for r f and f, and s = 0."""
        return freeze_array([[self.fx_px, 0.0, self.cx_px], [0.0, self.fy_px, self.cy_px], [0.0, 0.0, 1.0]])

    def inside(self, points_px: ArrayLike) -> Bools:
        """Which (N,) of `points_px` (N, 2) lie in the picture (outer pixels reach half a pixel out)."""
        p = points(points_px, 2)
        x, y = p[:, 0], p[:, 1]
        inside = (x >= -0.5) & (y >= -0.5) & (x <= self.width_px - 0.5) & (y <= self.height_px - 0.5)
        return np.asarray(inside, dtype=np.bool_)


def require_size(camera: Camera, width_px: int, height_px: int, what: str) -> None:
    """Raise BadInput when a picture of another size meets this camera."""
    if (width_px, height_px) != (camera.width_px, camera.height_px):
        raise BadInput(
            "geometry-size-not-calibrated",
            what=what,
            width_px=width_px,
            height_px=height_px,
            width_px_2=camera.width_px,
            height_px_2=camera.height_px,
        )


def normalised_to_pixels(camera: Camera, normalised: ArrayLike) -> Floats:
    """Pixels (N, 2) of undistorted `normalised` points (N, 2).

    Dupuis et al. 2019, eq. (3), corrected: p = K d(m), m the point divided by its depth (CONVENTIONS.md,
    Lens).
    """
    m = points(normalised, 2)
    d = lens.distort(camera.model, camera.distortion, m[:, 0], m[:, 1])
    return np.stack([camera.fx_px * d.x + camera.cx_px, camera.fy_px * d.y + camera.cy_px], axis=1)


def project(camera: Camera, points_cam: ArrayLike) -> Floats:
    """Pixels of points in the camera frame.

    Dupuis et al. 2019, eq. (3), corrected: the distortion acts on the point *after* its division by depth,
    not on the projected homogeneous vector.

    Parameters
    ----------
    camera : Camera
    points_cam : (N, 3) array
        Metres: x right, y down, z forward.

    Returns
    -------
    (N, 2) array
        Px. Points with z <= 0, or further off the axis than the lens model is one-to-one, come back as NaN: a
        polynomial would fold them into the picture.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> sightline.project(camera, [[0.0, 0.0, 5.0]]).tolist()
    [[959.5, 539.5]]
    """
    p = points(points_cam, 3)
    with np.errstate(divide="ignore", invalid="ignore"):
        m = p[:, :2] / p[:, 2:]
        seen = (p[:, 2] > 0) & (np.hypot(m[:, 0], m[:, 1]) <= camera.limit.radius)
    pixels = normalised_to_pixels(camera, np.where(seen[:, None], m, 0.0))
    pixels[~seen] = np.nan
    return pixels


def project_with_jacobians(camera: Camera, points_cam: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Pixels (N, 2), their derivative by the camera point (N, 2, 3) and by `camera.parameters` (N, 2, n);
    `points_cam` (N, 3), metres, all of them before the camera.

    The function of `project` (Dupuis et al. 2019, eq. (3), corrected) without its refusals, by the chain rule
    through m = (x/z, y/z): dp/dX = K d'(m) dm/dX, so that dp/dz = -(dp/dx m_x + dp/dy m_y).
    """
    p = points(points_cam, 3)
    x, y, z = p[:, 0] / p[:, 2], p[:, 1] / p[:, 2], p[:, 2]
    d = lens.distort(camera.model, camera.distortion, x, y)
    by_x, by_y = lens.by_coefficients(camera.model, camera.distortion, x, y)
    fx, fy = camera.fx_px, camera.fy_px
    pixels = np.stack([fx * d.x + camera.cx_px, fy * d.y + camera.cy_px], axis=1)
    by_point = np.empty((len(p), 2, 3))
    by_point[:, 0, 0], by_point[:, 0, 1] = fx * d.dx_dx / z, fx * d.dx_dy / z
    by_point[:, 1, 0], by_point[:, 1, 1] = fy * d.dx_dy / z, fy * d.dy_dy / z
    by_point[:, :, 2] = -(by_point[:, :, 0] * x[:, None] + by_point[:, :, 1] * y[:, None])
    by_lens = np.zeros((len(p), 2, 4 + len(camera.distortion)))
    by_lens[:, 0, 0], by_lens[:, 1, 1] = d.x, d.y
    by_lens[:, 0, 2] = by_lens[:, 1, 3] = 1.0
    by_lens[:, 0, 4:], by_lens[:, 1, 4:] = fx * by_x.T, fy * by_y.T
    return pixels, by_point, by_lens


def undistort_xy(camera: Camera, u_px: Floats, v_px: Floats) -> tuple[Floats, Floats, Bools]:
    """As `undistort`, on two arrays `u_px`, `v_px` (N,): m_x, m_y and whether they hold, (N,) each."""
    xd, yd = (u_px - camera.cx_px) / camera.fx_px, (v_px - camera.cy_px) / camera.fy_px
    if not camera.distortion.any() and camera.model == "brown":
        return xd, yd, np.isfinite(xd) & np.isfinite(yd)
    limit = camera.limit
    index = np.sqrt(xd * xd + yd * yd) * (1.0 / limit.table_step)
    index = np.fmin(index, len(limit.table_gain) - 1.001)  # NaN as well
    low = index.astype(np.intp)
    gain = limit.table_gain[low]
    gain += (index - low) * (limit.table_gain[low + 1] - gain)
    x, y = xd * gain, yd * gain
    if camera.model == "brown":  # a first answer to the tangential terms saves a round
        p1, p2 = float(camera.distortion[2]), float(camera.distortion[3])
        lean = 2.0 * (p1 * y + p2 * x)
        r2 = x * x + y * y
        x, y = x - (x * lean + p2 * r2) * gain, y - (y * lean + p1 * r2) * gain
    step = _newton(camera, xd, yd, x, y, 2)
    late = np.flatnonzero(~(step <= _SETTLED))
    if late.size:
        xl, yl = x[late], y[late]
        step[late] = _newton(camera, xd[late], yd[late], xl, yl, _MOST_STEPS)
        x[late], y[late] = xl, yl
    ok = (step <= _SETTLED) & (x * x + y * y <= limit.radius**2)
    return x, y, np.asarray(ok, dtype=np.bool_)


def _newton(camera: Camera, xd: Floats, yd: Floats, x: Floats, y: Floats, steps: int) -> Floats:
    """Improve x, y in place; returns the length of each point's last step, which Newton's method squares."""
    far = 2.0 * camera.limit.radius
    last = np.full_like(x, np.inf)
    with np.errstate(all="ignore"):
        for _ in range(steps):
            d = lens.distort(camera.model, camera.distortion, x, y)
            ex, ey = d.x - xd, d.y - yd
            scale = 1.0 / d.determinant
            dx = (d.dy_dy * ex - d.dx_dy * ey) * scale
            dy = (d.dx_dx * ey - d.dx_dy * ex) * scale
            x -= dx
            y -= dy
            last = np.maximum(np.abs(dx), np.abs(dy))
            if steps > 2:
                np.clip(x, -far, far, out=x)
                np.clip(y, -far, far, out=y)
                if not (last > _SETTLED).any():
                    break
    return last


def undistort(camera: Camera, points_px: ArrayLike) -> Undistorted:
    """Directions of pixels, by Newton's method with the lens model's own derivative.

    Dupuis et al. 2019, eq. (4), corrected: p' = d^-1(K^-1 p) with p the pixel; printed with the pixel and the
    point swapped. (OpenCV's default of five fixed-point rounds is off by up to 0.4 px; this is off by 1e-10
    px.)

    Parameters
    ----------
    camera : Camera
    points_px : (N, 2) array
        Px; (0, 0) is the centre of the top left pixel.

    Returns
    -------
    Undistorted
        `points` (N, 2): x / z and y / z of the camera frame; `ok` (N,): False outside the largest radius in
        which the lens model is one-to-one, and for NaN.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> sightline.undistort(camera, [[959.5, 539.5]]).points.tolist()
    [[0.0, 0.0]]
    """
    p = points(points_px, 2)
    x, y, ok = undistort_xy(camera, np.ascontiguousarray(p[:, 0]), np.ascontiguousarray(p[:, 1]))
    return Undistorted(np.stack([x, y], axis=1), ok)
