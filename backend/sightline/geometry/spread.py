"""Mean of values that scatter by more than their own uncertainties: vehicles differ among themselves."""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.robust import robust_scale

_LEAST_U = 1e-9
_FAR = 4.0


@dataclass(frozen=True)
class Spread:
    """Weighted mean, its standard uncertainty, the standard deviation between the things themselves, their
    number, and what of the mean's uncertainty falls with it.
    """

    mean: float
    u_mean: float
    between: float
    count: int
    u_own: float


def mean_and_spread(values: ArrayLike, u: ArrayLike, shared: ArrayLike = 0.0) -> Spread:
    """Mean of N >= 1 `values` (N,) with standard uncertainties `u` (N,) of their own, any one unit, each
    thing having a value of its own; `shared` (N, N): covariance of what they have in common beside.

    The spread between things is that which makes the weighted squares come out as N - 1 (Paule and Mandel
    1982), 0 where the uncertainties explain all scatter. One value tells nothing of a spread. What they share
    is in the mean whole, however many they are (JCGM 100:2008, 5.2.2).
    """
    x = np.asarray(values, dtype=np.float64).ravel()
    variance = np.maximum(np.asarray(u, dtype=np.float64).ravel(), _LEAST_U) ** 2

    def excess(between2: float) -> float:
        w = 1.0 / (variance + between2)
        mean = float(w @ x) / float(w.sum())
        return float(w @ (x - mean) ** 2) - (len(x) - 1)

    between2 = 0.0
    if len(x) > 1 and excess(0.0) > 0.0:
        high = float(np.square(x - x.mean()).sum()) + float(variance.max())
        between2 = float(scipy.optimize.brentq(excess, 0.0, high)) if excess(high) < 0.0 else high
    w = 1.0 / (variance + between2)
    own2, share = 1.0 / float(w.sum()), w / w.sum()
    common = np.broadcast_to(np.asarray(shared, dtype=np.float64), (len(x), len(x)))
    common2 = max(float(share @ common @ share), 0.0)
    return Spread(
        float(share @ x),
        float(np.sqrt(own2 + common2)),
        float(np.sqrt(between2)),
        len(x),
        float(np.sqrt(own2)),
    )


def outliers(
    values: ArrayLike, u: ArrayLike = 0.0, *, least: float = 0.0
) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which of N `values` (N,) lie far from the median, (N,): beyond four times their own `u`, a number or
    (N,), and the others' scatter.

    The scatter is 1.4826 times the median distance (Hampel 1974), at least `least`. Below five values nothing
    can be told and none strays.
    """
    x = np.asarray(values, dtype=np.float64).ravel()
    if len(x) < 5:
        return np.zeros(len(x), dtype=np.bool_)
    away = np.abs(x - np.median(x))
    scale = max(robust_scale(away), least, _LEAST_U)
    return np.asarray(away > _FAR * np.hypot(scale, np.asarray(u, dtype=np.float64)), dtype=np.bool_)
