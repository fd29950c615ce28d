"""How far from the axis a lens model can be inverted, found once per camera.

A calibrated polynomial bends back somewhere outside the points it was fitted to: two directions then share
one pixel, and pixels further out have no direction at all. Nothing is measured there.
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.enums import LensModel
from sightline.geometry.arrays import freeze_array
from sightline.geometry.lens import distort, radial_gain

_FARTHEST = 11.43  # tan 85 degrees: further off the axis, x/z is no sensible coordinate
_RADII = 512
_ANGLES = 72


@dataclass(frozen=True, eq=False)
class LensLimit:
    """Largest radius inside which the mapping is one-to-one, and a table to start its inversion from."""

    radius: float  # on the undistorted normalised plane
    table_step: float
    table_gain: Floats  # r / r_distorted at r_distorted = i * table_step


def _first_fold(model: LensModel, k: Floats, radii: Floats) -> int:
    """Index of the first of `radii` at which the mapping folds in any direction (len(radii) if none)."""
    angles = np.linspace(0.0, 2.0 * np.pi, _ANGLES, endpoint=False)
    x, y = np.outer(radii, np.cos(angles)), np.outer(radii, np.sin(angles))
    with np.errstate(all="ignore"):
        d = distort(model, k, x, y)
        gain = radial_gain(model, k, radii**2)[0]
        trace = d.dx_dx + d.dy_dy
        bad = ~((d.determinant > 1e-6) & (trace > 0) & np.isfinite(d.x)).all(axis=1) | ~(gain > 0)
    return int(np.argmax(bad)) if bad.any() else len(radii)


def lens_limit(model: LensModel, k: Floats, picture_radius: float) -> LensLimit:
    """The largest monotone radius of a lens, normalised (the tangent of the angle off the axis).

    model, k (n,): the lens; picture_radius: distorted normalised radius of the picture's farthest corner (the
    table need not reach beyond it). Own method: the first radius at which det d' is not positive in every
    direction (CONVENTIONS.md, Lens); judged by the whole 2x2 derivative, tangential terms count.
    """
    low, high = 0.0, _FARTHEST
    for _ in range(4):  # each pass narrows the fold to 1/512 of the last bracket
        radii = low + (high - low) * np.arange(1, _RADII + 1) / _RADII
        fold = _first_fold(model, k, radii)
        if fold == _RADII:
            low = high
            break
        low, high = (low if fold == 0 else float(radii[fold - 1])), float(radii[fold])
    return LensLimit(low, *_table(model, k, low, picture_radius))


def _table(model: LensModel, k: Floats, limit: float, picture_radius: float) -> tuple[float, Floats]:
    # radii spaced densely near the end, where the distorted radius hardly moves
    r = (
        limit * np.sin(np.linspace(0.0, np.pi / 2, 8192))
        if limit < _FARTHEST
        else np.linspace(0.0, limit, 16384)
    )
    bent = r * radial_gain(model, k, r * r)[0]
    bent = np.maximum.accumulate(bent)
    end = min(float(bent[-1]), 1.05 * picture_radius)
    wanted = np.linspace(0.0, end, 2049)
    radius = np.interp(wanted, bent, r)
    gain = np.ones_like(wanted)
    gain[1:] = radius[1:] / wanted[1:]
    return end / 2048, freeze_array(gain)
