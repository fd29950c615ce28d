"""Light of a scene and how surfaces answer it: sun or street lamp, sky and ground mirrored.

Colours are BGR, 0..255, in display space; the whole room mixes them there, which is plain and looks right.
"""

from dataclasses import dataclass

import numpy as np

from tests.simulation.camera import Array

BGR = tuple[float, float, float]


@dataclass(frozen=True)
class Light:
    """What lights a scene: the direction to the key light (road frame) and the colours around."""

    name: str
    key: tuple[float, float, float]
    key_gain: float
    ambient: BGR
    zenith: BGR
    horizon: BGR
    treeline: BGR
    ground: BGR
    exposure_s: float
    noise: float
    blur_px: float

    @property
    def low(self) -> bool:
        return self.name == "low_light"


DAY = Light(
    "daytime",
    (-0.42, -0.55, 0.72),
    0.80,
    (0.50, 0.46, 0.43),
    (225, 185, 140),
    (240, 235, 228),
    (70, 85, 78),
    (92, 94, 97),
    1 / 1000,
    2.2,
    0.62,
)
LOW = Light(
    "low_light",
    (-0.30, -0.62, 0.72),
    0.40,
    (0.190, 0.145, 0.120),
    (80, 46, 28),
    (128, 104, 98),
    (24, 19, 16),
    (34, 42, 50),
    1 / 400,
    5.0,
    0.85,
)


def _mirror(light: Light, up: Array) -> Array:
    """Colour seen in a mirror direction of elevation sine `up` (N,): ground, tree line, sky."""
    stops = np.array([-1.0, -0.25, -0.05, 0.0, 0.07, 0.12, 0.5, 1.0])
    g, t = np.array(light.ground), np.array(light.treeline)
    h, z = np.array(light.horizon), np.array(light.zenith)
    table = np.array([g * 0.55, g * 0.9, g * 1.1, t, t, h, (h + z) / 2, z])
    return np.stack([np.interp(up, stops, table[:, c]) for c in range(3)], -1)


def shade(
    light: Light, normals: Array, base: Array, view: Array, gloss: float = 0.55, floor: float = 0.06
) -> Array:
    """BGR (..., 3) of a surface: diffuse paint plus mirrored surroundings by Schlick's Fresnel term.

    All (..., 3): normals outward in the road frame, base BGR, view unit rays from the camera.
    """
    key = np.array(light.key) / np.linalg.norm(light.key)
    diffuse = np.clip(normals @ key, 0, None)
    dome = 0.55 + 0.45 * normals[..., 2]
    sun = np.array([0.93, 0.98, 1.04]) if not light.low else np.array([0.62, 0.86, 1.05])
    lit = base * (np.array(light.ambient) * dome[..., None] + light.key_gain * diffuse[..., None] * sun)
    cos = np.clip(-np.sum(view * normals, -1), 0, 1)
    bounce = view + 2 * cos[..., None] * normals
    fresnel = gloss * (floor + (1 - floor) * (1 - cos) ** 5) + gloss * 0.20
    half = key - view
    half /= np.linalg.norm(half, axis=-1, keepdims=True)
    spark = np.clip(np.sum(half * normals, -1), 0, 1) ** 60 * (95 if not light.low else 60) * gloss
    out: Array = np.clip(
        lit * (1 - fresnel[..., None])
        + fresnel[..., None] * _mirror(light, bounce[..., 2])
        + spark[..., None] * sun,
        0,
        255,
    )
    return out
