"""Lamps in low light: bloom around tail lamps and headlamps, and the beam on the road."""

from functools import lru_cache

import numpy as np

from tests.simulation.camera import DemoCamera, Floats
from tests.simulation.compose import BEAM_UNIT, Place
from tests.simulation.paint import Plate
from tests.simulation.shape import Shape
from tests.simulation.sideart import tail_lamp_box


@lru_cache(maxsize=4)
def _halo(radius: int) -> Floats:
    y, x = np.mgrid[-radius : radius + 1, -radius : radius + 1].astype(np.float32)
    r2 = (x * x + y * y) / radius**2
    out: Floats = np.exp(-r2 * 9) * 0.42 + np.exp(-r2 * 3.2) * 0.25 * np.clip(1 - r2, 0, 1)
    out.flags.writeable = False
    return out


def _add(frame: Floats, centre: np.ndarray, radius: int, ink: np.ndarray) -> None:
    """Adds a halo, clipped at the picture's border."""
    h, w = frame.shape[:2]
    cx, cy = round(float(centre[0])), round(float(centre[1]))
    x0, x1, y0, y1 = (
        max(cx - radius, 0),
        min(cx + radius + 1, w),
        max(cy - radius, 0),
        min(cy + radius + 1, h),
    )
    if x1 <= x0 or y1 <= y0:
        return
    part = _halo(radius)[y0 - cy + radius : y1 - cy + radius, x0 - cx + radius : x1 - cx + radius]
    frame[y0:y1, x0:x1] += part[..., None] * ink.astype(np.float32)


def add_glow(frame: Floats, camera: DemoCamera, shape: Shape, place: Place) -> None:
    """Bloom of the lamps on the near side, larger when nearer."""
    style = shape.vehicle.style
    l0, l1, z0, z1 = tail_lamp_box(shape)
    lamps = [
        ((l0 + 0.35 * (l1 - l0), (z0 + z1) / 2 + 0.02), 34.0, (26.0, 20.0, 105.0)),
        (
            (shape.length_m - 0.08, (style.head_lamp[1] + style.head_lamp[2]) / 2 * shape.sz),
            52.0,
            (120.0, 128.0, 132.0),
        ),
    ]
    near = place.side_plane_m - camera.centre_m[1]
    for (along, z), size, ink in lamps:
        inset = float(shape.inset(np.array(along), np.array(z)))
        px = camera.project(place.road(np.array(along), np.array(inset), np.array(z)))
        _add(frame, px, max(8, round(size * 3.1 / near)), np.array(ink))


def beam_plate(shape: Shape) -> Plate:
    """Headlamp light on the road ahead: gains (BGR) times 255 on the ground plane."""
    ppm, length = 24.0, shape.length_m
    along = length - 0.3 + (np.arange(int(9 * ppm)) + 0.5) / ppm
    y = 2.6 - (np.arange(int(4.2 * ppm)) + 0.5) / ppm
    ahead, side = np.meshgrid(along - length, y - shape.width_m / 2)
    spread = 0.55 + 0.22 * np.clip(ahead, 0, None)
    power = np.exp(-((side / spread) ** 2)) * np.clip(ahead / 1.2, 0, 1) * np.exp(-ahead / 5.0) * 2.4
    edge = np.clip((along[-1] - along) / 2, 0, 1) * np.clip((along - along[0]) / 0.5, 0, 1)
    gain = power * edge[None, :]
    rgba = np.stack([gain * 0.86, gain * 0.97, gain * 1.0, gain], -1) * BEAM_UNIT
    return Plate(np.clip(np.round(rgba), 0, 255).astype(np.uint8), ppm, float(length - 0.3), 2.6)
