"""A vehicle's geometry: outline and the inset of its near side, closed forms that painter and truth share."""

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from tests.simulation.camera import Array
from tests.simulation.scene import Vehicle

# how far from either end outlines of vehicles of one style differ, by how much, and what of an end may be
# cut off, metres
NEAR_END_M, END_M, CUT_M = 0.5, 0.015, 0.004


@dataclass(frozen=True, eq=False)
class Shape:
    """Geometry of one vehicle, local frame: l forward from the rear, z up, inset away from the camera."""

    vehicle: Vehicle
    outline: Array
    crest: Array
    length_m: float
    width_m: float
    sl: float
    sz: float
    axles: tuple[float, float]
    radius_m: float

    def at(self, l_ref: float, z_ref: float) -> tuple[float, float]:
        """A style's reference coordinates scaled to this vehicle."""
        return l_ref * self.sl, z_ref * self.sz

    def top(self, along: Array) -> Array:
        """Height of the upper outline at l (any shape)."""
        return np.asarray(np.interp(along, np.linspace(0, self.length_m, len(self.crest)), self.crest))

    def belt(self, along: Array) -> Array:
        """Height of the window sill line at l."""
        (l0, z0), (l1, z1) = self.vehicle.style.belt
        return self.sz * np.interp(along, [l0 * self.sl, l1 * self.sl], [z0, z1])

    def inset(self, along: Array, z: Array) -> Array:
        """How far the near side's skin lies behind the side plane at (l, z), metres; 0 is the tyre's face."""
        style = self.vehicle.style
        if style.name == "lorry":
            cab = along > 5.43 * self.sl
            return np.where(cab, 0.05 + 0.035 * np.clip(z - self.belt(along), 0, None), 0.02)
        belt = self.belt(along)
        above = np.clip(z - belt + 0.05, 0, None)
        out = (
            0.012
            + 0.10 * np.clip(0.52 * self.sz - z, 0, None) ** 1.5
            + 0.085 * np.clip(z - 0.60 * self.sz, 0, 0.4)
        )
        # the greenhouse leans in: a parabola of 10 cm eases into the slope
        out = out + style.tumble * np.where(above < 0.10, above**2 / 0.20, above - 0.05)
        out = out + 0.032 * np.clip(1 - (self.top(along) - z) / 0.10, 0, 1) ** 2
        rear = np.clip(1 - along / 0.42, 0, 1) ** 2 * 0.085
        nose = np.clip(1 - (self.length_m - along) / 0.75, 0, 1) ** 2 * 0.19
        return np.asarray(out + rear + nose)


def _upper(outline: Array, grid: Array) -> Array:
    """The highest outline point over each l: outlines fold back, so the maximum of segments."""
    best = np.full(grid.shape, -np.inf)
    for (l0, z0), (l1, z1) in pairwise(outline):
        lo, hi = min(l0, l1), max(l0, l1)
        inside = (grid >= lo) & (grid <= hi)
        t = (grid - l0) / (l1 - l0) if l1 != l0 else np.zeros_like(grid)
        best = np.maximum(best, np.where(inside, z0 + t * (z1 - z0), -np.inf))
    good = np.isfinite(best)
    return np.asarray(np.interp(grid, grid[good], best[good]))


def _spline(points: Array, per_segment: int = 6) -> Array:
    """Centripetal-like Catmull-Rom through the points (N, 2)."""
    padded = np.vstack([2 * points[0] - points[1], points, 2 * points[-1] - points[-2]])
    t = np.linspace(0, 1, per_segment, endpoint=False)[:, None]
    parts = []
    for p0, p1, p2, p3 in zip(padded, padded[1:], padded[2:], padded[3:], strict=False):
        chord = np.linalg.norm(p2 - p1)
        m1 = (p2 - p0) / max(np.linalg.norm(p2 - p0), 1e-9) * chord
        m2 = (p3 - p1) / max(np.linalg.norm(p3 - p1), 1e-9) * chord
        h = (2 * t**3 - 3 * t**2 + 1, t**3 - 2 * t**2 + t, -2 * t**3 + 3 * t**2, t**3 - t**2)
        parts.append(h[0] * p1 + h[1] * m1 + h[2] * p2 + h[3] * m2)
    return np.vstack([*parts, points[-1:]])


def _with_own_ends(points: Array, length_m: float, smooth: bool, rng: np.random.Generator) -> Array:
    """The outline through points (N, 2) of which those near either end are each moved along by some END_M,
    foremost and rearmost where they were; every second round end is cut off upright, as by a plate.

    Of an outline of straight lines the front is round, and the rear stays upright, as of a lorry's box.
    """
    ahead = points[:, 0] > length_m - NEAR_END_M
    near = ahead | ((points[:, 0] < NEAR_END_M) & smooth)
    along = points[:, 0] + near * rng.normal(0.0, END_M, len(points))
    points = np.stack([along, points[:, 1]], -1)
    bent = _spline(points) if smooth else np.vstack([points[~ahead], _spline(points[ahead])])
    cut_m = rng.integers(2, size=2) * rng.uniform(0.0, CUT_M, 2)
    low = float(bent[:, 0].min()) + smooth * cut_m[0]
    high = float(bent[:, 0].max()) - cut_m[1]
    return np.stack([np.clip((bent[:, 0] - low) / (high - low), 0.0, 1.0) * length_m, bent[:, 1]], -1)


@lru_cache(maxsize=64)
def shape_of(vehicle: Vehicle) -> Shape:
    """The shape of one vehicle, its roof's highest outline point exactly at the true roof height."""
    style = vehicle.style
    sl, sz = vehicle.model.length_m / style.length_m, vehicle.roof_height_m / style.height_m
    points = np.array(style.outline) * (sl, sz)
    if vehicle.ends_seed is not None:
        ends = np.random.default_rng((vehicle.ends_seed, 34))
        outline = _with_own_ends(points, vehicle.model.length_m, style.smooth, ends)
    else:
        outline = _spline(points) if style.smooth else points
    outline[:, 1] *= vehicle.roof_height_m / outline[:, 1].max()
    outline[:, 0] = np.clip(outline[:, 0], 0, vehicle.model.length_m)
    outline.flags.writeable = False
    crest = _upper(outline, np.linspace(0, vehicle.model.length_m, 400))
    crest.flags.writeable = False
    rear = style.rear_axle_m * sl
    axles = (rear, rear + vehicle.model.wheelbase_m)
    return Shape(
        vehicle=vehicle,
        outline=outline,
        crest=crest,
        length_m=vehicle.model.length_m,
        width_m=vehicle.model.width_m,
        sl=sl,
        sz=sz,
        axles=axles,
        radius_m=style.wheel_radius_m,
    )
