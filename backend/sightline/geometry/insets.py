"""Default insets: how far each target lies behind the side plane through the wheel contact.

These are estimates without a published source; screens and files show them as such, and they can be edited. A
target whose inset is unknown gets a wide uncertainty instead of a guess (the bias it stands for: `bias_m`).
"""

import numpy as np
from numpy.typing import ArrayLike

from sightline.enums import Target
from sightline.geometry.arrays import Floats

DEFAULT_INSETS: dict[Target, tuple[float, float, str]] = {
    "driver_eye": (
        0.45,
        0.10,
        "driver on the near side; 1.15 +- 0.15 m for a driver on the far side (estimate)",
    ),
    "taillight": (0.05, 0.05, "outer edge of the lamp (estimate)"),
    "headlight": (0.05, 0.05, "outer edge of the lamp (estimate)"),
    "roof": (0.30, 0.10, "near edge of the roof; 0.85 +- 0.10 m for its crown (estimate)"),
    "other": (0.0, 0.30, "unknown"),
}

# What an operator can see of a vehicle and choose between: words, inset, standard uncertainty (estimates).
INSET_CHOICES: dict[str, tuple[tuple[str, float, float], ...]] = {
    "driver_eye": (("near side", 0.45, 0.10), ("far side", 1.15, 0.15)),  # where the driver sits
    "roof": (("near edge", 0.30, 0.10), ("crown", 0.85, 0.10)),
}


def bias_m(
    camera_height_m: ArrayLike, height_m: ArrayLike, inset_m: ArrayLike, distance_m: ArrayLike
) -> Floats:
    """How much too high a target reads where its inset is taken to be 0, in metres; `camera_height_m`,
    `height_m`, `inset_m`, `distance_m`, any shape each, are broadcast: of the same shape.

    (Hc - h) inset / (D + inset): camera height Hc, true height h, distance D to the side plane. Exact for any
    pose and lens, for it is where the ray to the target meets the plane (CONVENTIONS.md, Height; not in the
    paper).
    """
    camera, height, inset, distance = (
        np.asarray(v, dtype=np.float64) for v in (camera_height_m, height_m, inset_m, distance_m)
    )
    return np.asarray((camera - height) * inset / (distance + inset), dtype=np.float64)
