"""Distributions of heights: percentiles, cumulative shares, densities, each with its 95 % interval.

Intervals need no assumption about the shape of a distribution: a percentile's lies between two order
statistics (David & Nagaraja 2003, 7.1), a share's is Clopper's and Pearson's (1934), a cumulative
distribution's band holds everywhere at once (Dvoretzky, Kiefer, Wolfowitz; constant by Massart 1990).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.messages.said import Said

PERCENTILES = (2.0, 2.5, 5.0, 10.0, 15.0, 50.0, 85.0, 90.0, 95.0, 97.5, 98.0)
CONFIDENCE = 0.95
_TAIL = 0.5 * (1.0 - CONFIDENCE)
_POINTS = 256  # of a density
_SEED = 20190403
_RESAMPLES = 400
_LEAST_FOR_DENSITY = 10
_LEAST_SPREAD = 1e-9  # metres; less is the rounding of equal values


@dataclass(frozen=True)
class Percentile:
    """A percentile with its interval of sampling; where the sample is smaller than an interval `needs`, there
    is neither, and `reason` says how many are needed and there.
    """

    percent: float
    value: float | None
    low: float | None
    high: float | None
    needs: int
    reason: Said | None = None


@dataclass(frozen=True)
class Share:
    """The share of a sample below a limit, with its interval."""

    limit: float
    below: int
    n: int
    share: float
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Ecdf:
    """Cumulative shares at sorted values, (M,) each: `share` of the sample is <= `value`; low, high: band, of
    sampling alone.
    """

    value: Floats
    share: Floats
    low: Floats
    high: Floats
    n: int


@dataclass(frozen=True, eq=False)
class Density:
    """A Gaussian kernel density on a grid, (M,) each, with a pointwise bootstrap band of the estimate itself
    (its smoothing bias and errors that values share are not in the band).
    """

    value: Floats
    density: Floats
    low: Floats
    high: Floats
    bandwidth: float
    n: int


def sorted_values(values: ArrayLike) -> Floats:
    """The finite `values`, any shape, in ascending order: what the functions of this module take, (N,)."""
    found = np.asarray(values, dtype=np.float64).ravel()
    return np.sort(found[np.isfinite(found)])


def percentiles(ordered: Floats, percents: Sequence[float] = PERCENTILES) -> list[Percentile]:
    """Percentiles of a sorted sample, `ordered` (N,), estimated without bias of the median (Hyndman & Fan
    1996, type 8).

    The interval holds the percentile with at least 95 %, whatever the distribution: it lies between two order
    statistics (David & Nagaraja 2003, 7.1). Values in the sample's unit; [] for an empty sample.
    """
    n = len(ordered)
    if n == 0:
        return []
    p = np.asarray(percents, dtype=np.float64) / 100.0
    values = np.quantile(ordered, p, method="median_unbiased")
    low, high = _ranks(n, tuple(p.tolist()))
    return [
        _percentile(ordered, percent, float(value), int(first), int(last))
        for percent, value, first, last in zip(percents, values, low, high, strict=True)
    ]


@lru_cache(maxsize=4096)  # groups and figures of one survey ask for the same ranks and shares many times
def _ranks(n: int, p: tuple[float, ...]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Places of the order statistics that enclose percentiles p, (P,) each; none outside 0 to n - 1."""
    # x[low] <= percentile fails if at most `low` values lie below it; likewise from above.
    low = scipy.stats.binom.ppf(_TAIL, n, p).astype(np.int64) - 1
    low -= (low >= 0) & (scipy.stats.binom.cdf(low, n, p) > _TAIL)
    return low, scipy.stats.binom.ppf(1.0 - _TAIL, n, p).astype(np.int64)


def _percentile(ordered: Floats, percent: float, value: float, low: int, high: int) -> Percentile:
    n, needs = len(ordered), vehicles_for_interval(percent)
    if low < 0 or high >= n:
        return Percentile(
            percent=percent, value=None, low=None, high=None, needs=needs, reason=too_few_for(percent, n)
        )
    return Percentile(
        percent=percent, value=value, low=float(ordered[low]), high=float(ordered[high]), needs=needs
    )


def too_few_for(percent: float, n: int, like: int | None = None) -> Said:
    """Why a percentile of n vehicles has no value: how many it needs, and how many there are. like: as how
    many of equal weight they count.
    """
    needs = vehicles_for_interval(percent)
    if like is None or like == n:
        return Said("stat-percentile-needs", percent=percent, needed=needs, count=n)
    return Said("stat-percentile-needs-alike", percent=percent, needed=needs, count=n, like=like)


def vehicles_for_interval(percent: float) -> int:
    """The fewest vehicles whose smallest and largest value enclose a percentile in 95 % of samples."""
    p = min(percent, 100.0 - percent) / 100.0
    if not 0.0 < p < 1.0:
        raise ValueError(f"A percentile of {percent} has no interval; it must lie between 0 and 100.")
    return int(np.ceil(np.log(_TAIL) / np.log1p(-p)))


def share_below(ordered: Floats, limit: float) -> Share | None:
    """The share of a sorted sample, `ordered` (N,), below `limit` (same unit); None for an empty sample.

    The interval is the exact one of a binomial share (Clopper and Pearson 1934).
    """
    n = len(ordered)
    if n == 0:
        return None
    below = int(np.searchsorted(ordered, limit, side="left"))
    low, high = share_interval(below, n)
    return Share(limit=limit, below=below, n=n, share=below / n, low=low, high=high)


@lru_cache(maxsize=4096)
def share_interval(count: int, n: int) -> tuple[float, float]:
    """The exact 95 % interval of a share `count` / `n` (Clopper and Pearson 1934); n must be positive."""
    low = float(scipy.stats.beta.ppf(_TAIL, count, n - count + 1)) if count else 0.0
    high = float(scipy.stats.beta.ppf(1.0 - _TAIL, count + 1, n - count)) if count < n else 1.0
    return low, high


def ecdf(ordered: Floats, most: int = 600) -> Ecdf | None:
    """Cumulative distribution of a sorted sample, `ordered` (N,), at no more than about `most` of its values.

    What is left out changes no step by more than 1 / most. The band is +- sqrt(ln(2 / 0.05) / (2 n)):
    Dvoretzky, Kiefer and Wolfowitz 1956 with the constant of Massart 1990. None for an empty sample.
    """
    n = len(ordered)
    if n == 0:
        return None
    rank = np.unique(np.rint(np.linspace(0, n - 1, min(n, most))).astype(np.int64))
    value = ordered[rank]
    share = np.searchsorted(ordered, value, side="right") / n
    band = np.sqrt(np.log(2.0 / (1.0 - CONFIDENCE)) / (2.0 * n))
    low, high = np.maximum(share - band, 0.0), np.minimum(share + band, 1.0)
    return Ecdf(value, np.asarray(share, dtype=np.float64), low, high, n)


def density(ordered: Floats, step: float = 0.0) -> Density | Said:
    """Kernel density of a sorted sample, `ordered` (N,), on a grid of 256 points, or the reason why there is
    none; per unit of the values.

    Gaussian kernel, Silverman's robust bandwidth 0.9 min(sd, IQR / 1.349) n^(-1/5) (Silverman 1986, 3.4.2,
    who rounds 1.349 to 1.34), and for values that were rounded to multiples of `step` at least half of that:
    narrower kernels draw the rounding as a comb (at half a step its ripple is 2 exp(-pi^2 / 2), 1.4 % of the
    density). Computed on counts of the grid by FFT, so that a million values and the bootstrap cost little.
    The band is the percentile bootstrap's (Efron and Tibshirani 1993, ch. 13).

    By simulation (normal heights, within 2 sd) the 95 % band holds the estimate's mean in .91 of samples of
    30, .94 of 60 and more.
    """
    n = len(ordered)
    if n < _LEAST_FOR_DENSITY:
        return Said("stat-density-needs", least=_LEAST_FOR_DENSITY, count=n)
    quartiles = np.quantile(ordered, [0.25, 0.75])
    spreads = [float(np.std(ordered, ddof=1)), float(quartiles[1] - quartiles[0]) / 1.349]
    spread = min((s for s in spreads if s > _LEAST_SPREAD), default=0.0)
    if spread == 0.0:
        return Said("stat-values-alike")
    width = max(0.9 * spread * n**-0.2, 0.5 * step)
    inner = ordered[[0, -1]] + np.array([-3.0, 3.0]) * width
    edges = np.linspace(inner[0], inner[1], _POINTS + 1)
    counts = np.histogram(ordered, edges)[0]
    at = np.arange(-(_POINTS - 1), _POINTS) * ((edges[1] - edges[0]) / width)
    kernel = np.exp(-0.5 * at * at) / np.sqrt(2.0 * np.pi)
    rng = np.random.default_rng(_SEED)
    resampled = rng.multinomial(n, counts / counts.sum(), _RESAMPLES)
    scale = n * width
    tail = 50.0 * (1.0 - CONFIDENCE)
    low, high = np.percentile(_smoothed(resampled, kernel) / scale, [tail, 100.0 - tail], axis=0)
    centre = 0.5 * (edges[1:] + edges[:-1])
    return Density(
        value=centre,
        density=_smoothed(counts[None, :], kernel)[0] / scale,
        low=low,
        high=high,
        bandwidth=float(width),
        n=n,
    )


def _smoothed(counts: NDArray[np.int64], kernel: Floats) -> Floats:
    """Counts (R, points) convolved with the kernel, cut to the grid."""
    points = counts.shape[1]
    size = scipy.fft.next_fast_len(points + len(kernel) - 1, real=True)
    full = scipy.fft.irfft(scipy.fft.rfft(counts, size, axis=1) * scipy.fft.rfft(kernel, size), size, axis=1)
    return np.asarray(np.maximum(full[:, points - 1 : 2 * points - 1], 0.0), dtype=np.float64)
