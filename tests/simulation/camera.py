"""The demonstration's own camera: a forward projection that owes nothing to `geometry`.

Frames as everywhere: image (0, 0) is the centre of the top-left pixel, camera x right, y down, z forward,
road X along the near lane, Y away from the camera, Z up; `x_cam = R @ x_road + t`.
Angles in radians, lengths in metres.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Floats = NDArray[Any]
Image = NDArray[np.uint8]


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
        return _rotation(self)

    def _turned(self) -> Array:
        cy, sy = np.cos(self.yaw_rad), np.sin(self.yaw_rad)
        cp, sp = np.cos(self.pitch_rad), np.sin(self.pitch_rad)
        forward = np.array([sy * cp, cy * cp, -sp])
        right = np.array([cy, -sy, 0.0])
        down = np.cross(forward, right)
        cr, sr = np.cos(self.roll_rad), np.sin(self.roll_rad)
        return np.array([cr * right + sr * down, -sr * right + cr * down, forward])

    def translation_m(self) -> Array:
        """cam_from_road translation (3,)."""
        return np.asarray(-self.rotation() @ np.array(self.centre_m))

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

    def _slope(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """The distortion's derivatives d(xd)/dx, d(xd)/dy (= d(yd)/dx) and d(yd)/dy."""
        k1, k2, p1, p2, k3 = self.distortion
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        steep = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3))
        xx = radial + x * x * steep + 2 * p1 * y + 6 * p2 * x
        yy = radial + y * y * steep + 6 * p1 * y + 2 * p2 * x
        return xx, x * y * steep + 2 * p1 * x + 2 * p2 * y, yy

    def undistort(self, pixels: Array) -> Array:
        """Normalised undistorted coordinates (..., 2) of pixels (..., 2), by Newton's steps to 1e-12."""
        xd = (pixels[..., 0] - self.cx_px) / self.fx_px
        yd = (pixels[..., 1] - self.cy_px) / self.fy_px
        x, y = xd.copy(), yd.copy()
        for _ in range(30):
            ex, ey = self.distort(x, y)
            ex, ey = xd - ex, yd - ey
            if max(np.max(np.abs(ex)), np.max(np.abs(ey))) < 1e-12:
                break
            xx, xy, yy = self._slope(x, y)
            scale = 1 / (xx * yy - xy * xy)
            x, y = x + scale * (yy * ex - xy * ey), y + scale * (xx * ey - xy * ex)
        return np.stack([x, y], -1)

    def ray_slopes(self, pixels: Array) -> Array:
        """(dX/dY, dZ/dY) of the rays through pixels, (..., 2): X = Cx + (Y - Cy) a, Z = Cz + (Y - Cy) b."""
        normalised = self.undistort(pixels)
        cam = np.concatenate([normalised, np.ones((*normalised.shape[:-1], 1))], -1)
        road = cam @ self.rotation()
        return np.asarray(road[..., [0, 2]] / road[..., 1:2])


@lru_cache(maxsize=8)
def _rotation(camera: DemoCamera) -> Array:
    out: Array = camera._turned()
    out.flags.writeable = False
    return out


def pixel_grid(camera: DemoCamera, pad: int = 0) -> Array:
    """Every pixel's centre (H + 2 pad, W + 2 pad, 2), with a border of pixels beyond the picture."""
    u, v = np.arange(-pad, camera.width_px + pad), np.arange(-pad, camera.height_px + pad)
    return np.stack(np.meshgrid(u.astype(float), v.astype(float)), -1)


def finer(field: Array, supersample: int, pad: int = 2) -> Floats:
    """A smooth field (H + 2 pad, W + 2 pad, ...) at sub-pixels (H s, W s, ...); linear: within 4e-4 px."""
    h, w = field.shape[0] * supersample, field.shape[1] * supersample
    fine = cv2.resize(field.astype(np.float32), (w, h), interpolation=cv2.INTER_LINEAR)
    edge = pad * supersample
    return np.ascontiguousarray(fine[edge:-edge, edge:-edge], np.float32)


@lru_cache(maxsize=8)
def slope_maps(camera: DemoCamera, supersample: int = 1) -> tuple[Floats, Floats]:
    """`ray_slopes` for every pixel (or sub-pixel): two (H*s, W*s) maps; all rays must look along +Y."""
    if supersample == 1:
        slopes = camera.ray_slopes(pixel_grid(camera)).astype(np.float32)
    else:
        slopes = finer(camera.ray_slopes(pixel_grid(camera, 2)), supersample)
    a, b = np.ascontiguousarray(slopes[..., 0]), np.ascontiguousarray(slopes[..., 1])
    a.flags.writeable = b.flags.writeable = False
    return a, b
