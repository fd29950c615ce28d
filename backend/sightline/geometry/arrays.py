"""The small pieces of array and rotation algebra that the whole room uses."""

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats


def freeze_array(values: ArrayLike) -> Floats:
    """A float64 copy, of the same shape as `values`, any shape, that cannot be written to."""
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array


def points(values: ArrayLike, width: int) -> Floats:
    """`values`, any shape of rows of `width`, as an (N, width) array; a single point becomes (1, width)."""
    array = np.asarray(values, dtype=np.float64)
    return array.reshape(-1, width)


def skew(v: Floats) -> Floats:
    """The matrix with `skew(a) @ b == cross(a, b)`: (..., 3, 3) of `v` (..., 3)."""
    out = np.zeros((*v.shape[:-1], 3, 3))
    out[..., 0, 1], out[..., 0, 2] = -v[..., 2], v[..., 1]
    out[..., 1, 0], out[..., 1, 2] = v[..., 2], -v[..., 0]
    out[..., 2, 0], out[..., 2, 1] = -v[..., 1], v[..., 0]
    return out


def exp_rotation(r_rad: Floats) -> Floats:
    """Rotation matrix (3, 3) of the rotation vector `r_rad` (3,), radians.

    Rodrigues 1840: R = I + sin(a)/a K + (1 - cos a)/a^2 K^2 with a = |r|, K = skew(r).
    """
    angle = float(np.linalg.norm(r_rad))
    k = skew(np.asarray(r_rad, dtype=np.float64))
    if angle < 1e-8:  # the series, where sin(a)/a would lose digits
        return np.asarray(np.eye(3) + k + 0.5 * k @ k, dtype=np.float64)
    a = np.sin(angle) / angle
    b = (1.0 - np.cos(angle)) / angle**2
    return np.asarray(np.eye(3) + a * k + b * k @ k, dtype=np.float64)


def nearest_rotation(matrix: Floats) -> Floats:
    """The rotation (3, 3) nearest to `matrix` (3, 3) = U S V': U diag(1, 1, det UV') V' (Umeyama 1991)."""
    u, _, vt = np.linalg.svd(matrix)
    sign = np.sign(np.linalg.det(u @ vt))
    return np.asarray(u @ np.diag([1.0, 1.0, sign]) @ vt, dtype=np.float64)


def is_covariance(matrix: Floats) -> bool:
    """Whether `matrix` (n, n) is finite, symmetric and, up to rounding, nowhere of negative variance."""
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not np.isfinite(matrix).all():
        return False
    sigma = np.sqrt(np.abs(np.diag(matrix)))
    scale = np.outer(sigma, sigma) + 1e-300
    if np.abs(matrix - matrix.T).max(initial=0.0) > 0 and (np.abs(matrix - matrix.T) / scale).max() > 1e-6:
        return False
    sigma = np.where(sigma > 0, sigma, 1.0)
    correlation = matrix / np.outer(sigma, sigma)
    return bool(
        np.diag(matrix).min(initial=0.0) >= 0 and np.linalg.eigvalsh(correlation).min(initial=0.0) > -1e-6
    )
