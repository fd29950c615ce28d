"""Lays textures onto a frame through the camera: every pixel asks its own ray, so the lens is exact.

A plane Y = y is met by a pixel's ray at X = Cx + (y - Cy) a, Z = Cz + (y - Cy) b (the camera's slope maps).
"""

from dataclasses import dataclass

import cv2
import numpy as np

from tests.simulation.camera import Array, DemoCamera, Floats, slope_maps
from tests.simulation.paint import Plate

Box = tuple[int, int, int, int]
BEAM_UNIT = 100.0


@dataclass(frozen=True)
class Place:
    """Where a vehicle's local frame lies: road X of its rear, its direction of travel, its side plane."""

    rear_m: float
    direction: int
    side_plane_m: float

    def road(self, along: Array, inset: Array, z: Array) -> Array:
        """Road points (..., 3) of local (l, inset, z)."""
        along, inset, z = np.broadcast_arrays(along, inset, z)
        return np.stack([self.rear_m + self.direction * along, self.side_plane_m + inset, z], -1)


def box_of(camera: DemoCamera, points: Array, grow: int = 3) -> Box | None:
    """Pixel box (x0, y0, x1, y1) around projected road points, clipped; None when out of view."""
    px = camera.project(points)
    lo, hi = np.floor(px.min(0)).astype(int) - grow, np.ceil(px.max(0)).astype(int) + grow + 1
    x0, y0 = max(int(lo[0]), 0), max(int(lo[1]), 0)
    x1, y1 = min(int(hi[0]), camera.width_px), min(int(hi[1]), camera.height_px)
    return (x0, y0, x1, y1) if x1 - x0 > 1 and y1 - y0 > 1 else None


def plate_box(
    camera: DemoCamera, plate: Plate, place: Place, inset_m: float, shift: tuple[float, float]
) -> Box | None:
    """Pixel box of a plate at an inset."""
    h, w = plate.rgba.shape[:2]
    along = np.linspace(plate.left_m, plate.left_m + w / plate.ppm, 9) + shift[0]
    z = np.linspace(plate.top_m - h / plate.ppm, plate.top_m, 5) + shift[1]
    return box_of(camera, place.road(along[None, :], np.array(inset_m), z[:, None]).reshape(-1, 3))


def blend(frame: Floats, box: Box, rgba: Array) -> None:
    """Premultiplied BGRA (8 bits) over the float frame, in place."""
    x0, y0, x1, y1 = box
    part = frame[y0:y1, x0:x1]
    keep = cv2.cvtColor(cv2.bitwise_not(rgba[..., 3]), cv2.COLOR_GRAY2BGR)
    cv2.multiply(part, keep, part, 1 / 255.0, cv2.CV_32F)
    cv2.add(part, cv2.cvtColor(rgba, cv2.COLOR_BGRA2BGR), part, None, cv2.CV_32F)


def lay_plate(
    frame: Floats,
    camera: DemoCamera,
    plate: Plate,
    place: Place,
    inset_m: float,
    shift: tuple[float, float] = (0.0, 0.0),
) -> None:
    """Draws a flat plate that stands at `inset_m` behind the side plane, moved by shift (l, z)."""
    box = plate_box(camera, plate, place, inset_m, shift)
    if box is None:
        return
    x0, y0, x1, y1 = box
    a, b = slope_maps(camera)
    away = place.side_plane_m + inset_m - camera.centre_m[1]
    k = place.direction * plate.ppm
    u = a[y0:y1, x0:x1] * np.float32(away * k)
    u += np.float32((camera.centre_m[0] - place.rear_m) * k - (plate.left_m + shift[0]) * plate.ppm - 0.5)
    v = b[y0:y1, x0:x1] * np.float32(-away * plate.ppm)
    v += np.float32((plate.top_m + shift[1] - camera.centre_m[2]) * plate.ppm - 0.5)
    rgba = cv2.remap(plate.rgba, u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0)
    blend(frame, box, rgba)


@dataclass(frozen=True, eq=False)
class Relief:
    """The near side: a plate whose texels lie at their own insets (`depth`, a coarser grid)."""

    plate: Plate
    depth: Floats
    depth_ppm: float


def lay_relief(frame: Floats, camera: DemoCamera, relief: Relief, place: Place) -> None:
    """Draws the near side; each ray seeks its own inset by fixed-point steps (the slopes are below one)."""
    plate = relief.plate
    box = _union(plate_box(camera, plate, place, 0.0, (0, 0)), plate_box(camera, plate, place, 0.3, (0, 0)))
    if box is None:
        return
    x0, y0, x1, y1 = box
    a, b = slope_maps(camera)
    depth = _seek(relief, camera, place, a[y0:y1:2, x0:x1:2], b[y0:y1:2, x0:x1:2])
    full = _double(depth, (x1 - x0, y1 - y0))
    away = full + np.float32(place.side_plane_m - camera.centre_m[1])
    u, v = _texels(plate.ppm, plate, camera, place, away, a[y0:y1, x0:x1], b[y0:y1, x0:x1])
    rgba = cv2.remap(plate.rgba, u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0)
    blend(frame, box, rgba)


def _union(one: Box | None, two: Box | None) -> Box | None:
    if one is None or two is None:
        return one or two
    return min(one[0], two[0]), min(one[1], two[1]), max(one[2], two[2]), max(one[3], two[3])


def _texels(
    ppm: float, plate: Plate, camera: DemoCamera, place: Place, away: Floats, a: Floats, b: Floats
) -> tuple[Floats, Floats]:
    """Texture coordinates where rays are `away` metres along Y from the camera."""
    k = place.direction * ppm
    u = away * a * np.float32(k) + np.float32(
        (camera.centre_m[0] - place.rear_m) * k - plate.left_m * ppm - 0.5
    )
    v = np.float32((plate.top_m - camera.centre_m[2]) * ppm - 0.5) - away * b * np.float32(ppm)
    return u, v


def _seek(relief: Relief, camera: DemoCamera, place: Place, a: Floats, b: Floats, steps: int = 6) -> Floats:
    depth: Floats = np.full(a.shape, 0.06, np.float32)
    base = np.float32(place.side_plane_m - camera.centre_m[1])
    for _ in range(steps):
        u, v = _texels(relief.depth_ppm, relief.plate, camera, place, depth + base, a, b)
        depth = cv2.remap(relief.depth, u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return depth


def _double(half: Floats, size: tuple[int, int]) -> Floats:
    """From every second pixel to every pixel: sample k of the half grid sits at pixel 2k."""
    w, h = size
    move = np.array([[0.5, 0, 0], [0, 0.5, 0]], np.float32)
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(half, move, (w, h), flags=flags, borderMode=cv2.BORDER_REPLICATE)


def lay_ground(frame: Floats, camera: DemoCamera, plate: Plate, place: Place, add: bool = False) -> None:
    """Draws a plate that lies on the road: its second axis is the inset, the farthest on top."""
    h, w = plate.rgba.shape[:2]
    along = np.linspace(plate.left_m, plate.left_m + w / plate.ppm, 9)
    y = np.linspace(plate.top_m - h / plate.ppm, plate.top_m, 7)
    road = place.road(along[None, :], y[:, None], np.array(0.0)).reshape(-1, 3)
    road = road[road[:, 1] > camera.centre_m[1] + 0.8]
    box = box_of(camera, road) if len(road) else None
    if box is None:
        return
    x0, y0, x1, y1 = box
    a, b = slope_maps(camera)
    away = np.float32(-camera.centre_m[2]) / np.minimum(b[y0:y1, x0:x1], np.float32(-1e-3))
    k = place.direction * plate.ppm
    u = away * a[y0:y1, x0:x1] * np.float32(k)
    u += np.float32((camera.centre_m[0] - place.rear_m) * k - plate.left_m * plate.ppm - 0.5)
    v = away * np.float32(-plate.ppm)
    v += np.float32((plate.top_m + place.side_plane_m - camera.centre_m[1]) * plate.ppm - 0.5)
    rgba = cv2.remap(plate.rgba, u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0)
    if add:
        frame[y0:y1, x0:x1] *= 1 + rgba[..., :3] / np.float32(BEAM_UNIT)
    else:
        blend(frame, box, rgba)
