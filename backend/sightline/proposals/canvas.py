"""A vehicle's side plane as a small picture for a network: metres along its way, to the right, and up."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.road_pose import RoadPose
from sightline.proposals.side_view import Bgr, Plane

Values = NDArray[np.float32]
CHANGE_FULL = 4.0  # times the tolerance: more is as good as certain
UNSEEN = -0.5  # in the place of the change, where the picture ends
_LEAST_SPREAD = 8.0  # grey levels


@dataclass(frozen=True)
class Canvas:
    """A window on the plane Y = `y_m`: `size` (columns, rows) cells of `cell_m` (along, up); cell (0, 0) is
    at `along_m` in the vehicle's way (X times `ahead`, 1 or -1) and at `z_m`. Rows go up.
    """

    y_m: float
    ahead: int
    along_m: float
    z_m: float
    cell_m: tuple[float, float]
    size: tuple[int, int]

    def place(self, column: ArrayLike, row: ArrayLike) -> tuple[Floats, Floats]:
        """Along and Z of cells: `column`, any shape, and `row`, any shape; of the same shape each."""
        along = self.along_m + np.asarray(column, np.float64) * self.cell_m[0]
        return along, self.z_m + np.asarray(row, np.float64) * self.cell_m[1]

    def cell(self, along_m: ArrayLike, z_m: ArrayLike) -> tuple[Floats, Floats]:
        """Column and row of places: `along_m`, any shape, and `z_m`, any shape; of the same shape each."""
        column = (np.asarray(along_m, np.float64) - self.along_m) / self.cell_m[0]
        return column, (np.asarray(z_m, np.float64) - self.z_m) / self.cell_m[1]

    def pixels(self, pose: RoadPose) -> Floats:
        """Where each cell is seen, (rows, columns, 2) px; NaN behind the camera."""
        along, z = self.place(np.arange(self.size[0]), np.zeros(1))
        _, z = self.place(np.zeros(1), np.arange(self.size[1]))
        grid_x, grid_z = np.meshgrid(self.ahead * along, z)
        points = np.stack([grid_x, np.full_like(grid_x, self.y_m), grid_z], axis=-1).reshape(-1, 3)
        found = project(pose.camera, pose.to_camera(points))
        return np.asarray(found.reshape(*grid_x.shape, 2), dtype=np.float64)


def lay_on_canvas(canvas: Canvas, picture: Bgr, change: Plane, pose: RoadPose) -> Values:
    """`picture` (H, W, 3) BGR and `change` (H, W) against the empty road over its tolerance, laid out:
    (4, rows, columns), colour with mean 0 and spread 1 over what is seen, then the change, 0 to 1.

    Own method: each cell is projected by the pose; where a cell is larger than a pixel, the picture is
    smoothed by half a cell first.
    """
    pixels = canvas.pixels(pose)
    height, width = change.shape
    visible = np.isfinite(pixels).all(axis=-1) & (pixels >= 0).all(axis=-1)
    visible &= (pixels[..., 0] <= width - 1) & (pixels[..., 1] <= height - 1)
    maps = np.where(visible[..., None], pixels, -9.0).astype(np.float32)
    if not visible.any():
        return np.full((4, *visible.shape), UNSEEN, np.float32)
    part, corner = _part(maps, visible, picture, change)
    maps = maps - corner
    cell_px = [_apart_px(pixels, axis) for axis in (1, 0)]
    colour, apart = (_smoothed(one, cell_px) for one in part)
    border = cv2.BORDER_REPLICATE
    laid_out = cv2.remap(colour, maps[..., 0], maps[..., 1], cv2.INTER_LINEAR, borderMode=border)
    moved = cv2.remap(apart, maps[..., 0], maps[..., 1], cv2.INTER_LINEAR, borderMode=border)
    usual, spread = laid_out[visible].mean(), laid_out[visible].std() + _LEAST_SPREAD
    out = np.zeros((4, *visible.shape), np.float32)
    out[:3] = np.moveaxis((laid_out - usual) / spread, -1, 0) * visible
    out[3] = np.where(visible, moved, UNSEEN)
    return out


def _part(
    maps: Values, seen: NDArray[np.bool_], picture: Bgr, change: Plane
) -> tuple[tuple[Values, Values], Values]:
    """What is looked at, with a margin, and its corner (2,) px: most of a frame is something else."""
    at = maps[seen]
    low = np.maximum(np.floor(at.min(axis=0)).astype(int) - 12, 0)
    high = np.ceil(at.max(axis=0)).astype(int) + 13
    rows, columns = slice(low[1], high[1]), slice(low[0], high[0])
    apart = np.clip(change[rows, columns] / CHANGE_FULL, 0, 1).astype(np.float32)
    return (picture[rows, columns].astype(np.float32), apart), low.astype(np.float32)


def _apart_px(pixels: Floats, axis: int) -> float:
    """How far apart cells beside each other are seen, in the middle of the canvas."""
    apart = np.linalg.norm(np.diff(pixels, axis=axis), axis=-1)
    return float(np.median(apart[np.isfinite(apart)]))


def _smoothed(values: Values, cell_px: Sequence[float]) -> Values:
    sigma = [0.5 * apart for apart in cell_px]
    if max(sigma) < 0.7:
        return values
    return np.asarray(
        cv2.GaussianBlur(values, (0, 0), max(sigma[0], 0.3), sigmaY=max(sigma[1], 0.3)), np.float32
    )
