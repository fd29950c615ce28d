"""The demonstration's own camera: an independent forward projection, so that its truth owes nothing to `geometry`.

Frames as everywhere: image (0, 0) is the centre of the top-left pixel, camera x right, y down, z forward,
road X along the near lane, Y away from the camera, Z up; `x_cam = R @ x_road + t`. Angles in radians, lengths in metres.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Floats = NDArray[np.float32]


@dataclass(frozen=True)
class DemoCamera:
    """True intrinsics (pinhole with Brown distortion) and true road pose of one set-up."""

    width_px: int = 640
    height_px: int = 480
    fx_px: float = 483.5
    fy_px: float = 484.1
    cx_px: float = 318.6
    cy_px: float = 242.2
    distortion: tuple[float, float, float, float, float] = (-0.32, 0.12, 5e-4, -3e-4, -0.02)
    centre_m: tuple[float, float, float] = (-0.62, -3.06, 1.36)
    yaw_rad: float = 0.37
    pitch_rad: float = 0.035
    roll_rad: float = 0.012

    def rotation(self) -> Array:
        """cam_from_road rotation (3, 3): yaw to the right, pitch down, roll about the optical axis."""
        cy, sy = np.cos(self.yaw_rad), np.sin(self.yaw_rad)
        cp, sp = np.cos(self.pitch_rad), np.sin(self.pitch_rad)
        forward = np.array([sy * cp, cy * cp, -sp])
        right = np.array([cy, -sy, 0.0])
        down = np.cross(forward, right)
        cr, sr = np.cos(self.roll_rad), np.sin(self.roll_rad)
        return np.array([cr * right + sr * down, -sr * right + cr * down, forward])

    def translation_m(self) -> Array:
        """cam_from_road translation (3,)."""
        return -self.rotation() @ np.array(self.centre_m)

    def distort(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Brown's model (OpenCV's order k1 k2 p1 p2 k3) on normalised coordinates of any shape."""
        k1, k2, p1, p2, k3 = self.distortion
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
        yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
        return xd, yd

    def project_cam(self, points_m: Array) -> Array:
        """Pixels (..., 2) of points in the camera frame (..., 3); z is kept positive by a small floor."""
        z = np.maximum(points_m[..., 2], 1e-3)
        # a point far outside the picture must stay outside: the polynomial turns back at large radii
        x, y = points_m[..., 0] / z, points_m[..., 1] / z
        shrink = np.minimum(1.0, 1.25 / np.maximum(np.hypot(x, y), 1e-9))
        xd, yd = self.distort(x * shrink, y * shrink)
        out = np.where(shrink < 1, 1.3, 1.0)
        return np.stack([self.fx_px * xd * out + self.cx_px, self.fy_px * yd * out + self.cy_px], -1)

    def project(self, points_m: Array) -> Array:
        """Distorted pixels (..., 2) of road points (..., 3)."""
        return self.project_cam(points_m @ self.rotation().T + self.translation_m())

    def undistort(self, pixels: Array) -> Array:
        """Normalised undistorted coordinates (..., 2) of pixels (..., 2), by fixed-point steps to 1e-12."""
        xd = (pixels[..., 0] - self.cx_px) / self.fx_px
        yd = (pixels[..., 1] - self.cy_px) / self.fy_px
        x, y = xd.copy(), yd.copy()
        for _ in range(200):
            ex, ey = self.distort(x, y)
            x, y = x + (xd - ex), y + (yd - ey)
            if np.max(np.abs(xd - ex)) < 1e-12 and np.max(np.abs(yd - ey)) < 1e-12:
                break
        return np.stack([x, y], -1)

    def ray_slopes(self, pixels: Array) -> Array:
        """(dX/dY, dZ/dY) of the rays through pixels, (..., 2): X = Cx + (Y - Cy) a, Z = Cz + (Y - Cy) b."""
        normalised = self.undistort(pixels)
        cam = np.concatenate([normalised, np.ones((*normalised.shape[:-1], 1))], -1)
        road = cam @ self.rotation()
        return road[..., [0, 2]] / road[..., 1:2]


@lru_cache(maxsize=8)
def slope_maps(camera: DemoCamera, supersample: int = 1) -> tuple[Floats, Floats]:
    """`ray_slopes` for every pixel (or sub-pixel): two (H*s, W*s) maps; all rays must look along +Y."""
    s = supersample
    u = (np.arange(camera.width_px * s) + 0.5) / s - 0.5
    v = (np.arange(camera.height_px * s) + 0.5) / s - 0.5
    slopes = camera.ray_slopes(np.stack(np.meshgrid(u, v), -1))
    a, b = slopes[..., 0].astype(np.float32), slopes[..., 1].astype(np.float32)
    a.flags.writeable = b.flags.writeable = False
    return a, b
