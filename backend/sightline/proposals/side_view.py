"""A frame laid out on a vertical plane along the road, metres along and up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.geometry.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.road_pose import RoadPose

Bgr = NDArray[np.uint8]
Plane = NDArray[np.float32]
_CELL = 0.7  # size of a cell over that of a pixel
_LEAST_CELL_M = 0.008


@dataclass(frozen=True, eq=False)
class SideView:
    """Pictures (h, w) on the plane Y = `y_m`: luminance, redness (R less the larger of G and B), the change
    against the empty road over its tolerance, and which cells lie in the frame. Row i is at Z = `bottom_m` +
    i `cell_m`, column j at X = `left_m` + j `cell_m`.
    """

    light: Plane
    red: Plane
    change: Plane
    seen: NDArray[np.bool_]
    left_m: float
    bottom_m: float
    cell_m: float
    y_m: float

    def column(self, x_m: float) -> int:
        """The column nearest to X, inside the view."""
        return int(np.clip(round((x_m - self.left_m) / self.cell_m), 0, self.light.shape[1] - 1))

    def row(self, z_m: float) -> int:
        """The row nearest to Z, inside the view."""
        return int(np.clip(round((z_m - self.bottom_m) / self.cell_m), 0, self.light.shape[0] - 1))

    def x_m(self, column: float) -> float:
        return self.left_m + column * self.cell_m

    def z_m(self, row: float) -> float:
        return self.bottom_m + row * self.cell_m


def side_view(
    picture: Bgr,
    change: Plane,
    pose: RoadPose,
    y_m: float,
    x_m: tuple[float, float],
    z_m: tuple[float, float],
) -> SideView:
    """`picture` (H, W, 3) BGR and `change` (H, W), laid out on the plane Y = `y_m` between two X and two Z.

    Own method: each cell is projected by the pose and sampled bilinearly; cells are 0.7 pixels large, and not
    less than 8 mm.
    """
    away = abs(y_m - float(pose.centre_m[1]))
    cell = _CELL * away / (0.5 * (pose.camera.fx_px + pose.camera.fy_px))
    cell = max(cell, _LEAST_CELL_M)
    x, z = np.arange(x_m[0], x_m[1], cell), np.arange(z_m[0], z_m[1], cell)
    grid_x, grid_z = np.meshgrid(x, z)
    points = np.stack([grid_x, np.full_like(grid_x, y_m), grid_z], axis=-1).reshape(-1, 3)
    pixels = project(pose.camera, pose.to_camera(points)).reshape(*grid_x.shape, 2)
    height, width = change.shape
    seen = np.isfinite(pixels).all(axis=-1) & (pixels >= 1).all(axis=-1)
    seen &= (pixels[..., 0] <= width - 2) & (pixels[..., 1] <= height - 2)
    maps = np.where(seen[..., None], pixels, -9.0).astype(np.float32)
    smooth = cv2.GaussianBlur(picture, (0, 0), 0.7).astype(np.float32)
    laid = cv2.remap(smooth, maps[..., 0], maps[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT)
    apart = cv2.remap(change, maps[..., 0], maps[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT)
    blue, green, red = laid[..., 0], laid[..., 1], laid[..., 2]
    light = 0.114 * blue + 0.587 * green + 0.299 * red
    redness = red - np.maximum(blue, green)
    return SideView(
        light=np.asarray(light, np.float32),
        red=np.asarray(redness, np.float32),
        change=np.asarray(apart, np.float32),
        seen=np.asarray(seen, np.bool_),
        left_m=float(x[0]),
        bottom_m=float(z[0]),
        cell_m=cell,
        y_m=y_m,
    )


def pixel_of(pose: RoadPose, x_m: float, y_m: float, z_m: float) -> tuple[float, float]:
    """Where a road point is seen, pixels."""
    found: Floats = project(pose.camera, pose.to_camera(np.array([[x_m, y_m, z_m]])))[0]
    return float(found[0]), float(found[1])


def averaged(views: Sequence[SideView]) -> SideView:
    """The mean of views of one vehicle, cell by cell where they show it; seen is what two of them show, and
    `change` becomes the share of them in which something stands before the road.
    """
    wide = min(view.light.shape[1] for view in views)
    seen = np.stack([view.seen[:, :wide] for view in views])
    count = np.maximum(seen.sum(axis=0), 1).astype(np.float32)

    def mean(values: list[Plane]) -> Plane:
        total = np.zeros(count.shape, np.float32)
        for value, where in zip(values, seen, strict=True):
            total += value[:, :wide] * where
        return np.asarray(total / count, np.float32)

    return replace(
        views[0],
        light=mean([view.light for view in views]),
        red=mean([view.red for view in views]),
        change=mean([np.where(view.change > 1, np.float32(1), np.float32(0)) for view in views]),
        seen=np.asarray(seen.sum(axis=0) >= min(len(views), 2)),
    )
