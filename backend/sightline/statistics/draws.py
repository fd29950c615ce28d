"""Draws of errors for the propagation of distributions (JCGM 101:2008): always the same ones."""

from functools import cache, lru_cache

import numpy as np
import scipy

from sightline.arrays import Floats

TAIL = 0.025
LEVELS = (np.arange(4000) + 0.5) / 4000  # one draw in each of so many equally likely parts of a distribution
# Spread evenly against the levels and each other: multiples of irrational numbers, modulo 1; always the same.
OTHER = np.argsort((np.arange(4000) + 0.5) * 0.4142135623730951 % 1.0, kind="stable")


@cache
def normal_draws() -> Floats:
    """(4000,) normal deviates (JCGM 101:2008, 6.4.7), spread evenly against `LEVELS`."""
    return np.asarray(scipy.special.ndtri((np.arange(4000) + 0.5) * 0.6180339887498949 % 1.0), np.float64)


@lru_cache(maxsize=256)
def student_draws(freedom: float) -> Floats:
    """(4000,) quantiles of Student's t with so many degrees of freedom, at `LEVELS`, ascending.

    Own method: the upper half, mirrored.
    """
    upper = np.asarray(scipy.special.stdtrit(freedom, LEVELS[len(LEVELS) // 2 :]), np.float64)
    found = np.concatenate([-upper[::-1], upper])
    found.setflags(write=False)
    return found


def ends_of(draws: Floats) -> tuple[float, float]:
    """The ends of the 95 % interval of draws (D,) (JCGM 101:2008, 7.7)."""
    low, high = np.quantile(draws, [TAIL, 1.0 - TAIL])
    return float(low), float(high)
