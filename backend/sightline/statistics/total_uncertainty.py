"""Total uncertainty of percentiles, means, spreads and shares of heights (JCGM 101:2008, GUM Supplement 1).

What an interval holds: the sample; sites as clusters, where heights of several are pooled (`sites`); errors
that many heights share (`shared_errors`); the random error of each height, which widens a distribution and is
taken out of the value (`deconvolution`). Their distributions are propagated by draws, always the same ones.
One site, or no word of sites, gives intervals for that place and those days alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.coverage import COVERAGE_95
from sightline.enums import IntervalPart
from sightline.statistics.deconvolution import SmoothDensity, noise_of, smooth_density
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.sites import Sites, pooled_variance, sites_of
from sightline.statistics.wording import holding, there_are

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_TAIL = 0.025
_LEVELS = (np.arange(4000) + 0.5) / 4000  # one draw in each of so many equally likely parts of a distribution
# Spread evenly against the levels and each other: multiples of irrational numbers, modulo 1; always the same.
_OTHER = np.argsort((np.arange(4000) + 0.5) * 0.4142135623730951 % 1.0, kind="stable")
_SHAPE = 0.1  # of a correction for random error: what a density of another shape may change it by (k = 1)
_SMOOTHED = 0.5  # spreads, on either side of a percentile: heights by which sites are compared there
_WINDOW = 0.10  # of all heights, on either side of a percentile: those that say which groups it rests on
_LEAST_IN_WINDOW = 25
_MEAN_OF_INSET = 0.5  # of an assumed inset's variance: its mean's, the rest is the vehicles' own
_LARGEST = 30.0  # of the logarithm of a variance's ratio, beyond which numbers end
_LEAST_BEYOND = 1.0  # heights that must be expected beyond a percentile for it to have an interval


@cache
def normal_draws() -> Floats:
    """(4000,) normal deviates (JCGM 101:2008, 6.4.7), spread evenly against `_LEVELS`."""
    return np.asarray(scipy.special.ndtri((np.arange(4000) + 0.5) * 0.6180339887498949 % 1.0), np.float64)


@lru_cache(maxsize=256)
def student_draws(freedom: float) -> Floats:
    """(4000,) quantiles of Student's t with so many degrees of freedom, at `_LEVELS`, ascending.

    Own method: the upper half, mirrored.
    """
    upper = np.asarray(scipy.special.stdtrit(freedom, _LEVELS[len(_LEVELS) // 2 :]), np.float64)
    found = np.concatenate([-upper[::-1], upper])
    found.setflags(write=False)
    return found


@dataclass(frozen=True, eq=False)
class HeightSample:
    """Heights (N,) with the parts of their uncertainty, metres.

    u_random_m: (N,), of what no other height shares; site: (N,), codes of any kind, or None.
    """

    height_m: Floats
    u_random_m: Floats
    shared: tuple[SharedErrors, ...] = ()
    site: Ints | None = None

    def where(self, chosen: Ints | NDArray[np.bool_]) -> "HeightSample":
        """The rows that are `chosen` (M,), by number, or (N,), by truth."""
        shared = tuple(one.where(chosen) for one in self.shared)
        site = None if self.site is None else self.site[chosen]
        return HeightSample(self.height_m[chosen], self.u_random_m[chosen], shared, site)


def sample_of_measurements(
    height_m: Floats,
    u_height_m: Floats,
    u_clicks_m: Floats,
    u_by_inset_m: Floats,
    pose: Ints,
    inset: Ints,
    site: Ints | None = None,
    pose_names: Ints | None = None,
) -> HeightSample:
    """Heights height_m (N,) with budgets of u_height_m (N,), of which u_clicks_m (N,) comes from clicks and
    u_by_inset_m (N,) from an assumed inset; pose (N,), inset (N,), site (N,): codes from 0, which of each a
    height used; pose_names (G,): by which another sample knows each pose.

    Own reading of the budget: clicks are random; what neither clicks nor inset explain (lens, pose, board) is
    shared by all heights of a pose; of an assumed inset half the variance is the vehicles' own and half that
    of its mean, which all heights with that inset share, for no inset's source says how much. Where the parts
    are not known (NaN) all of it is taken as the pose's.
    """
    clicks, by_inset = np.nan_to_num(u_clicks_m), np.nan_to_num(u_by_inset_m)
    by_pose = np.sqrt(np.maximum(np.nan_to_num(u_height_m) ** 2 - clicks**2 - by_inset**2, 0.0))
    shared = (
        SharedErrors(pose, by_pose, pose_names),
        SharedErrors(inset, by_inset * np.sqrt(_MEAN_OF_INSET)),
    )
    random = np.sqrt(clicks**2 + (1.0 - _MEAN_OF_INSET) * by_inset**2)
    return HeightSample(height_m, random, tuple(one for one in shared if np.any(one.u_m > 0.0)), site)


@dataclass(frozen=True)
class TotalFigure:
    """A figure of the true heights with its 95 % interval; `reason` says why there is none."""

    value: float
    U95_low: float | None
    U95_high: float | None
    reason: str | None = None


@dataclass(frozen=True)
class TotalPercentile(TotalFigure):
    """A percentile of the true heights, metres; `raw`: the plain percentile of the measured ones (linear
    between heights, Hyndman & Fan 1996, type 7, as NumPy, R and spreadsheets have it).
    """

    percent: float = 50.0
    raw: float = 0.0


@dataclass(frozen=True)
class _Local:
    """A percentile of the measured heights: where, their density there, each height's influence (N,) on the
    percentile of the true ones, how much the correction widens it, and the correction.
    """

    p: float
    at_m: float
    density: float
    own: Floats
    of_correction: Floats
    widened: float
    correction_m: float


class TotalUncertainty:
    """Figures of one sample of heights (N,), N > 0, each with its total uncertainty.

    Coverage of the intervals by simulation: `tests/bench/bench_coverage.py`, DECISIONS.md 31.
    """

    def __init__(self, sample: HeightSample) -> None:
        order = np.argsort(sample.height_m, kind="stable")
        sample = sample.where(order)
        self._height_m = sample.height_m
        self._shared = sample.shared
        self._sites = sites_of(sample.site)
        spread_m2 = sum(one.spread_m2() for one in sample.shared)
        # Sites show by their differences what their shared errors were; a sample without sites does not.
        unknown = sum(one.variance_of_spread_m4() for one in sample.shared) if self._sites is None else 0.0
        self._u_spread_m2 = float(np.sqrt(unknown))
        self._noise = noise_of(sample.u_random_m, spread_m2)
        self._noise_m2 = self._noise.variance_m2
        self._random = bool(np.any(sample.u_random_m > 0.0))

    @cached_property
    def _density(self) -> SmoothDensity | None:
        """Of the true heights; a mean needs none."""
        return smooth_density(self._height_m, self._noise)

    @property
    def n(self) -> int:
        """How many heights."""
        return len(self._height_m)

    @property
    def sites(self) -> int | None:
        """How many sites are the clusters; None where heights stand for one place."""
        return None if self._sites is None else len(self._sites.count)

    @property
    def holds(self) -> tuple[IntervalPart, ...]:
        """What the intervals hold."""
        parts: dict[IntervalPart, bool] = {
            "sampling": True,
            "sites": self._sites is not None,
            "shared_errors": bool(self._shared),
            "random_error": self._random,
        }
        return tuple(part for part, there in parts.items() if there)

    @property
    def holds_in_words(self) -> str:
        """What the intervals hold, and for which roads, as the end of a sentence."""
        words: dict[IntervalPart, str] = {
            "sampling": "sampling",
            "sites": f"differences between {self.sites} sites",
            "shared_errors": "errors that heights share",
            "random_error": "random error (removed from the values)",
        }
        return holding([words[part] for part in self.holds], self.sites)

    def percentile(self, percent: float) -> TotalPercentile:
        """A percentile, 0 < percent < 100, metres.

        The value is the sample's (Hyndman & Fan 1996, type 8) with the correction of `deconvolution`. Its
        interval without sites is that of order statistics (David & Nagaraja 2003, 7.1), read between ranks;
        with sites it is Student's, as much longer on one side as that of order statistics is.
        """
        raw = float(np.quantile(self._height_m, percent / 100.0))
        draws = self.percentile_draws(percent)
        if isinstance(draws, str):
            value = float(np.quantile(self._height_m, percent / 100.0, method="median_unbiased"))
            return TotalPercentile(value, None, None, draws, percent=percent, raw=raw)
        value, error = draws
        low, high = _ends(error)
        return TotalPercentile(value, value + low, value + high, percent=percent, raw=raw)

    def percentile_draws(self, percent: float) -> tuple[float, Floats] | str:
        """A percentile's value and draws of its error (D,), metres, or the reason why there are none."""
        p = percent / 100.0
        needed = int(np.ceil(_LEAST_BEYOND / min(p, 1.0 - p)))
        if self._density is None or self.n < needed:
            return self._too_few(max(needed, 8))
        here = self._local(p, self._density)
        sampled = self._order_statistics(p, self._density) - here.at_m
        u_m2 = (_SHAPE * here.correction_m) ** 2
        u_m2 += (here.correction_m * self._u_spread_m2 / max(self._noise_m2, 1e-12)) ** 2
        if self._sites is None:
            near = self._near(p)
            u_m2 += sum(one.where(near).variance_of_mean_m2() for one in self._shared)
            draws = here.widened * sampled
        else:
            draws, unseen = self._between_sites(here, sampled, self._sites)
            u_m2 += unseen
        return here.at_m + here.correction_m, draws + np.sqrt(u_m2) * normal_draws()

    def named_effects_m(self, percent: float) -> dict[int, float]:
        """What one standard uncertainty of each error that other samples know (a road pose's) moves a
        percentile by, metres, by the error's name.

        Of the heights whose ranks lie about it, as in its own uncertainty.
        """
        near = self._near(percent / 100.0)
        found: dict[int, float] = {}
        for one in self._shared:
            found |= one.where(near).named_of_mean_m(np.ones(len(near)))
        return found

    def mean(self) -> TotalFigure:
        """The mean height, metres: random errors leave it as it is."""
        value = float(self._height_m.mean())
        if self.n < 2:
            return TotalFigure(value, None, None, self._too_few(2))
        influence = self._height_m - value
        if self._sites is None:
            draws = _student(float(self._height_m.var(ddof=1)) / self.n, self.n - 1.0)
            u_m2 = sum(one.variance_of_mean_m2() for one in self._shared)
        else:
            pooled = pooled_variance(self._sites, influence, influence, self._shared)
            draws, u_m2 = _student(pooled.variance, pooled.freedom), pooled.unseen
        low, high = _ends(draws + np.sqrt(u_m2) * normal_draws())
        return TotalFigure(value, value + low, value + high)

    def sd(self) -> TotalFigure:
        """The standard deviation of the true heights, metres: what the errors added to it is taken out.

        Of the measured heights' variance the logarithm has a Student interval; 0 where errors explain it all.
        """
        if self.n < 3:
            return TotalFigure(0.0, None, None, self._too_few(3))
        measured_m2 = float(self._height_m.var(ddof=1))
        influence = np.square(self._height_m - self._height_m.mean())
        influence -= influence.mean()
        if self._sites is None:
            draws = _student(float(influence.var()) / self.n, self.n - 1.0)
        else:
            pooled = pooled_variance(self._sites, influence, influence, ())
            draws = _student(pooled.variance, pooled.freedom)
        draws = (
            measured_m2 * np.expm1(np.minimum(draws / max(measured_m2, 1e-12), _LARGEST))
            + self._u_spread_m2 * normal_draws()
        )
        value = measured_m2 - self._noise_m2
        low, high = _ends(draws)
        found = np.sqrt(np.maximum([value, value + low, value + high], 0.0))
        return TotalFigure(float(found[0]), float(found[1]), float(found[2]))

    def share_below(self, limit_m: float) -> TotalFigure:
        """The share of the true heights below a limit, 0 to 1.

        Sampling by Jeffreys' interval (Brown, Cai & DasGupta 2001), of the heights that a sample without
        sites would need for the same variance (Korn & Graubard 1998).
        """
        plain = float(np.mean(self._height_m < limit_m))
        if self._density is None:
            return TotalFigure(plain, None, None, self._too_few(8))
        correction = self._density.share_correction(limit_m)
        n = self._effective_n(plain, limit_m)
        draws = scipy.special.betaincinv(n * plain + 0.5, n * (1.0 - plain) + 0.5, _LEVELS) - plain
        near = self._near(plain)
        shared_m2 = sum(one.where(near).variance_of_mean_m2() for one in self._shared)
        u2 = (self._density.true_density(limit_m) ** 2) * (shared_m2 if self._sites is None else 0.0)
        u2 += (_SHAPE * correction) ** 2
        low, high = _ends(draws + np.sqrt(u2) * normal_draws())
        value = float(np.clip(plain + correction, 0.0, 1.0))
        return TotalFigure(value, max(value + low, 0.0), min(value + high, 1.0))

    def _effective_n(self, share: float, limit_m: float) -> float:
        if self._sites is None or not 0.0 < share < 1.0:
            return float(self.n)
        influence = np.asarray((self._height_m < limit_m) - share, dtype=np.float64)
        pooled = pooled_variance(self._sites, influence, influence, ())
        wider = float(scipy.special.stdtrit(pooled.freedom, 1.0 - _TAIL)) / COVERAGE_95
        return min(share * (1.0 - share) / max(pooled.variance * wider**2, 1e-12), float(self.n))

    def _too_few(self, needed: int) -> str:
        if self.n >= needed:
            return "the heights are all the same"
        return f"its interval needs at least {needed} heights; {there_are(self.n)}"

    def _local(self, p: float, density: SmoothDensity) -> _Local:
        at = float(np.quantile(self._height_m, p, method="median_unbiased"))
        slope = density.measured_density(at)
        own = np.asarray((p - (self._height_m <= at)) / slope, dtype=np.float64)
        # Between ranks the count below is a whole number and its variance not quite p (1 - p).
        own *= np.sqrt(p * (1.0 - p)) / slope / max(float(own.std()), 1e-12)
        of_correction = density.correction_influence_m(p)[density.cell_of(self._height_m)]
        both = own + of_correction
        return _Local(
            p=p,
            at_m=at,
            density=slope,
            own=own,
            of_correction=of_correction,
            widened=float(both.std() / max(own.std(), 1e-12)),
            correction_m=density.correction_m(p),
        )

    def _order_statistics(self, p: float, density: SmoothDensity) -> Floats:
        """Percentile p of the measured heights by its confidence distribution, (D,).

        The height of rank x lies above it with probability 1 - I_p(x, n - x + 1), which is read between whole
        ranks too. Beyond the outermost height the limit lies where, by the smooth density, the outermost of n
        would reach the percentile with the probability wanted.
        """
        n, ordered = self.n, self._height_m
        reach = 5.0 * np.sqrt(n * p * (1.0 - p)) + 6.0
        rank = np.linspace(max(n * p - reach, 1.0), min(n * p + reach, float(n)), 500)
        level = 1.0 - scipy.special.betainc(rank, n - rank + 1.0, p)
        at = np.interp(np.interp(_LEVELS, level, rank), np.arange(1, n + 1), ordered)
        low, high = (1.0 - p) ** n > _LEVELS, 1.0 - p**n < _LEVELS
        middle = float(density.measured_quantile_m(p))
        at[low] = ordered[0] - (density.measured_quantile_m(1.0 - _LEVELS[low] ** (1.0 / n)) - middle)
        at[high] = ordered[-1] + (middle - density.measured_quantile_m((1.0 - _LEVELS[high]) ** (1.0 / n)))
        return np.asarray(at, dtype=np.float64)

    def _between_sites(self, here: _Local, sampled: Floats, sites: Sites) -> tuple[Floats, float]:
        """Draws (D,) of a percentile's error by what sites differ in, and the variance they do not show."""
        influence = here.own + here.of_correction
        smooth = self._smooth_influence(here) + here.of_correction
        pooled = pooled_variance(sites, influence, smooth, self._shared)
        ends = _ends(sampled)
        plain = COVERAGE_95 * np.sqrt(here.p * (1.0 - here.p) / self.n) / here.density
        draws = _student(pooled.variance, pooled.freedom)
        longer = np.where(draws < 0.0, -ends[0], ends[1]) / plain
        return draws * np.sqrt(pooled.within * longer**2 + 1.0 - pooled.within), pooled.unseen

    def _smooth_influence(self, here: _Local) -> Floats:
        """Influence (N,) of each height on the percentile of heights smoothed by half their spread."""
        assert self._density is not None
        width = _SMOOTHED * self._density.spread_m
        away = (here.at_m - self._height_m) / width
        below = scipy.special.ndtr(away)
        density = float(np.exp(-0.5 * away**2).mean()) / (width * np.sqrt(2.0 * np.pi))
        return np.asarray((below.mean() - below) / density, dtype=np.float64)

    def _near(self, p: float) -> Ints:
        """Rows whose ranks lie about p."""
        half = max(int(_WINDOW * self.n), _LEAST_IN_WINDOW)
        middle = int(p * self.n)
        return np.arange(max(middle - half, 0), min(middle + half + 1, self.n))


@dataclass(frozen=True)
class TotalFigures:
    """The figures of one sample with their total uncertainty; shares: in the order of their limits.

    words: what the intervals hold, and for which roads, as the end of a sentence.
    """

    n: int
    sites: int | None
    holds: tuple[IntervalPart, ...]
    words: str
    mean: TotalFigure
    sd: TotalFigure
    percentiles: list[TotalPercentile]
    shares: list[TotalFigure]


def total_figures(
    sample: HeightSample, percents: Sequence[float], limits_m: Sequence[float] = ()
) -> TotalFigures | None:
    """All figures of a sample; None of an empty one."""
    if not len(sample.height_m):
        return None
    found = TotalUncertainty(sample)
    return TotalFigures(
        n=found.n,
        sites=found.sites,
        holds=found.holds,
        words=found.holds_in_words,
        mean=found.mean(),
        sd=found.sd(),
        percentiles=[found.percentile(percent) for percent in percents],
        shares=[found.share_below(limit) for limit in limits_m],
    )


def difference(one: TotalUncertainty, other: TotalUncertainty, percent: float) -> TotalFigure | str:
    """A percentile of `other` less that of `one`, metres, with its interval, or the reason why there is none.

    The two are taken to share no error.
    """
    first, second = one.percentile_draws(percent), other.percentile_draws(percent)
    if isinstance(first, str) or isinstance(second, str):
        return first if isinstance(first, str) else str(second)
    value = second[0] - first[0]
    low, high = _ends(second[1] - first[1][_OTHER])
    return TotalFigure(value, value + low, value + high)


def _student(variance: float, freedom: float) -> Floats:
    """Draws (D,) of an error of this estimated variance, ascending."""
    return np.asarray(student_draws(freedom) * np.sqrt(variance), dtype=np.float64)


def _ends(draws: Floats) -> tuple[float, float]:
    low, high = np.quantile(draws, [_TAIL, 1.0 - _TAIL])
    return float(low), float(high)
