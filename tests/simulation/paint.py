"""Paints the near side of a vehicle once: a texture over the local (l, z) plane, light baked in.

Textures are premultiplied BGRA in 0..255; light may be baked because a vehicle only slides along X.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.simulation.camera import Array, Floats, Image
from tests.simulation.light import Light, shade
from tests.simulation.shape import Shape

FINE = 3


@dataclass(frozen=True, eq=False)
class Plate:
    """A texture on a plane of constant inset: pixel (i, j) is l = left + (i + .5) / ppm, z = top - ..."""

    rgba: Array
    ppm: float
    left_m: float
    top_m: float


class Stencil:
    """Coverage masks over a rectangle of the local plane, antialiased by drawing them three times finer."""

    def __init__(self, left_m: float, right_m: float, bottom_m: float, top_m: float, ppm: float) -> None:
        self.left_m, self.top_m, self.ppm = left_m, top_m, ppm
        self.size = (int(np.ceil((right_m - left_m) * ppm)), int(np.ceil((top_m - bottom_m) * ppm)))
        self.along = left_m + (np.arange(self.size[0]) + 0.5) / ppm
        self.up = top_m - (np.arange(self.size[1]) + 0.5) / ppm

    def grid(self) -> tuple[Array, Array]:
        """(l, z) of every texture pixel."""
        along, up = np.meshgrid(self.along, self.up)
        return along, up

    def fine(self) -> Floats:
        return np.zeros((self.size[1] * FINE, self.size[0] * FINE), np.float32)

    def to_fine(self, points: Array) -> NDArray[np.int32]:
        """Local metres to fine pixels with 4 fractional bits."""
        p = np.asarray(points, float)
        scale = self.ppm * FINE
        xy = np.stack([(p[:, 0] - self.left_m) * scale - 0.5, (self.top_m - p[:, 1]) * scale - 0.5], -1)
        return np.round(xy * 16).astype(np.int32)

    def fine_bytes(self) -> Image:
        return np.zeros((self.size[1] * FINE, self.size[0] * FINE), np.uint8)

    def shrink(self, fine: Floats) -> Floats:
        return cv2.resize(fine, self.size, interpolation=cv2.INTER_AREA)

    def area(self, *polygons: Array) -> Floats:
        """Coverage of polygons (each (N, 2) in metres)."""
        return self._drawn([self.to_fine(polygon) for polygon in polygons], 0)

    def line(self, points: Array, width_m: float) -> Floats:
        """Coverage of a polyline of a given width."""
        return self._drawn([self.to_fine(points)], max(1, round(width_m * self.ppm * FINE)))

    def _drawn(self, shapes: list[NDArray[np.int32]], thick: int) -> Floats:
        """Draws on a fine canvas just around the shapes: most are small parts of a large texture."""
        out = np.zeros((self.size[1], self.size[0]), np.float32)
        every = np.concatenate(shapes) / (16 * FINE)
        pad = 2 + thick // FINE
        lo = np.clip(np.floor(every.min(0)).astype(int) - pad, 0, self.size)
        hi = np.clip(np.ceil(every.max(0)).astype(int) + pad, 0, self.size)
        w, h = hi - lo
        if w <= 0 or h <= 0:
            return out
        fine = np.zeros((h * FINE, w * FINE), np.uint8)
        for shape in shapes:
            moved = shape - (lo * 16 * FINE).astype(np.int32)
            if thick:
                cv2.polylines(fine, [moved], False, 255, thick, shift=4)
            else:
                cv2.fillPoly(fine, [moved], 255, shift=4)
        small = cv2.resize(fine, (int(w), int(h)), interpolation=cv2.INTER_AREA)
        out[lo[1] : hi[1], lo[0] : hi[0]] = small * np.float32(1 / 255)
        return out

    def disc(self, centre: tuple[float, float], radius_m: float) -> Floats:
        turn = np.linspace(0, 2 * np.pi, 72, endpoint=False)
        ring = np.stack([centre[0] + radius_m * np.cos(turn), centre[1] + radius_m * np.sin(turn)], -1)
        return self.area(ring)


def around(mask: Floats) -> tuple[slice, slice]:
    """The smallest box that holds all of a mask."""
    rows, columns = np.flatnonzero(mask.any(1)), np.flatnonzero(mask.any(0))
    if not len(rows):
        return slice(0, 0), slice(0, 0)
    return slice(int(rows[0]), int(rows[-1]) + 1), slice(int(columns[0]), int(columns[-1]) + 1)


class Layer:
    """A premultiplied picture that masks are laid onto."""

    def __init__(self, size: tuple[int, int]) -> None:
        self.colour: Floats = np.zeros((size[1], size[0], 3), np.float32)
        self.alpha: Floats = np.zeros((size[1], size[0], 1), np.float32)

    def lay(self, mask: Floats, colour: object, opacity: float = 1.0) -> None:
        """Covers with a colour (BGR, or a picture of BGR) where the mask is."""
        at = around(mask)
        m = (mask[at] * np.float32(opacity))[..., None]
        ink = np.asarray(colour, np.float32)
        ink = ink[at] if ink.ndim == 3 else ink
        self.colour[at] += (ink - self.colour[at]) * m
        self.alpha[at] += (1 - self.alpha[at]) * m

    def cut(self, mask: Floats) -> None:
        """Takes away what the mask covers."""
        at = around(mask)
        keep = 1 - mask[at][..., None]
        self.colour[at] *= keep
        self.alpha[at] *= keep

    def tint(self, mask: Floats, gain: float) -> None:
        """Darkens (gain < 1) or lightens what is there."""
        at = around(mask)
        self.colour[at] *= 1 + np.float32(gain - 1) * mask[at][..., None]

    def copy(self) -> "Layer":
        twin = Layer((self.colour.shape[1], self.colour.shape[0]))
        twin.colour, twin.alpha = self.colour.copy(), self.alpha.copy()
        return twin

    def plate(self, stencil: Stencil) -> Plate:
        whole = np.concatenate([self.colour, self.alpha * 255], -1)
        rgba = np.clip(np.round(whole), 0, 255).astype(np.uint8)
        rgba.flags.writeable = False
        return Plate(rgba, stencil.ppm, stencil.left_m, stencil.top_m)


def side_normals(shape: Shape, along: Array, z: Array) -> Array:
    """Outward unit normals (..., 3) of the near side in the road frame."""
    step = 0.004
    dl = (shape.inset(along + step, z) - shape.inset(along - step, z)) / (2 * step)
    dz = (shape.inset(along, z + step) - shape.inset(along, z - step)) / (2 * step)
    if shape.vehicle.style.smooth:
        crease = 0.62 * shape.sz + 0.02 * (along - 1.5)
        dz = (
            dz
            + 0.30 * np.exp(-(((z - crease) / 0.035) ** 2))
            - 0.26 * np.exp(-(((z - crease - 0.075) / 0.03) ** 2))
        )
    n = np.stack([dl * shape.vehicle.direction, -np.ones_like(dl), dz], -1)
    out: Array = n / np.linalg.norm(n, axis=-1, keepdims=True)
    return out


def side_view(shape: Shape, z: Array, eye_m: float, near_m: float) -> Array:
    """Unit rays from the camera to the near side, by height alone."""
    ray = np.stack([np.zeros_like(z), np.full_like(z, near_m), z - eye_m], -1)
    out: Array = ray / np.linalg.norm(ray, axis=-1, keepdims=True)
    return out


def body_outline(shape: Shape) -> Array:
    """The closed outline of the painted body, sill included."""
    style = shape.vehicle.style
    if not style.smooth:
        return shape.outline
    sill = style.sill_m * shape.sz
    foot = np.array([[shape.length_m - 0.30, sill], [0.34, sill]])
    return np.vstack([shape.outline, foot])


def glass_area(shape: Shape, stencil: Stencil) -> Floats:
    """Coverage of the side windows: the greenhouse less its rails and rear pillar."""
    style = shape.vehicle.style
    scale = stencil.ppm * FINE
    inside = stencil.fine_bytes()
    cv2.fillPoly(inside, [stencil.to_fine(body_outline(shape))], 1, shift=4)
    rail = 0.075 if style.smooth else 0.12
    depth = cv2.distanceTransform(inside, cv2.DIST_L2, 3)
    pane = (depth > rail * scale).astype(np.uint8)
    (l0, z0), (l1, z1) = (shape.at(*p) for p in style.glass_rear)
    lean = (l1 - l0) / max(z1 - z0, 1e-6)
    back = l0 - z0 * lean
    behind = np.array([[-1, 0], [back, 0], [back + 4 * lean, 4], [-1, 4]])
    grid = np.linspace(-0.5, shape.length_m + 0.5, 40)
    below = np.vstack([np.stack([grid, shape.belt(grid)], -1), [[grid[-1], -1.0], [grid[0], -1.0]]])
    for away in (behind, below):
        cv2.fillPoly(pane, [stencil.to_fine(away)], 0, shift=4)
    # blur, then steepen to one pixel around the half: corners become round, straight edges stay
    sigma = 0.016 * stencil.ppm
    soft = cv2.GaussianBlur(stencil.shrink(pane.astype(np.float32)), (0, 0), sigma)
    return np.asarray(np.clip((soft - 0.5) * 2.5 * sigma + 0.5, 0, 1), np.float32)


def pane_area(shape: Shape, stencil: Stencil) -> Floats:
    """Coverage of the glass one can see through."""
    return less_pillars(shape, stencil, glass_area(shape, stencil))


def less_pillars(shape: Shape, stencil: Stencil, glass: Floats) -> Floats:
    """The windows less the pillars between them."""
    panes = glass
    for pillar in shape.vehicle.style.pillars:
        at, _ = shape.at(pillar, 0)
        panes = panes * (1 - stencil.line(np.array([[at - 0.05, 0.6], [at + 0.05, 2.2]]), 0.085))
    return panes


def painted_body(shape: Shape, light: Light, stencil: Stencil, eye_m: float, near_m: float) -> Floats:
    """The paint's colour at every texture pixel (h, w, 3)."""
    along, z = np.meshgrid(stencil.along[::2], stencil.up[::2])
    normals = side_normals(shape, along, z)
    base = np.broadcast_to(np.array(shape.vehicle.paint), (*along.shape, 3))
    colour = shade(light, normals, base, side_view(shape, z, eye_m, near_m))
    # light that reaches low panels comes over dark asphalt: a soft falloff toward the sill
    fall = np.clip(0.62 + 0.55 * (z - 0.2), 0.55, 1.0)
    half = (colour * fall[..., None]).astype(np.float32)
    return np.asarray(cv2.resize(half, stencil.size, interpolation=cv2.INTER_LINEAR), np.float32)
