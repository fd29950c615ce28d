"""Does the board end where the detection ends?

The detectors accept a part of a larger board: told 5x6 they find a 5x6 piece of a 9x6 board, and with it the
wrong reference row. So each side is asked whether the pattern goes on beyond it.
"""

from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.enums import PatternSide

_ANGLES = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
_RADIUS = 0.32  # of the distance to the neighbours: inside the four squares that meet
_SIDES: tuple[PatternSide, ...] = get_args(PatternSide)


def _crossing(gray: NDArray[np.uint8], at: Floats, across: Floats, down: Floats) -> Floats:
    """How much points (N, 2) look like the crossing of four squares; NaN where the ring leaves the picture.

    The brightness on a ring around a crossing goes dark, light, dark, light: its second harmonic is strong
    and its first vanishes. Where a single square touches a plain margin the first is the stronger one.
    """
    from scipy.ndimage import map_coordinates  # here, so that a server starts without SciPy

    ring = np.cos(_ANGLES)[:, None, None] * across + np.sin(_ANGLES)[:, None, None] * down
    points = at[None] + _RADIUS * ring
    x, y = points[..., 0], points[..., 1]
    inside = ((x >= 0) & (y >= 0) & (x <= gray.shape[1] - 1) & (y <= gray.shape[0] - 1)).all(axis=0)
    value = map_coordinates(gray, [y, x], output=np.float64, order=1, mode="nearest")
    first = np.abs((value * np.exp(-1j * _ANGLES)[:, None]).mean(axis=0))
    second = np.abs((value * np.exp(-2j * _ANGLES)[:, None]).mean(axis=0))
    return np.where(inside, second - first, np.nan)


def goes_on(gray: NDArray[np.uint8], grid: Floats) -> PatternSide | None:
    """Where the pattern goes on beyond a `grid` of corners (rows, columns, 2), pixels; None if it
    ends.

    gray (H, W). A side goes on when most of the places where its next corners would be are crossings as clear
    as half of those found. Sides out of the picture are not judged. Own method: a crossing is a ring whose
    brightness has a second harmonic, and no first.
    """
    for side, turned in zip(_SIDES, _grids_from_each_side(grid), strict=True):
        # (rows, columns, 2) with the asked side first: the next line of corners, carried on with its bend
        third = turned[2] if len(turned) > 2 else 2.0 * turned[1] - turned[0]
        beyond = 3.0 * turned[0] - 3.0 * turned[1] + third
        outward = beyond - turned[0]
        along = np.gradient(turned[0], axis=0)
        score = _crossing(gray, beyond, outward, along)
        own = _crossing(gray, turned[0], outward, along)
        judged = np.isfinite(score)
        if judged.sum() * 2 < len(score) or not np.isfinite(own).any():
            continue
        clear = float(np.nanmedian(own))
        if clear > 0 and float((score[judged] > 0.5 * clear).mean()) > 0.7:
            return side
    return None


def _grids_from_each_side(grid: Floats) -> tuple[Floats, ...]:
    """The grid with its left, right, upper and lower line first."""
    columns = grid.transpose(1, 0, 2)
    return columns, columns[::-1], grid, grid[::-1]
