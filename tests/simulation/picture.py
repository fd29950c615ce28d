"""Finding edges in rendered pictures, and heights from pixels by an inverse of the tests' own."""

import numpy as np

from tests.simulation.camera import DemoCamera
from tests.simulation.truth import FramePixels, PassTruth


def frame_of(one: PassTruth, number: int) -> FramePixels:
    return next(f for f in one.frames if f.frame == number)


def edge_along_column(field: np.ndarray, x: float, y: float, reach: int) -> float:
    """Where a column (mean of three) crosses half way between its two ends, nearest to y; sub-pixel rows."""
    left = int(np.floor(x)) - 1
    share = x - np.floor(x)
    rows = np.arange(round(y) - reach, round(y) + reach + 1)
    weight = np.array([(1 - share), 1.0, 1.0, share]) / 3
    column = field[rows, left : left + 4] @ weight
    signed = column - (column[:2].mean() + column[-2:].mean()) / 2
    at = np.flatnonzero(np.sign(signed[:-1]) != np.sign(signed[1:]))
    crossings = rows[at] + signed[at] / (signed[at] - signed[at + 1])
    return float(crossings[np.argmin(np.abs(crossings - y))])


def _ray(camera: DemoCamera, pixel: tuple[float, float]) -> np.ndarray:
    """Unit-depth ray in the road frame: plain fixed-point undistortion, unlike the renderer's Newton."""
    k1, k2, p1, p2, k3 = camera.distortion
    xd, yd = (pixel[0] - camera.cx_px) / camera.fx_px, (pixel[1] - camera.cy_px) / camera.fy_px
    x, y = xd, yd
    for _ in range(500):
        r2 = x * x + y * y
        radial = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
        x = (xd - 2 * p1 * x * y - p2 * (r2 + 2 * x * x)) / radial
        y = (yd - p1 * (r2 + 2 * y * y) - 2 * p2 * x * y) / radial
    return np.asarray(camera.rotation().T @ np.array([x, y, 1.0]))


def height_m(
    camera: DemoCamera, contact: tuple[float, float], target: tuple[float, float], inset_m: float
) -> float:
    """Height of a target from two pixels and its inset: ground plane, then the shifted side plane."""
    centre = np.array(camera.centre_m)
    down = _ray(camera, contact)
    foot = centre + down * (-centre[2] / down[2])
    up = _ray(camera, target)
    return float(centre[2] + up[2] * (foot[1] + inset_m - centre[1]) / up[1])
