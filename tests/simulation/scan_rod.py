"""A rod that is held upright in a line camera's plane: dark and light bands, edges at known heights.

The camera's centre is EYE_M above the road and looks level; by similar triangles a point seen at height z on
the near lane's plane is at EYE_M + (z - EYE_M) distance / plane at the rod's distance.
"""

from dataclasses import dataclass

import numpy as np

from tests.simulation.camera import Array, Floats
from tests.simulation.scan_art import EYE_M, row_edges_m
from tests.simulation.scan_traffic import ScanSite

ROD_M, BAND_M = 2.0, 0.25
LIGHT_DN, DARK_DN = 214.0, 34.0
_FINER = 16


@dataclass(frozen=True)
class HeldRod:
    """A rod in camera 1's plane from one time to another, its foot on the road."""

    distance_m: float
    from_s: float
    to_s: float

    @property
    def marks_m(self) -> tuple[float, ...]:
        """Heights of foot, every other band's edge and top."""
        return tuple(np.arange(0.0, ROD_M + BAND_M, 2 * BAND_M).tolist())


def row_of(site: ScanSite, distance_m: float, height_m: float) -> float:
    """Row in strip 1 (centres at whole numbers) of a point at a distance and height above the road."""
    if site.plane_m is None:
        raise ValueError("the site has no distance, so nothing but the near plane has rows")
    seen_m = EYE_M + (height_m - EYE_M) * site.plane_m / distance_m
    return (site.top_m - seen_m) * site.rows / site.field_m - 0.5


def lay_rods(site: ScanSite, rods: tuple[HeldRod, ...], edge_s: Array, scene: Floats) -> None:
    """Puts what stands in camera 1's plane over the scene (lines, rows), in place."""
    for rod in rods:
        seen = (edge_s[:-1] >= rod.from_s) & (edge_s[1:] <= rod.to_s)
        if seen.any():
            light, cover = _line(site, rod)
            scene[seen] = light + (1 - cover) * scene[seen]


def _line(site: ScanSite, rod: HeldRod) -> tuple[Floats, Floats]:
    """Premultiplied light and coverage (rows,), each row the mean of what its pixel sees."""
    assert site.plane_m is not None
    edges = row_edges_m(site, 1)
    parts = (np.arange(_FINER) + 0.5) / _FINER
    seen_m = edges[:-1, None] + np.diff(edges)[:, None] * parts
    height = EYE_M + (seen_m - EYE_M) * rod.distance_m / site.plane_m
    inside = (height >= 0) & (height <= ROD_M)
    tone = np.where(np.floor(height / BAND_M) % 2 == 0, DARK_DN, LIGHT_DN)
    return (
        np.asarray((tone * inside).mean(1), np.float32),
        np.asarray(inside.mean(1), np.float32),
    )
