"""Percentiles of another fleet: the heights of each class as measured, mixed by other shares."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from sightline.statistics.distributions import CONFIDENCE, Percentile

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


def mixed_percentile(
    heights_m: Floats, code: Ints, shares: Sequence[float], percent: float, confidence: float = CONFIDENCE
) -> Percentile:
    """A percentile of a fleet in which class c has the share `shares`[c], from heights of each class.

    heights_m (N,) in metres, code (N,) the class of each. The estimate is Hyndman's and Fan's type 8 (1996)
    with each height weighing shares[c] / n_c; of equal weights it is theirs. The interval inverts that of
    the share below the percentile (Woodruff 1952), whose variance is the sum of shares[c]^2 F_c (1 - F_c) /
    n_c and whose limits are a binomial's with the sample size that has this variance, at most N (Korn and
    Graubard 1998). Shares are taken as exact. Raises ValueError where a class with a share has no height.
    """
    shares_ = np.asarray(shares, dtype=np.float64)
    counts = np.bincount(code, minlength=len(shares_))
    if np.any((shares_ > 0.0) & (counts[: len(shares_)] == 0)) or not shares_.sum() > 0.0:
        raise ValueError("A class with a share has no height.")
    keep = shares_[code] > 0.0
    order = np.argsort(heights_m[keep], kind="stable")
    x, of = heights_m[keep][order], code[keep][order]
    weight = (shares_ / np.maximum(counts, 1))[of] / shares_.sum()
    place = (np.cumsum(weight) - weight / 3.0) / (1.0 + weight.mean() / 3.0)
    p = percent / 100.0
    value = float(np.interp(p, place, x))
    sampled = _sample_size(p, x <= value, of, shares_ / shares_.sum(), counts)
    tail, below = 0.5 * (1.0 - confidence), p * sampled
    low = float(stats.beta.ppf(tail, below, sampled - below + 1.0))
    high = float(stats.beta.ppf(1.0 - tail, below + 1.0, sampled - below))
    if not (place[0] <= low and high <= place[-1]):
        return Percentile(percent, value, None, None, f"too few vehicles for an interval: {len(x)}")
    return Percentile(percent, value, float(np.interp(low, place, x)), float(np.interp(high, place, x)))


def _sample_size(p: float, below: NDArray[np.bool_], code: Ints, shares: Floats, counts: Ints) -> float:
    """The size of a simple sample whose share below has the variance that the mixed one has; at most its
    own.
    """
    inside = np.bincount(code, below, minlength=len(shares)) / np.maximum(counts, 1)
    variance = float(np.sum(shares**2 * inside * (1.0 - inside) / np.maximum(counts, 1)))
    return min(p * (1.0 - p) / variance if variance > 0.0 else np.inf, float(len(code)))
