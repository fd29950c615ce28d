"""Lens distortion on the normalised image plane, with its derivatives.

Two models, both in OpenCV's definition, acting *after* the division by depth (Dupuis et al. 2019, eq. (3),
corrected: as printed the distortion acts on the homogeneous vector before the division):

brown    D. C. Brown 1966: k1 k2 p1 p2 [k3 [k4 k5 k6]], radial polynomial or quotient plus tangential terms
fisheye  Kannala and Brandt 2006: theta_d = theta (1 + k1 theta^2 + ... + k4 theta^8)
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.enums import LensModel

BROWN_NAMES = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
FISHEYE_NAMES = ("k1", "k2", "k3", "k4")


@dataclass(frozen=True, eq=False)
class Distorted:
    """Distorted coordinates and the 2x2 derivative by the undistorted ones (it is symmetric: xy == yx)."""

    x: Floats
    y: Floats
    dx_dx: Floats
    dx_dy: Floats
    dy_dy: Floats

    @property
    def determinant(self) -> Floats:
        """det d' of each point, same shape as `x`: positive where the lens model keeps the picture's hand."""
        return self.dx_dx * self.dy_dy - self.dx_dy * self.dx_dy


def names(model: LensModel, count: int) -> tuple[str, ...]:
    """Names of the first `count` distortion coefficients."""
    return (BROWN_NAMES if model == "brown" else FISHEYE_NAMES)[:count]


def _brown_coefficients(k: Floats) -> list[float]:
    return [float(v) for v in k] + [0.0] * (8 - len(k))


def _brown_gain(k: Floats, r2: Floats) -> tuple[Floats, Floats]:
    """Radial gain g(r^2) and dg/d(r^2)."""
    k1, k2, _, _, k3, k4, k5, k6 = _brown_coefficients(k)
    top = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3))
    slope = k1 + r2 * (2.0 * k2 + r2 * (3.0 * k3))
    if k4 == k5 == k6 == 0.0:
        return top, slope
    bottom = 1.0 + r2 * (k4 + r2 * (k5 + r2 * k6))
    gain = top / bottom
    return gain, (slope - gain * (k4 + r2 * (2.0 * k5 + r2 * (3.0 * k6)))) / bottom


def _fisheye_gain(k: Floats, r2: Floats) -> tuple[Floats, Floats]:
    """theta_d / r and its derivative by r^2; the series near the axis, where the quotient loses digits."""
    k1, k2, k3, k4 = (float(v) for v in k)
    near = r2 < 1e-8
    q = np.where(near, 1.0, r2)
    r = np.sqrt(q)
    theta = np.arctan(r)
    t2 = theta * theta
    theta_d = theta * (1.0 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4))))
    slope = 1.0 + t2 * (3.0 * k1 + t2 * (5.0 * k2 + t2 * (7.0 * k3 + t2 * (9.0 * k4))))
    gain = theta_d / r
    d_gain = (slope / (1.0 + q) - gain) / (2.0 * q)
    return np.where(near, 1.0 + (k1 - 1.0 / 3.0) * r2, gain), np.where(near, k1 - 1.0 / 3.0, d_gain)


def radial_gain(model: LensModel, k: Floats, r2: Floats) -> tuple[Floats, Floats]:
    """Gain g and dg/d(r^2) of the radial part, both of the same shape as `r2`, any shape: a point at radius r
    goes to radius r g(r^2). `k` (n,): the model's coefficients in OpenCV's order.

    Brown 1966, and Kannala and Brandt 2006, as the module writes them.
    """
    return _brown_gain(k, r2) if model == "brown" else _fisheye_gain(k, r2)


def distort(model: LensModel, k: Floats, x: Floats, y: Floats) -> Distorted:
    """Distort normalised points; `x`, `y` of any one shape, `k` (n,).

    Brown 1966, with the tangential terms 2 p1 x y + p2 (r^2 + 2 x^2) and p1 (r^2 + 2 y^2) + 2 p2 x y, or
    Kannala and Brandt 2006, which has no such terms.
    """
    xx, yy, xy = x * x, y * y, x * y
    r2 = xx + yy
    gain, slope = radial_gain(model, k, r2)
    slope2 = 2.0 * slope
    p1, p2 = (float(k[2]), float(k[3])) if model == "brown" else (0.0, 0.0)
    if p1 == 0.0 and p2 == 0.0:
        return Distorted(x * gain, y * gain, gain + slope2 * xx, slope2 * xy, gain + slope2 * yy)
    return Distorted(
        x * gain + 2.0 * p1 * xy + p2 * (r2 + 2.0 * xx),
        y * gain + p1 * (r2 + 2.0 * yy) + 2.0 * p2 * xy,
        gain + slope2 * xx + 2.0 * p1 * y + 6.0 * p2 * x,
        slope2 * xy + 2.0 * p1 * x + 2.0 * p2 * y,
        gain + slope2 * yy + 6.0 * p1 * y + 2.0 * p2 * x,
    )


def by_coefficients(model: LensModel, k: Floats, x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Derivatives of the distorted x and y by each coefficient: two arrays (n, N) at `x`, `y` (N,) for `k`
    (n,).

    As `distort`, whose terms are linear in the coefficients but for k4 k5 k6: d/dk4 (1 + ...)/(1 + k4 r^2 +
    ...) is -g r^2 / (1 + k4 r^2 + ...).
    """
    r2 = x * x + y * y
    if model == "fisheye":
        r = np.sqrt(np.maximum(r2, 1e-300))
        theta = np.arctan(r)
        powers = np.stack([theta ** (2 * i + 1) / r for i in range(1, 5)])
        return powers * x, powers * y
    radial = [r2, r2 * r2, r2 * r2 * r2]
    if len(k) > 5:
        k4, k5, k6 = _brown_coefficients(k)[5:]
        bottom = 1.0 + r2 * (k4 + r2 * (k5 + r2 * k6))
        radial = [power / bottom for power in radial]
        gain = _brown_gain(k, r2)[0]
        radial += [-gain * power for power in radial]
    xy2 = 2.0 * x * y
    by_x = [radial[0] * x, radial[1] * x, xy2, r2 + 2.0 * x * x, *(v * x for v in radial[2:])]
    by_y = [radial[0] * y, radial[1] * y, r2 + 2.0 * y * y, xy2, *(v * y for v in radial[2:])]
    return np.stack(by_x[: len(k)]), np.stack(by_y[: len(k)])
